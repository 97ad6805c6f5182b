#include "render/ray_world.hpp"

#include "gpu/transfer.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace glint::render {
namespace {

std::array<float, 3> toArray(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

SurfaceTextureRef textureRef(const GpuScene& gpuScene, const scene::TextureSlot& slot, TextureKind kind) {
    const glm::mat3& m = slot.uvTransform;
    return {gpuScene.textureIndex(slot, kind), slot.texCoord, {m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1]}};
}

SurfaceMaterial surfaceMaterial(const GpuScene& gpuScene, const scene::Material& m) {
    const auto color = [&](const scene::TextureSlot& slot) { return textureRef(gpuScene, slot, TextureKind::Color); };
    const auto data = [&](const scene::TextureSlot& slot) { return textureRef(gpuScene, slot, TextureKind::Data); };
    SurfaceMaterial out;
    out.alpha = m.alphaMode == scene::AlphaMode::Opaque ? SurfaceAlpha::Opaque
                : m.alphaMode == scene::AlphaMode::Mask ? SurfaceAlpha::Mask
                                                        : SurfaceAlpha::Blend;
    out.alphaCutoff = m.alphaCutoff;
    out.unlit = m.unlit;
    out.baseColorFactor = {m.baseColorFactor.r, m.baseColorFactor.g, m.baseColorFactor.b, m.baseColorFactor.a};
    out.baseColorTexture = color(m.baseColorTexture);
    out.metallicFactor = m.metallicFactor;
    out.roughnessFactor = m.roughnessFactor;
    out.metallicRoughnessTexture = data(m.metallicRoughnessTexture);
    out.normalTexture = data(m.normalTexture);
    out.normalScale = m.normalScale;
    out.occlusionTexture = data(m.occlusionTexture);
    out.occlusionStrength = m.occlusionStrength;
    out.emissiveFactor = toArray(m.emissiveFactor);
    out.emissiveTexture = color(m.emissiveTexture);
    out.specularFactor = m.specularFactor;
    out.specularTexture = data(m.specularTexture);
    out.specularColorFactor = toArray(m.specularColorFactor);
    out.specularColorTexture = color(m.specularColorTexture);
    out.ior = m.ior;
    out.transmissionFactor = m.transmissionFactor;
    out.transmissionTexture = data(m.transmissionTexture);
    out.clearcoatFactor = m.clearcoatFactor;
    out.clearcoatRoughnessFactor = m.clearcoatRoughnessFactor;
    out.clearcoatTexture = data(m.clearcoatTexture);
    out.clearcoatRoughnessTexture = data(m.clearcoatRoughnessTexture);
    out.clearcoatNormalTexture = data(m.clearcoatNormalTexture);
    out.clearcoatNormalScale = m.clearcoatNormalScale;
    out.specularGlossiness = m.specularGlossiness;
    out.specularGlossinessFactor = toArray(m.specularGlossinessFactor);
    out.glossinessFactor = m.glossinessFactor;
    out.specularGlossinessTexture = color(m.specularGlossinessTexture);
    return out;
}

SurfaceLight surfaceLight(const shared::Light& light) {
    SurfaceLight out;
    out.kind = light.type == shared::kLightDirectional ? SurfaceLightKind::Directional
               : light.type == shared::kLightPoint     ? SurfaceLightKind::Point
                                                       : SurfaceLightKind::Spot;
    out.color = toArray(light.color);
    out.positionWS = toArray(light.positionWS);
    out.directionWS = toArray(light.directionWS);
    out.range = light.range;
    // Back from scale and offset (render/lights.cpp).
    const float cosOuter = -light.spotOffset / std::max(light.spotScale, 1e-6f);
    out.outerConeAngle = std::acos(std::clamp(cosOuter, -1.0f, 1.0f));
    out.innerConeAngle = std::acos(std::clamp(cosOuter + 1 / std::max(light.spotScale, 1e-6f), -1.0f, 1.0f));
    out.castsShadow = light.castsShadow != 0;
    return out;
}

std::vector<SurfaceLight> surfaceLights(std::span<const shared::Light> lights) {
    std::vector<SurfaceLight> result;
    for (const shared::Light& light : lights)
        result.push_back(surfaceLight(light));
    return result;
}

/// Where GpuScene has put an item's vertices and indices.
SurfaceMesh surfaceMesh(GpuScene& gpuScene, const GpuItem& item) {
    using shared::VertexAttributes;
    const VkDeviceAddress positions =
        gpuScene.positions().address() + static_cast<VkDeviceAddress>(item.vertexOffset) * sizeof(glm::vec3);
    const VkDeviceAddress attributes =
        gpuScene.attributes().address() + static_cast<VkDeviceAddress>(item.vertexOffset) * sizeof(VertexAttributes);
    const auto attribute = [&](size_t offset) { return VertexStream{attributes + offset, sizeof(VertexAttributes)}; };
    SurfaceMesh mesh;
    mesh.positions = {positions, sizeof(glm::vec3)};
    mesh.normals = attribute(offsetof(VertexAttributes, normal));
    mesh.tangents = attribute(offsetof(VertexAttributes, tangent));
    mesh.uv0 = attribute(offsetof(VertexAttributes, uv0));
    mesh.uv1 = attribute(offsetof(VertexAttributes, uv1));
    mesh.colors = attribute(offsetof(VertexAttributes, color));
    mesh.indices = gpuScene.indices().address() + VkDeviceAddress{item.firstIndex} * sizeof(uint32_t);
    return mesh;
}

} // namespace

Result<RayWorld> RayWorld::create(gpu::Context& context, Context& library, GpuScene& gpuScene,
                                  const scene::Scene& scene, const scene::Pose& pose,
                                  std::span<const shared::Light> lights, RayBackend backend) {
    std::vector<RayMesh> rayMeshes;
    std::vector<RayInstance> rayInstances;
    std::vector<SurfaceMesh> meshes;
    std::vector<SurfaceInstance> instances;
    std::vector<uint32_t> items;
    std::unordered_map<const scene::Geometry*, uint32_t> numbers;
    const scene::Material defaultMaterial;
    for (size_t i = 0; i < pose.items.size(); ++i) {
        const scene::DrawItem& drawn = pose.items[i];
        const GpuItem& item = gpuScene.items()[i];
        const scene::Geometry& geometry = *drawn.geometry;
        if (item.topology != scene::Topology::Triangles || item.surface == SurfaceClass::Transparent)
            continue;
        const auto [known, isNew] = numbers.try_emplace(&geometry, static_cast<uint32_t>(rayMeshes.size()));
        if (isNew) {
            RayMesh mesh;
            mesh.positions = &geometry.positions.data()->x;
            mesh.vertexCount = static_cast<uint32_t>(geometry.positions.size());
            mesh.indices = std::span(geometry.indices).first(geometry.indices.size() / 3 * 3);
            rayMeshes.push_back(mesh);
            meshes.push_back(surfaceMesh(gpuScene, item));
        }
        RayInstance placed;
        placed.mesh = known->second;
        std::copy_n(glm::value_ptr(drawn.localToWorld), 16, placed.localToWorld.begin());
        placed.opaque = item.surface == SurfaceClass::Opaque;
        placed.doubleSided = item.doubleSided;
        rayInstances.push_back(placed);
        const size_t material = drawn.material < 0 ? scene.materials.size() : static_cast<size_t>(drawn.material);
        instances.push_back({placed.mesh, static_cast<uint32_t>(material), placed.localToWorld});
        items.push_back(static_cast<uint32_t>(i));
    }
    std::vector<SurfaceMaterial> materials;
    for (const scene::Material& material : scene.materials)
        materials.push_back(surfaceMaterial(gpuScene, material));
    materials.push_back(surfaceMaterial(gpuScene, defaultMaterial));
    std::vector<SurfaceTexture> textures;
    for (const VkDescriptorImageInfo& entry : gpuScene.textures().entries())
        textures.push_back({entry.imageView, entry.sampler});

    RaySceneDesc rayDesc;
    rayDesc.meshes = rayMeshes;
    rayDesc.instances = rayInstances;
    rayDesc.backend = backend;
    GLINT_TRY(rays, RayScene::create(library, rayDesc));
    SurfaceTableDesc desc;
    desc.textures = textures;
    desc.materials = materials;
    desc.meshes = meshes;
    desc.instances = instances;
    desc.maxLights = shared::kMaxLights;
    const std::vector<SurfaceLight> shining = surfaceLights(lights);
    desc.lights = shining;
    GLINT_TRY(surfaces, SurfaceTable::create(library, desc));
    if (items.empty())
        items.push_back(0); // no buffer is empty; nobody asks for it
    GLINT_TRY(itemBuffer, gpu::uploadBuffer(context, "rays/items", items, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    return RayWorld(std::move(rays), std::move(surfaces), std::move(itemBuffer));
}

void RayWorld::bindForShadows(gpu::Pass& pass) {
    rays_.bind(pass.read("rayItems", items_));
}

Result<void> RayWorld::setLights(std::span<const shared::Light> lights) {
    return surfaces_.setLights(surfaceLights(lights));
}

} // namespace glint::render
