// Copies data between CPU and GPU and waits for completion: for set-up, tests and headless work only.
#pragma once

#include "gpu/pass.hpp"

namespace glint::gpu {

/// Creates a device buffer with this content; adds usage TRANSFER_DST.
Result<Buffer> uploadBuffer(Context& context, std::string name, std::span<const std::byte> content,
                            VkBufferUsageFlags usage);

template <class T>
Result<Buffer> uploadBuffer(Context& context, std::string name, const std::vector<T>& content,
                            VkBufferUsageFlags usage) {
    return uploadBuffer(context, std::move(name), std::as_bytes(std::span(content)), usage);
}

/// Fills mip 0 of every layer (tightly packed, layer after layer), makes the other mips by box filtering, and leaves
/// the image ready for sampling. The image needs TRANSFER_DST usage, and TRANSFER_SRC if it has mips.
Result<void> uploadImage(Context& context, Image& image, std::span<const std::byte> content);

/// Returns one mip of one layer, tightly packed. The image needs TRANSFER_SRC usage.
Result<std::vector<std::byte>> downloadImage(Context& context, Image& image, uint32_t mip = 0, uint32_t layer = 0);

/// Returns the whole buffer, which needs TRANSFER_SRC usage.
Result<std::vector<std::byte>> downloadBuffer(Context& context, Buffer& buffer);

size_t bytesPerTexel(VkFormat format);

/// As downloadImage, converted to RGBA floats from any uncompressed format. Missing colour channels are 0, a missing
/// alpha is 1. Integer formats yield their integer values.
Result<std::vector<float>> downloadImageAsFloats(Context& context, Image& image, uint32_t mip = 0, uint32_t layer = 0);

} // namespace glint::gpu
