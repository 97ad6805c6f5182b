#include "lab/renderer/gpu_textures.hpp"

#include "gpu/transfer.hpp"
#include "shared/material.h"

#include <bit>

namespace glint::render {
namespace {

VkSamplerAddressMode addressMode(scene::Wrap wrap) {
    switch (wrap) {
    case scene::Wrap::Repeat: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case scene::Wrap::MirroredRepeat: return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case scene::Wrap::ClampToEdge: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    }
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

gpu::SamplerDesc samplerDesc(const scene::Sampler& sampler) {
    const auto filter = [](scene::Filter f) {
        return f == scene::Filter::Nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    };
    gpu::SamplerDesc desc;
    desc.magFilter = filter(sampler.magFilter);
    desc.minFilter = filter(sampler.minFilter);
    desc.mips = sampler.mipFilter != scene::MipFilter::None;
    desc.mipMode =
        sampler.mipFilter == scene::MipFilter::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    desc.wrapU = addressMode(sampler.wrapU);
    desc.wrapV = addressMode(sampler.wrapV);
    return desc;
}

Result<gpu::Image> uploadTexture(gpu::Context& context, const scene::Image& image, TextureKind kind) {
    const auto mips = static_cast<uint32_t>(std::bit_width(std::max(image.width, image.height)));
    GLINT_TRY(texture, gpu::Image::create(
                           context, {"texture/" + image.name,
                                     kind == TextureKind::Color ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                                     image.width, image.height, mips, 1, gpu::ImageShape::Flat,
                                     VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                         VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    GLINT_CHECK(gpu::uploadImage(context, texture, std::as_bytes(std::span(image.rgba))));
    return texture;
}

} // namespace

Result<void> GpuTextures::addSlot(gpu::Context& context, const scene::Scene& scene, const scene::TextureSlot& slot,
                                  TextureKind kind) {
    if (slot.texture < 0 || indices_.contains({slot.texture, kind}))
        return {};
    const scene::Texture& texture = scene.textures[size_t(slot.texture)];
    if (texture.image < 0)
        return {};
    auto image = images_.find({texture.image, kind});
    if (image == images_.end()) {
        GLINT_TRY(uploaded, uploadTexture(context, scene.images[size_t(texture.image)], kind));
        image = images_.emplace(std::pair{texture.image, kind}, std::move(uploaded)).first;
    }
    indices_[{slot.texture, kind}] = static_cast<uint32_t>(entries_.size());
    entries_.push_back({&image->second, samplerDesc(texture.sampler)});
    return {};
}

Result<GpuTextures> GpuTextures::create(gpu::Context& context, const scene::Scene& scene) {
    GpuTextures result;
    Result<void> status;
    for (const scene::Material& material : scene.materials)
        visitTextureSlots(material, [&](const scene::TextureSlot& slot, TextureKind kind) {
            if (status)
                status = result.addSlot(context, scene, slot, kind);
        });
    GLINT_CHECK(status);
    GLINT_TRY(table, gpu::TextureTable::create(context, result.entries_));
    result.table_ = std::move(table);
    return result;
}

bool GpuTextures::holds(const scene::Scene& scene) const {
    bool all = true;
    for (const scene::Material& material : scene.materials)
        visitTextureSlots(material, [&](const scene::TextureSlot& slot, TextureKind kind) {
            all &= slot.texture < 0 || scene.textures[size_t(slot.texture)].image < 0 ||
                   indices_.contains({slot.texture, kind});
        });
    return all;
}

uint32_t GpuTextures::index(const scene::TextureSlot& slot, TextureKind kind) const {
    const auto found = indices_.find({slot.texture, kind});
    return found == indices_.end() ? shared::kNoTexture : found->second;
}

} // namespace glint::render
