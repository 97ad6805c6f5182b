#include "gpu/mip_chain.hpp"

#include "base/assert.hpp"

#include <algorithm>

namespace glint::gpu {

Result<MipChain> MipChain::create(Context& context, uint32_t layers) {
    MipChain chain;
    GLINT_TRY(halve, Pipeline::compute(context, {layers > 1 ? "prefilter/mip_layers" : "prefilter/mip", 0, {}}));
    chain.halve_ = std::move(halve);
    if (layers == 1) {
        GLINT_TRY(copy, Pipeline::compute(context, {"prefilter/picture", 0, {}}));
        chain.copy_ = std::move(copy);
    }
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

void MipChain::makeFrom(Frame& frame, Image& picture, Image& image) const {
    GLINT_ASSERT(copy_, "made for images of several layers");
    frame.untimed([&] {
        frame.pass(copy_)
            .read("picture", picture, SamplerKind::NearestClamp)
            .write("copy", image, 0)
            .dispatch(image.width(), image.height());
    });
    make(frame, image);
}

} // namespace glint::gpu
