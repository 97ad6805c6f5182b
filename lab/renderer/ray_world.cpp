#include "lab/renderer/ray_world.hpp"

#include "gpu/transfer.hpp"
#include "shared/ray_flags.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

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
    out.thicknessFactor = m.thicknessFactor;
    out.thicknessTexture = data(m.thicknessTexture);
    out.attenuationColor = toArray(m.attenuationColor);
    out.attenuationDistance = m.attenuationDistance;
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

/// The last one is glTF's default.
std::vector<SurfaceMaterial> surfaceMaterials(const GpuScene& gpuScene, const scene::Scene& scene) {
    const scene::Material defaultMaterial;
    std::vector<SurfaceMaterial> materials;
    for (const scene::Material& material : scene.materials)
        materials.push_back(surfaceMaterial(gpuScene, material));
    materials.push_back(surfaceMaterial(gpuScene, defaultMaterial));
    return materials;
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
    // The inverse of scale and offset (lab/renderer/lights.cpp).
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

/// Returns the range of an item's vertices and indices in GpuScene's buffers.
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
    if (item.prevVertexDelta != 0)
        mesh.previousPositions = {positions + static_cast<VkDeviceAddress>(item.prevVertexDelta) * sizeof(glm::vec3),
                                  sizeof(glm::vec3)};
    mesh.indices = gpuScene.indices().address() + VkDeviceAddress{item.firstIndex} * sizeof(uint32_t);
    return mesh;
}

} // namespace

/// A pose as the lists of a ray scene and a surface table.
struct RayWorld::Gathered {
    std::vector<Part> parts;
    std::vector<RayInstance> rayInstances;
    std::vector<SurfaceMesh> meshes;
    std::vector<SurfaceInstance> instances;
    std::vector<uint32_t> items;
};

RayWorld::Gathered RayWorld::gather(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose) {
    Gathered all;
    std::unordered_set<const scene::Geometry*> deformed;
    for (const auto& geometry : pose.deformed)
        deformed.insert(geometry.get());
    std::unordered_map<const scene::Geometry*, uint32_t> numbers;
    for (size_t i = 0; i < pose.items.size(); ++i) {
        const scene::DrawItem& drawn = pose.items[i];
        const GpuItem& item = gpuScene.items()[i];
        const scene::Geometry& geometry = *drawn.geometry;
        if (item.topology != scene::Topology::Triangles)
            continue;
        const auto [known, isNew] = numbers.try_emplace(&geometry, static_cast<uint32_t>(all.parts.size()));
        if (isNew) {
            all.parts.push_back(
                {&geometry, deformed.contains(&geometry), geometry.positions.size(), geometry.indices.size() / 3 * 3});
            all.meshes.push_back(surfaceMesh(gpuScene, item));
        }
        RayInstance placed;
        placed.mesh = known->second;
        std::copy_n(glm::value_ptr(drawn.localToWorld), 16, placed.localToWorld.begin());
        placed.opaque = item.surface == SurfaceClass::Opaque;
        placed.mask = item.surface == SurfaceClass::Transparent ? shared::kTransparentMask : 0xff;
        placed.doubleSided = item.doubleSided;
        all.rayInstances.push_back(placed);
        const size_t material = drawn.material < 0 ? scene.materials.size() : static_cast<size_t>(drawn.material);
        all.instances.push_back({placed.mesh, static_cast<uint32_t>(material), placed.localToWorld});
        all.items.push_back(static_cast<uint32_t>(i));
    }
    return all;
}

Result<RayWorld> RayWorld::create(gpu::Context& context, Context& library, GpuScene& gpuScene,
                                  const scene::Scene& scene, const scene::Pose& pose,
                                  std::span<const shared::Light> lights, RayBackend backend) {
    Gathered all = gather(gpuScene, scene, pose);
    std::vector<RayMesh> rayMeshes;
    for (const Part& part : all.parts) {
        RayMesh mesh;
        mesh.positions = &part.geometry->positions.data()->x;
        mesh.vertexCount = static_cast<uint32_t>(part.vertices);
        mesh.indices = std::span(part.geometry->indices).first(part.indices);
        mesh.deforms = part.deforms;
        rayMeshes.push_back(mesh);
    }
    const std::vector<SurfaceMaterial> materials = surfaceMaterials(gpuScene, scene);
    std::vector<SurfaceTexture> textures;
    for (const VkDescriptorImageInfo& entry : gpuScene.textures().entries())
        textures.push_back({entry.imageView, entry.sampler});

    RaySceneDesc rayDesc;
    rayDesc.meshes = rayMeshes;
    rayDesc.instances = all.rayInstances;
    rayDesc.backend = backend;
    GLINT_TRY(rays, RayScene::create(library, rayDesc));
    SurfaceTableDesc desc;
    desc.textures = textures;
    desc.materials = materials;
    desc.meshes = all.meshes;
    desc.instances = all.instances;
    desc.maxLights = shared::kMaxLights;
    const std::vector<SurfaceLight> shining = surfaceLights(lights);
    desc.lights = shining;
    GLINT_TRY(surfaces, SurfaceTable::create(library, desc));
    std::vector<uint32_t> items = all.items;
    if (items.empty())
        items.push_back(0); // a buffer must not be empty; this element is never read
    GLINT_TRY(itemBuffer, gpu::uploadBuffer(context, "rays/items", items, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    RayWorld world(std::move(rays), std::move(surfaces), std::move(itemBuffer));
    world.itemNumbers_ = std::move(all.items);
    world.parts_ = std::move(all.parts);
    return world;
}

Result<bool> RayWorld::setPose(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose) {
    Gathered all = gather(gpuScene, scene, pose);
    const auto isSame = [](const Part& a, const Part& b) {
        return a.deforms == b.deforms && a.vertices == b.vertices && a.indices == b.indices &&
               (a.deforms || a.geometry == b.geometry);
    };
    if (all.items != itemNumbers_ || !std::ranges::equal(all.parts, parts_, isSame))
        return false;
    for (size_t i = 0; i < all.parts.size(); ++i)
        if (all.parts[i].deforms)
            GLINT_CHECK(rays_.deform(static_cast<uint32_t>(i), &all.parts[i].geometry->positions.data()->x,
                                     static_cast<uint32_t>(all.parts[i].vertices)));
    GLINT_CHECK(rays_.setInstances(all.rayInstances));
    GLINT_CHECK(surfaces_.setMeshes(all.meshes)); // the renderer's buffers may have been replaced
    GLINT_CHECK(surfaces_.setInstances(all.instances));
    parts_ = std::move(all.parts);
    return true;
}

Result<void> RayWorld::setMaterials(GpuScene& gpuScene, const scene::Scene& scene, const scene::Pose& pose) {
    GLINT_CHECK(surfaces_.setMaterials(surfaceMaterials(gpuScene, scene)));
    return rays_.setInstances(gather(gpuScene, scene, pose).rayInstances); // some may have become transparent
}

void RayWorld::bindForShadows(gpu::Pass& pass) {
    rays_.bind(pass.read("rayItems", items_));
}

Result<void> RayWorld::setLights(std::span<const shared::Light> lights) {
    return surfaces_.setLights(surfaceLights(lights));
}

} // namespace glint::render
