#include "gpu/support/surface_scene.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace glint::test {

SurfaceMaterial emitting(const glm::vec3& radiance) {
    SurfaceMaterial material = blackMatte();
    material.emissiveFactor = {radiance.r, radiance.g, radiance.b};
    return material;
}

SurfaceMaterial whiteMetal(float perceptualRoughness) {
    SurfaceMaterial material;
    material.roughnessFactor = perceptualRoughness;
    return material;
}

SurfaceMaterial blackMatte() {
    SurfaceMaterial material;
    material.baseColorFactor = {0, 0, 0, 1};
    material.metallicFactor = 0;
    material.specularFactor = 0;
    return material;
}

SurfaceScene& SurfaceScene::addQuad(const glm::vec3& a, const glm::vec3& u, const glm::vec3& v,
                                    const SurfaceMaterial& material) {
    RayInstance instance;
    instance.mesh = static_cast<uint32_t>(triangles.meshes.size());
    instance.opaque = material.alpha == SurfaceAlpha::Opaque && material.transmissionFactor == 0;
    TestMesh& mesh = triangles.meshes.emplace_back();
    mesh.addTriangle(a, a + u, a + u + v);
    mesh.addTriangle(a, a + u + v, a + v);
    triangles.instances.push_back(instance);
    materials.push_back(material);
    return *this;
}

SurfaceScene SurfaceScene::scaled(float scale) const {
    SurfaceScene result = *this;
    for (TestMesh& mesh : result.triangles.meshes)
        for (glm::vec3& position : mesh.positions)
            position *= scale;
    return result;
}

SyntheticScene SurfaceScene::seenBy(const SurfaceScene& scene) {
    return [&scene](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        TestRay ray;
        ray.originWS = origin;
        ray.directionWS = direction;
        ray.flags = shared::kRayAllOpaque;
        const std::vector<ExactHit> hits = exactHits(scene.triangles, ray);
        if (hits.empty())
            return {};
        const TestMesh& mesh = scene.triangles.meshes[scene.triangles.instances[hits[0].instance].mesh];
        const auto vertex = [&](uint32_t i) {
            return glm::dvec3(mesh.positions[mesh.indices[size_t{3} * hits[0].primitive + i]]);
        };
        const glm::dvec3 normal =
            glm::normalize(glm::cross(vertex(1) - vertex(0), vertex(2) - vertex(0))) * (hits[0].frontFace ? 1.0 : -1.0);
        // The exact hit of the double precision ray with the plane: exactHits begins with rounded rays.
        const double distance = glm::dot(vertex(0) - origin, normal) / glm::dot(direction, normal);
        const SurfaceMaterial& material = scene.materials[hits[0].instance];
        SyntheticSurface surface;
        surface.distance = distance;
        surface.normalWS = normal;
        surface.f0 = glm::vec3(material.metallicFactor * material.baseColorFactor[0]);
        surface.perceptualRoughness = material.roughnessFactor;
        surface.radiance = glm::make_vec3(material.emissiveFactor.data());
        return surface;
    };
}

SurfaceScene::World SurfaceScene::build(gpu::Context& context, Context& library, RayBackend backend) const {
    std::list<gpu::Buffer> buffers;
    const auto upload = [&](const auto& list) {
        buffers.push_back(
            must(gpu::uploadBuffer(context, "test/stream", list,
                                   VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT)));
        return buffers.back().address();
    };
    std::vector<RayMesh> rayMeshes;
    std::vector<SurfaceMesh> meshes;
    for (const TestMesh& mesh : triangles.meshes) {
        rayMeshes.push_back(mesh.view());
        SurfaceMesh surface;
        surface.positions = {upload(mesh.positions), sizeof(glm::vec3)};
        surface.indices = upload(mesh.indices);
        if (!mesh.colors.empty())
            surface.colors = {upload(mesh.colors), sizeof(glm::vec4)};
        meshes.push_back(surface);
    }
    std::vector<SurfaceInstance> instances;
    for (uint32_t i = 0; i < triangles.instances.size(); ++i)
        instances.push_back({triangles.instances[i].mesh, i, triangles.instances[i].localToWorld});
    RaySceneDesc rayDesc;
    rayDesc.meshes = rayMeshes;
    rayDesc.instances = triangles.instances;
    rayDesc.backend = backend;
    SurfaceTableDesc desc;
    desc.materials = materials;
    desc.meshes = meshes;
    desc.instances = instances;
    desc.lights = lights;
    return {std::move(buffers), must(RayScene::create(library, rayDesc)), must(SurfaceTable::create(library, desc))};
}

} // namespace glint::test
