// A host that draws nothing: it copies the G-buffer of another and gives that to the reflections, as one that reads it
// from files does. With the same G-buffer the library must answer with the same bits.
#include "lab/renderer/display_pass.hpp"
#include "lab/renderer/lending.hpp"
#include "lab/session/run_job.hpp"
#include "lab/session/scene_host.hpp"
#include "tests/gpu/support/gpu_test.hpp"

namespace glint::test {
namespace host_frame_test {

Error fixed(const char* what) {
    return makeError(ErrorCode::Unsupported, "the {} of a stored G-buffer cannot be changed", what);
}

class StoredHost final : public render::HostFrame {
public:
    StoredHost(gpu::Context& context, render::JobInputs&& inputs, const render::View& view,
               const render::ProgramSettings& settings)
        : context_(context), inputs_(std::move(inputs)), view_(view), settings_(settings) {}

    Result<void> store(render::GBuffer& drawn) {
        GLINT_TRY(made, render::GBuffer::create(context_, inputs_.width, inputs_.height,
                                                {.backFaces = static_cast<bool>(drawn.backDepth)}));
        gbuffer_ = std::move(made);
        GLINT_TRY(display, render::DisplayPass::create(context_));
        display_ = std::move(display);
        return context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands);
            for (const auto image :
                 {&render::GBuffer::deviceDepth, &render::GBuffer::normal, &render::GBuffer::material,
                  &render::GBuffer::motion, &render::GBuffer::litRadiance, &render::GBuffer::fallbackSpecular,
                  &render::GBuffer::albedo, &render::GBuffer::backDepth})
                if (drawn.*image)
                    frame.copy(drawn.*image, gbuffer_.*image);
        });
    }

    const render::JobInputs& inputs() const override { return inputs_; }
    render::View view() const override { return view_; }
    Result<void> setSettings(const render::ProgramSettings& settings) override {
        settings_ = settings;
        return {};
    }
    Result<void> resize(uint32_t, uint32_t) override { return fixed("size"); }
    Result<void> setCamera(const scene::Camera&) override { return fixed("camera"); }
    Result<bool> setTime(double, Reflections&) override { return fixed("time"); }
    Result<bool> setMaterials(const scene::MaterialOverrides&, Reflections&) override { return fixed("materials"); }
    Result<std::unique_ptr<render::HostFrame>> remade(Context&) override { return fixed("device"); }

    bool drawsAlike() const override { return true; }
    Result<void> draw(gpu::Frame&, VkCommandBuffer, uint32_t) override { return {}; }
    render::GBuffer& gbuffer() override { return gbuffer_; }
    GBuffer lend(gpu::Frame& frame) override { return render::lendGBuffer(frame, gbuffer_); }
    EnvironmentMap lendEnvironment(gpu::Frame&) override { return {}; }
    void recordSources(VkCommandBuffer) override {}
    Result<HostImage> drawLayers(gpu::Frame&, VkCommandBuffer, Reflections&, HostImage lit) override { return lit; }
    void drawTransparent(gpu::Frame&, gpu::Image&, bool) override {}
    void display(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& target) override {
        display_.draw(frame, radiance, target, settings_.render.display);
    }
    bool hasLayers() const override { return false; }
    Result<void> giveSources(Reflections&) override { return {}; }
    std::vector<std::pair<std::string, double>> passTimes() override { return {}; }

private:
    gpu::Context& context_;
    render::JobInputs inputs_;
    render::View view_;
    render::ProgramSettings settings_;
    render::GBuffer gbuffer_;
    render::DisplayPass display_;
};

class HostFrameTest : public GpuTest {
protected:
    static render::RenderJob job() {
        render::RenderJob job;
        job.scene = "builtin:exact"; // no environment, nothing transparent
        job.width = 192;
        job.height = 108;
        return job;
    }
    static render::SessionOptions options() { return {.settings = {}, .statistics = true, .display = true}; }

    /// What `SceneHost` draws for the job, stored.
    static render::ReflectionSession storedSession() {
        return must(render::ReflectionSession::create(
            gpu(),
            [](Context& library) -> Result<std::unique_ptr<render::HostFrame>> {
                auto inputs = std::make_shared<render::JobInputs>(must(render::loadJobInputs(job())));
                const auto drawn = must(render::SceneHost::create(gpu(), library, inputs, job()));
                Result<void> done;
                run([&](VkCommandBuffer commands) {
                    gpu::Frame frame(gpu(), commands);
                    done = drawn->draw(frame, commands, 0);
                });
                must(std::move(done));
                render::JobInputs words;
                words.width = inputs->width;
                words.height = inputs->height;
                auto stored = std::make_unique<StoredHost>(gpu(), std::move(words), drawn->view(), job().settings);
                must(stored->store(drawn->gbuffer()));
                return std::unique_ptr<render::HostFrame>(std::move(stored));
            },
            options()));
    }
};

TEST_F(HostFrameTest, AStoredGBufferIsReflectedAsTheOneThatIsDrawn) {
    render::RenderJob drawnJob = job();
    drawnJob.statistics = drawnJob.display = true;
    render::ReflectionSession drawn = must(render::openJob(gpu(), drawnJob));
    render::ReflectionSession stored = storedSession();
    for (render::ReflectionSession* session : {&drawn, &stored})
        must(session->renderFrame(0));
    EXPECT_GT(stored.stats().rays, 1000u);
    EXPECT_EQ(stored.stats().outcomes, drawn.stats().outcomes);
    for (const char* view : {"composite", "scene", "reflection", "ray", "depth", "albedo"}) {
        const render::RenderedView a = must(drawn.readView(view)), b = must(stored.readView(view));
        EXPECT_EQ(a.rgba, b.rgba) << view;
        EXPECT_EQ(a.rgb8, b.rgb8) << view;
    }
}

TEST_F(HostFrameTest, WhatAHostCannotChangeIsAnErrorAndTheFrameStays) {
    render::ReflectionSession session = storedSession();
    must(session.renderFrame(0));
    const std::vector<float> before = must(session.readView("composite")).rgba;
    EXPECT_EQ(session.setTime(1).error().code, ErrorCode::Unsupported);
    EXPECT_EQ(session.setCamera({}).error().code, ErrorCode::Unsupported);
    EXPECT_EQ(session.remake().error().code, ErrorCode::Unsupported);
    must(session.renderFrame(1));
    EXPECT_EQ(must(session.readView("composite")).rgba, before);

    render::ProgramSettings without;
    without.reflections.screen.enabled = false;
    must(session.setSettings(without));
    must(session.renderFrame(0));
    EXPECT_NE(must(session.readView("composite")).rgba, before);
}

} // namespace host_frame_test
} // namespace glint::test
