// A camera beside the one that asks: it sees the asked ray from the side.
#pragma once

#include "glint/inspection.hpp"
#include "orbit_camera.hpp"
#include "render/view.hpp"

#include <span>
#include <vector>

namespace glint::view {

struct SecondCamera {
    bool shown = false;
    bool placed = false; ///< there is something that it looks at
    bool sawRay = false; ///< there was a ray when it was last asked what to look at
    bool turned = false; ///< by hand: it stays where it is
    OrbitCamera camera;
    float cut = 0;                   ///< metres along the view axis: what is nearer is left out
    glm::uvec2 size = glm::uvec2(0); ///< of its pane, pixels; 0: not drawn yet
    render::View view;               ///< that of its last picture
    std::vector<float> depth;        ///< of that picture: metres along the view axis, a number a pixel

    /// Looks at the ray from the side, from a place that the asking camera sees: no wall is in between there.
    /// `asked`  the view that the ray was asked in, `asking` its camera, whose lens is taken
    /// `askedDepth`  metres along that view's axis, a number a pixel
    void lookAt(const RayInspection& ray, const render::View& asked, std::span<const float> askedDepth,
                const scene::Camera& asking);
    /// Looks at what the asking camera turns about.
    void lookAt(const OrbitCamera& asking);
    /// Whether the picture shows something nearer at this pixel.
    bool hides(glm::vec2 px, float metres) const;
};

} // namespace glint::view
