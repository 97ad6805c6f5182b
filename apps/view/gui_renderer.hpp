// Draws what Dear ImGui has put together, by one pipeline of src/gpu: no backend of ImGui's own, so no second view of
// Vulkan in the program.
#pragma once

#include "gpu/pass.hpp"
#include "gpu/texture_table.hpp"

#include <memory>

struct ImDrawData;

namespace glint::view {

/// Which texture an ImGui draw command shows: ImTextureID holds this number.
using GuiTexture = uint32_t;
constexpr GuiTexture kFontTexture = 0;

class GuiRenderer {
public:
    /// Makes the font's texture from ImGui's context, which must be there. `context` knows gpu::shaders::view().
    /// Errors: OutOfMemory, DeviceLost.
    static Result<GuiRenderer> create(gpu::Context& context);

    /// The pictures that draw commands may name, as textures 1, 2, ...: each twice, smooth (odd numbers) and with every
    /// pixel a square (even ones). They must be ready for sampling when `draw` runs, and outlive it.
    /// Errors: OutOfMemory.
    Result<void> setPictures(std::span<const gpu::Image* const> pictures);
    static constexpr GuiTexture smooth(uint32_t picture) { return 1 + 2 * picture; }
    static constexpr GuiTexture squares(uint32_t picture) { return 2 + 2 * picture; }

    /// Into `target` (RGBA8_UNORM, a colour attachment), over black. Waits until it is done.
    /// Errors: OutOfMemory, DeviceLost.
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
