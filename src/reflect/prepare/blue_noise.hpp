// A tile of blue noise: neighbouring values differ strongly, so that errors made with them are fine-grained.
#pragma once

#include <cstdint>
#include <span>

namespace glint::reflect {

/// Returns kBlueNoiseSize^2 texels in rows: two independent ranks of 16 bits each, low and high, uniformly distributed.
/// The tile repeats without seams. Computed in the first call, in about 100 ms; identical on every machine.
std::span<const uint32_t> blueNoiseMask();

} // namespace glint::reflect
