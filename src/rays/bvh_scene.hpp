// Back end `bvh`: Glint's own hierarchy of two levels, built on the CPU, in three storage buffers that
// shaders/rays/bvh.glsl traverses.
#pragma once

#include "gpu/pass.hpp"
#include "rays/instance.hpp"
#include "rays/mesh.hpp"
#include "rays/wide_bvh.hpp"

namespace glint::rays {

class BvhScene {
public:
    /// Errors: OutOfMemory; Unsupported for buffers larger than the device lets a shader see.
    static Result<BvhScene> create(gpu::Context& context, std::vector<Mesh> meshes, uint32_t maxInstances);

    /// Checked by the caller: at most maxInstances, every mesh there.
    void setInstances(std::span<const RayInstance> instances);
    Mesh& mesh(uint32_t index) { return parts_[index].mesh; }
    /// After the mesh's vertices were moved.
    void fitMesh(uint32_t index);

    bool pending() const { return staged_ || topChanged_ || anyDeformed_; }
    void record(gpu::Frame& frame);
    void releaseStaging();
    void bind(gpu::Pass& pass);

private:
    struct Part {
        // Once uploaded, these three are kept of meshes that deform only.
        Mesh mesh;
        WideBvh tree;
        std::vector<uint32_t> kept; ///< by primitive of the tree: the triangle's number
        Bounds bounds;
        uint32_t firstNode = 0;
        uint32_t firstTriangle = 0;
        bool deformed = false;
    };

    static std::vector<Bounds> boxesOf(const Part& part);
    void writeNodes(const Part& part, shared::BvhNode* out) const;
    void writeTriangles(const Part& part, shared::BvhTriangle* out) const;
    void fitTop();

    std::vector<Part> parts_;
    uint32_t maxInstances_ = 0;
    std::vector<RayInstance> instances_;
    WideBvh top_;
    std::vector<uint32_t> topInstances_; ///< by primitive of the top: its place in the host's list
    double topCost_ = 0;                 ///< when it was built
    std::vector<shared::BvhInstance> topRecords_;
    bool topChanged_ = false;
    bool anyDeformed_ = false;
    bool staged_ = true; ///< the first record has not been
    gpu::Buffer nodeStaging_, triangleStaging_;
    gpu::Buffer nodes_, triangles_, instanceRecords_;
};

} // namespace glint::rays
