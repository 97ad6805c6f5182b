// Images with several samples a pixel, for tests of hosts with multisampling.
#pragma once

#include "gpu/support/synthetic_gbuffer.hpp"

namespace glint::test {

constexpr uint32_t kSamples = 4;

/// Sample positions of Vulkan's standard pattern, in quarters of a pixel: the quarter that holds each sample.
constexpr glm::uvec2 kSampleQuarters[kSamples] = {{1, 0}, {3, 1}, {0, 2}, {2, 3}};

/// `texel(x, y, sample)`
gpu::Image makeSamples(gpu::Context& context, const char* name, VkFormat format, uint32_t width, uint32_t height,
                       const std::function<glm::vec4(uint32_t, uint32_t, uint32_t)>& texel);

} // namespace glint::test
