// What our renderer has, as the library takes it, and back: the seam between a host and include/glint.
#pragma once

#include "glint/reflections.hpp"
#include "render/environment.hpp"
#include "render/gbuffer.hpp"
#include "render/transparent_layers.hpp"
#include "render/view.hpp"

namespace glint::render {

inline constexpr gpu::Use kSampled = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                      VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_TRANSFER_READ_BIT,
                                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// Our device, as the library adopts a host's, with the shaders that we have replaced. Errors: as Context::adopt.
Result<Context> adoptDevice(gpu::Context& context);

/// Ours, as the library takes it: brought into the layout that we promise.
HostImage lend(gpu::Frame& frame, gpu::Image& image);
/// The library's, as our own passes take it.
gpu::Image borrow(const HostImage& image, const char* name, uint32_t mips = 1, uint32_t layers = 1);

glint::GBuffer lendGBuffer(gpu::Frame& frame, GBuffer& g);
/// `coverage`: absent with one sample a pixel.
TransparentLayer lendLayer(gpu::Frame& frame, gpu::Image& depth, LayerImages& layer, gpu::Image& coverage);
EnvironmentMap lendEnvironmentMap(gpu::Frame& frame, Environment& environment, const EnvironmentSettings& settings);
glint::View libraryView(const View& view, uint32_t frameIndex, uint32_t seed);

} // namespace glint::render
