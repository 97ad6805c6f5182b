// Triangles with materials, as a host provides them for rays, and the G-buffer that a camera sees of them.
#pragma once

#include "gpu/support/ray_test.hpp"
#include "gpu/support/synthetic_gbuffer.hpp"

#include "glint/glint.hpp"

#include <list>

namespace glint::test {

struct SurfaceScene {
    TestScene triangles;
    std::vector<SurfaceMaterial> materials; ///< of the instances, one each
    std::vector<SurfaceLight> lights;

    /// A parallelogram with corner `a` and sides `u` and `v`; its front faces cross(u, v).
    SurfaceScene& addQuad(const glm::vec3& a, const glm::vec3& u, const glm::vec3& v, const SurfaceMaterial& material);
    /// The same scene, `scale` times as large.
    SurfaceScene scaled(float scale) const;
    /// The first hit of a camera ray; `scene` must outlive the function.
    static SyntheticScene seenBy(const SurfaceScene& scene);

    /// The scene on the device, for rays.
    struct World {
        std::list<gpu::Buffer> buffers;
        RayScene rays;
        SurfaceTable surfaces;
    };
    World build(gpu::Context& context, Context& library, RayBackend backend) const;
};

SurfaceMaterial emitting(const glm::vec3& radiance);
SurfaceMaterial whiteMetal(float perceptualRoughness);
SurfaceMaterial blackMatte();

} // namespace glint::test
