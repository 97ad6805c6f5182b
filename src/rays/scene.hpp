// What stands behind glint::RayScene: the host's lists checked, one of the two back ends, and what building took.
#pragma once

#include "glint/ray_scene.hpp"
#include "gpu/timers.hpp"
#include "rays/bvh_scene.hpp"
#include "rays/query_scene.hpp"

#include <variant>

namespace glint::rays {

class Scene {
public:
    static Result<std::unique_ptr<Scene>> create(gpu::Context& context, const RaySceneDesc& desc);

    RayBackend backend() const { return backend_; }
    uint32_t instanceCount() const { return instanceCount_; }
    Result<void> setInstances(std::span<const RayInstance> instances);
    Result<void> deform(uint32_t mesh, const float* positions, uint32_t vertexCount, uint32_t vertexStride);
    void record(VkCommandBuffer commands);
    void releaseStaging();
    RaySceneTimes times();

    /// Gives the pass the scene, as shaders/rays/query.glsl or bvh.glsl of the same back end declares it:
    ///   scene.bind(frame.pass(pipeline)).read("...", ...).dispatch(...)
    gpu::Pass& bind(gpu::Pass& pass);
    gpu::Pass& bind(gpu::Pass&& pass) { return bind(pass); } ///< lives as long as the expression

private:
    explicit Scene(gpu::Context& context) : context_(context) {}
    Result<void> check(std::span<const RayInstance> instances) const;

    gpu::Context& context_;
    RayBackend backend_ = RayBackend::Bvh;
    std::variant<std::unique_ptr<BvhScene>, std::unique_ptr<QueryScene>> scene_;
    std::unique_ptr<gpu::Timers> timers_;
    RaySceneTimes times_;
    std::vector<uint32_t> deformable_; ///< by mesh: its vertices if it deforms, else 0
    uint32_t maxInstances_ = 0;
    uint32_t instanceCount_ = 0;
    bool recorded_ = false; ///< buffers hold a scene: a garbled one could keep a GPU busy for good
};

} // namespace glint::rays
