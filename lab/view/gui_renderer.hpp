// Draws Dear ImGui's draw data with one pipeline of src/gpu instead of ImGui's own Vulkan backend, so that the program
// has a single Vulkan layer.
#pragma once

#include "gpu/pass.hpp"
#include "gpu/texture_table.hpp"

#include <memory>

struct ImDrawData;

namespace glint::view {

/// The texture of an ImGui draw command: ImTextureID holds this number.
using GuiTexture = uint32_t;
constexpr GuiTexture kFontTexture = 0;

class GuiRenderer {
public:
    /// Creates the font texture from ImGui's context, which must exist. Requires that `context` has
    /// gpu::shaders::view() registered. Errors: OutOfMemory, DeviceLost.
    static Result<GuiRenderer> create(gpu::Context& context);

    /// Sets the images that draw commands may refer to, as textures 1, 2, ...: each has two textures, one with linear
    /// filtering (odd numbers) and one with nearest filtering (even numbers). The images must be ready for sampling
    /// when `draw` executes, and must outlive their use. Errors: OutOfMemory.
    Result<void> setPictures(std::span<const gpu::Image* const> pictures);
    static constexpr GuiTexture smooth(uint32_t picture) { return 1 + 2 * picture; }
    static constexpr GuiTexture squares(uint32_t picture) { return 2 + 2 * picture; }

    /// Draws into `target` (RGBA8_UNORM, a colour attachment), over black, and waits for completion. Errors:
    /// OutOfMemory, DeviceLost.
    Result<void> draw(const ImDrawData& data, gpu::Image& target);
    static constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

    double milliseconds(); ///< GPU time of the last draw

private:
    explicit GuiRenderer(gpu::Context& context) : context_(&context) {}
    Result<void> fill(const ImDrawData& data);
    Result<void> reserve(gpu::Buffer& buffer, const char* name, size_t bytes, VkBufferUsageFlags usage);

    gpu::Context* context_;
    gpu::Image font_;
    gpu::TextureTable table_;
    uint32_t textures_ = 1;
    gpu::Pipeline pipeline_;
    gpu::Buffer vertices_;
    gpu::Buffer indices_;
    std::unique_ptr<gpu::Timers> timers_;
};

} // namespace glint::view
