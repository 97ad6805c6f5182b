#include "gpu/texture_table.hpp"

#include <algorithm>
#include <bit>

namespace glint::gpu {
namespace {

Result<VkSampler> makeSampler(Context& context, const SamplerDesc& desc) {
    VkSamplerCreateInfo info = {VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = desc.magFilter;
    info.minFilter = desc.minFilter;
    info.mipmapMode = desc.mipMode;
    info.addressModeU = desc.wrapU;
    info.addressModeV = desc.wrapV;
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.maxLod = desc.mips ? VK_LOD_CLAMP_NONE : 0;
    if (context.anisotropy() && desc.mips && desc.minFilter == VK_FILTER_LINEAR && desc.magFilter == VK_FILTER_LINEAR) {
        info.anisotropyEnable = VK_TRUE;
        info.maxAnisotropy = 8; // floors are seen at grazing angles; beyond 8, no difference is visible
    }
    VkSampler sampler = VK_NULL_HANDLE;
    if (context.api().CreateSampler(context.device(), &info, context.callbacks(), &sampler) != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "a texture's sampler cannot be created");
    context.nameObject(VK_OBJECT_TYPE_SAMPLER, reinterpret_cast<uint64_t>(sampler), "textures/sampler");
    return sampler;
}

/// The layout of tables of `count` textures, some of which may be missing. The context keeps it.
Result<VkDescriptorSetLayout> layoutOf(Context& context, uint32_t count) {
    VkDescriptorSetLayout& layout = context.tableLayouts()[count];
    if (layout)
        return layout;
    const VkDescriptorSetLayoutBinding binding = {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, count,
                                                  VK_SHADER_STAGE_ALL, nullptr};
    const VkDescriptorBindingFlags partial = VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT;
    const VkDescriptorSetLayoutBindingFlagsCreateInfo flags = {
        VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO, nullptr, 1, &partial};
    VkDescriptorSetLayoutCreateInfo info = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, &flags};
    info.bindingCount = 1;
    info.pBindings = &binding;
    const VkResult result =
        context.api().CreateDescriptorSetLayout(context.device(), &info, context.callbacks(), &layout);
    if (result != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "a table of {} textures cannot be created (VkResult {})", count,
                         static_cast<int>(result));
    context.nameObject(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, reinterpret_cast<uint64_t>(layout), "textures");
    return layout;
}

} // namespace

Result<TextureTable> TextureTable::create(Context& context, std::span<const Entry> entries) {
    TextureTable owner; // owns the samplers until the table is complete
    owner.context_ = &context;
    std::vector<std::pair<SamplerDesc, VkSampler>>& samplers = owner.samplers_;
    std::vector<VkDescriptorImageInfo> infos;
    for (const Entry& entry : entries) {
        auto known = std::find_if(samplers.begin(), samplers.end(),
                                  [&](const auto& pair) { return pair.first == entry.sampler; });
        if (known == samplers.end()) {
            GLINT_TRY(sampler, makeSampler(context, entry.sampler));
            known = samplers.insert(samplers.end(), {entry.sampler, sampler});
        }
        infos.push_back({known->second, entry.image->view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }
    GLINT_TRY(table, create(context, infos));
    table.samplers_.swap(samplers);
    return table;
}

Result<TextureTable> TextureTable::create(Context& context, std::span<const VkDescriptorImageInfo> entries) {
    if (!context.hasTables())
        return makeError(ErrorCode::Unsupported,
                         "probes, planar mirrors and surfaces of rays need tables of images, which are not enabled on "
                         "{}: adopt the device with DeviceDemands::Sources",
                         context.info().name);
    TextureTable table;
    table.context_ = &context;
    table.entries_.assign(entries.begin(), entries.end());
    const Api& api = context.api();
    // Powers of two: tables of about the same size share their layout, and so the pipelines that read them.
    const auto count = static_cast<uint32_t>(std::bit_ceil(std::max<size_t>(entries.size(), 1)));
    GLINT_TRY(layout, layoutOf(context, count));
    table.layout_ = layout;

    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, count};
    VkDescriptorPoolCreateInfo poolInfo = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    poolInfo.maxSets = 1;
    poolInfo.poolSizeCount = 1;
    poolInfo.pPoolSizes = &size;
    VkResult result = api.CreateDescriptorPool(context.device(), &poolInfo, context.callbacks(), &table.pool_);
    if (result == VK_SUCCESS) {
        const VkDescriptorSetAllocateInfo allocate = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, nullptr,
                                                      table.pool_, 1, &table.layout_};
        result = api.AllocateDescriptorSets(context.device(), &allocate, &table.set_);
    }
    if (result != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "a table of {} textures cannot be created (VkResult {})", count,
                         static_cast<int>(result));
    context.nameObject(VK_OBJECT_TYPE_DESCRIPTOR_SET, reinterpret_cast<uint64_t>(table.set_), "textures");
    if (!entries.empty()) {
        VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = table.set_;
        write.descriptorCount = static_cast<uint32_t>(entries.size());
        write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        write.pImageInfo = entries.data();
        api.UpdateDescriptorSets(context.device(), 1, &write, 0, nullptr);
    }
    return table;
}

void TextureTable::destroy() {
    if (!context_)
        return;
    const Api& api = context_->api();
    for (const auto& [desc, sampler] : samplers_)
        api.DestroySampler(context_->device(), sampler, context_->callbacks());
    api.DestroyDescriptorPool(context_->device(), pool_, context_->callbacks());
}

void TextureTable::swap(TextureTable& other) {
    std::swap(context_, other.context_);
    std::swap(layout_, other.layout_);
    std::swap(pool_, other.pool_);
    std::swap(set_, other.set_);
    std::swap(samplers_, other.samplers_);
    std::swap(entries_, other.entries_);
}

} // namespace glint::gpu
