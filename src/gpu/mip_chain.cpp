#include "gpu/mip_chain.hpp"

#include <algorithm>

namespace glint::gpu {

Result<MipChain> MipChain::create(Context& context, uint32_t layers) {
    MipChain chain;
    GLINT_TRY(halve, Pipeline::compute(context, {layers > 1 ? "prefilter/mip_layers" : "prefilter/mip", 0, {}}));
    chain.halve_ = std::move(halve);
    return chain;
}

void MipChain::make(Frame& frame, Image& image) const {
    frame.untimed([&] {
        for (uint32_t mip = 1; mip < image.desc().mips; ++mip)
            frame.pass(halve_)
                .readWrite("finer", image, mip - 1)
                .write("coarser", image, mip)
                .dispatch(std::max(image.width() >> mip, 1u), std::max(image.height() >> mip, 1u), image.desc().layers);
    });
}

} // namespace glint::gpu
