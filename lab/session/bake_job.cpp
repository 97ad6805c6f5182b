#include "lab/session/bake_job.hpp"

#include "lab/job/job_environment.hpp"
#include "lab/renderer/lending.hpp"
#include "lab/renderer/ray_world.hpp"

#include <optional>

namespace glint::render {

Result<ProbeSet> runBakeJob(gpu::Context& context, const RenderJob& job, const BakeOptions& options) {
    GLINT_TRY(inputs, loadJobInputs(job));
    const RenderSettings& settings = job.settings.render;
    context.addShaders(gpu::shaders::render());
    GLINT_TRY(environment, makeEnvironment(context, inputs, settings, StrongLights::Taken));
    GLINT_TRY(renderer, Renderer::create(context, *inputs.scene, inputs.pose, std::move(environment), settings));
    GLINT_TRY(library, adoptDevice(context));
    std::optional<RayWorld> rays; // for shadows
    if (settings.lights.shadows == ShadowMode::Rays) {
        GLINT_TRY(world, RayWorld::create(context, *library, renderer.scene(), *inputs.scene, inputs.pose,
                                          renderer.lights(), job.settings.reflections.rays.backend));
        rays = std::move(world);
        GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) { rays->record(commands); }));
        GLINT_CHECK(renderer.setRayWorld(&*rays));
    }
    return bakeProbes(context, *library, renderer, inputs, settings, job.scene, options);
}

} // namespace glint::render
