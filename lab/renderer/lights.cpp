#include "lab/renderer/lights.hpp"

#include "base/log.hpp"

#include <algorithm>
#include <cmath>

namespace glint::render {

std::vector<shared::Light> gpuLights(const scene::Pose& pose) {
    std::vector<shared::Light> lights;
    for (const scene::PosedLight& posed : pose.lights) {
        if (lights.size() + scene::kMostStrongLights >= shared::kMaxLights) {
            log::warning("the scene has {} lights; the first {} are used", pose.lights.size(), lights.size());
            break;
        }
        const scene::Light& light = posed.light;
        shared::Light out = {};
        out.type = light.type == scene::LightType::Directional ? shared::kLightDirectional
                   : light.type == scene::LightType::Point     ? shared::kLightPoint
                                                               : shared::kLightSpot;
        out.color = light.color * light.intensity;
        out.positionWS = posed.positionWS;
        out.directionWS = posed.directionWS;
        out.range = std::isfinite(light.range) ? light.range : 0;
        // KHR_lights_punctual, "Inner and Outer Cone Angles": the reference falloff, as scale and offset.
        const float cosOuter = std::cos(light.outerConeAngle);
        out.spotScale = 1 / std::max(std::cos(light.innerConeAngle) - cosOuter, 0.001f);
        out.spotOffset = -cosOuter * out.spotScale;
        lights.push_back(out);
    }
    return lights;
}

glm::vec3 rotateFromEnvironment(const glm::vec3& direction, float degrees) {
    const float angle = glm::radians(degrees);
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return {c * direction.x + s * direction.z, direction.y, -s * direction.x + c * direction.z};
}

shared::Light sunLight(const Sun& sun, const EnvironmentSettings& settings) {
    shared::Light out = {};
    out.type = shared::kLightDirectional;
    out.color = sun.irradiance * settings.strength;
    out.directionWS = -rotateFromEnvironment(sun.direction, settings.rotation);
    out.angularRadius = sun.angularRadius;
    return out;
}

} // namespace glint::render
