// Back end `query`: the driver's acceleration structures, one bottom level per mesh, for shaders/rays/query.glsl.
#pragma once

#include "gpu/dirty_ranges.hpp"
#include "gpu/pass.hpp"
#include "gpu/progress.hpp"
#include "rays/instance.hpp"
#include "rays/mesh.hpp"

namespace glint::rays {

class QueryScene {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<QueryScene>> create(gpu::Context& context, std::vector<Mesh> meshes,
                                                      uint32_t maxInstances);

    /// Requires, checked by the caller: at most maxInstances, and every mesh exists.
    void setInstances(std::span<const RayInstance> instances);
    /// Requires, checked by the caller: they exist.
    void updateInstances(uint32_t first, std::span<const RayInstance> instances);
    Mesh& mesh(uint32_t index) { return parts_[index].mesh; }
    /// Call after the mesh's vertices were moved.
    void fitMesh(uint32_t index);

    bool pending(const gpu::Progress& progress);
    void record(gpu::Frame& frame, const gpu::Progress& progress);
    void releaseStaging(const gpu::Progress& progress);
    void bind(gpu::Pass& pass) { pass.read("scene", top_); }

private:
    QueryScene() = default;
    void place(size_t first, std::span<const RayInstance> instances);

    struct Part {
        Mesh mesh; ///< positions are kept only for meshes that deform
        size_t firstVertex = 0;
        gpu::AccelerationStructure structure; ///< empty for a mesh without triangles
        bool deformed = false;
    };

    std::vector<Part> parts_;
    std::vector<VkAccelerationStructureInstanceKHR> records_; ///< maxInstances records; the inactive ones last
    gpu::DirtyRanges dirty_;                                  ///< bytes of records_, since the GPU had all of them
    gpu::Standing topUpload_;
    gpu::Standing deformedUpload_ = gpu::Standing(false); ///< of the parts with `deformed`
    gpu::Standing upload_;                                ///< of all other data, from the staging buffers
    gpu::Buffer positionStaging_, indexStaging_;
    gpu::Buffer positions_, indices_, instances_;
    gpu::Buffer scratch_;
    gpu::AccelerationStructure top_;
};

} // namespace glint::rays
