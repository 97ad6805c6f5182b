#include "lab/renderer/view.hpp"

#include <cmath>

namespace glint::render {

glm::mat4 projection(const scene::Camera& camera, float aspectRatio) {
    glm::mat4 viewToClip(0);
    if (camera.orthographic) {
        constexpr float kLongest = 1000; // metres; an orthographic depth range must be finite
        const float far = std::isfinite(camera.far) ? camera.far : camera.near + kLongest;
        const float depthPerMetre = 1 / (far - camera.near);
        viewToClip[0][0] = 2 / (camera.orthoHeight * aspectRatio);
        viewToClip[1][1] = 2 / camera.orthoHeight;
        viewToClip[2][2] = depthPerMetre; // viewZ = -z
        viewToClip[3][2] = far * depthPerMetre;
        viewToClip[3][3] = 1;
        return viewToClip;
    }
    // Upchurch, Desbrun 2012, "Tightening the Precision of Perspective Rendering", with near and far exchanged.
    const float focal = 1 / std::tan(camera.fovY / 2);
    viewToClip[0][0] = focal / aspectRatio;
    viewToClip[1][1] = focal;
    viewToClip[2][3] = -1;
    viewToClip[3][2] = camera.near;
    return viewToClip;
}

View makeView(const scene::Camera& camera, uint32_t width, uint32_t height, glm::vec2 jitterPX) {
    View view;
    view.width = width;
    view.height = height;
    view.orthographic = camera.orthographic;
    view.viewToWorld = camera.viewToWorld;
    view.worldToView = glm::inverse(camera.viewToWorld);
    view.jitterUV = jitterPX / glm::vec2(width, height);
    glm::mat4 jitter(1);
    jitter[3][0] = 2 * view.jitterUV.x;
    jitter[3][1] = -2 * view.jitterUV.y;
    view.viewToClip = jitter * projection(camera, static_cast<float>(width) / static_cast<float>(height));
    view.worldToClip = view.viewToClip * view.worldToView;
    view.clipToWorld = glm::inverse(view.worldToClip);
    return view;
}

} // namespace glint::render
