// Rewrites a shader so that a software device computes it as GPUs may. Vulkan leaves some results to the device: tests
// on a software device alone would let shaders rely on its choices.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::gpu {

/// Returns the shader with
/// - mix(x, y, a) as x + a * (y - x), which is not y for a = 1 where x is much larger;
/// - quotients as products with the inverse, so that x / x may be a little below 1.
/// An NVIDIA H200 does both. Not here: what built-in functions do inside (smoothstep, mod, normalize); products and
/// sums that are rounded once, because llvmpipe rounds them twice even where a shader asks for fma; and halves, because
/// llvmpipe stores them rounded toward 0 itself. `words`: SPIR-V 1.5 of one entry point. Errors: InvalidArgument if it
/// is not SPIR-V.
Result<std::vector<uint32_t>> asGpusCompute(std::span<const uint32_t> words);

} // namespace glint::gpu
