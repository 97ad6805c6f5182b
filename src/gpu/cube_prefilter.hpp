// Cube maps filtered by GGX for every roughness: used by the library for a host's probes and by our renderer for its
// environments. shaders/prefilter contains the formulas.
#pragma once

#include "gpu/mip_chain.hpp"
#include "gpu/pass.hpp"

namespace glint::gpu {

/// Returns the number of mips from a face size of `face` down to `last`; both are powers of two, `face` >= `last`.
uint32_t cubeMips(uint32_t face, uint32_t last);

constexpr uint32_t kLastFilteredFace = 8; ///< texels; a lobe of roughness 1 needs no fewer

class CubePrefilter {
public:
    /// Requires that `context` has a registered set with shaders/prefilter.
    static Result<CubePrefilter> create(Context& context);

    /// Copies mip 0 of `cube` to mip 0 of `source` and `filtered`, which have the same size, and makes the other mips
    /// of `source`.
    void copy(Frame& frame, Image& cube, Image& source, Image& filtered) const;
    /// Fills mips 1 and up of `filtered` from `source` with its mips. Mip i has perceptual roughness i / (mips - 1).
    void filter(Frame& frame, Image& source, Image& filtered) const;

private:
    Pipeline copy_;
    Pipeline ggx_;
    MipChain mips_;
};

} // namespace glint::gpu
