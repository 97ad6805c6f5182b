// One large array of textures as set 1, binding 0 ("bindless"): materials refer to textures by index.
#pragma once

#include "gpu/resources.hpp"

namespace glint::gpu {

struct SamplerDesc {
    VkFilter magFilter = VK_FILTER_LINEAR;
    VkFilter minFilter = VK_FILTER_LINEAR;
    VkSamplerMipmapMode mipMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    bool mips = true; ///< false: level 0 only
    VkSamplerAddressMode wrapU = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    VkSamplerAddressMode wrapV = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    bool operator==(const SamplerDesc&) const = default;
};

class TextureTable {
public:
    TextureTable() = default;
    /// The caller owns the images and must transition them to SHADER_READ_ONLY_OPTIMAL before use. An entry pairs an
    /// image with its sampler; shaders declare `layout(set = 1, binding = 0) uniform sampler2D textures[];`.
    struct Entry {
        const Image* image = nullptr;
        SamplerDesc sampler;
    };
    static Result<TextureTable> create(Context& context, std::span<const Entry> entries);
    /// As above, for a host's views and samplers, which must outlive the table.
    static Result<TextureTable> create(Context& context, std::span<const VkDescriptorImageInfo> entries);
    ~TextureTable() { destroy(); }
    TextureTable(TextureTable&& other) noexcept { swap(other); }
    TextureTable& operator=(TextureTable&& other) noexcept { return swap(other), *this; }

    /// Shared with tables of about the same size, and kept by the context.
    VkDescriptorSetLayout layout() const { return layout_; }
    VkDescriptorSet set() const { return set_; }
    std::span<const VkDescriptorImageInfo> entries() const { return entries_; }

private:
    void destroy();
    void swap(TextureTable& other);

    Context* context_ = nullptr;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    std::vector<std::pair<SamplerDesc, VkSampler>> samplers_; ///< created by the table
    std::vector<VkDescriptorImageInfo> entries_;
};

} // namespace glint::gpu
