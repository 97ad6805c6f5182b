// What a rough surface that stands alone reflects of an environment, by quadrature: the truth for everything that looks
// an environment up.
#pragma once

#include "lab/scene/images/hdr_image.hpp"

namespace glint::measure {

struct ReflectingPoint {
    glm::dvec3 normal; ///< unit, in the picture's own space
    glm::dvec3 toEye;  ///< unit, above the surface
    double perceptualRoughness = 1;
};

/// The mean of the picture's radiance over the lobe that reflects to the eye: GGX with height-correlated Smith times
/// the cosine, divided by its integral, which is the directional albedo. It is the radiance of a white metal (F0 = 1)
/// whose energy is compensated (lib/brdf.glsl). Pixels have one radiance each, and are cut into parts where the lobe is
/// narrow. Based on: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"; Heitz 2014,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 99.
glm::dvec3 specularIntegral(const scene::HdrImage& equirect, const ReflectingPoint& at);

} // namespace glint::measure
