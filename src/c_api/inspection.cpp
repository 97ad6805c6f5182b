// What a Reflections says of a pixel and of the host's declarations.
#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

#include <limits>

using namespace glint;
using namespace glint::c_api;

namespace {

/// The library's names are literals, which end in a zero. Null: none.
const char* text(std::string_view name) {
    return name.empty() ? nullptr : name.data();
}

GlintRaySample toSample(const RaySample& sample) {
    GlintRaySample c = {};
    std::copy(sample.positionPX.begin(), sample.positionPX.end(), c.positionPX);
    c.level = sample.level;
    c.rayDepth = sample.rayDepth;
    c.sceneDepth = sample.sceneDepth;
    c.slabEndDepth = sample.slabEndDepth.value_or(std::numeric_limits<float>::quiet_NaN());
    c.distance = sample.distance;
    c.decision = text(sample.decision);
    return c;
}

GlintRaySource toSource(const RayInspection::Source& source) {
    GlintRaySource c = {text(source.name), source.weight, {}};
    std::copy(source.radiance.begin(), source.radiance.end(), c.radiance);
    return c;
}

} // namespace

void glint_ray_inspection_init(GlintRayInspection* inspection, uint32_t size) {
    initStruct<RayInspection>(inspection, size);
}

void glint_input_check_init(GlintInputCheck* check, uint32_t size) {
    initStruct<InputCheck>(check, size);
}

void glint_known_plane_init(GlintKnownPlane* plane, uint32_t size) {
    initStruct<KnownPlane>(plane, size);
}

GlintResult glint_reflections_record_inspection(GlintReflections* reflections, VkCommandBuffer commands, uint32_t x,
                                                uint32_t y) {
    GLINT_C_REQUIRE(reflections);
    return outcome(reflections->reflections.recordInspection(commands, x, y));
}

GlintResult glint_reflections_inspection(GlintReflections* reflections, GlintRayInspection* inspection) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_CHECK(checkResultStruct<RayInspection>(inspection));
    if (!reflections->inspects)
        return fail(invalidArgument("these reflections were made without inspection: set "
                                    "GlintReflectionsDesc::inspection"));
    const RayInspection read = reflections->reflections.inspection();
    reflections->raySamples.clear();
    reflections->rayFades.clear();
    reflections->raySources.clear();
    for (const RaySample& sample : read.samples)
        reflections->raySamples.push_back(toSample(sample));
    for (const RayInspection::Fade& fade : read.fades)
        reflections->rayFades.push_back({text(fade.name), fade.factor, 0});
    for (const RayInspection::Source& source : read.sources)
        reflections->raySources.push_back(toSource(source));
    GlintRayInspection c = toC(read);
    c.samples = reflections->raySamples.data();
    c.sampleCount = static_cast<uint32_t>(reflections->raySamples.size());
    c.fades = reflections->rayFades.data();
    c.fadeCount = static_cast<uint32_t>(reflections->rayFades.size());
    c.sources = reflections->raySources.data();
    c.sourceCount = static_cast<uint32_t>(reflections->raySources.size());
    c.whyNoRay = text(read.whyNoRay);
    c.outcome = text(read.outcome);
    if (read.hitPixel) {
        c.hasHitPixel = VK_TRUE;
        std::copy(read.hitPixel->begin(), read.hitPixel->end(), c.hitPixel);
    }
    if (read.projection) {
        c.proxy = text(read.projection->proxy);
        c.projectedProbe = read.projection->probe.value_or(UINT32_MAX);
        c.projectionDistance = read.projection->distance;
    }
    writeStruct(c, inspection, inspection->size);
    return GLINT_SUCCESS;
}

GlintResult glint_reflections_record_input_check(GlintReflections* reflections, VkCommandBuffer commands,
                                                 const GlintKnownPlane* plane) {
    GLINT_C_REQUIRE(reflections);
    if (!plane)
        return outcome(reflections->reflections.recordInputCheck(commands));
    GLINT_C_TRY(known, readStruct<KnownPlane>(plane));
    return outcome(reflections->reflections.recordInputCheck(commands, &known));
}

GlintResult glint_reflections_input_check(GlintReflections* reflections, GlintInputCheck* check) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_CHECK(checkResultStruct<InputCheck>(check));
    const InputCheck& read = reflections->reflections.inputCheck();
    reflections->inputFindings = read.findings;
    GlintInputCheck c = toC(read);
    c.findingCount = static_cast<uint32_t>(read.findings.size());
    writeStruct(c, check, check->size);
    return GLINT_SUCCESS;
}

const char* glint_reflections_input_finding(const GlintReflections* reflections, uint32_t index) {
    return reflections && index < reflections->inputFindings.size() ? reflections->inputFindings[index].c_str()
                                                                    : nullptr;
}
