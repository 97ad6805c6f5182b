// What the frames of an antialiased still do: which of them count, and where each puts its sample in the pixel.
#include "lab/session/frame_mean.hpp"
#include "lab/session/settled_frames.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace glint::test {
namespace frame_mean_test {

render::RenderJob makeJob(bool hasHistory) {
    render::RenderJob job;
    job.settings.reflections.denoise.enabled = hasHistory;
    job.settings.reflections.screen.colorSource = ColorSource::Current;
    EXPECT_EQ(render::settledFrames(job.settings.reflections) > 1, hasHistory);
    return job;
}

TEST(FrameMean, WithoutAHistoryEveryFrameCounts) {
    const render::RenderJob job = makeJob(false);
    for (uint32_t frame = 0; frame < 20; ++frame) {
        const render::MeanStep step = render::meanStep(job, frame, 20);
        EXPECT_TRUE(step.adds);
        EXPECT_EQ(step.restarts, frame == 0);
    }
}

TEST(FrameMean, WithAHistoryTheLastFramesCount) {
    const render::RenderJob job = makeJob(true);
    for (uint32_t frame = 0; frame < 30; ++frame) {
        const render::MeanStep step = render::meanStep(job, frame, 30);
        EXPECT_EQ(step.adds, frame >= 30 - render::kSmoothFrames) << frame;
        EXPECT_EQ(step.restarts, frame == 30 - render::kSmoothFrames) << frame;
    }
}

TEST(FrameMean, APictureThatSettledGetsAsManyFramesAgain) {
    EXPECT_EQ(render::smoothFramesAfter(1), 4u);
    EXPECT_EQ(render::smoothFramesAfter(8), 8u);
    EXPECT_EQ(render::smoothFramesAfter(30), render::kSmoothFrames);
    render::RenderJob job = makeJob(true);
    job.settle = 4;
    EXPECT_TRUE(render::meanStep(job, 0, 4).restarts) << "its frames all count";
}

/// Sixteen samples lie in each quarter of the pixel four times, but for those of the first and the last frame.
TEST(FrameMean, SamplesFillThePixelEvenly) {
    const render::RenderJob job = makeJob(false);
    std::array<int, 4> quarters = {};
    glm::vec2 sum(0);
    for (uint32_t frame = 0; frame < render::kSmoothFrames; ++frame) {
        const glm::vec2 shift = render::meanStep(job, frame, render::kSmoothFrames).jitterPX;
        EXPECT_GE(std::min(shift.x, shift.y), -0.5f);
        EXPECT_LT(std::max(shift.x, shift.y), 0.5f);
        sum += shift;
        if (frame == 0 || frame + 1 == render::kSmoothFrames)
            EXPECT_EQ(shift, glm::vec2(0));
        else
            ++quarters.at((shift.x < 0 ? 0 : 1) + (shift.y < 0 ? 0 : 2));
    }
    for (const int count : quarters)
        EXPECT_GE(count, 3);
    EXPECT_LT(glm::length(sum / float(render::kSmoothFrames)), 0.05f);
}

TEST(FrameMean, PicturesToLookAtAreAntialiasedAndOthersWhereAsked) {
    using render::Antialias;
    render::RenderJob job = makeJob(true);
    EXPECT_FALSE(render::accumulates(job));
    job.smoothStill = true;
    EXPECT_TRUE(render::accumulates(job));
    job.settings.reflections.rays.accumulate = true; // its sums end where the camera moves
    EXPECT_FALSE(render::accumulates(job));
    job.settings.render.display.antialias = Antialias::Accumulate;
    EXPECT_TRUE(render::accumulates(job));
    for (const Antialias other : {Antialias::None, Antialias::Fxaa, Antialias::Msaa4}) {
        job.settings.render.display.antialias = other;
        EXPECT_FALSE(render::accumulates(job));
    }
}

} // namespace frame_mean_test
} // namespace glint::test
