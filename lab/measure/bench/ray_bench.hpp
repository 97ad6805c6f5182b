// Measures the cost of rays on a scene with a given number of triangles: building, moving, deforming and tracing, with
// each back end of the device, on the same rays. Also compares the hits of the back ends.
#pragma once

#include "glint/context.hpp"
#include "glint/ray_scene.hpp"
#include "gpu/context.hpp"
#include "lab/measure/bench/effect_times.hpp"

#include <optional>

namespace glint::measure {

struct RayBenchPlan {
    uint64_t triangles = 0; ///< of the meshes, approximately; >= 100
    uint32_t rays = 0;      ///< per list, approximately; >= 64
    uint32_t repeats = 5;   ///< of each measurement except building; >= 1
};

/// The cost of a scene change, from the host's call until the GPU has finished. Medians, in milliseconds.
struct RayUpdateTimes {
    double cpuMs = 0;  ///< the call, and recording
    double wallMs = 0; ///< submitting and waiting
    double gpuMs = 0;  ///< from timestamps; 0: unknown, as with Bvh
};

struct RayTraceTimes {
    uint64_t rays = 0;
    uint64_t met = 0;
    Spread gpuMs;  ///< from timestamps; 0 without them
    Spread wallMs; ///< submitting and waiting
    /// Rays whose hits differ from those of the previous back end. None: there is no previous back end.
    std::optional<uint64_t> differ;
};

struct RayBackendFigures {
    RayBackend backend = RayBackend::Bvh;
    std::string refused;   ///< why the scene could not be created; all figures except createMs are 0 then
    double createMs = 0;   ///< CPU time of RayScene::create, also if it failed
    RayUpdateTimes build;  ///< recording and executing the rest of the build; cpuMs is the time of recording
    size_t bytes = 0;      ///< device memory after staging memory is freed
    size_t mostBytes = 0;  ///< device memory including staging memory
    RayUpdateTimes move;   ///< setInstances: all instances but one moved
    RayUpdateTimes deform; ///< deform: one mesh
    RayTraceTimes camera;  ///< coherent rays, side by side
    RayTraceTimes bounce;  ///< rays in random directions, from the hits of the camera's rays
    RayTraceTimes changed; ///< the camera's rays after moving and deforming: traced once
};

struct RayBenchFigures {
    uint64_t triangles = 0; ///< of the meshes
    uint64_t placed = 0;    ///< of the instances
    uint64_t deformed = 0;  ///< of the mesh that is deformed
    uint32_t meshes = 0;
    uint32_t instances = 0;
    std::vector<RayBackendFigures> backends; ///< Query, if the device has ray queries, and Bvh

    uint64_t differing() const; ///< rays of all lists whose hits differ
    uint64_t compared() const;  ///< number of compared rays
};

/// `context` must have been created, not adopted; `library` must use the same device. Errors: OutOfMemory, DeviceLost.
/// A back end that rejects the scene is not an error.
Result<RayBenchFigures> measureRays(gpu::Context& context, Context& library, const RayBenchPlan& plan);

} // namespace glint::measure
