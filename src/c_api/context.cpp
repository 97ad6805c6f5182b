#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

uint32_t glint_version(void) {
    return version();
}

void glint_context_desc_init(GlintContextDesc* desc, uint32_t size) {
    initStruct<HostDevice>(desc, size);
}

const char* const* glint_required_device_extensions(uint32_t* count) {
    const std::span<const char* const> names = requiredDeviceExtensions();
    if (count)
        *count = static_cast<uint32_t>(names.size());
    return names.data();
}

const char* const* glint_ray_query_extensions(uint32_t* count) {
    const std::span<const char* const> names = rayQueryExtensions();
    if (count)
        *count = static_cast<uint32_t>(names.size());
    return names.data();
}

void glint_require_device_features(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                                   VkPhysicalDeviceVulkan13Features* v13, GlintDeviceDemands demands) {
    requireDeviceFeatures(core, v12, v13,
                          demands == GLINT_DEVICE_DEMANDS_SCREEN ? DeviceDemands::Screen : DeviceDemands::Sources);
}

GlintResult glint_context_adopt(const GlintContextDesc* desc, uint32_t abi, GlintContext** context) {
    GLINT_C_REQUIRE(context);
    *context = nullptr;
    if (abi != GLINT_C_ABI) // before any struct is read
        return fail(invalidArgument("the host was compiled for interface {} of Glint's C header, this library has {}: "
                                    "compile it again with the header of this library",
                                    abi, GLINT_C_ABI));
    GLINT_C_TRY(device, readStruct<HostDevice>(desc));
    GLINT_C_TRY(adopted, Context::adopt(device));
    *context = new GlintContext{std::move(adopted), {}, {}};
    return GLINT_SUCCESS;
}

void glint_context_destroy(GlintContext* context) {
    delete context;
}

const char* glint_context_device_name(const GlintContext* context) {
    return context ? context->context.deviceName().c_str() : nullptr;
}

const char* glint_context_driver(const GlintContext* context) {
    return context ? context->context.driver().c_str() : nullptr;
}

void glint_memory_report_init(GlintMemoryReport* report, uint32_t size) {
    initStruct<MemoryReport>(report, size);
}

GlintResult glint_context_memory(GlintContext* context, GlintMemoryReport* report) {
    GLINT_C_REQUIRE(context);
    GLINT_C_CHECK(checkResultStruct<MemoryReport>(report));
    context->memory = context->context.memory();
    context->memoryUses.clear();
    for (const MemoryUse& use : context->memory.uses)
        context->memoryUses.push_back({use.name.c_str(), use.bytes, use.count, 0});
    GlintMemoryReport c = toC(context->memory);
    c.uses = context->memoryUses.data();
    c.useCount = static_cast<uint32_t>(context->memoryUses.size());
    writeStruct(c, report, report->size);
    return GLINT_SUCCESS;
}
