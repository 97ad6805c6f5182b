#include "lab/renderer/gpu_scene.hpp"

#include "gpu/device_address.hpp"
#include "gpu/transfer.hpp"

#include <algorithm>

namespace glint::render {
namespace {

/// The content of the vertex and index buffers, gathered before one upload each.
struct GeometryArrays {
    std::vector<glm::vec3> positions;
    std::vector<shared::VertexAttributes> attributes;
    std::vector<uint32_t> indices;

    void append(const scene::Geometry& geometry) {
        const auto element = [](const auto& array, size_t i, auto fallback) {
            return array.empty() ? fallback : array[i];
        };
        for (size_t i = 0; i < geometry.positions.size(); ++i)
            attributes.push_back({element(geometry.normals, i, glm::vec3(0)),
                                  element(geometry.tangents, i, glm::vec4(0)),
                                  element(geometry.uvs[0], i, glm::vec2(0)), element(geometry.uvs[1], i, glm::vec2(0)),
                                  element(geometry.colors, i, glm::vec4(1))});
        positions.insert(positions.end(), geometry.positions.begin(), geometry.positions.end());
        indices.insert(indices.end(), geometry.indices.begin(), geometry.indices.end());
    }
};

Result<void> checkSize(const gpu::Context& context, const char* what, size_t bytes, size_t most) {
    if (bytes > most)
        return makeError(ErrorCode::Unsupported, "the scene's {} take {} bytes; one buffer of {} holds {}", what, bytes,
                         context.info().name, most);
    return {};
}

/// True if nothing moves so: it grew or shrank so much in one frame that it was hidden before, or is now. As
/// shaders/rays/hit_motion.glsl.
bool appeared(const glm::mat4& before, const glm::mat4& now) {
    constexpr float kLargestChange = 4; // of the volume
    const float was = std::abs(glm::determinant(glm::mat3(before)));
    const float is = std::abs(glm::determinant(glm::mat3(now)));
    return was > kLargestChange * is || is > kLargestChange * was;
}

} // namespace

Result<GpuScene> GpuScene::create(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose) {
    GpuScene result;
    GLINT_TRY(textures, GpuTextures::create(context, scene));
    result.textures_ = std::move(textures);
    GLINT_CHECK(result.uploadMaterials(context, scene));
    GLINT_CHECK(result.setPose(context, scene, pose));
    return result;
}

gpu::Pass& GpuScene::bind(gpu::Pass& pass) {
    return pass.read("instances", instances_)
        .read("geometry", geometry_)
        .readByAddress(positions_)
        .readByAddress(attributes_)
        .readByAddress(indices_)
        .indices(indices_);
}

Result<void> GpuScene::uploadMaterials(gpu::Context& context, const scene::Scene& scene) {
    std::vector<shared::Material> materials;
    for (const scene::Material& material : scene.materials)
        materials.push_back(gpuMaterial(material, textures_));
    materials.push_back(gpuMaterial(scene::Material(), textures_));
    GLINT_TRY(buffer, gpu::uploadBuffer(context, "scene/materials", materials, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    materials_ = std::move(buffer);
    return {};
}

Result<bool> GpuScene::setMaterials(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose) {
    if (!textures_.holds(scene))
        return false;
    const bool transmitted = transmitsLight_;
    GLINT_CHECK(uploadMaterials(context, scene));
    lastShapes_.clear(); // a body's shape depends on its material
    GLINT_CHECK(uploadInstances(context, scene, pose));
    return transmitted == transmitsLight_;
}

Result<void> GpuScene::setPose(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose) {
    if (!positions_ || !pose.deformed.empty())
        GLINT_CHECK(uploadGeometry(context, pose));
    GLINT_CHECK(uploadInstances(context, scene, pose));
    boundsWS_ = pose.boundsWS;
    lastTransforms_.clear();
    for (const scene::DrawItem& item : pose.items)
        lastTransforms_.push_back(item.localToWorld);
    lastDeformed_.clear();
    for (const auto& geometry : pose.deformed)
        lastDeformed_.push_back(geometry->positions);
    return {};
}

Result<void> GpuScene::uploadGeometry(gpu::Context& context, const scene::Pose& pose) {
    GeometryArrays arrays;
    ranges_.clear();
    for (const scene::DrawItem& item : pose.items) {
        const Range range = {static_cast<uint32_t>(arrays.indices.size()),
                             static_cast<uint32_t>(arrays.positions.size()), 0};
        if (ranges_.emplace(item.geometry, range).second)
            arrays.append(*item.geometry);
    }
    // After all other vertices, the previous positions of deformed vertices; only positions are needed.
    for (size_t i = 0; i < pose.deformed.size(); ++i) {
        const auto range = ranges_.find(pose.deformed[i].get());
        if (range == ranges_.end() || i >= lastDeformed_.size() ||
            lastDeformed_[i].size() != pose.deformed[i]->positions.size())
            continue;
        range->second.prevVertexDelta =
            static_cast<int>(arrays.positions.size()) - static_cast<int>(range->second.firstVertex);
        arrays.positions.insert(arrays.positions.end(), lastDeformed_[i].begin(), lastDeformed_[i].end());
    }
    GLINT_CHECK(checkSize(context, "vertices", arrays.attributes.size() * sizeof(shared::VertexAttributes),
                          context.maxBufferSize()));
    // Read by address, by ray hits, too (glint/surface_table.hpp).
    constexpr VkBufferUsageFlags kStorage =
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    GLINT_TRY(positions, gpu::uploadBuffer(context, "scene/positions", arrays.positions, kStorage));
    GLINT_TRY(attributes, gpu::uploadBuffer(context, "scene/attributes", arrays.attributes, kStorage));
    GLINT_TRY(indices,
              gpu::uploadBuffer(context, "scene/indices", arrays.indices, kStorage | VK_BUFFER_USAGE_INDEX_BUFFER_BIT));
    positions_ = std::move(positions);
    attributes_ = std::move(attributes);
    indices_ = std::move(indices);
    GLINT_TRY(geometry, gpu::Buffer::create(context, {"scene/geometry", sizeof(shared::GeometryAddresses),
                                                      VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferHome::Upload}));
    *static_cast<shared::GeometryAddresses*>(geometry.mapped()) = {gpu::addressWords(positions_.address()),
                                                                   gpu::addressWords(attributes_.address()),
                                                                   gpu::addressWords(indices_.address())};
    geometry_ = std::move(geometry);
    return {};
}

Result<void> GpuScene::uploadInstances(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose) {
    const auto defaultMaterial = static_cast<uint32_t>(scene.materials.size());
    const bool moved = lastTransforms_.size() == pose.items.size();
    std::vector<shared::Instance> instances;
    std::vector<BodyShape> shapes;
    items_.clear();
    transmitsLight_ = false;
    for (size_t i = 0; i < pose.items.size(); ++i) {
        const scene::DrawItem& item = pose.items[i];
        const Range& range = ranges_.at(item.geometry);
        const scene::Material material = item.material < 0 ? scene::Material() : scene.materials[size_t(item.material)];
        GpuItem out;
        out.firstIndex = range.firstIndex;
        out.indexCount = static_cast<uint32_t>(item.geometry->indices.size());
        out.vertexOffset = static_cast<int32_t>(range.firstVertex);
        out.prevVertexDelta = range.prevVertexDelta;
        out.topology = item.geometry->topology;
        out.surface = surfaceClass(material);
        out.doubleSided = material.doubleSided;
        // Decided once: the shape of moving and deforming objects does not change.
        const bool known = moved && lastShapes_.size() == pose.items.size();
        const BodyShape shape = known ? lastShapes_[i] : bodyShape(material, *item.geometry);
        shapes.push_back(shape);
        out.isBody = shape != BodyShape::Straight;
        transmitsLight_ |= render::transmitsLight(material);
        out.mirrored = glm::determinant(glm::mat3(item.localToWorld)) < 0;
        out.boundsWS = item.boundsWS;
        items_.push_back(out);

        const bool follows = moved && !appeared(lastTransforms_[i], item.localToWorld);
        const bool noNormals = item.geometry->normals.empty() && out.topology != scene::Topology::Triangles;
        instances.push_back(
            {item.localToWorld, follows ? lastTransforms_[i] : item.localToWorld,
             item.material < 0 ? defaultMaterial : static_cast<uint32_t>(item.material),
             (out.mirrored ? shared::kInstanceMirrored : 0) | (noNormals ? shared::kInstanceNoNormals : 0),
             range.firstIndex, range.firstVertex, range.prevVertexDelta, item.boundsWS.center(),
             static_cast<uint32_t>(shape)});
    }
    GLINT_CHECK(
        checkSize(context, "instances", instances.size() * sizeof(shared::Instance), context.maxStorageBufferRange()));
    GLINT_TRY(buffer, gpu::uploadBuffer(context, "scene/instances", instances, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    instances_ = std::move(buffer);
    lastShapes_ = std::move(shapes);
    return {};
}

} // namespace glint::render
