#include "lab/tests/render/support/render_test.hpp"

#include "lab/scene/builtin/shapes.hpp"

namespace glint::test {

void SceneParts::add(scene::Geometry geometry, const scene::Material& material, const glm::mat4& transform) {
    if (scene.scenes.empty())
        scene.scenes.emplace_back();
    scene::Primitive primitive;
    primitive.geometry = std::move(geometry);
    primitive.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene::Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    scene::Node node;
    node.mesh = static_cast<int>(scene.meshes.size());
    node.matrix = transform;
    scene.meshes.push_back(std::move(mesh));
    scene.scenes[0].nodes.push_back(static_cast<int>(scene.nodes.size()));
    scene.nodes.push_back(std::move(node));
}

void SceneParts::addLight(const scene::Light& light, const glm::vec3& position, const glm::vec3& direction) {
    scene::Node node;
    node.light = static_cast<int>(scene.lights.size());
    node.matrix = scene::lookAt(position, position + direction);
    scene.lights.push_back(light);
    scene.scenes[0].nodes.push_back(static_cast<int>(scene.nodes.size()));
    scene.nodes.push_back(std::move(node));
}

scene::Geometry square(float halfExtent) {
    const glm::mat4 standing = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1}; // +Y -> +Z
    return scene::builtin::transformed(scene::builtin::plane(glm::vec2(halfExtent)), standing);
}

scene::Geometry ball(float radius) {
    return scene::builtin::sphere(radius, 128, 64);
}

scene::Material metal(float perceptualRoughness, const glm::vec3& color) {
    scene::Material material;
    material.baseColorFactor = glm::vec4(color, 1);
    material.metallicFactor = 1;
    material.roughnessFactor = perceptualRoughness;
    return material;
}

scene::Material matte(const glm::vec3& color) {
    scene::Material material;
    material.baseColorFactor = glm::vec4(color, 1);
    material.metallicFactor = 0;
    material.specularFactor = 0;
    return material;
}

scene::Material emissive(const glm::vec3& radiance) {
    scene::Material material = matte(glm::vec3(0));
    material.emissiveFactor = radiance;
    return material;
}

scene::Camera orthographicCamera(float height) {
    scene::Camera camera;
    camera.viewToWorld = scene::lookAt(glm::vec3(0, 0, 10), glm::vec3(0));
    camera.orthographic = true;
    camera.orthoHeight = height;
    camera.far = 100;
    return camera;
}

scene::HdrImage environmentPicture(uint32_t width, const std::function<glm::vec3(const glm::vec3&)>& radiance) {
    scene::HdrImage image{width, width / 2, {}};
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const float phi = ((float(x) + 0.5f) / float(width) - 0.5f) * 2 * glm::pi<float>();
            const float theta = (float(y) + 0.5f) / float(image.height) * glm::pi<float>();
            image.rgb.push_back(
                radiance({std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)}));
        }
    return image;
}

gpu::Context& RenderTest::gpu() {
    static gpu::Context& context = [&]() -> gpu::Context& {
        GpuTest::gpu().addShaders(gpu::shaders::render());
        return GpuTest::gpu();
    }();
    return context;
}

RenderTest::Frame RenderTest::draw(const SceneParts& parts, const render::ViewParameters& view, uint32_t width,
                                   uint32_t height, const scene::HdrImage& environment,
                                   const render::RenderSettings& settings, const render::GBufferOptions& options) {
    const scene::Pose pose = must(scene::pose(parts.scene, 0));
    render::Environment light = must(environment.rgb.empty() ? render::Environment::createNone(gpu())
                                                             : render::Environment::create(gpu(), environment));
    render::Renderer renderer = must(render::Renderer::create(gpu(), parts.scene, pose, std::move(light), settings));
    must(renderer.resize(width, height, options));
    run([&](VkCommandBuffer commands) {
        gpu::Frame frame(gpu(), commands);
        render::GBuffer& gbuffer = renderer.drawOpaque(frame, view);
        renderer.drawTransparent(frame, gbuffer.litRadiance);
    });
    render::GBuffer& g = renderer.gbuffer();
    const auto read = [&](gpu::Image& image) {
        return image && image.desc().samples == 1
                   ? Picture{image.width(), image.height(), must(gpu::downloadImageAsFloats(gpu(), image))}
                   : Picture();
    };
    return {read(g.litRadiance),      read(g.deviceDepth), read(g.normal),   read(g.material),
            read(g.fallbackSpecular), read(g.motion),      read(g.backDepth)};
}

} // namespace glint::test
