// Sequences of built-in scenes: the clock, the seeds, the figures, and the measure's own motion of surfaces against the
// G-buffer's.
#include "gpu/transfer.hpp"
#include "lab/cli/sequence/sequence_output.hpp"
#include "lab/measure/motion/sequence.hpp"
#include "lab/measure/motion/surface_motion.hpp"
#include "lab/tests/image/job_test.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace sequence_test {

using Frames = std::vector<std::vector<float>>;

class SequenceTest : public JobTest {
protected:
    static measure::ComparedConfig config(const std::string& scene, std::vector<std::string> assignments) {
        measure::ComparedConfig config;
        config.name = assignments.empty() ? "defaults" : assignments.front();
        config.job.scene = scene;
        config.job.width = 80;
        config.job.height = 45;
        config.job.settings = settingsOf(std::move(assignments));
        return config;
    }
    static measure::Sequence run(const measure::SequencePlan& plan, Frames* composites = nullptr) {
        measure::SequenceCallbacks callbacks;
        callbacks.frame = [&](const measure::SequenceFrame& frame) -> Result<void> {
            if (composites)
                composites->push_back(frame.composite.rgba);
            return {};
        };
        return must(measure::renderSequence(device(), plan, callbacks));
    }
};

TEST_F(SequenceTest, EveryFrameIsThePictureOfItsMoment) {
    measure::SequencePlan plan;
    plan.configs = {config("builtin:motion-objects", {})};
    plan.configs.front().job.time = 0.25;
    plan.frames = 4;
    plan.fps = 10;
    Frames frames;
    run(plan, &frames);
    ASSERT_EQ(frames.size(), 4u);
    EXPECT_NE(frames[0], frames[1]);
    for (const size_t i : {size_t{0}, size_t{3}}) {
        render::RenderJob job = plan.configs.front().job;
        job.time += double(i) / plan.fps;
        job.views = {"composite"};
        EXPECT_EQ(must(render::runJob(device(), job)).views[0].rgba, frames[i]) << i;
    }
}

TEST_F(SequenceTest, TheSeedDecidesEveryBit) {
    measure::SequencePlan plan;
    plan.configs = {config("builtin:motion-still", {"rays.enabled=true", "screen.enabled=false"})};
    plan.path.move = scene::CameraMove::Truck;
    plan.frames = 3;
    Frames once, twice, other;
    run(plan, &once);
    plan.configs.push_back(plan.configs.front()); // also after another config
    run(plan, &twice);
    ASSERT_EQ(twice.size(), 6u);
    EXPECT_TRUE(std::equal(once.begin(), once.end(), twice.begin()));
    EXPECT_TRUE(std::equal(once.begin(), once.end(), twice.begin() + 3));
    plan.configs.resize(1);
    plan.configs.front().job.seed = 1;
    run(plan, &other);
    EXPECT_NE(once[1], other[1]);
}

/// More samples of the reference's own kind have no bias, all the energy and all the sharpness.
TEST_F(SequenceTest, RaysHaveNoiseAndNoBias) {
    measure::SequencePlan plan;
    const std::vector<std::string> rays = {"rays.enabled=true", "screen.enabled=false", "rays.regularization=0"};
    plan.configs = {config("builtin:motion-objects", rays)};
    plan.reference = config("builtin:motion-objects", rays);
    plan.reference->job.settings.reflections.rays.samples = 32;
    plan.reference->job.settings.reflections.rays.accumulate = true;
    plan.reference->job.frames = 2;
    plan.frames = 6;
    plan.measure = true;
    const measure::Sequence sequence = run(plan);
    ASSERT_EQ(sequence.configs[0].figures.size(), measure::kSignals);
    const measure::MotionBandFigures& figures = sequence.configs[0].figures[0][measure::kBands];
    EXPECT_GT(figures.error.pixels, 1000);
    EXPECT_GT(figures.error.noise.mean, 0.02);
    EXPECT_LT(std::abs(figures.error.bias.mean), 0.1 * figures.error.noise.mean);
    EXPECT_NEAR(figures.error.energy.mean, 1, 0.1);
    EXPECT_GT(figures.flicker.flicker.mean, 0.1);
    EXPECT_TRUE(figures.steps.empty());
    EXPECT_GT(sequence.configs[0].raysPerPixel, 0.3);
    EXPECT_GT(sequence.configs[0].times.total().median, 0);

    const auto json = nlohmann::json::parse(cli::sequenceJson(sequence));
    const auto& band = json["configs"][0]["figures"]["reflection"]["all"];
    EXPECT_EQ(band["noise"]["mean"], figures.error.noise.mean);
    EXPECT_EQ(band["trail"].size(), measure::kTrailFrames);
    EXPECT_TRUE(band["lag90"]["mean"].is_null());
    EXPECT_NE(cli::sequenceText(sequence).find("reflection all"), std::string::npos);
}

/// Rays of one frame show a switched lamp at once; an image that no longer changes never does.
TEST_F(SequenceTest, LagsFollowTheLamp) {
    measure::SequencePlan plan;
    plan.configs = {config("builtin:motion-lamp", {"rays.enabled=true", "screen.enabled=false", "rays.samples=16"}),
                    config("builtin:motion-lamp", {"screen.enabled=false"})};
    for (measure::ComparedConfig& one : plan.configs)
        one.job.time = 0.5;
    plan.reference = config("builtin:motion-lamp", {"rays.enabled=true", "screen.enabled=false", "rays.samples=64"});
    plan.reference->job.frames = 1;
    plan.frames = 6;
    plan.measure = true;
    const measure::Sequence sequence = run(plan);
    EXPECT_EQ(sequence.steps, std::vector<uint32_t>{2}); // 32 frames after the scene's start, and 30 are before ours
    const auto& rays = sequence.configs[0].figures[0][measure::kBands].steps;
    ASSERT_EQ(rays.size(), 1u);
    EXPECT_EQ(rays[0].frame, 2u);
    EXPECT_EQ(rays[0].lag90, 0);
    EXPECT_GT(rays[0].pixels, 100u);
    const auto& sky = sequence.configs[1].figures[0][measure::kBands].steps;
    ASSERT_EQ(sky.size(), 1u);
    EXPECT_TRUE(std::isnan(sky[0].lag90));
}

TEST_F(SequenceTest, ImpossiblePlansAreErrors) {
    measure::SequencePlan plan;
    plan.configs = {config("builtin:motion-still", {})};
    plan.frames = 10'000'000;
    plan.measure = true;
    const auto made = measure::renderSequence(device(), plan, {});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(made.error().message.find("lower --frames"), std::string::npos) << made.error().message;
}

/// The G-buffer's motion leads each pixel to where exact rays find its surface in the frame before, for objects that
/// move under a camera that moves too.
TEST_F(SequenceTest, MotionVectorsAreThoseOfExactRays) {
    render::RenderJob job = config("builtin:motion-objects", {}).job;
    job.width = 160;
    job.height = 90;
    render::ReflectionSession session = must(render::openJob(device(), job));
    const scene::Camera start = session.inputs().camera;
    measure::SurfaceTracker tracker(*session.inputs().scene);
    render::GBuffer* gbuffer = nullptr;
    render::FrameRequest plan;
    plan.afterOpaque = [&](gpu::Frame&, render::GBuffer& drawn) { gbuffer = &drawn; };
    measure::SurfaceMotion exact;
    for (const uint32_t frame : {0u, 1u}) {
        const double seconds = 0.1 * frame;
        scene::Camera camera = start;
        camera.viewToWorld[3].x += 0.1f * static_cast<float>(frame);
        must(session.setTime(seconds));
        must(session.setCamera(camera));
        must(session.renderFrame(frame, plan));
        exact = must(tracker.advance(seconds, session.view()));
        EXPECT_EQ(exact.empty(), frame == 0);
    }
    const std::vector<float> motion = must(gpu::downloadImageAsFloats(device(), gbuffer->motion));
    size_t seen = 0, hidden = 0, wrong = 0;
    for (uint32_t p = 0; p < exact.size(); ++p) {
        hidden += exact[p].origin == measure::SurfaceOrigin::Hidden;
        if (exact[p].origin != measure::SurfaceOrigin::Seen)
            continue;
        ++seen;
        const glm::vec2 from(exact[p].pixel % job.width, exact[p].pixel / job.width);
        const glm::vec2 to(p % job.width, p / job.width);
        const glm::vec2 found = to + glm::vec2(motion[4 * p], motion[4 * p + 1]) * glm::vec2(job.width, job.height);
        wrong += std::max(std::abs(found.x - from.x), std::abs(found.y - from.y)) > 1.01f; // it names whole pixels
    }
    EXPECT_GT(seen, 8000u);
    EXPECT_GT(hidden, 100u);
    EXPECT_LT(wrong, seen / 500); // a pixel's centre and the exact ray may differ in the triangle at an edge
}

TEST_F(SequenceTest, NothingMovesWhereNothingChanges) {
    render::RenderJob job = config("builtin:motion-lamp", {}).job;
    render::ReflectionSession session = must(render::openJob(device(), job));
    measure::SurfaceTracker tracker(*session.inputs().scene);
    must(session.renderFrame(0));
    for (const double seconds : {0.0, 0.01, 0.2})
        EXPECT_TRUE(must(tracker.advance(seconds, session.view())).empty());
    const measure::SurfaceMotion switched = must(tracker.advance(0.6, session.view()));
    EXPECT_FALSE(switched.empty()); // the lamp's light shrinks
}

} // namespace sequence_test
} // namespace glint::test
