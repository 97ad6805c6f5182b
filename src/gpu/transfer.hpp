// Moving data between the CPU and the GPU, waiting for it: set-up, tests and headless work only.
#pragma once

#include "gpu/pass.hpp"

namespace glint::gpu {

/// A device buffer with this content; usage TRANSFER_DST is added.
Result<Buffer> uploadBuffer(Context& context, std::string name, std::span<const std::byte> content,
                            VkBufferUsageFlags usage);

template <class T>
Result<Buffer> uploadBuffer(Context& context, std::string name, const std::vector<T>& content,
                            VkBufferUsageFlags usage) {
    return uploadBuffer(context, std::move(name), std::as_bytes(std::span(content)), usage);
}

/// Fills mip 0 of every layer (tightly packed, layer after layer) and makes the other mips from it by box filtering;
/// leaves the image ready for sampling. The image needs TRANSFER_DST, and TRANSFER_SRC if it has mips.
Result<void> uploadImage(Context& context, Image& image, std::span<const std::byte> content);

/// One mip of one layer, tightly packed. The image needs TRANSFER_SRC.
Result<std::vector<std::byte>> downloadImage(Context& context, Image& image, uint32_t mip = 0, uint32_t layer = 0);

/// The whole buffer. It needs TRANSFER_SRC.
Result<std::vector<std::byte>> downloadBuffer(Context& context, Buffer& buffer);

size_t bytesPerTexel(VkFormat format);

/// downloadImage as RGBA floats, whatever the (uncompressed) format; missing channels are 0, missing alpha 1. Integer
/// formats give their integers.
Result<std::vector<float>> downloadImageAsFloats(Context& context, Image& image, uint32_t mip = 0, uint32_t layer = 0);

} // namespace glint::gpu
