// SPDX-License-Identifier: MIT
// Planar mirrors: flat surfaces whose reflections the host draws from a mirrored camera. Glint computes the camera and
// a clip plane; the host provides the drawn image and its depth. Optional. docs/techniques/planar.md.
#pragma once

#include "glint/api.h"
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

/// A mirror rectangle in the world. Surfaces in its plane and within its outline belong to it.
struct PlanarMirror {
    std::array<float, 3> centerWS = {0, 0, 0};
    std::array<float, 3> normalWS = {0, 1, 0};  ///< unit, towards the reflecting side
    std::array<float, 3> tangentWS = {1, 0, 0}; ///< unit, perpendicular to the normal
    std::array<float, 2> halfExtents = {1, 1};  ///< metres, > 0: along the tangent and along cross(normal, tangent)
    /// Metres, maximum distance from the plane of surfaces that belong to the mirror, and offset of clipPlane
    /// towards the reflecting side. 0: 1/5000 of the longer half extent.
    float tolerance = 0;
};

/// The image that the host drew for a mirror.
struct PlanarPicture {
    HostImage radiance; ///< linear; any size and format; one sample per pixel
    HostImage depth;    ///< same size, any number of samples, conventions of PlanarMirrorsDesc
    View view;          ///< the view that it was drawn with, as mirroredView returned it
};

constexpr uint32_t kMaxPlanarMirrors = 16;

struct PlanarMirrorsDesc {
    std::span<const PlanarMirror> mirrors; ///< at most kMaxPlanarMirrors
    uint32_t width = 0;                    ///< pixels of the mirror images that Glint stores
    uint32_t height = 0;
    Conventions conventions; ///< depth encoding, clip space and view space of the host
};

/// Returns the mirrored camera, whose image shows what `view` sees in the mirror, flipped left to right. The flip keeps
/// triangle winding as in any other view. The host must not draw geometry behind clipPlane.
GLINT_API View mirroredView(const View& view, const PlanarMirror& mirror);
/// Returns the clip plane (n, d): the host draws only geometry with dot(n, positionWS) + d > 0. Clip in the shader
/// (gl_ClipDistance), since an oblique near plane would change depth.
GLINT_API std::array<float, 4> clipPlane(const PlanarMirror& mirror);
/// True if the camera is on the reflecting side, so that the mirror has an image to draw.
GLINT_API bool facesView(const PlanarMirror& mirror, const View& view);

/// Stores the images of the planar mirrors for Reflections::setPlanar. Threading: external synchronization.
class GLINT_API PlanarMirrors {
public:
    /// Creates an image with mips and a depth image for each mirror: 15 bytes per pixel.
    /// Errors: InvalidArgument names the mirror and the reason; OutOfMemory.
    static Result<PlanarMirrors> create(Context& context, const PlanarMirrorsDesc& desc);
    ~PlanarMirrors();
    PlanarMirrors(PlanarMirrors&&) noexcept;
    PlanarMirrors& operator=(PlanarMirrors&&) noexcept;

    uint32_t count() const;

    /// Sets new positions of the mirrors. Requires the same number of mirrors as in create.
    /// Errors: InvalidArgument as in create.
    Result<void> setMirrors(std::span<const PlanarMirror> mirrors);

    /// Records the copy of a mirror's image into Glint's own image, outside of rendering. The host's images are read by
    /// these commands only. Call it before Reflections::record for the view that the image was mirrored from; the image
    /// is valid for this view only. Never submits or waits.
    /// Errors: InvalidArgument if the images do not match the description.
    Result<void> record(VkCommandBuffer commands, uint32_t mirror, const PlanarPicture& picture);
    /// Declares that this mirror has no image, because it faces away, for example. The mirror has weight 0 until the
    /// next record, as after create.
    void skip(uint32_t mirror);

    reflect::PlanarState& state() { return *state_; } ///< for Glint's own classes

private:
    explicit PlanarMirrors(std::unique_ptr<reflect::PlanarState> state);
    std::unique_ptr<reflect::PlanarState> state_;
};

} // namespace glint
