// What rays cost on a scene of so many triangles: building, moving, deforming and tracing, with each back end that the
// device has, on the same rays; and whether the back ends found the same hits.
#pragma once

#include "glint/context.hpp"
#include "glint/ray_scene.hpp"
#include "gpu/context.hpp"
#include "measure/effect_times.hpp"

#include <optional>

namespace glint::measure {

struct RayBenchPlan {
    uint64_t triangles = 0; ///< of the meshes, about; >= 100
    uint32_t rays = 0;      ///< of each list, about; >= 64
    uint32_t repeats = 5;   ///< of each measurement but building; >= 1
};

/// A change of the scene, from the host's call until the GPU is done. Medians, in milliseconds.
struct RayUpdateTimes {
    double cpuMs = 0;  ///< the call, and recording
    double wallMs = 0; ///< submitting and waiting
    double gpuMs = 0;  ///< by timestamps; 0: not known, as with Bvh
};

struct RayTraceTimes {
    uint64_t rays = 0;
    uint64_t met = 0;
    Spread gpuMs;  ///< by timestamps; 0 without them
    Spread wallMs; ///< submitting and waiting
    /// Rays whose hits differ from those of the back end before. None: there was none to compare with.
    std::optional<uint64_t> differ;
};

struct RayBackendFigures {
    RayBackend backend = RayBackend::Bvh;
    std::string refused;   ///< why there is no such scene here; all but createMs is 0 then
    double createMs = 0;   ///< CPU: RayScene::create, also where it refused in the end
    RayUpdateTimes build;  ///< recording and running what create left to do; cpuMs is the recording's
    size_t bytes = 0;      ///< of device memory, staging freed
    size_t mostBytes = 0;  ///< with staging memory
    RayUpdateTimes move;   ///< setInstances: all but one of them moved
    RayUpdateTimes deform; ///< deform: one of the meshes
    RayTraceTimes camera;  ///< side by side
    RayTraceTimes bounce;  ///< in any direction, from where the camera's rays met the scene
    RayTraceTimes changed; ///< the camera's, after moving and deforming: traced once
};

struct RayBenchFigures {
    uint64_t triangles = 0; ///< of the meshes
    uint64_t placed = 0;    ///< of the instances
    uint64_t deformed = 0;  ///< of the mesh that is deformed
    uint32_t meshes = 0;
    uint32_t instances = 0;
    std::vector<RayBackendFigures> backends; ///< Query, if the device has ray queries, and Bvh

    uint64_t differing() const; ///< rays of all lists whose hits differ
    uint64_t compared() const;  ///< of so many
};

/// `context` must have been created, not adopted; `library` must stand on the same device.
/// Errors: OutOfMemory, DeviceLost. A back end that refuses the scene is no error.
Result<RayBenchFigures> measureRays(gpu::Context& context, Context& library, const RayBenchPlan& plan);

} // namespace glint::measure
