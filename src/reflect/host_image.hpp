// A host's images as our passes take them, and ours as a host does.
#pragma once

#include "glint/gbuffer.hpp"
#include "gpu/pass.hpp"

namespace glint::reflect {

/// The library's own images are handed out ready for sampling by whatever comes next.
inline constexpr gpu::Use kHandedOut = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                        VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT,
                                        VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// In the state that the host says it is in; empty for an absent one.
inline gpu::Image borrow(const HostImage& host, const char* name, uint32_t mips = 1, uint32_t layers = 1) {
    if (!host)
        return {};
    gpu::ResourceState state;
    state.writeStages = host.stages;
    state.writeAccess = host.access;
    state.layout = host.layout;
    return gpu::Image::borrow(
        host.image, host.view,
        {name, host.format, host.width, host.height, mips, layers, gpu::ImageShape::Flat, 0, host.samples}, state);
}

/// The host finds its image in the layout in which it gave it.
inline void giveBack(gpu::Frame& frame, gpu::Image& image, const HostImage& original) {
    if (image)
        frame.hand(image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, original.layout});
}

inline HostImage handOut(const gpu::Image& image) {
    return {image.handle(),    image.view(),    image.desc().format,
            image.width(),     image.height(),  VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
            kHandedOut.stages, VK_ACCESS_2_NONE};
}

/// In these it shows nothing.
inline bool isInNoLayout(const HostImage& image) {
    return image.layout == VK_IMAGE_LAYOUT_UNDEFINED || image.layout == VK_IMAGE_LAYOUT_PREINITIALIZED;
}

} // namespace glint::reflect
