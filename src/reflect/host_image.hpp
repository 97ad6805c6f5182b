// Converts a host's images for our passes, and ours for the host.
#pragma once

#include "glint/gbuffer.hpp"
#include "gpu/pass.hpp"

namespace glint::reflect {

/// The library's own images are returned ready for sampling by any later command.
inline constexpr gpu::Use kHandedOut = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                        VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT,
                                        VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// Returns the state that the host declares.
inline gpu::ResourceState stateOf(const HostImage& host) {
    return {host.stages, host.access, 0, 0, host.layout};
}

/// Borrows the image in the state that the host declares; empty for an absent image.
inline gpu::Image borrow(const HostImage& host, const char* name, uint32_t mips = 1, uint32_t layers = 1) {
    if (!host)
        return {};
    return gpu::Image::borrow(
        host.image, host.view,
        {name, host.format, host.width, host.height, mips, layers, gpu::ImageShape::Flat, 0, host.samples},
        stateOf(host));
}

/// As borrow, into an Image that may already hold this image: then nothing is allocated.
inline void lend(gpu::Image& image, const HostImage& host, const char* name, uint32_t mips = 1, uint32_t layers = 1) {
    if (image.handle() == host.image && image.view() == host.view && image.desc().mips == mips)
        image.lendAgain(stateOf(host));
    else
        image = borrow(host, name, mips, layers);
}

/// Returns the host's image to the layout in which the host provided it.
inline void giveBack(gpu::Frame& frame, gpu::Image& image, const HostImage& original) {
    if (image)
        frame.hand(image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, original.layout});
}

inline HostImage handOut(const gpu::Image& image) {
    HostImage host = {image.handle(),    image.view(),    image.desc().format,
                      image.width(),     image.height(),  VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                      kHandedOut.stages, VK_ACCESS_2_NONE};
    host.usage = image.desc().usage;
    host.mips = image.desc().mips;
    return host;
}

/// True for layouts in which an image has no defined content.
inline bool isInNoLayout(const HostImage& image) {
    return image.layout == VK_IMAGE_LAYOUT_UNDEFINED || image.layout == VK_IMAGE_LAYOUT_PREINITIALIZED;
}

} // namespace glint::reflect
