// What a screen-space ray should find: for each reflective pixel of a G-buffer the exact mirror ray's first hit on the
// scene's triangles, and whether the picture shows that point (docs/truth.md).
#pragma once

#include "measure/ray_oracle.hpp"
#include "render/view.hpp"

#include <span>
#include <vector>

namespace glint::measure {

/// Where the exact ray's first hit is, as seen from the camera.
enum class TruthKind : uint8_t {
    NoRay,        ///< background, or nothing that reflects
    Visible,      ///< the picture shows it
    OffScreen,    ///< outside the picture
    Hidden,       ///< behind what the picture shows there
    BehindCamera, ///< not in front of the near plane
    Nothing,      ///< the ray meets no triangle
};
constexpr size_t kTruthKinds = 6;

struct RayTruth {
    TruthKind kind = TruthKind::NoRay;
    bool dips = false;           ///< a leaning shading normal sends the ray below its own triangle
    bool facesAway = false;      ///< the triangle hit shows the camera its other side
    float distance = 0;          ///< metres along the ray; 0 with NoRay and Nothing
    glm::vec2 px = glm::vec2(0); ///< pixels, centres at .5; 0 where it is not in front of the camera
    glm::vec3 positionWS = glm::vec3(0);
};

/// A G-buffer as views give it: four floats a pixel, rows from the top.
struct GBufferPicture {
    std::span<const float> viewZ;    ///< x: metres along the view axis, 0: background
    std::span<const float> normalWS; ///< xyz: what the tracer reflected at
    std::span<const float> material; ///< rgb: F0, a: perceptual roughness
};

/// F0 up to here counts as none: half a step of 8 bits, below which no tracer can be expected to see it.
constexpr float kLeastF0 = 1.0f / 510;

/// One entry a pixel. The ray starts at the G-buffer's position and leaves in the mirror direction of its normal; what
/// lies nearer than `kStartSkip` times viewZ is the start's own neighbourhood.
/// The truth is visible if it projects into the picture, in front of the near plane, and the depth there is its own:
/// within 1 % of its viewZ, or what its triangle's depth changes by over one pixel, whichever is larger.
/// `view`  the one that the G-buffer was drawn with
/// Threading: uses all cores. A 1280x720 picture takes a second or two.
std::vector<RayTruth> traceTruth(const RayOracle& oracle, const render::View& view, const GBufferPicture& gbuffer);

constexpr double kStartSkip = 1e-4; ///< of viewZ: half a pixel of a 720-line picture

} // namespace glint::measure
