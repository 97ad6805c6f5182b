// A second camera that shows the inspected ray from the side.
#pragma once

#include "glint/inspection.hpp"
#include "lab/renderer/view.hpp"
#include "lab/view/orbit_camera.hpp"

#include <span>
#include <vector>

namespace glint::view {

struct SecondCamera {
    bool shown = false;
    bool placed = false; ///< it has a target
    bool sawRay = false; ///< a ray existed when the target was last chosen
    bool turned = false; ///< moved by the user, so that it is no longer placed automatically
    OrbitCamera camera;
    float cut = 0;                   ///< metres along the view axis: nearer geometry is cut away
    glm::uvec2 size = glm::uvec2(0); ///< size of its pane in pixels; 0: not yet drawn
    render::View view;               ///< view of its last picture
    std::vector<float> depth;        ///< of that picture: metres along the view axis, one number per pixel

    /// Looks at the ray from the side, from a position that the inspecting camera sees, so that no wall is in between.
    /// `asked`       the view that the ray was traced in
    /// `asking`      its camera, whose lens is used
    /// `askedDepth`  metres along that view's axis, one number per pixel
    void lookAt(const RayInspection& ray, const render::View& asked, std::span<const float> askedDepth,
                const scene::Camera& asking);
    /// Looks at the orbit target of the inspecting camera.
    void lookAt(const OrbitCamera& asking);
    /// True if the picture shows a nearer surface at this pixel.
    bool hides(glm::vec2 px, float metres) const;
};

} // namespace glint::view
