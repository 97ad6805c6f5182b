#include "gpu/support/host_structures.hpp"

#include "support/must.hpp"

#include <algorithm>
#include <cstring>

namespace glint::test {
namespace {

constexpr VkPipelineStageFlags2 kBuild = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
constexpr VkPipelineStageFlags2 kTrace = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkAccessFlags2 kRead = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
constexpr VkAccessFlags2 kWrite = VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;

void barrier(const gpu::Context& context, VkCommandBuffer commands, VkPipelineStageFlags2 from,
             VkAccessFlags2 fromAccess, VkPipelineStageFlags2 to, VkAccessFlags2 toAccess) {
    VkMemoryBarrier2 memory = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2, nullptr, from, fromAccess, to, toAccess};
    VkDependencyInfo info = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &memory;
    context.api().CmdPipelineBarrier2(commands, &info);
}

/// A buffer that the CPU writes and builds read.
template <class T>
gpu::Buffer inputBuffer(gpu::Context& context, const std::vector<T>& items) {
    gpu::Buffer buffer = must(gpu::Buffer::create(
        context, {"host/input", items.size() * sizeof(T), gpu::kBuildInputUsage, gpu::BufferHome::Upload}));
    std::memcpy(buffer.mapped(), items.data(), items.size() * sizeof(T));
    return buffer;
}

} // namespace

// ---------------------------------------------------------------- one structure

HostStructure::HostStructure(gpu::Context& context, VkAccelerationStructureTypeKHR type, bool deforms,
                             std::vector<VkAccelerationStructureGeometryKHR> geometries,
                             const std::vector<uint32_t>& primitives)
    : context_(context), type_(type), geometries_(std::move(geometries)) {
    if (deforms)
        flags_ |= VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_UPDATE_BIT_KHR;
    for (const uint32_t count : primitives)
        ranges_.push_back({count, 0, 0, 0});
    const gpu::Api& api = context.api();
    const VkAccelerationStructureBuildGeometryInfoKHR build = info();
    VkAccelerationStructureBuildSizesInfoKHR sizes = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
    api.GetAccelerationStructureBuildSizesKHR(context.device(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &build,
                                              primitives.data(), &sizes);
    storage_ = must(gpu::Buffer::create(
        context, {"host/structure", sizes.accelerationStructureSize,
                  VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
                  gpu::BufferHome::Device}));
    scratch_ = must(gpu::Buffer::create(
        context,
        {"host/scratch", std::max(sizes.buildScratchSize, sizes.updateScratchSize) + context.scratchAlignment(),
         VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT, gpu::BufferHome::Device}));
    VkAccelerationStructureCreateInfoKHR create = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR};
    create.buffer = storage_.handle();
    create.size = sizes.accelerationStructureSize;
    create.type = type;
    api.CreateAccelerationStructureKHR(context.device(), &create, nullptr, &handle_);
    const VkAccelerationStructureDeviceAddressInfoKHR asked = {
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR, nullptr, handle_};
    address_ = api.GetAccelerationStructureDeviceAddressKHR(context.device(), &asked);
}

HostStructure::~HostStructure() {
    context_.api().DestroyAccelerationStructureKHR(context_.device(), handle_, nullptr);
}

VkAccelerationStructureBuildGeometryInfoKHR HostStructure::info() const {
    VkAccelerationStructureBuildGeometryInfoKHR info = {
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
    info.type = type_;
    info.flags = flags_;
    info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
    info.geometryCount = static_cast<uint32_t>(geometries_.size());
    info.pGeometries = geometries_.data();
    return info;
}

void HostStructure::build(VkCommandBuffer commands, bool refit) const {
    VkAccelerationStructureBuildGeometryInfoKHR build = info();
    build.dstAccelerationStructure = handle_;
    const VkDeviceSize alignment = context_.scratchAlignment();
    build.scratchData.deviceAddress = (scratch_.address() + alignment - 1) / alignment * alignment;
    if (refit) {
        build.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_UPDATE_KHR;
        build.srcAccelerationStructure = handle_;
    }
    const VkAccelerationStructureBuildRangeInfoKHR* ranges = ranges_.data();
    context_.api().CmdBuildAccelerationStructuresKHR(commands, 1, &build, &ranges);
}

// ---------------------------------------------------------------- the host

RayTracingHost::RayTracingHost(gpu::Context& context, const std::vector<std::vector<Geometry>>& bottoms)
    : context_(context) {
    for (const std::vector<Geometry>& meshes : bottoms) {
        Bottom& bottom = bottoms_.emplace_back();
        std::vector<VkAccelerationStructureGeometryKHR> geometries;
        std::vector<uint32_t> primitives;
        for (const Geometry& described : meshes) {
            const TestMesh& mesh = *described.mesh;
            const gpu::Buffer& positions = bottom.buffers.emplace_back(inputBuffer(context, mesh.positions));
            const gpu::Buffer& indices = bottom.buffers.emplace_back(inputBuffer(context, mesh.indices));
            VkAccelerationStructureGeometryKHR& geometry = geometries.emplace_back(VkAccelerationStructureGeometryKHR{
                VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR, nullptr, VK_GEOMETRY_TYPE_TRIANGLES_KHR, {}, 0});
            if (described.opaque)
                geometry.flags = VK_GEOMETRY_OPAQUE_BIT_KHR;
            VkAccelerationStructureGeometryTrianglesDataKHR& data = geometry.geometry.triangles;
            data = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR};
            data.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
            data.vertexData.deviceAddress = positions.address();
            data.vertexStride = sizeof(glm::vec3);
            data.maxVertex = static_cast<uint32_t>(mesh.positions.size()) - 1;
            data.indexType = VK_INDEX_TYPE_UINT32;
            data.indexData.deviceAddress = indices.address();
            primitives.push_back(static_cast<uint32_t>(mesh.indices.size() / 3));
        }
        bottom.structure =
            std::make_unique<HostStructure>(context, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR,
                                            meshes.front().mesh->deforms, std::move(geometries), primitives);
    }
}

RayTracingHost::RayTracingHost(gpu::Context& context, const TestScene& scene)
    : RayTracingHost(context, [&] {
          std::vector<std::vector<Geometry>> bottoms;
          for (const TestMesh& mesh : scene.meshes)
              bottoms.push_back({{&mesh}});
          return bottoms;
      }()) {}

std::vector<RayTracingHost::Instance> RayTracingHost::inOrder(const std::vector<RayInstance>& instances) {
    std::vector<Instance> list;
    for (const RayInstance& instance : instances)
        list.push_back({instance});
    return list;
}

std::vector<RayTracingHost::Instance> RayTracingHost::reversed(const std::vector<RayInstance>& instances) {
    std::vector<Instance> list;
    for (uint32_t i = static_cast<uint32_t>(instances.size()); i-- > 0;)
        list.push_back({instances[i], i});
    return list;
}

void RayTracingHost::write(Top& top, const std::vector<Instance>& instances) {
    std::vector<VkAccelerationStructureInstanceKHR> records;
    for (const Instance& instance : instances) {
        const RayInstance& placed = instance.placed;
        VkAccelerationStructureInstanceKHR& record = records.emplace_back(VkAccelerationStructureInstanceKHR{});
        for (size_t row = 0; row < 3; ++row)
            for (size_t column = 0; column < 4; ++column)
                record.transform.matrix[row][column] = placed.localToWorld[column * 4 + row];
        record.instanceCustomIndex = instance.customIndex & 0xffffff;
        record.mask = placed.mask;
        VkGeometryInstanceFlagsKHR flags = 0;
        if (instance.forcesOpacity)
            flags |= placed.opaque ? VK_GEOMETRY_INSTANCE_FORCE_OPAQUE_BIT_KHR
                                   : VK_GEOMETRY_INSTANCE_FORCE_NO_OPAQUE_BIT_KHR;
        if (placed.doubleSided)
            flags |= VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
        record.flags = flags & 0xff;
        record.accelerationStructureReference = bottoms_[placed.mesh].structure->address();
    }
    if (!top.instances)
        top.instances = inputBuffer(context_, records);
    else
        std::memcpy(top.instances.mapped(), records.data(), top.instances.size());
}

size_t RayTracingHost::addTop(const std::vector<Instance>& instances) {
    Top& top = tops_.emplace_back();
    write(top, instances);
    VkAccelerationStructureGeometryKHR geometry = {
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR, nullptr, VK_GEOMETRY_TYPE_INSTANCES_KHR, {}, 0};
    geometry.geometry.instances = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR};
    geometry.geometry.instances.data.deviceAddress = top.instances.address();
    top.structure =
        std::make_unique<HostStructure>(context_, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, false,
                                        std::vector{geometry}, std::vector{static_cast<uint32_t>(instances.size())});
    return tops_.size() - 1;
}

void RayTracingHost::move(size_t bottom, const std::vector<glm::vec3>& positions) {
    std::memcpy(bottoms_[bottom].buffers.front().mapped(), positions.data(), positions.size() * sizeof(glm::vec3));
}

void RayTracingHost::buildBottoms(VkCommandBuffer commands) const {
    for (const Bottom& bottom : bottoms_)
        bottom.structure->build(commands);
    barrier(context_, commands, kBuild, kWrite, kBuild | kTrace, kRead);
}

void RayTracingHost::refitBottom(VkCommandBuffer commands, size_t bottom) const {
    barrier(context_, commands, kTrace | kBuild, kWrite, kBuild, kRead | kWrite);
    bottoms_[bottom].structure->build(commands, true);
    barrier(context_, commands, kBuild, kWrite, kBuild | kTrace, kRead);
}

void RayTracingHost::buildTop(VkCommandBuffer commands, size_t top) const {
    barrier(context_, commands, kTrace | kBuild, kWrite, kBuild, kRead | kWrite);
    tops_[top].structure->build(commands);
    barrier(context_, commands, kBuild, kWrite, kTrace, kRead);
}

void RayTracingHost::buildAll(VkCommandBuffer commands) const {
    buildBottoms(commands);
    for (size_t top = 0; top < tops_.size(); ++top)
        buildTop(commands, top);
}

} // namespace glint::test
