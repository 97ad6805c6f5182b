// The images of a host's G-buffer: one table for whoever checks, borrows or returns them.
#pragma once

#include "reflect/host.hpp"
#include "reflect/input_checks.hpp"

#include <array>

namespace glint::reflect {

struct GBufferImage {
    const char* name;
    HostImage GBuffer::*host;
    gpu::Image Inputs::*borrowed;
    bool (*required)(const Conventions& conventions);
    ImageRole role;
    bool ofSurfaces; ///< as many samples a pixel as `depth`; all others have one
    bool ownSize;    ///< any size; all others have the frame's
};

namespace needed {

inline bool always(const Conventions&) {
    return true;
}
inline bool never(const Conventions&) {
    return false;
}
inline bool byMaterials(const Conventions& conventions) {
    return conventions.material != MaterialKind::Standard;
}
inline bool byMetals(const Conventions& conventions) {
    return conventions.material == MaterialKind::MetallicRoughness;
}

} // namespace needed

constexpr std::array<GBufferImage, 8> kGBufferImages = {{
    {"depth", &GBuffer::depth, &Inputs::depth, needed::always, ImageRole::Depth, true, false},
    {"normal", &GBuffer::normal, &Inputs::normal, needed::always, ImageRole::Color, true, false},
    {"material", &GBuffer::material, &Inputs::material, needed::byMaterials, ImageRole::Color, true, false},
    {"baseColor", &GBuffer::baseColor, &Inputs::baseColor, needed::byMetals, ImageRole::Color, true, false},
    {"litRadiance", &GBuffer::litRadiance, &Inputs::litRadiance, needed::always, ImageRole::Color, false, false},
    {"fallbackSpecular", &GBuffer::fallbackSpecular, &Inputs::fallbackSpecular, needed::never, ImageRole::Color, false,
     false},
    {"backDepth", &GBuffer::backDepth, &Inputs::backDepth, needed::never, ImageRole::Depth, false, true},
    {"motion", &GBuffer::motion, &Inputs::motion, needed::never, ImageRole::Color, false, false},
}};

} // namespace glint::reflect
