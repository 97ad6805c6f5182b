// gpu/progress.hpp: what the GPU is known to have executed, and work that is repeated until it has executed.
#include "gpu/pass.hpp"
#include "gpu/progress.hpp"
#include "gpu/support/frames_in_flight.hpp"

namespace glint::test {
namespace progress_test {

class ProgressTest : public GpuTest {
protected:
    static Recording record(gpu::Progress& progress, uint64_t frame = 0) {
        progress.begin(frame);
        return Recording(gpu(), [&](VkCommandBuffer commands) {
            gpu::Frame recording(gpu(), commands);
            progress.end(recording);
        });
    }
    static void run(Recording& recording) {
        recording.submit();
        recording.wait();
    }
};

TEST_F(ProgressTest, KnowsWhatWasExecutedAndWhatWasDropped) {
    gpu::Progress progress = must(gpu::Progress::create(gpu(), "test/progress"));
    Recording first = record(progress);
    Recording second = record(progress);
    EXPECT_EQ(progress.recording(), 2u);
    run(second);
    EXPECT_FALSE(progress.isExecuted(1));
    EXPECT_TRUE(progress.isExecuted(2));
    run(first);
    EXPECT_TRUE(progress.isExecuted(1)) << "late";
    EXPECT_FALSE(progress.isExecuted(0));
    EXPECT_FALSE(progress.isExecuted(3));
}

TEST_F(ProgressTest, CountsOnlyFramesThatTheHostSaysAreDone) {
    gpu::Progress progress = must(gpu::Progress::create(gpu(), "test/progress", 2));
    for (uint64_t frame = 10; frame < 12; ++frame) {
        Recording recording = record(progress, frame);
        run(recording);
        EXPECT_FALSE(progress.isExecuted(1)) << "at frame " << frame;
    }
    progress.begin(12);
    EXPECT_TRUE(progress.isExecuted(1));
    EXPECT_FALSE(progress.isExecuted(2));
}

TEST_F(ProgressTest, OldMarksAreForgotten) {
    gpu::Progress progress = must(gpu::Progress::create(gpu(), "test/progress"));
    Recording first = record(progress);
    run(first);
    for (int i = 0; i < 300; ++i)
        progress.begin();
    EXPECT_FALSE(progress.isExecuted(1));
    EXPECT_FALSE(progress.isExecuted(45)) << "never executed, though its place once bore a mark";
}

TEST_F(ProgressTest, StandingWorkIsNeededUntilItWasExecuted) {
    gpu::Progress progress = must(gpu::Progress::create(gpu(), "test/progress"));
    gpu::Standing work;
    EXPECT_FALSE(gpu::Standing(false).isNeeded(progress));
    std::vector<Recording> recordings;
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(work.isNeeded(progress));
        recordings.push_back(record(progress));
        work.recorded(progress);
    }
    run(recordings[17]);
    EXPECT_FALSE(work.isNeeded(progress));
    EXPECT_TRUE(work.isDone());
    work.ask();
    EXPECT_TRUE(work.isNeeded(progress)) << "what was done before no longer counts";
    recordings.push_back(record(progress)); // without it
    run(recordings.back());
    EXPECT_TRUE(work.isNeeded(progress));
}

} // namespace progress_test
} // namespace glint::test
