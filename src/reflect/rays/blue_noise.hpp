// A tile of blue noise: numbers of which each is unlike its neighbours', so that errors made with them are
// fine-grained.
#pragma once

#include <cstdint>
#include <span>

namespace glint::reflect {

/// kBlueNoiseSize^2 texels by rows: two independent ranks of 16 bits each, low and high, evenly spread over their
/// range. The tile repeats without seams. Made at the first call, in some 100 ms; the same on every machine.
std::span<const uint32_t> blueNoiseMask();

} // namespace glint::reflect
