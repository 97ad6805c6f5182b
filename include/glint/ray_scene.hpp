// The host's triangles and their instances, ready for rays. Optional: without one Glint reflects what is on screen.
#pragma once

#include "glint/api.hpp"
#include "glint/context.hpp"
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

/// Triangles in their own space. Read during RayScene::create alone.
struct RayMesh {
    const float* positions = nullptr; ///< x, y, z of each vertex
    uint32_t vertexCount = 0;
    uint32_t vertexStride = 12;        ///< bytes from vertex to vertex, >= 12
    std::span<const uint32_t> indices; ///< three a triangle, counter-clockwise as seen from its front
    bool deforms = false;              ///< RayScene::deform will be called
};

/// A mesh placed in the world. Its place in the host's list is what a hit reports.
struct RayInstance {
    uint32_t mesh = 0;
    Matrix4 localToWorld = kIdentity; ///< affine
    uint8_t mask = 0xff;              ///< rays meet it if their own mask shares a bit
    bool opaque = true;               ///< false: the shader is asked about each triangle that a ray meets (alpha tests)
    bool doubleSided = true;          ///< false: rays that cull back faces pass through them
};

struct RaySceneDesc {
    std::span<const RayMesh> meshes;
    std::span<const RayInstance> instances;
    uint32_t maxInstances = 0; ///< most that setInstances may be given; at least as many as `instances`
    RayBackend backend = RayBackend::Auto;
};

/// What building took. GPU times come some frames later; 0 until then, and with the Bvh back end.
struct RaySceneTimes {
    double cpuBuildMs = 0;  ///< create: hierarchies (Bvh) or preparing buffers (Query)
    double cpuUpdateMs = 0; ///< the last setInstances or deform
    double gpuBuildMs = 0;  ///< of the record that built meshes
    double gpuUpdateMs = 0; ///< of the last record that built or fitted anything
};

/// Both back ends find the same hits. Triangles with a vertex that is NaN, infinite or beyond 1e18 m are left out, as
/// are instances with such a transform or a singular one; empty scenes are fine. Threading: external synchronisation.
class GLINT_API RayScene {
public:
    /// Copies the triangles; with the Bvh back end it builds the hierarchies too: about a second a million triangles.
    /// Errors: InvalidArgument for an index or a mesh number that is out of range; Unsupported for Query on a device
    /// without it, or a scene larger than its storage buffers; OutOfMemory. `context` must outlive the scene.
    static Result<RayScene> create(Context& context, const RaySceneDesc& desc);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    RayBackend backend() const; ///< Query or Bvh

    /// All instances anew: moved, added or taken away. Takes effect with the next record.
    /// Errors: InvalidArgument as in create, and for more than maxInstances.
    Result<void> setInstances(std::span<const RayInstance> instances);
    /// Moves the vertices of a mesh that was made with `deforms`; a position that is not finite keeps its old place.
    /// The tree stays as it was built and is fitted to them. Takes effect with the next record.
    /// Errors: InvalidArgument for another mesh or another number of vertices.
    Result<void> deform(uint32_t mesh, const float* positions, uint32_t vertexCount, uint32_t vertexStride = 12);

    /// Records what the calls above left to do, outside of rendering, before anything that traces; nothing if there is
    /// nothing. It never submits or waits. The first one copies from memory that the scene keeps until
    /// releaseStaging; updates travel in the command buffer itself, so any number of frames may be in flight.
    void record(VkCommandBuffer commands);
    /// Frees what only the first record needed. Call once the GPU is done with it.
    void releaseStaging();

    RaySceneTimes times();

    rays::Scene& scene() { return *scene_; } ///< for Glint's own classes
    /// The same: gives a pass the scene, as the ray seam of this back end declares it.
    void bind(gpu::Pass& pass);

private:
    explicit RayScene(std::unique_ptr<rays::Scene> scene);
    std::unique_ptr<rays::Scene> scene_;
};

} // namespace glint
