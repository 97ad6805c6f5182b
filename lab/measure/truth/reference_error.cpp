#include "lab/measure/truth/reference_error.hpp"

#include <algorithm>

namespace glint::measure {

ReferencePicture::ReferencePicture(std::vector<float> radiance, std::span<const float> roughness,
                                   std::span<const float> reflectivity)
    : radiance_(std::move(radiance)), bands_(pixelBands(roughness, reflectivity)) {
    for (size_t i = 0; i < radiance_.size(); i += 4)
        mirrors_.push_back(reflectivity[i] > 0 && roughness[i] <= kMirrorRoughness);
}

ReferenceError ReferencePicture::errorOf(std::span<const float> picture) const {
    ReferenceError error;
    error.displayed = worstPixels(relativeErrors(radiance_, picture, kDisplayWhite));
    error.radiance = worstPixels(relativeErrors(radiance_, picture, kBrightestRelative));
    error.psnr = psnr(radiance_, picture);
    error.psnrMirrors = psnr(radiance_, picture, mirrors_);
    error.relativeMse = relativeMse(radiance_, picture);
    error.relativeMseMirrors = relativeMse(radiance_, picture, mirrors_);
    for (size_t band = 0; band <= kBands; ++band) {
        const std::vector<uint8_t> mask = bandMask(bands_, band);
        error.bands[band] = {static_cast<uint64_t>(std::ranges::count(mask, uint8_t{1})),
                             relativeMse(radiance_, picture, mask)};
    }
    error.mirrorPixels = static_cast<uint64_t>(std::ranges::count(mirrors_, uint8_t{1}));
    return error;
}

} // namespace glint::measure
