// SPDX-License-Identifier: MIT
// A layer of the host's transparent surfaces, stored as a G-buffer in front of the opaque one. Glint refracts, absorbs
// and blurs the light behind the layer and adds the layer's reflections. docs/techniques/refraction.md.
#pragma once

#include "glint/gbuffer.hpp"

#include <cstdint>

namespace glint {

/// Shape that refraction assumes for a body at each point of its surface. TransparentLayer::body stores its number.
enum class BodyShape : uint8_t {
    Straight, ///< no refraction: a blended surface, a wall without thickness
    Sphere,   ///< a solid sphere: a ball, a lens
    Plane,    ///< a hollow body, as a plate: light leaves it in its original direction
    Thin,     ///< a pane: a plate of 5 mm, whatever thickness `body` has
};

/// A layer holds at most one surface per pixel. The host records layers from back to front. All images are required
/// unless marked optional, have the size of the G-buffer and one sample per pixel. `depth` and `normal` follow the
/// G-buffer's conventions, and colours are sRGB-encoded if the settings say so for the G-buffer. All other encodings
/// are stated here.
struct TransparentLayer {
    HostImage depth;    ///< background depth where the layer is empty; surfaces behind the G-buffer's depth are hidden
    HostImage normal;   ///< towards the camera
    HostImage material; ///< F0 in rgb, linear; perceptual roughness in a
    /// rgb: radiance of the surface itself (diffuse, emission, highlights and fallbackSpecular), multiplied by its
    /// coverage. a: coverage of the background by the surface, [0, 1]; 1 if the surface transmits light by
    /// `transmittance`.
    HostImage radiance;
    HostImage fallbackSpecular; ///< optional: the part of `radiance` that reflections replace
    /// rgb: transmittance of the surface, excluding Fresnel reflection and absorption inside the body; 0: opaque or
    /// blended only. a: coverage of the reflecting surface, [0, 1].
    HostImage transmittance;
    /// rgb: transmittance colour; a: absorption distance, metres after which white light has taken this colour; 0: no
    /// absorption.
    HostImage absorption;
    /// r: index of refraction; g: thickness, metres; b: number of a BodyShape; a: dispersion as 20 / Abbe number,
    /// 0: no dispersion.
    HostImage body;
    /// Optional. World position of the centre of the pixel's object, in 32-bit floats. Probes are selected at this
    /// position, so that no probe boundary crosses an object.
    HostImage objectCenter;
    /// Optional, from a host that draws with several samples. r: fraction of each pixel that the layer covers, [0, 1],
    /// less what solid objects in front hide. g: the part of it that shows surfaces of the layer in front of that in
    /// `depth`, which miss the pixel's centre; an image of one channel has none. Edge pixels blend these fractions.
    /// Where `depth` is background, all of the layer misses the centre. What misses it is taken from adjacent pixels.
    HostImage coverage;
};

} // namespace glint
