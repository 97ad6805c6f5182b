// A layer of the host's transparent surfaces: a G-buffer of its own over the opaque one. Light that comes through it is
// bent, absorbed and blurred, and it reflects. docs/techniques/refraction.md.
#pragma once

#include "glint/gbuffer.hpp"

#include <cstdint>

namespace glint {

/// What a body is taken for at each point of its surface. The number that TransparentLayer::body holds.
enum class BodyShape : uint8_t {
    Straight, ///< light goes on as it came: a blended surface, a wall without thickness
    Sphere,   ///< filled: a ball, a lens
    Plane,    ///< hollow: a plate, which turns the light back to its old direction
    Thin,     ///< a pane: a plate of 5 mm, whatever `body` says
};

/// At each pixel at most one surface, the layers themselves from back to front. All images are present unless said
/// otherwise, as large as the G-buffer, one sample a pixel. `depth`, `normal` and whether colours are sRGB-encoded are
/// as the G-buffer's conventions and settings say; everything else is as said here.
struct TransparentLayer {
    HostImage depth;    ///< background where the layer has nothing; where it lies behind the G-buffer's it is not seen
    HostImage normal;   ///< towards the eye
    HostImage material; ///< F0 in rgb, linear; perceptual roughness in a
    /// What the surface itself sends to the eye (diffuse, emission, highlights, and fallbackSpecular), multiplied by
    /// its coverage; a: coverage, [0, 1], of what is behind. 1 for all that transmits light by `transmittance`.
    HostImage radiance;
    HostImage fallbackSpecular; ///< may be absent: the part of `radiance` that reflections replace
    /// rgb: share of the light behind that comes through the surface, before Fresnel's part is taken away and without
    /// what is absorbed on the way; 0: opaque or merely blended. a: how much of a reflecting surface is there, [0, 1].
    HostImage transmittance;
    HostImage absorption; ///< rgb: colour that white light has taken after the distance in a, metres; a = 0: clear
    HostImage body;       ///< r: index of refraction; g: thickness, metres; b: a BodyShape's number
    /// May be absent. World position of the centre of the pixel's object, in 32-bit floats: probes are chosen there, so
    /// that no seam of theirs runs across an object.
    HostImage objectCenter;
    /// May be absent. r: how much of each pixel shows transparent surfaces, [0, 1], from a host that draws with several
    /// samples: pixels at edges, those of what stands before the layer too, get that part of it, also where `depth` has
    /// nothing at the pixel's centre.
    HostImage coverage;
};

} // namespace glint
