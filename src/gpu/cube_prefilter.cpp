#include "gpu/cube_prefilter.hpp"

#include "shared/environment.h"

#include <algorithm>
#include <bit>

namespace glint::gpu {
namespace {

/// Wide lobes are stored in small faces, so the total samples per mip stay about the same.
uint32_t sampleCount(uint32_t mip) {
    return std::min(64u << (2 * (mip - 1)), 1024u);
}

} // namespace

uint32_t cubeMips(uint32_t face, uint32_t last) {
    return static_cast<uint32_t>(std::countr_zero(face) - std::countr_zero(last)) + 1;
}

Result<CubePrefilter> CubePrefilter::create(Context& context) {
    CubePrefilter result;
    GLINT_TRY(copy, Pipeline::compute(context, {"prefilter/copy", 0, {}}));
    GLINT_TRY(ggx, Pipeline::compute(context, {"prefilter/ggx", sizeof(shared::PrefilterConstants), {}}));
    GLINT_TRY(mips, MipChain::create(context, 6));
    result.mips_ = std::move(mips);
    result.copy_ = std::move(copy);
    result.ggx_ = std::move(ggx);
    return result;
}

void CubePrefilter::copy(Frame& frame, Image& cube, Image& source, Image& filtered) const {
    frame.pass(copy_)
        .read("cube", cube)
        .write("source", source)
        .write("filtered", filtered)
        .dispatch(source.width(), source.width(), 6);
    mips_.make(frame, source);
}

void CubePrefilter::filter(Frame& frame, Image& source, Image& filtered) const {
    const uint32_t mips = filtered.desc().mips;
    for (uint32_t mip = 1; mip < mips; ++mip) {
        const shared::PrefilterConstants constants = {filtered.width() >> mip, sampleCount(mip),
                                                      static_cast<float>(mip) / static_cast<float>(mips - 1),
                                                      static_cast<float>(source.width())};
        frame.pass(ggx_)
            .read("source", source)
            .write("filtered", filtered, mip)
            .push(constants)
            .dispatch(constants.faceSize, constants.faceSize, 6);
    }
}

} // namespace glint::gpu
