#include "lab/scene/gltf/lenses_lights.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace glint::scene::gltf {
namespace {

/// Returns a required number above 0.
float positive(const JsonObject& object, const char* key) {
    if (!object.has(key)) {
        object.failMissing(key);
        return 1;
    }
    const float value = object.number(key, 1);
    if (!(value > 0))
        object.diagnostics().fail("{} is {} but must be above 0", object.pathOf(key), value);
    return value;
}

void readPerspective(const JsonObject& object, Lens& lens) {
    lens.fovY = positive(object, "yfov");
    if (lens.fovY >= glm::pi<float>())
        object.diagnostics().fail("{} is {} but must be below pi (radians)", object.pathOf("yfov"), lens.fovY);
    if (object.has("aspectRatio"))
        lens.aspectRatio = positive(object, "aspectRatio");
    lens.near = positive(object, "znear");
    lens.far = object.has("zfar") ? positive(object, "zfar") : std::numeric_limits<float>::infinity();
}

void readOrthographic(const JsonObject& object, Lens& lens) {
    lens.orthographic = true;
    const float halfWidth = positive(object, "xmag");
    const float halfHeight = positive(object, "ymag");
    lens.orthoHeight = 2 * halfHeight;
    lens.aspectRatio = halfWidth / halfHeight;
    lens.near = object.number("znear", 0, 0);
    lens.far = positive(object, "zfar");
}

LightType readLightType(const JsonObject& object) {
    const std::string type = object.string("type");
    if (type == "point")
        return LightType::Point;
    if (type == "spot")
        return LightType::Spot;
    if (type != "directional")
        object.diagnostics().fail("{} is \"{}\", which is none of directional, point and spot", object.pathOf("type"),
                                  type);
    return LightType::Directional;
}

} // namespace

void readCameras(Document& document, Scene& scene) {
    for (const JsonObject& object : document.root().objects("cameras")) {
        Lens lens;
        lens.name = object.string("name");
        const std::string type = object.string("type");
        if (type == "perspective")
            readPerspective(object.object("perspective"), lens);
        else if (type == "orthographic")
            readOrthographic(object.object("orthographic"), lens);
        else
            document.diagnostics.fail("{} is \"{}\", which is neither perspective nor orthographic",
                                      object.pathOf("type"), type);
        if (!(lens.far > lens.near))
            document.diagnostics.fail("{}: zfar {} must be beyond znear {}", object.path(), lens.far, lens.near);
        scene.cameras.push_back(std::move(lens));
    }
}

void readLights(Document& document, Scene& scene) {
    const JsonObject extension = document.root().extension("KHR_lights_punctual");
    for (const JsonObject& object : extension.objects("lights")) {
        Light light;
        light.name = object.string("name");
        light.type = readLightType(object);
        light.color = glm::max(object.vector<3>("color", glm::vec3(1)), 0.0f);
        light.intensity = object.number("intensity", 1, 0);
        if (object.has("range"))
            light.range = positive(object, "range");
        const JsonObject spot = object.object("spot");
        light.outerConeAngle = spot.number("outerConeAngle", glm::quarter_pi<float>(), 1e-3f, glm::half_pi<float>());
        light.innerConeAngle = std::min(spot.number("innerConeAngle", 0, 0), light.outerConeAngle);
        scene.lights.push_back(std::move(light));
    }
}

} // namespace glint::scene::gltf
