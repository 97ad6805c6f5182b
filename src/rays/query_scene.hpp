// Back end `query`: the driver's acceleration structures, one bottom level a mesh, for shaders/rays/query.glsl.
#pragma once

#include "gpu/pass.hpp"
#include "rays/instance.hpp"
#include "rays/mesh.hpp"

namespace glint::rays {

class QueryScene {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<QueryScene>> create(gpu::Context& context, std::vector<Mesh> meshes,
                                                      uint32_t maxInstances);

    /// Checked by the caller: at most maxInstances, every mesh there.
    void setInstances(std::span<const RayInstance> instances);
    Mesh& mesh(uint32_t index) { return parts_[index].mesh; }
    /// After the mesh's vertices were moved.
    void fitMesh(uint32_t index);

    bool pending() const { return staged_ || topChanged_ || anyDeformed_; }
    void record(gpu::Frame& frame);
    void releaseStaging();
    void bind(gpu::Pass& pass) { pass.read("scene", top_); }

private:
    QueryScene() = default;

    struct Part {
        Mesh mesh; ///< positions are kept of meshes that deform only
        size_t firstVertex = 0;
        gpu::AccelerationStructure structure; ///< none for a mesh without triangles
        bool deformed = false;
    };

    std::vector<Part> parts_;
    std::vector<VkAccelerationStructureInstanceKHR> records_; ///< maxInstances of them; inactive ones behind
    bool topChanged_ = false;
    bool anyDeformed_ = false;
    bool staged_ = true; ///< the first record has not been
    gpu::Buffer positionStaging_, indexStaging_;
    gpu::Buffer positions_, indices_, instances_;
    gpu::Buffer scratch_;
    gpu::AccelerationStructure top_;
};

} // namespace glint::rays
