// The exact result of screen-space rays: for each reflective pixel of a G-buffer, the first hit of the exact mirror ray
// on the scene's triangles, and whether that point is visible in the image (docs/truth.md).
#pragma once

#include "lab/measure/truth/ray_oracle.hpp"
#include "lab/renderer/view.hpp"

#include <span>
#include <vector>

namespace glint::measure {

/// The position of the exact ray's first hit, as seen from the camera.
enum class TruthKind : uint8_t {
    NoRay,        ///< background, or a surface that does not reflect
    Visible,      ///< visible in the image
    OffScreen,    ///< outside the image
    Hidden,       ///< behind the visible surface at that pixel
    BehindCamera, ///< not in front of the near plane
    Nothing,      ///< the ray hits no triangle
};
constexpr size_t kTruthKinds = 6;

/// What a ray meets: an item of the pose and its material; none: no triangle.
struct MetSurface {
    int item = -1;
    int material = -1;
    bool operator==(const MetSurface&) const = default;
};

struct RayTruth {
    TruthKind kind = TruthKind::NoRay;
    bool dips = false;           ///< an interpolated shading normal sends the ray below its own triangle
    bool facesAway = false;      ///< the camera sees the other side of the hit triangle
    float distance = 0;          ///< metres along the ray; 0 with NoRay and Nothing
    glm::vec2 px = glm::vec2(0); ///< pixels, centres at .5; 0 if the hit is not in front of the camera
    glm::vec3 positionWS = glm::vec3(0);
    glm::vec3 normalWS = glm::vec3(0);
    MetSurface met;   ///< by the exact ray
    MetSurface shown; ///< by the eye's ray through the pixel's centre, also with NoRay
};

/// A G-buffer as its views: four floats per pixel, rows from the top.
struct GBufferPicture {
    std::span<const float> viewZ;    ///< x: metres along the view axis, 0: background
    std::span<const float> normalWS; ///< xyz: the normal that the tracer reflected at
    std::span<const float> material; ///< rgb: F0, a: perceptual roughness
};

/// F0 up to this value counts as none: half a step of 8 bits, which a tracer cannot be expected to represent.
constexpr float kLeastF0 = 1.0f / 510;

/// Returns one entry per pixel. The ray starts at the G-buffer's position, in the mirror direction of its normal. Hits
/// nearer than `kStartSkip` times viewZ are ignored, as they are on the neighbourhood of the start. The true hit is
/// visible if it projects into the image, in front of the near plane, and the depth there agrees: within 1 % of its
/// viewZ or the depth change of its triangle over one pixel, whichever is larger.
/// `view`  the view that the G-buffer was drawn with
/// Threading: uses all cores. A 1280x720 image takes a second or two.
std::vector<RayTruth> traceTruth(const RayOracle& oracle, const render::View& view, const GBufferPicture& gbuffer);

constexpr double kStartSkip = 1e-4; ///< of viewZ: half a pixel of a 720-line image

} // namespace glint::measure
