// Back end `bvh`: Glint's own two-level hierarchy, built on the CPU and stored in three buffers that
// shaders/rays/bvh.glsl traverses.
#pragma once

#include "gpu/dirty_ranges.hpp"
#include "gpu/pass.hpp"
#include "gpu/progress.hpp"
#include "rays/instance.hpp"
#include "rays/mesh.hpp"
#include "rays/wide_bvh.hpp"

namespace glint::rays {

class BvhScene {
public:
    /// Does the device have buffers for so many triangles and instances?
    static bool fits(const gpu::Context& context, size_t triangles, size_t instances);
    /// Errors: OutOfMemory; Unsupported for buffers larger than the device makes.
    static Result<BvhScene> create(gpu::Context& context, std::vector<Mesh> meshes, uint32_t maxInstances);

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
    void bind(gpu::Pass& pass);

private:
    struct Part {
        // After the upload, these three are kept only for meshes that deform.
        Mesh mesh;
        WideBvh tree;
        std::vector<uint32_t> kept; ///< by primitive of the tree: the number of the triangle
        Bounds bounds;
        uint32_t firstNode = 0;
        uint32_t firstTriangle = 0;
        bool deformed = false;
    };

    static std::vector<Bounds> boxesOf(const Part& part);
    void writeNodes(const Part& part, shared::BvhNode* out) const;
    void writeTriangles(const Part& part, shared::BvhTriangle* out) const;
    /// An instance as the top level holds it.
    struct Placed {
        Bounds boundsWS;
        shared::BvhInstance record;
    };
    /// No value for an instance that no ray intersects.
    std::optional<Placed> place(uint32_t instance) const;
    void fitTop();
    /// Places these instances again. Returns false, having changed nothing, if one appeared or disappeared.
    bool replace(uint32_t first, uint32_t count);

    std::vector<Part> parts_;
    uint32_t maxInstances_ = 0;
    std::vector<RayInstance> instances_;
    WideBvh top_;
    std::vector<uint32_t> topInstances_; ///< by primitive of the top level: the index in the host's list, ascending
    std::vector<Bounds> topBoxes_;       ///< by primitive of the top level
    std::optional<BvhLinks> topLinks_;   ///< of top_; absent until a part of it changes
    double topCost_ = 0;                 ///< cost when the top level was built
    size_t moved_ = 0;                   ///< instances placed again since the cost was computed
    std::vector<shared::BvhInstance> topRecords_;
    gpu::Standing topUpload_; ///< of the dirty bytes
    gpu::DirtyRanges dirtyNodes_, dirtyRecords_;
    gpu::Standing deformedUpload_ = gpu::Standing(false); ///< of the parts with `deformed`
    gpu::Standing upload_;                                ///< of all other data, from the staging buffers
    gpu::Buffer nodeStaging_, triangleStaging_;
    gpu::Buffer nodes_, triangles_, instanceRecords_;
    gpu::Buffer addresses_; ///< of these three
};

} // namespace glint::rays
