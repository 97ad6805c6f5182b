// The images of a host's G-buffer, and the scalars of its material: one table of each for whoever checks, borrows or
// returns them.
#pragma once

#include "reflect/host.hpp"
#include "reflect/input_checks.hpp"

#include <array>

namespace glint::reflect {

struct GBufferImage {
    const char* name;
    HostImage GBuffer::*host;
    gpu::Image Inputs::*borrowed;
    bool (*required)(const GBuffer& gbuffer);
    ImageRole role;
    bool ofSurfaces; ///< as many samples a pixel as `depth`; all others have one
    bool ownSize;    ///< any size; all others have the frame's
};

namespace needed {

inline bool always(const GBuffer&) {
    return true;
}
inline bool never(const GBuffer&) {
    return false;
}
inline bool byRoughness(const GBuffer& gbuffer) {
    return gbuffer.conventions.material != MaterialKind::Standard;
}
inline bool byMetals(const GBuffer& gbuffer) {
    return gbuffer.conventions.material == MaterialKind::MetallicRoughness;
}
/// The colour of the material; scalars that are stored in the image ask for it themselves.
inline bool byColors(const GBuffer& gbuffer) {
    return byRoughness(gbuffer) && !byMetals(gbuffer);
}

} // namespace needed

constexpr std::array<GBufferImage, 10> kGBufferImages = {{
    {"depth", &GBuffer::depth, &Inputs::depth, needed::always, ImageRole::Depth, true, false},
    {"normal", &GBuffer::normal, &Inputs::normal, needed::always, ImageRole::Color, true, false},
    {"material", &GBuffer::material, &Inputs::material, needed::byColors, ImageRole::Color, true, false},
    {"baseColor", &GBuffer::baseColor, &Inputs::baseColor, needed::byMetals, ImageRole::Color, true, false},
    {"litRadiance", &GBuffer::litRadiance, &Inputs::litRadiance, needed::always, ImageRole::Color, false, false},
    {"fallbackSpecular", &GBuffer::fallbackSpecular, &Inputs::fallbackSpecular, needed::never, ImageRole::Color, false,
     false},
    {"backDepth", &GBuffer::backDepth, &Inputs::backDepth, needed::never, ImageRole::Depth, false, true},
    {"transparentDepth", &GBuffer::transparentDepth, &Inputs::transparentDepth, needed::never, ImageRole::Depth, false,
     false},
    {"motion", &GBuffer::motion, &Inputs::motion, needed::never, ImageRole::Color, false, false},
    {"coatNormal", &GBuffer::coatNormal, &Inputs::coatNormal, needed::never, ImageRole::Color, true, false},
}};

/// A scalar of the material: GBuffer states the image that holds it.
struct MaterialScalar {
    const char* name;
    MaterialChannel GBuffer::*stated;
    gpu::Image Inputs::*own; ///< borrowed, unless another image of the G-buffer holds the scalar
    bool (*used)(const GBuffer& gbuffer);
    bool ofSurfaces; ///< as many samples a pixel as `depth`; all others have one

    /// True if the scalar is read from an image.
    bool isRead(const GBuffer& gbuffer) const { return used(gbuffer) && (gbuffer.*stated).scale != 0; }
    const HostImage& image(const GBuffer& gbuffer) const {
        const HostImage& image = (gbuffer.*stated).image;
        return image ? image : gbuffer.material;
    }
};

constexpr std::array<MaterialScalar, Inputs::kScalars> kMaterialScalars = {{
    {"roughness", &GBuffer::roughness, &Inputs::roughness, needed::byRoughness, true},
    {"metallic", &GBuffer::metallic, &Inputs::metallic, needed::byMetals, true},
    {"specular", &GBuffer::specular, &Inputs::specular, needed::byMetals, true},
    {"occlusion", &GBuffer::occlusion, &Inputs::occlusion, needed::always, false},
    {"f90", &GBuffer::f90, &Inputs::f90, needed::byRoughness, true},
    {"coat", &GBuffer::coat, &Inputs::coat, needed::always, true},
    {"coatRoughness", &GBuffer::coatRoughness, &Inputs::coatRoughness, needed::always, true},
}};

/// True if both are one image, seen through one view.
inline bool isSameImage(const HostImage& a, const HostImage& b) {
    return a.image == b.image && a.view == b.view;
}

} // namespace glint::reflect
