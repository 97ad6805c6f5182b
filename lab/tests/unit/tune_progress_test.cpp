// What `glint tune` says about the time left.
#include "lab/cli/tune/tune_progress.hpp"

#include <gtest/gtest.h>

namespace glint::cli {
namespace tune_progress_test {

TEST(TuneProgress, TimeLeftFollowsFromWhatTheGenerationsTook) {
    EXPECT_EQ(TuneProgress::left(0, 10, {}), std::nullopt);
    EXPECT_EQ(TuneProgress::left(0.25, 10, {}), 30);
    EXPECT_EQ(TuneProgress::left(0.25, 10, 12.0), 12);
    EXPECT_EQ(TuneProgress::left(0, 10, 12.0), 12);
    EXPECT_EQ(TuneProgress::left(0.9, 10, -3.0), 0);
}

TEST(TuneProgress, TheLineSaysWhatIsDone) {
    EXPECT_EQ(TuneProgress::line({0, 5, 40}, 20, {}), "trying each setting, 5 of 40");
    EXPECT_EQ(TuneProgress::line({3, 12, 24}, 20, 250.2), "generation 3 of 20, 12 of 24, 4:10 left");
}

} // namespace tune_progress_test
} // namespace glint::cli
