// VK_KHR_acceleration_structure, for ray queries: a bottom level is built from triangles, a top level from instances of
// bottom levels. Creation only allocates; Frame::build and Frame::refit fill a structure on the GPU.
#pragma once

#include "gpu/resources.hpp"

namespace glint::gpu {

/// The triangles of one mesh, in buffers created with kBuildInputUsage.
struct TriangleRange {
    Buffer* positions = nullptr; ///< three floats per vertex, tightly packed
    size_t positionOffset = 0;   ///< bytes
    uint32_t vertexCount = 0;
    Buffer* indices = nullptr; ///< uint32, relative to the first vertex; all below vertexCount
    size_t indexOffset = 0;    ///< bytes
    uint32_t triangleCount = 0;
};

constexpr VkBufferUsageFlags kBuildInputUsage = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR |
                                                VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT |
                                                VK_BUFFER_USAGE_TRANSFER_DST_BIT;

/// Movable; destroys its Vulkan objects. Requires Context::rayQuery.
class AccelerationStructure {
public:
    AccelerationStructure() = default;
    /// `deforms`: Frame::refit will be called on this structure, so that it is built as updatable. Errors: OutOfMemory.
    static Result<AccelerationStructure> bottom(Context& context, std::string name, const TriangleRange& triangles,
                                                bool deforms);
    /// `instances` holds `count` VkAccelerationStructureInstanceKHR, which refer to `bottoms` by address. `instances`
    /// and `bottoms` must outlive the structure. Errors: OutOfMemory.
    static Result<AccelerationStructure> top(Context& context, std::string name, Buffer& instances, uint32_t count,
                                             std::vector<AccelerationStructure*> bottoms);
    ~AccelerationStructure() { destroy(); }
    AccelerationStructure(AccelerationStructure&& other) noexcept { swap(other); }
    AccelerationStructure& operator=(AccelerationStructure&& other) noexcept { return swap(other), *this; }

    explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
    VkAccelerationStructureKHR handle() const { return handle_; }
    VkDeviceAddress address() const { return address_; } ///< the address that instance records contain
    Buffer& storage() { return storage_; }               ///< the buffer that barriers refer to
    std::span<Buffer* const> inputs() const { return inputs_; }
    std::span<AccelerationStructure* const> references() const { return references_; }
    /// Bytes of scratch memory that a build or refit requires, alignment included.
    size_t scratchSize() const { return scratchSize_; }

private:
    friend class Frame;

    Result<void> allocate(Context& context, std::string name, uint32_t primitives);
    VkAccelerationStructureBuildGeometryInfoKHR buildInfo(const VkAccelerationStructureGeometryKHR& geometry) const;
    void recordBuild(VkCommandBuffer commands, Buffer& scratch, size_t scratchOffset, bool refit) const;
    void destroy();
    void swap(AccelerationStructure& other);

    Context* context_ = nullptr;
    VkAccelerationStructureTypeKHR type_ = VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR;
    VkBuildAccelerationStructureFlagsKHR flags_ = 0;
    VkAccelerationStructureGeometryKHR geometry_ = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
    uint32_t primitives_ = 0;
    size_t scratchSize_ = 0;
    std::vector<Buffer*> inputs_;
    std::vector<AccelerationStructure*> references_;
    Buffer storage_;
    VkAccelerationStructureKHR handle_ = VK_NULL_HANDLE;
    VkDeviceAddress address_ = 0;
};

} // namespace glint::gpu
