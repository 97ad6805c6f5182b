// A host's own top-level acceleration structure as the scene, and what the host declares of it. Nothing here reads,
// builds or owns the structure.
#pragma once

#include "glint/ray_scene.hpp"
#include "gpu/pass.hpp"
#include "rays/bounds.hpp"

#include <vector>

namespace glint::rays {

class AdoptedScene {
public:
    /// Errors: InvalidArgument.
    static Result<AdoptedScene> create(const HostAccelerationStructure& host);

    /// Replaces handle and declarations; after an error they are as before. Errors: InvalidArgument, also for another
    /// numbering, which the pipelines of the scene were made for.
    Result<void> replace(const HostAccelerationStructure& host);

    InstanceNumbering numbering() const { return numbering_; }
    uint32_t instanceCount() const { return instanceCount_; }
    /// 0 for a host that declares none.
    uint32_t triangleCount(uint32_t instance) const { return triangleCounts_.empty() ? 0 : triangleCounts_[instance]; }
    const Bounds& transparentBounds() const { return transparentBounds_; }
    void bind(gpu::Pass& pass) const { pass.read("scene", topLevel_); }

private:
    AdoptedScene() = default;

    VkAccelerationStructureKHR topLevel_ = VK_NULL_HANDLE;
    InstanceNumbering numbering_ = InstanceNumbering::TopLevelIndex;
    uint32_t instanceCount_ = 0;
    std::vector<uint32_t> triangleCounts_;
    Bounds transparentBounds_;
};

} // namespace glint::rays
