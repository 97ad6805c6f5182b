// Planar mirrors: flat surfaces whose reflections the host draws, from a camera behind the mirror. Glint hands out that
// camera and a clip plane; the host hands back the picture and its depth. Optional. docs/techniques/planar.md.
#pragma once

#include "glint/api.hpp"
#include "glint/context.hpp"
#include "glint/gbuffer.hpp"
#include "glint/view.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace glint {

namespace reflect {
class PlanarState;
}

/// A rectangle in the world. Surfaces belong to it that lie in its plane and within its outline.
struct PlanarMirror {
    std::array<float, 3> centerWS = {0, 0, 0};
    std::array<float, 3> normalWS = {0, 1, 0};  ///< unit, to the side that reflects
    std::array<float, 3> tangentWS = {1, 0, 0}; ///< unit, across the normal
    std::array<float, 2> halfExtents = {1, 1};  ///< metres, > 0: along the tangent, and along cross(normal, tangent)
    /// Metres off the plane within which surfaces belong to it and nothing is drawn behind it; 0: a five-thousandth of
    /// the longer half extent.
    float tolerance = 0;
};

/// What the host drew for a mirror.
struct PlanarPicture {
    HostImage radiance; ///< linear; size and format are free; one sample a pixel
    HostImage depth;    ///< of the same size, any number of samples, with the conventions of PlanarMirrorsDesc
    View view;          ///< that it was drawn with, as mirroredView gave it
};

constexpr uint32_t kMaxPlanarMirrors = 16;

struct PlanarMirrorsDesc {
    std::span<const PlanarMirror> mirrors; ///< at most kMaxPlanarMirrors
    uint32_t width = 0;                    ///< pixels of the pictures that Glint keeps of them
    uint32_t height = 0;
    Conventions conventions; ///< how the host stores depth, which way its picture and its view space go
};

/// The camera that sees in its picture what `view` sees in the mirror, left and right exchanged so that it stays a
/// camera like any other: no winding turns round. What lies behind the clip plane must not be drawn.
GLINT_API View mirroredView(const View& view, const PlanarMirror& mirror);
/// (n, d): only what has dot(n, positionWS) + d > 0 belongs into the picture. A plane for the shader: depth stays what
/// it is, as it does not with an oblique near plane.
GLINT_API std::array<float, 4> clipPlane(const PlanarMirror& mirror);
/// Whether the eye is on the side that reflects, and so there is anything to draw.
GLINT_API bool facesView(const PlanarMirror& mirror, const View& view);

/// Threading: external synchronisation.
class GLINT_API PlanarMirrors {
public:
    /// Makes a picture with mips and a depth image for each mirror: 15 bytes a pixel.
    /// Errors: InvalidArgument names the mirror and what is wrong with it; OutOfMemory. `context` must outlive them.
    static Result<PlanarMirrors> create(Context& context, const PlanarMirrorsDesc& desc);
    ~PlanarMirrors();
    PlanarMirrors(PlanarMirrors&&) noexcept;
    PlanarMirrors& operator=(PlanarMirrors&&) noexcept;

    uint32_t count() const;

    /// Where they are now, as many as there were. Errors: InvalidArgument as in create.
    Result<void> setMirrors(std::span<const PlanarMirror> mirrors);

    /// Records the taking over of a mirror's picture, outside of rendering; the host's images are read here alone.
    /// Before Reflections::record for the view that it was mirrored from, and for no other. Never submits or waits.
    /// Errors: InvalidArgument if the images do not fit.
    Result<void> record(VkCommandBuffer commands, uint32_t mirror, const PlanarPicture& picture);
    /// There is no picture of this mirror, which faces the other way, say: it does not answer until the next one. As
    /// after create.
    void skip(uint32_t mirror);

    reflect::PlanarState& state() { return *state_; } ///< for Glint's own classes

private:
    explicit PlanarMirrors(std::unique_ptr<reflect::PlanarState> state);
    std::unique_ptr<reflect::PlanarState> state_;
};

} // namespace glint
