// SPDX-License-Identifier: MIT
// The host's triangles and instances for ray tracing, or its own acceleration structure. Optional: without a RayScene
// the source `rays` is not available.
#pragma once

#include "glint/api.h"
#include "glint/context.hpp"
#include "glint/host_acceleration_structure.hpp"
#include "glint/ray_backend.hpp"
#include "glint/view.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace glint {

namespace rays {
class Scene;
}
namespace gpu {
class Pass;
}

/// Triangles in local space. Glint reads the data during RayScene::create only.
struct RayMesh {
    const float* positions = nullptr; ///< x, y, z of each vertex
    uint32_t vertexCount = 0;
    uint32_t vertexStride = 12;        ///< bytes from vertex to vertex, >= 12
    std::span<const uint32_t> indices; ///< three per triangle, counter-clockwise seen from the front
    bool deforms = false;              ///< true if RayScene::deform will be called for this mesh
};

/// A mesh placed in the world. Hits report the index of the instance in the host's list.
struct RayInstance {
    uint32_t mesh = 0;
    Matrix4 localToWorld = kIdentity; ///< affine
    uint8_t mask = 0xff;              ///< rays intersect it if their mask shares a bit with this mask
    bool opaque = true;               ///< false: the shader tests each intersected triangle (alpha tests)
    bool doubleSided = true;          ///< false: rays that cull back faces pass through its back faces
};

struct RaySceneDesc {
    std::span<const RayMesh> meshes;
    std::span<const RayInstance> instances;
    uint32_t maxInstances = 0; ///< maximum count for setInstances; raised to the count of `instances`
    RayBackend backend = RayBackend::Auto;
};

/// Build times. GPU times arrive some frames later; they are 0 until then, and with the Bvh back end.
struct RaySceneTimes {
    double cpuBuildMs = 0;  ///< create: building hierarchies (Bvh) or preparing buffers (Query)
    double cpuUpdateMs = 0; ///< the last setInstances, updateInstances or deform
    double gpuBuildMs = 0;  ///< the record that built meshes
    double gpuUpdateMs = 0; ///< the last record that built or refitted
};

/// Acceleration structures of the host's triangles: made by Glint with `create`, or the host's own with `adopt`. Both
/// back ends find the same hits. `create` skips triangles with a vertex that is NaN, infinite or beyond 1e18 m, and
/// instances with such a transform or a singular one. Empty scenes are valid. Threading: external synchronization.
class GLINT_API RayScene {
public:
    /// Copies the triangles. With the Bvh back end it also builds the hierarchies, in about 1 s per million triangles.
    /// Errors: InvalidArgument for a vertex index or a mesh index out of range; Unsupported for Query on a device
    /// without ray queries, or for a scene larger than the device's buffers; OutOfMemory.
    static Result<RayScene> create(Context& context, const RaySceneDesc& desc);
    /// Traces through the host's own top level instead, by the Query back end. Copies nothing, builds nothing and takes
    /// no device memory; the same geometry gives the same hits as with `create`.
    ///
    /// Each command buffer that Glint records traces the top level of the last call of `adopt` or
    /// setAccelerationStructure before it was recorded; the handle and all that it refers to must exist until the GPU
    /// has finished with that command buffer, and Glint never destroys them. The host records two barriers: before
    /// Reflections::record, from ACCELERATION_STRUCTURE_WRITE of its builds to ACCELERATION_STRUCTURE_READ at
    /// COMPUTE_SHADER; and before it builds or refits these structures again, one of execution from COMPUTE_SHADER to
    /// ACCELERATION_STRUCTURE_BUILD.
    ///
    /// On such a scene setInstances, updateInstances and deform return InvalidArgument, because the host makes these
    /// changes in its own structures; `record` records nothing, releaseStaging has no effect, and all times are 0.
    /// Errors: Unsupported on a device without ray queries; InvalidArgument for a null handle, 2^24 instances or more,
    /// triangle counts for another number of instances, or a box with a side that is not a number, beyond 1e18 m or
    /// reversed.
    static Result<RayScene> adopt(Context& context, const HostAccelerationStructure& host);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    RayBackend backend() const; ///< returns Query or Bvh

    /// Replaces the host's top level and the declarations that come with it, each frame if the host has several. Takes
    /// effect with the next command buffer that traces rays; those in flight keep theirs. Cheap, and allowed at any
    /// time between recordings.
    /// Errors: InvalidArgument as in `adopt`, for another `numbering` than there, and for a scene made by `create`.
    Result<void> setAccelerationStructure(const HostAccelerationStructure& host);

    /// Replaces all instances: the host may move, add or remove instances. Takes effect with the next record.
    /// Errors: InvalidArgument as in create, and for more than maxInstances instances.
    Result<void> setInstances(std::span<const RayInstance> instances);
    /// Replaces the instances from `first` on, as many as are given; the others stay. The same hits as with
    /// setInstances. With the Bvh back end, cost and upload are those of the given instances and of the nodes above
    /// them, unless an instance appears or disappears (its transform becomes singular) or the hierarchy is worn out.
    /// The Query back end uploads the given instances and builds its top level on the GPU, as with setInstances.
    /// Errors: InvalidArgument as in create, and for instances after the list's last one.
    Result<void> updateInstances(uint32_t first, std::span<const RayInstance> instances);
    /// Moves the vertices of a mesh created with `deforms`. A vertex with a non-finite position keeps its old position.
    /// The hierarchy is refitted, not rebuilt. Takes effect with the next record.
    /// Errors: InvalidArgument for a mesh created without `deforms`, or for a different vertex count.
    Result<void> deform(uint32_t mesh, const float* positions, uint32_t vertexCount, uint32_t vertexStride = 12);

    /// Records the pending work of the calls above, outside of rendering; without pending work it records nothing. Call
    /// it before any pass that traces rays. Never submits or waits. The first record copies from staging memory that
    /// the scene keeps until releaseStaging. Updates are stored in the command buffer itself, so any number of frames
    /// may be in flight. Until the GPU has executed a record, the next record repeats its work, so a command buffer
    /// that is never submitted causes no error.
    void record(VkCommandBuffer commands);
    /// Frees the staging memory of the first record. Call it after the GPU has finished this record; before that it has
    /// no effect.
    void releaseStaging();

    RaySceneTimes times(); ///< returns the build times

    rays::Scene& scene() { return *scene_; } ///< for Glint's own classes
    /// For Glint's own classes: binds the scene to a pass, as the ray seam of this back end declares it.
    void bind(gpu::Pass& pass);

private:
    explicit RayScene(std::unique_ptr<rays::Scene> scene);
    std::unique_ptr<rays::Scene> scene_;
};

} // namespace glint
