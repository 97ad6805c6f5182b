// A host that traces rays itself: acceleration structures made without Glint's help, from the triangles of a test.
#pragma once

#include "gpu/support/ray_test.hpp"

#include <deque>

namespace glint::test {

/// One acceleration structure; `build` fills it on the GPU.
class HostStructure {
public:
    HostStructure(gpu::Context& context, VkAccelerationStructureTypeKHR type, bool deforms,
                  std::vector<VkAccelerationStructureGeometryKHR> geometries, const std::vector<uint32_t>& primitives);
    ~HostStructure();
    HostStructure(const HostStructure&) = delete;
    HostStructure& operator=(const HostStructure&) = delete;

    VkAccelerationStructureKHR handle() const { return handle_; }
    VkDeviceAddress address() const { return address_; }
    void build(VkCommandBuffer commands, bool refit = false) const;

private:
    VkAccelerationStructureBuildGeometryInfoKHR info() const;

    gpu::Context& context_;
    VkAccelerationStructureTypeKHR type_;
    VkBuildAccelerationStructureFlagsKHR flags_ = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    std::vector<VkAccelerationStructureGeometryKHR> geometries_;
    std::vector<VkAccelerationStructureBuildRangeInfoKHR> ranges_;
    gpu::Buffer storage_, scratch_;
    VkAccelerationStructureKHR handle_ = VK_NULL_HANDLE;
    VkDeviceAddress address_ = 0;
};

/// Bottom levels, and top levels of them. The barriers are those that RayScene::adopt asks of a host.
class RayTracingHost {
public:
    struct Geometry {
        const TestMesh* mesh = nullptr;
        bool opaque = false; ///< an instance may force either
    };
    struct Instance {
        RayInstance placed; ///< mesh: number of the bottom level
        uint32_t customIndex = 0;
        bool forcesOpacity = true; ///< false: RayInstance::opaque has no effect, its geometries tell
    };

    /// The geometries of each bottom level. A bottom level deforms if its first mesh does.
    RayTracingHost(gpu::Context& context, const std::vector<std::vector<Geometry>>& bottoms);
    /// One bottom level for each mesh.
    RayTracingHost(gpu::Context& context, const TestScene& scene);

    /// In this order, without custom indices.
    static std::vector<Instance> inOrder(const std::vector<RayInstance>& instances);
    /// In reverse order; custom indices are the numbers in the list.
    static std::vector<Instance> reversed(const std::vector<RayInstance>& instances);
    /// Returns a new top level's number.
    size_t addTop(const std::vector<Instance>& instances);
    VkAccelerationStructureKHR top(size_t number) const { return tops_[number].structure->handle(); }

    /// Writes other instances, as many. The GPU must be done with this top level.
    void setInstances(size_t top, const std::vector<Instance>& instances) { write(tops_[top], instances); }
    /// Writes other positions of a mesh, the first of its bottom level. The GPU must be done with it.
    void move(size_t bottom, const std::vector<glm::vec3>& positions);

    void buildBottoms(VkCommandBuffer commands) const;
    void refitBottom(VkCommandBuffer commands, size_t bottom) const;
    void buildTop(VkCommandBuffer commands, size_t top) const;
    void buildAll(VkCommandBuffer commands) const;

private:
    struct Bottom {
        std::deque<gpu::Buffer> buffers; ///< positions, indices of each geometry
        std::unique_ptr<HostStructure> structure;
    };
    struct Top {
        gpu::Buffer instances;
        std::unique_ptr<HostStructure> structure;
    };
    void write(Top& top, const std::vector<Instance>& instances);

    gpu::Context& context_;
    std::vector<Bottom> bottoms_;
    std::vector<Top> tops_;
};

} // namespace glint::test
