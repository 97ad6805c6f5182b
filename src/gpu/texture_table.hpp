// One big array of textures as set 1, binding 0 ("bindless"): materials name their textures by index.
#pragma once

#include "gpu/resources.hpp"

namespace glint::gpu {

struct SamplerDesc {
    VkFilter magFilter = VK_FILTER_LINEAR;
    VkFilter minFilter = VK_FILTER_LINEAR;
    VkSamplerMipmapMode mipMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    bool mips = true; ///< false: always level 0
    VkSamplerAddressMode wrapU = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    VkSamplerAddressMode wrapV = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    bool operator==(const SamplerDesc&) const = default;
};

class TextureTable {
public:
    TextureTable() = default;
    /// Images stay the caller's, which must bring them into SHADER_READ_ONLY_OPTIMAL before use. `entries` pairs an
    /// image with its sampler; shaders declare `layout(set = 1, binding = 0) uniform sampler2D textures[];`.
    struct Entry {
        const Image* image = nullptr;
        SamplerDesc sampler;
    };
    static Result<TextureTable> create(Context& context, std::span<const Entry> entries);
    /// The same of a host's views and samplers, which must outlive the table.
    static Result<TextureTable> create(Context& context, std::span<const VkDescriptorImageInfo> entries);
    ~TextureTable() { destroy(); }
    TextureTable(TextureTable&& other) noexcept { swap(other); }
    TextureTable& operator=(TextureTable&& other) noexcept { return swap(other), *this; }

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
    std::vector<std::pair<SamplerDesc, VkSampler>> samplers_; ///< made here
    std::vector<VkDescriptorImageInfo> entries_;
};

} // namespace glint::gpu
