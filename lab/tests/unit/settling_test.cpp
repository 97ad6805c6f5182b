// When the mean over a still view's frames has stopped moving.
#include "lab/session/settling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::render {
namespace {

/// A picture of `value` + noise, averaged over so many frames.
class NoisyMean {
public:
    std::vector<uint8_t> add(double deviation) {
        ++frames_;
        std::vector<uint8_t> bytes;
        for (double& sum : sums_) {
            sum += 128 + deviation * std::sqrt(12.0) * (random() - 0.5);
            bytes.push_back(static_cast<uint8_t>(std::lround(sum / frames_)));
        }
        return bytes;
    }

private:
    double random() { return ((state_ = state_ * 1664525 + 1013904223) >> 8) / double(1 << 24); }

    std::vector<double> sums_ = std::vector<double>(30000);
    uint32_t frames_ = 0;
    uint32_t state_ = 1;
};

uint32_t framesUntilSettled(double deviation, double error, double* found = nullptr) {
    NoisyMean mean;
    Settling settling(error);
    for (uint32_t frames = 1; frames < 1000; ++frames) {
        const std::vector<uint8_t> picture = mean.add(deviation);
        if (Settling::looksAfter(frames) && settling.settled(frames, picture)) {
            if (found)
                *found = settling.error();
            return frames;
        }
    }
    return 0;
}

TEST(Settling, LooksMoreRarelyAsFramesAreMany) {
    std::vector<uint32_t> looked;
    for (uint32_t frames = 0; frames <= 50; ++frames)
        if (Settling::looksAfter(frames))
            looked.push_back(frames);
    EXPECT_EQ(looked, (std::vector<uint32_t>{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48}));
}

TEST(Settling, WithoutNoiseTwoFramesAreEnough) {
    EXPECT_EQ(framesUntilSettled(0, 0.01), 2u);
}

TEST(Settling, EndsWhenTheMeansDeviationIsTheError) {
    // sqrt(n) = deviation / error, up to the next n that is looked at.
    EXPECT_EQ(framesUntilSettled(9, 3.2), 8u);
    EXPECT_EQ(framesUntilSettled(9, 2.4), 16u);
    double error = 0;
    EXPECT_EQ(framesUntilSettled(20, 2.9, &error), 48u);
    EXPECT_NEAR(error, 20 / std::sqrt(48.0), 0.15) << "the deviation of the mean, and the bytes' rounding";
}

TEST(Settling, HasNoErrorBeforeTwoPictures) {
    Settling settling(1);
    EXPECT_FALSE(settling.settled(1, {1, 2, 3}));
    EXPECT_TRUE(std::isinf(settling.error()));
    EXPECT_FALSE(settling.settled(2, {1, 2, 9}));
    EXPECT_DOUBLE_EQ(settling.error(), std::sqrt(36.0 / 3));
}

} // namespace
} // namespace glint::render
