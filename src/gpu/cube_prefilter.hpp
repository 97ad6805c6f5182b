// Cube maps filtered for every roughness by GGX: what the library does for a host's probes and our renderer for its
// environments. shaders/prefilter has the formulas.
#pragma once

#include "gpu/pass.hpp"

namespace glint::gpu {

/// Mips from a face of this size down to one of `last`; both are powers of two, `face` >= `last`.
uint32_t cubeMips(uint32_t face, uint32_t last);

constexpr uint32_t kLastFilteredFace = 8; ///< texels that a lobe of roughness 1 needs

class CubePrefilter {
public:
    /// `context` knows a set with shaders/prefilter.
    static Result<CubePrefilter> create(Context& context);

    /// A cube's mip 0 into those of `source` and `filtered`, which have one size, and the other mips of `source`.
    void copy(Frame& frame, Image& cube, Image& source, Image& filtered) const;
    /// Mips 1 and up of `filtered`, from `source` with its mips. Mip i stands for perceptual roughness i / (mips - 1).
    void filter(Frame& frame, Image& source, Image& filtered) const;

private:
    Pipeline copy_;
    Pipeline ggx_;
};

} // namespace glint::gpu
