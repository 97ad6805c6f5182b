// Images with several samples a pixel, for tests of hosts that draw so.
#pragma once

#include "gpu/support/synthetic_gbuffer.hpp"

namespace glint::test {

constexpr uint32_t kSamples = 4;

/// Where Vulkan's standard pattern has them, in quarters of a pixel: the quarter that holds each.
constexpr glm::uvec2 kSampleQuarters[kSamples] = {{1, 0}, {3, 1}, {0, 2}, {2, 3}};

/// `texel(x, y, sample)`
gpu::Image makeSamples(gpu::Context& context, const char* name, VkFormat format, uint32_t width, uint32_t height,
                       const std::function<glm::vec4(uint32_t, uint32_t, uint32_t)>& texel);

} // namespace glint::test
