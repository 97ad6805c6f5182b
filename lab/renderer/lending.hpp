// Converts our renderer's objects to include/glint types and back: the seam between a host and the library.
#pragma once

#include "glint/reflections.hpp"
#include "lab/renderer/environment.hpp"
#include "lab/renderer/gbuffer.hpp"
#include "lab/renderer/transparent_layers.hpp"
#include "lab/renderer/view.hpp"

namespace glint::render {

inline constexpr gpu::Use kSampled = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                      VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT,
                                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// Adopts our device for the library, including our shader replacements. A later call returns the same context where
/// nobody uses it any longer, so that the next session of a program compiles no pipeline a second time; sessions that
/// exist together have their own, for each reports its memory. Errors: as Context::adopt.
Result<std::shared_ptr<Context>> adoptDevice(gpu::Context& context);

/// Wraps our image for the library, and transitions it to the layout that we promise.
HostImage lend(gpu::Frame& frame, gpu::Image& image);
/// Wraps the library's image for our own passes.
gpu::Image borrow(const HostImage& image, const char* name, uint32_t mips = 1, uint32_t layers = 1);

glint::GBuffer lendGBuffer(gpu::Frame& frame, GBuffer& g);
/// `coverage`: absent with one sample per pixel.
TransparentLayer lendLayer(gpu::Frame& frame, gpu::Image& depth, LayerImages& layer, gpu::Image& coverage);
EnvironmentMap lendEnvironmentMap(gpu::Frame& frame, Environment& environment, const EnvironmentSettings& settings);
glint::View libraryView(const View& view, uint32_t frameIndex, uint32_t seed);

} // namespace glint::render
