#include "gpu/acceleration_structure.hpp"

#include "base/assert.hpp"

#include <algorithm>

namespace glint::gpu {

Result<AccelerationStructure> AccelerationStructure::bottom(Context& context, std::string name,
                                                            const TriangleRange& triangles, bool deforms) {
    AccelerationStructure structure;
    structure.type_ = VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR;
    structure.flags_ = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    if (deforms)
        structure.flags_ |= VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_UPDATE_BIT_KHR;
    structure.inputs_ = {triangles.positions, triangles.indices};
    structure.geometry_.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
    VkAccelerationStructureGeometryTrianglesDataKHR& data = structure.geometry_.geometry.triangles;
    data = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR};
    data.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
    data.vertexData.deviceAddress = triangles.positions->address() + triangles.positionOffset;
    data.vertexStride = 3 * sizeof(float);
    data.maxVertex = std::max(triangles.vertexCount, 1u) - 1;
    data.indexType = VK_INDEX_TYPE_UINT32;
    data.indexData.deviceAddress = triangles.indices->address() + triangles.indexOffset;
    GLINT_CHECK(structure.allocate(context, std::move(name), triangles.triangleCount));
    return structure;
}

Result<AccelerationStructure> AccelerationStructure::top(Context& context, std::string name, Buffer& instances,
                                                         uint32_t count, std::vector<AccelerationStructure*> bottoms) {
    AccelerationStructure structure;
    structure.type_ = VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR;
    structure.flags_ = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    structure.inputs_ = {&instances};
    structure.references_ = std::move(bottoms);
    structure.geometry_.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
    VkAccelerationStructureGeometryInstancesDataKHR& data = structure.geometry_.geometry.instances;
    data = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR};
    data.data.deviceAddress = instances.address();
    GLINT_CHECK(structure.allocate(context, std::move(name), count));
    return structure;
}

VkAccelerationStructureBuildGeometryInfoKHR
AccelerationStructure::buildInfo(const VkAccelerationStructureGeometryKHR& geometry) const {
    VkAccelerationStructureBuildGeometryInfoKHR info = {
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
    info.type = type_;
    info.flags = flags_;
    info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
    info.geometryCount = 1;
    info.pGeometries = &geometry;
    return info;
}

Result<void> AccelerationStructure::allocate(Context& context, std::string name, uint32_t primitives) {
    GLINT_ASSERT(context.rayQuery(), "{}: ray queries are not enabled", name);
    context_ = &context;
    primitives_ = primitives;
    const VkAccelerationStructureBuildGeometryInfoKHR build = buildInfo(geometry_);
    VkAccelerationStructureBuildSizesInfoKHR sizes = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
    context.api().GetAccelerationStructureBuildSizesKHR(
        context.device(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &build, &primitives, &sizes);
    // The scratch address is rounded up inside the buffer.
    scratchSize_ = std::max(sizes.buildScratchSize, sizes.updateScratchSize) + context.scratchAlignment();
    GLINT_TRY(storage, Buffer::create(context, {std::move(name), std::max<size_t>(sizes.accelerationStructureSize, 16),
                                                VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR |
                                                    VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
                                                BufferHome::Device}));
    storage_ = std::move(storage);
    VkAccelerationStructureCreateInfoKHR info = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR};
    info.buffer = storage_.handle();
    info.size = sizes.accelerationStructureSize;
    info.type = type_;
    if (const VkResult result =
            context.api().CreateAccelerationStructureKHR(context.device(), &info, context.callbacks(), &handle_);
        result != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "acceleration structure '{}' cannot be created: VkResult {}",
                         storage_.name(), static_cast<int>(result));
    context.nameObject(VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, reinterpret_cast<uint64_t>(handle_),
                       storage_.name().c_str());
    const VkAccelerationStructureDeviceAddressInfoKHR asked = {
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR, nullptr, handle_};
    address_ = context.api().GetAccelerationStructureDeviceAddressKHR(context.device(), &asked);
    return {};
}

void AccelerationStructure::recordBuild(VkCommandBuffer commands, Buffer& scratch, size_t scratchOffset,
                                        bool refit) const {
    GLINT_ASSERT(!refit || (flags_ & VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_UPDATE_BIT_KHR),
                 "refit of a structure that was not made for it");
    GLINT_ASSERT(scratchOffset + scratchSize_ <= scratch.size(),
                 "a build of {} bytes at {} of {} bytes of scratch memory", scratchSize_, scratchOffset,
                 scratch.size());
    const VkDeviceSize alignment = context_->scratchAlignment();
    VkAccelerationStructureBuildGeometryInfoKHR info = buildInfo(geometry_);
    info.dstAccelerationStructure = handle_;
    info.scratchData.deviceAddress = (scratch.address() + scratchOffset + alignment - 1) / alignment * alignment;
    if (refit) {
        info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_UPDATE_KHR;
        info.srcAccelerationStructure = handle_;
    }
    const VkAccelerationStructureBuildRangeInfoKHR range = {primitives_, 0, 0, 0};
    const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range;
    context_->api().CmdBuildAccelerationStructuresKHR(commands, 1, &info, &ranges);
}

void AccelerationStructure::destroy() {
    if (context_ && handle_)
        context_->api().DestroyAccelerationStructureKHR(context_->device(), handle_, context_->callbacks());
    handle_ = VK_NULL_HANDLE;
}

void AccelerationStructure::swap(AccelerationStructure& other) {
    std::swap(context_, other.context_);
    std::swap(type_, other.type_);
    std::swap(flags_, other.flags_);
    std::swap(geometry_, other.geometry_);
    std::swap(primitives_, other.primitives_);
    std::swap(scratchSize_, other.scratchSize_);
    std::swap(inputs_, other.inputs_);
    std::swap(references_, other.references_);
    std::swap(storage_, other.storage_);
    std::swap(handle_, other.handle_);
    std::swap(address_, other.address_);
}

} // namespace glint::gpu
