// Base of the renderer's tests: scenes put together in a few lines, drawn headless, read back as floats.
#pragma once

#include "tests/gpu/support/gpu_test.hpp"

#include "lab/renderer/renderer.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace glint::test {

/// Pixels as RGBA floats, rows from the top.
struct Picture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> texels;
    glm::vec4 at(uint32_t x, uint32_t y) const {
        const float* p = &texels[(size_t{y} * width + x) * 4];
        return {p[0], p[1], p[2], p[3]};
    }
    glm::vec3 center() const { return at(width / 2, height / 2); }
};

inline float largestChannel(const glm::vec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// A scene of single primitives, each with a material, and of lights.
struct SceneParts {
    scene::Scene scene;

    void add(scene::Geometry geometry, const scene::Material& material, const glm::mat4& transform = glm::mat4(1));
    void addLight(const scene::Light& light, const glm::vec3& position, const glm::vec3& direction);
};

/// A square in z = 0 that faces +Z, 2 * halfExtent wide.
scene::Geometry square(float halfExtent);
scene::Geometry ball(float radius);

/// Metallic, white, of this roughness; or a dielectric without reflections of this base colour.
scene::Material metal(float perceptualRoughness, const glm::vec3& color = glm::vec3(1));
scene::Material matte(const glm::vec3& color);
scene::Material emissive(const glm::vec3& radiance);

/// Looks along -Z from z = 10 at a square of the world `height` metres high.
scene::Camera orthographicCamera(float height);

/// Every direction has the radiance that `radiance` gives it.
scene::HdrImage environmentPicture(uint32_t width, const std::function<glm::vec3(const glm::vec3&)>& radiance);

class RenderTest : public GpuTest {
protected:
    static gpu::Context& gpu();

    struct Frame { ///< images with several samples a pixel are left empty
        Picture lit;
        Picture depth;
        Picture normal;
        Picture material;
        Picture fallback;
        Picture motion;
        Picture backDepth; ///< empty unless asked for
    };
    /// Draws everything, transparent surfaces too. Without a picture the environment is black.
    static Frame draw(const SceneParts& parts, const render::ViewParameters& view, uint32_t width, uint32_t height,
                      const scene::HdrImage& environment = {}, const render::RenderSettings& settings = {},
                      const render::GBufferOptions& options = {});
};

} // namespace glint::test
