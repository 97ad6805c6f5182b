#include "rays/query_scene.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace glint::rays {
namespace {

/// Bytes of scratch memory for meshes that are built in parallel; a single large mesh may need more.
constexpr size_t kScratchForMany = size_t{32} << 20;

VkAccelerationStructureInstanceKHR recordOf(const RayInstance& instance, const Placement& placement,
                                            VkDeviceAddress structure) {
    VkAccelerationStructureInstanceKHR record = {};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            record.transform.matrix[row][column] = static_cast<float>(placement.localToWorld[column][row]);
    record.mask = instance.mask;
    // Facing is determined in the mesh's own space, whatever the transform. Unflipped, the front has clockwise vertices
    // in left-handed coordinates: counter-clockwise in ours.
    VkGeometryInstanceFlagsKHR flags =
        instance.opaque ? VK_GEOMETRY_INSTANCE_FORCE_OPAQUE_BIT_KHR : VK_GEOMETRY_INSTANCE_FORCE_NO_OPAQUE_BIT_KHR;
    if (instance.doubleSided)
        flags |= VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
    record.flags = flags & 0xff;
    record.accelerationStructureReference = structure;
    return record;
}

} // namespace

Result<std::unique_ptr<QueryScene>> QueryScene::create(gpu::Context& context, std::vector<Mesh> meshes,
                                                       uint32_t maxInstances) {
    std::unique_ptr<QueryScene> scene(new QueryScene);
    scene->records_.resize(std::max(maxInstances, 1u));
    size_t vertexCount = 0;
    size_t triangleCount = 0;
    for (const Mesh& mesh : meshes) {
        vertexCount += mesh.positions.size();
        triangleCount += mesh.triangles.size();
    }
    const size_t positionBytes = std::max<size_t>(vertexCount, 1) * sizeof(glm::vec3);
    const size_t indexBytes = std::max<size_t>(triangleCount, 1) * sizeof(glm::uvec3);
    const size_t instanceBytes = scene->records_.size() * sizeof(scene->records_.front());
    const auto make = [&](gpu::Buffer& out, const char* name, size_t size, VkBufferUsageFlags usage,
                          gpu::BufferHome home) -> Result<void> {
        GLINT_TRY(buffer, gpu::Buffer::create(context, {name, size, usage, home}));
        out = std::move(buffer);
        return {};
    };
    constexpr VkBufferUsageFlags kStaging = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    constexpr gpu::BufferHome kDevice = gpu::BufferHome::Device;
    GLINT_CHECK(make(scene->positions_, "rays/positions", positionBytes, gpu::kBuildInputUsage, kDevice));
    GLINT_CHECK(make(scene->indices_, "rays/indices", indexBytes, gpu::kBuildInputUsage, kDevice));
    GLINT_CHECK(make(scene->instances_, "rays/instances", instanceBytes, gpu::kBuildInputUsage, kDevice));
    GLINT_CHECK(
        make(scene->positionStaging_, "rays/positions/staging", positionBytes, kStaging, gpu::BufferHome::Upload));
    GLINT_CHECK(make(scene->indexStaging_, "rays/indices/staging", indexBytes, kStaging, gpu::BufferHome::Upload));

    auto* positions = static_cast<glm::vec3*>(scene->positionStaging_.mapped());
    auto* indices = static_cast<glm::uvec3*>(scene->indexStaging_.mapped());
    size_t firstVertex = 0;
    size_t firstTriangle = 0;
    size_t scratchBytes = 0;
    size_t largest = 0;
    scene->parts_.reserve(meshes.size()); // the top level points to the structures in this vector
    for (size_t i = 0; i < meshes.size(); ++i) {
        Part& part = scene->parts_.emplace_back();
        part.mesh = std::move(meshes[i]);
        part.firstVertex = firstVertex;
        std::copy(part.mesh.positions.begin(), part.mesh.positions.end(), positions + firstVertex);
        std::copy(part.mesh.triangles.begin(), part.mesh.triangles.end(), indices + firstTriangle);
        if (!std::all_of(part.mesh.triangles.begin(), part.mesh.triangles.end(), isLeftOut)) {
            const gpu::TriangleRange range = {&scene->positions_,
                                              firstVertex * sizeof(glm::vec3),
                                              static_cast<uint32_t>(part.mesh.positions.size()),
                                              &scene->indices_,
                                              firstTriangle * sizeof(glm::uvec3),
                                              static_cast<uint32_t>(part.mesh.triangles.size())};
            GLINT_TRY(structure, gpu::AccelerationStructure::bottom(context, "rays/mesh", range, part.mesh.deforms));
            part.structure = std::move(structure);
            largest = std::max(largest, part.structure.scratchSize());
            scratchBytes += part.structure.scratchSize();
        }
        firstVertex += part.mesh.positions.size();
        firstTriangle += part.mesh.triangles.size();
        if (!part.mesh.deforms)
            part.mesh = {};
    }
    std::vector<gpu::AccelerationStructure*> bottoms;
    for (Part& part : scene->parts_)
        if (part.structure)
            bottoms.push_back(&part.structure);
    GLINT_TRY(top, gpu::AccelerationStructure::top(context, "rays/scene", scene->instances_,
                                                   static_cast<uint32_t>(scene->records_.size()), std::move(bottoms)));
    scene->top_ = std::move(top);
    largest = std::max(largest, scene->top_.scratchSize());
    scratchBytes = std::max(largest, std::min(scratchBytes, kScratchForMany));
    GLINT_CHECK(make(scene->scratch_, "rays/scratch", scratchBytes,
                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT, kDevice));
    return scene;
}

void QueryScene::setInstances(std::span<const RayInstance> instances) {
    std::fill(records_.begin(), records_.end(), VkAccelerationStructureInstanceKHR{});
    place(0, instances);
    dirty_.clear();
    dirty_.add(0, records_.size() * sizeof(records_.front()));
    topUpload_.ask();
}

void QueryScene::updateInstances(uint32_t first, std::span<const RayInstance> instances) {
    if (instances.empty())
        return;
    place(first, instances);
    if (topUpload_.isDone())
        dirty_.clear();
    dirty_.add(first * sizeof(records_.front()), instances.size() * sizeof(records_.front()));
    topUpload_.ask();
}

void QueryScene::place(size_t first, std::span<const RayInstance> instances) {
    for (size_t i = 0; i < instances.size(); ++i) {
        const Part& part = parts_[instances[i].mesh];
        const auto placement = placementOf(instances[i]);
        records_[first + i] = placement && part.structure ? recordOf(instances[i], *placement, part.structure.address())
                                                          : VkAccelerationStructureInstanceKHR{};
    }
}

void QueryScene::fitMesh(uint32_t index) {
    if (deformedUpload_.isDone())
        for (Part& part : parts_)
            part.deformed = false;
    parts_[index].deformed = static_cast<bool>(parts_[index].structure);
    deformedUpload_.ask();
}

bool QueryScene::pending(const gpu::Progress& progress) {
    const bool upload = upload_.isNeeded(progress);
    const bool deformed = deformedUpload_.isNeeded(progress);
    return topUpload_.isNeeded(progress) || upload || deformed;
}

void QueryScene::record(gpu::Frame& frame, const gpu::Progress& progress) {
    // In this order: the GPU may finish recordings meanwhile, and an upload that is repeated must be followed by the
    // changes made after it.
    const bool deformed = deformedUpload_.isNeeded(progress);
    const bool top = topUpload_.isNeeded(progress);
    if (upload_.isNeeded(progress)) {
        frame.scope("rays/build", [&] {
            frame.upload(positionStaging_, positions_);
            frame.upload(indexStaging_, indices_);
            frame.build(top_.references(), scratch_);
        });
        upload_.recorded(progress);
    }
    frame.scope("rays/update", [&] {
        if (deformed) {
            std::vector<gpu::AccelerationStructure*> structures;
            for (Part& part : parts_) {
                if (!part.deformed)
                    continue;
                structures.push_back(&part.structure);
                frame.update(positions_, part.mesh.positions.data(), part.mesh.positions.size() * sizeof(glm::vec3),
                             part.firstVertex * sizeof(glm::vec3));
            }
            frame.refit(structures, scratch_);
            deformedUpload_.recorded(progress);
        }
        if (top) {
            frame.update(instances_, std::as_bytes(std::span(records_)), dirty_.merged());
            topUpload_.recorded(progress);
        }
        frame.build(std::array{&top_}, scratch_); // its boxes depend on the meshes' boxes
    });
}

void QueryScene::releaseStaging(const gpu::Progress& progress) {
    if (upload_.isNeeded(progress))
        return;
    positionStaging_ = {};
    indexStaging_ = {};
}

} // namespace glint::rays
