// Our renderer as the host of a frame: draws a posed scene and provides probes, mirrors and rays to the reflections. It
// uses the library only through include/glint, as any host does.
#pragma once

#include "lab/job/render_job.hpp"
#include "lab/renderer/ray_world.hpp"
#include "lab/renderer/renderer.hpp"
#include "lab/scene/find_mirrors.hpp"
#include "lab/session/host_frame.hpp"
#include "lab/sources/mirror_world.hpp"
#include "lab/sources/probe_world.hpp"

namespace glint::render {

class SceneHost final : public HostFrame {
public:
    /// `inputs`   of the job; remade hosts share them
    /// `library`  the device of `context` as adopted by the library. Both must outlive the host
    /// Errors: those of the device and the settings.
    static Result<std::unique_ptr<HostFrame>> create(gpu::Context& context, Context& library,
                                                     std::shared_ptr<JobInputs> inputs, const RenderJob& job);

    const JobInputs& inputs() const override { return *inputs_; }
    View view() const override { return renderer_->view(parameters_); }

    Result<void> setSettings(const ProgramSettings& settings) override;
    Result<void> resize(uint32_t width, uint32_t height) override;
    Result<void> setCamera(const scene::Camera& camera) override;
    void setJitter(glm::vec2 jitterPX) override;
    void setSeed(uint32_t seed) override { job_.seed = seed; }
    Result<bool> setTime(double seconds, Reflections& reflections) override;
    Result<bool> setMaterials(const scene::MaterialOverrides& overrides, Reflections& reflections) override;
    Result<std::unique_ptr<HostFrame>> remade(Context& library) override;

    Result<void> draw(gpu::Frame& frame, VkCommandBuffer commands, uint32_t frameIndex) override;
    bool drawsAlike() const override { return !mirrorWorld_; } // the images of mirrors have noise of their own
    GBuffer& gbuffer() override { return renderer_->gbuffer(); }
    glint::GBuffer lend(gpu::Frame& frame) override;
    EnvironmentMap lendEnvironment(gpu::Frame& frame) override;
    void recordSources(VkCommandBuffer commands) override;
    Result<HostImage> drawLayers(gpu::Frame& frame, VkCommandBuffer commands, Reflections& reflections,
                                 HostImage lit) override;
    void drawTransparent(gpu::Frame& frame, gpu::Image& picture, bool overLayers) override;
    void display(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& target) override;

    bool hasLayers() const override;
    Result<void> giveSources(Reflections& reflections) override;
    std::vector<std::pair<std::string, double>> passTimes() override;

private:
    SceneHost(gpu::Context& context, Context& library, std::shared_ptr<JobInputs> inputs, const RenderJob& job)
        : context_(context), library_(library), inputs_(std::move(inputs)), job_(job) {
        parameters_.camera = inputs_->camera;
    }
    Result<void> make();
    Result<Renderer> makeRenderer();
    Result<void> remakeRenderer();
    Result<void> applySettings(const RenderSettings& before);
    Result<void> resizeGBuffer();
    Result<void> makeProbes();
    bool showsLayerDepth() const;
    void findMirrors();
    std::vector<PlanarMirror> wantedMirrors() const;
    Result<void> makeMirrors(Reflections& reflections);
    Result<bool> moveMirrors();
    Result<void> makeRayWorld();
    Result<void> moveRays(Reflections& reflections);
    Result<void> giveRays(Reflections& reflections);

    gpu::Context& context_;
    Context& library_;
    std::shared_ptr<JobInputs> inputs_;
    RenderJob job_;
    ViewParameters parameters_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<ProbeWorld> probeWorld_;    ///< absent unless the job requests probes
    std::unique_ptr<RayWorld> rayWorld_;        ///< absent until the settings enable rays
    std::unique_ptr<RayWorld> retiredRayWorld_; ///< the previous ray world, as long as Reflections may refer to it
    RayBackend rayBackend_ = RayBackend::Auto;
    std::vector<PlanarMirror> mirrors_;        ///< mirrors of the current pose, the best first
    std::unique_ptr<MirrorWorld> mirrorWorld_; ///< absent unless the job requests mirrors and the scene has some
};

} // namespace glint::render
