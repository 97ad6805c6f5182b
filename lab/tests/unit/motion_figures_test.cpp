// The figures of moving pictures, on synthetic frames whose answers are known.
#include "lab/measure/motion/motion_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace glint::measure {
namespace motion_figures_test {

constexpr uint32_t kWidth = 64, kHeight = 48;
constexpr uint8_t kGlossyBand = 1;

/// Radiance of a pixel in a frame.
using Picture = std::function<double(uint32_t x, uint32_t y, uint32_t frame)>;

Radiance paint(const Picture& picture, uint32_t frame) {
    std::vector<float> rgba;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x)
            rgba.insert(rgba.end(), 4, static_cast<float>(picture(x, y, frame)));
    return radianceOf(rgba);
}

/// Every pixel has normal noise of its own.
Picture noisy(const Picture& picture, double sigma, uint32_t seed) {
    auto random = std::make_shared<std::mt19937>(seed);
    return [=](uint32_t x, uint32_t y, uint32_t frame) {
        return picture(x, y, frame) + std::normal_distribution<double>(0, sigma)(*random);
    };
}

/// An exponential moving average of a picture with weight 1 / (1 + n); frames must be asked for in order.
Picture averaged(const Picture& picture, double n) {
    auto history = std::make_shared<std::vector<double>>();
    return [=](uint32_t x, uint32_t y, uint32_t frame) {
        const size_t p = y * kWidth + x;
        const double now = picture(x, y, frame);
        if (history->size() <= p)
            history->push_back(now);
        return (*history)[p] += (now - (*history)[p]) / (1 + n);
    };
}

double flat(uint32_t /*x*/, uint32_t /*y*/, uint32_t /*frame*/) {
    return 2;
}

/// Something with structure in both directions, that moves by a pixel per frame.
double stripes(uint32_t x, uint32_t y, uint32_t frame) {
    return 2 + std::sin(0.31 * (double(x) + frame)) + 0.7 * std::sin(0.23 * double(y) + 0.5 * frame);
}

struct Run {
    std::array<Picture, 2> test;
    std::array<Picture, 2> reference;
    uint32_t frames = 1;
    uint32_t warmUp = 0;
    std::vector<uint32_t> steps = {};
    std::function<SurfaceMotion(uint32_t frame)> motion = {};
};

MotionBandFigures measured(const Run& run) {
    MotionMeter meter(run.warmUp, run.steps);
    const auto bands = std::make_shared<std::vector<uint8_t>>(kWidth * kHeight, kGlossyBand);
    for (uint32_t i = 0; i < run.frames; ++i) {
        MotionFrame frame{kWidth, kHeight, {paint(run.test[0], i), paint(run.test[1], i)}, {}, bands};
        if (run.reference[0])
            frame.reference = {paint(run.reference[0], i), paint(run.reference[1], i)};
        meter.add(frame, run.motion ? run.motion(i) : SurfaceMotion());
    }
    return meter.figures()[kGlossyBand];
}

TEST(MotionFigures, NoiseAndBiasAreSeparated) {
    const Picture wrong = [](uint32_t, uint32_t, uint32_t) { return 2.3; };
    const MotionBandFigures figures = measured({.test = {noisy(wrong, 0.2, 1), noisy(wrong, 0.2, 2)},
                                                .reference = {noisy(flat, 0.03, 3), noisy(flat, 0.03, 4)},
                                                .frames = 8});
    const double divisor = 2 * 2 + 0.01;
    EXPECT_NEAR(figures.error.bias.mean, 0.09 / divisor, 0.03 * 0.09 / divisor);
    EXPECT_NEAR(figures.error.noise.mean, 0.04 / divisor, 0.03 * 0.04 / divisor);
    EXPECT_NEAR(figures.error.relativeMse.mean, 0.13 / divisor, 0.03 * 0.13 / divisor);
    EXPECT_NEAR(figures.error.energy.mean, 2.3 / 2, 0.003);
    EXPECT_EQ(figures.error.pixels, kWidth * kHeight);
}

TEST(MotionFigures, OnlyTheBandOfAPixelCounts) {
    MotionMeter meter(0, {});
    auto bands = std::make_shared<std::vector<uint8_t>>(kWidth * kHeight, kNoBand);
    std::fill_n(bands->begin(), 100, uint8_t{2});
    const Radiance two = paint(flat, 0), black = paint([](auto, auto, auto) { return 0.0; }, 0);
    meter.add({kWidth, kHeight, {black, black}, {two, two}, bands}, {});
    const MotionFigures figures = meter.figures();
    EXPECT_EQ(figures[2].error.pixels, 100);
    EXPECT_EQ(figures[kBands].error.pixels, 100);
    EXPECT_EQ(figures[kBands].error.energy.mean, 0);
    EXPECT_EQ(figures[0].error.pixels, 0);
    EXPECT_TRUE(std::isnan(figures[0].error.bias.mean));
}

/// MOTION: noise a / (2 - a), flicker a / sqrt(2 - a) of the raw frames', a = 1 / (1 + n).
TEST(MotionFigures, AMovingAverageHasItsKnownNoiseAndFlicker) {
    for (const double n : {6.0, 15.0}) {
        const double a = 1 / (1 + n), sigma = 0.4;
        const uint32_t warmUp = 100, frames = 130;
        const MotionBandFigures figures =
            measured({.test = {averaged(noisy(flat, sigma, 5), n), averaged(noisy(flat, sigma, 6), n)},
                      .reference = {flat, flat},
                      .frames = frames,
                      .warmUp = warmUp});
        EXPECT_NEAR(figures.error.noise.mean, sigma * sigma * a / (2 - a) / 4.01, 0.05 * figures.error.noise.mean) << n;
        const double raw = std::sqrt(2.0) * sigma / 2;
        EXPECT_NEAR(figures.flicker.flicker.mean, raw * a / std::sqrt(2 - a), 0.02 * figures.flicker.flicker.mean) << n;
        EXPECT_LT(figures.flicker.swim.mean, 0.1 * figures.flicker.flicker.mean) << n;
    }
}

TEST(MotionFigures, FlickerNeedsNoReference) {
    const MotionBandFigures figures =
        measured({.test = {noisy(stripes, 0.2, 7), noisy(stripes, 0.2, 8)}, .reference = {}, .frames = 16});
    EXPECT_NEAR(figures.flicker.flicker.mean, std::sqrt(2.0) * 0.2 / 2, 0.01);
    EXPECT_TRUE(std::isnan(figures.flicker.swim.mean));
    EXPECT_TRUE(std::isnan(figures.error.relativeMse.mean));
}

TEST(MotionFigures, SwimIsTheErrorThatMovesAndNotTheOneThatStands) {
    const Picture swimming = [](uint32_t x, uint32_t y, uint32_t frame) {
        return flat(x, y, frame) + (frame % 2 == 0 ? 0.1 : -0.1);
    };
    const Picture standing = [](uint32_t x, uint32_t y, uint32_t frame) { return stripes(x, y, frame) + 0.5; };
    const auto references = std::array{noisy(flat, 0.1, 9), noisy(flat, 0.1, 10)};
    const FlickerFigures moves =
        measured({.test = {swimming, swimming}, .reference = references, .frames = 16}).flicker;
    EXPECT_NEAR(moves.swim.mean, 0.2 / 2, 0.003);
    EXPECT_EQ(moves.flicker.mean, 0);
    const FlickerFigures stands =
        measured({.test = {standing, standing}, .reference = {stripes, stripes}, .frames = 16}).flicker;
    EXPECT_NEAR(stands.swim.mean, 0, 1e-6);
}

TEST(MotionFigures, TemporalPsnrIsThatOfTheChangeAlone) {
    const Picture half = [](uint32_t, uint32_t, uint32_t) { return 0.5; };
    const Picture blinking = [](uint32_t, uint32_t, uint32_t frame) { return frame % 2 == 0 ? 0.5 : 0.6; };
    const FlickerFigures figures =
        measured(
            {.test = {blinking, blinking}, .reference = {noisy(half, 0.05, 11), noisy(half, 0.05, 12)}, .frames = 9})
            .flicker;
    EXPECT_NEAR(figures.tPsnr, 20, 0.2); // of a difference of .1
    EXPECT_EQ(measured({.test = {half, half}, .reference = {half, half}, .frames = 3}).flicker.tPsnr,
              std::numeric_limits<double>::infinity());
}

TEST(MotionFigures, AMovingAverageLagsAsLongAsItsWeightsSay) {
    const Picture stepped = [](uint32_t x, uint32_t, uint32_t frame) { return x < 20 && frame >= 10 ? 0.2 : 2.0; };
    for (const double n : {0.0, 3.0, 15.0}) {
        const MotionBandFigures figures = measured({.test = {averaged(stepped, n), averaged(stepped, n)},
                                                    .reference = {noisy(stepped, 0.05, 13), noisy(stepped, 0.05, 14)},
                                                    .frames = 110,
                                                    .steps = {10}});
        ASSERT_EQ(figures.steps.size(), 1u);
        const StepResponse& step = figures.steps[0];
        const double keep = n / (1 + n); // of the old, after j frames: keep^(j + 1)
        const auto lag = [&](double rest) { return n == 0 ? 0 : std::ceil(std::log(rest) / std::log(keep)) - 1; };
        EXPECT_EQ(step.frame, 10u);
        EXPECT_NEAR(step.lag90, lag(0.1), n == 0 ? 0 : 1) << n;
        EXPECT_NEAR(step.lag99, lag(0.01), n == 0 ? 0 : 0.1 * lag(0.01)) << n; // noise of the reference
        EXPECT_LT(step.overshoot, 0.02) << n;
        EXPECT_NEAR(double(step.pixels), 20 * kHeight, 30);
    }
}

TEST(MotionFigures, AChangeThatNeverShowsHasNoLag) {
    const Picture stepped = [](uint32_t, uint32_t, uint32_t frame) { return frame >= 4 ? 1.0 : 2.0; };
    const MotionBandFigures late =
        measured({.test = {flat, flat}, .reference = {stepped, stepped}, .frames = 16, .steps = {4}});
    ASSERT_EQ(late.steps.size(), 1u);
    EXPECT_TRUE(std::isnan(late.steps[0].lag90));
    const Picture nervous = [=](uint32_t x, uint32_t y, uint32_t frame) {
        return stepped(x, y, frame) - (frame == 5 ? 0.3 : 0);
    };
    EXPECT_NEAR(measured({.test = {nervous, nervous}, .reference = {stepped, stepped}, .frames = 16, .steps = {4}})
                    .steps[0]
                    .overshoot,
                0.3, 1e-4);
}

TEST(MotionFigures, NoiseIsNoStep) {
    const MotionBandFigures figures = measured(
        {.test = {flat, flat}, .reference = {noisy(flat, 0.5, 15), noisy(flat, 0.5, 16)}, .frames = 8, .steps = {4}});
    EXPECT_TRUE(figures.steps.empty());
}

TEST(MotionFigures, AShiftedPictureIsItsOwnTrail) {
    for (const uint32_t k : {1u, 4u, 16u}) {
        const Picture late = [=](uint32_t x, uint32_t y, uint32_t frame) { return stripes(x, y, frame - k); };
        const MotionBandFigures figures = measured({.test = {noisy(late, 0.2, 17), noisy(late, 0.2, 18)},
                                                    .reference = {noisy(stripes, 0.2, 19), noisy(stripes, 0.2, 20)},
                                                    .frames = 40,
                                                    .warmUp = 17});
        EXPECT_NEAR(figures.trail[k - 1].value, 1, 0.02) << k;
        EXPECT_NEAR(figures.trail[k - 1].value, 1, 4 * figures.trail[k - 1].standardError) << k;
        EXPECT_LT(figures.trail[k - 1].standardError, 0.01) << k;
    }
    const MotionBandFigures none = measured({.test = {noisy(stripes, 0.2, 21), noisy(stripes, 0.2, 22)},
                                             .reference = {noisy(stripes, 0.2, 23), noisy(stripes, 0.2, 24)},
                                             .frames = 40,
                                             .warmUp = 17});
    for (const Share& share : none.trail)
        EXPECT_NEAR(share.value, 0, 0.02);
}

TEST(MotionFigures, BlurLeadsAsMuchAsItTrailsAndLagLeadsLess) {
    // A box of nine pixels on waves of 20 has the gain g; a half of 1 - g resembles either.
    const Picture waves = [](uint32_t x, uint32_t, uint32_t frame) { return 2 + std::sin(0.31 * (double(x) + frame)); };
    const Picture blurred = [=](uint32_t x, uint32_t y, uint32_t frame) {
        double sum = 0;
        for (uint32_t i = 0; i < 9; ++i)
            sum += waves(x + i, y, frame - 4) / 9;
        return sum;
    };
    const double gain = std::sin(4.5 * 0.31) / (9 * std::sin(0.5 * 0.31));
    const MotionBandFigures blur = measured({.test = {noisy(blurred, 0.2, 40), noisy(blurred, 0.2, 41)},
                                             .reference = {noisy(waves, 0.2, 42), noisy(waves, 0.2, 43)},
                                             .frames = 40,
                                             .warmUp = 17});
    EXPECT_NEAR(blur.trail[3].value, 0.5 * (1 - gain), 0.03);
    EXPECT_NEAR(blur.lead[3].value, 0.5 * (1 - gain), 0.03);
    const Picture late = [=](uint32_t x, uint32_t y, uint32_t frame) { return waves(x, y, frame - 4); };
    const MotionBandFigures lag = measured({.test = {noisy(late, 0.2, 44), noisy(late, 0.2, 45)},
                                            .reference = {noisy(waves, 0.2, 46), noisy(waves, 0.2, 47)},
                                            .frames = 40,
                                            .warmUp = 17});
    EXPECT_NEAR(lag.trail[3].value, 1, 0.02);
    EXPECT_NEAR(lag.lead[3].value, -std::cos(4 * 0.31), 0.03);
}

TEST(MotionFigures, AStillPictureHasNoTrail) {
    const MotionBandFigures figures =
        measured({.test = {flat, flat}, .reference = {noisy(flat, 0.5, 25), noisy(flat, 0.5, 26)}, .frames = 24});
    for (const TrailFigures& shares : {figures.trail, figures.lead})
        for (const Share& share : shares)
            EXPECT_TRUE(std::isnan(share.value)) << share.value;
}

TEST(MotionFigures, SharpIsTheGainOfGradients) {
    // A box of three pixels on waves of angular frequency w has the gain (1 + 2 cos w) / 3.
    const double w = 0.9;
    const Picture waves = [=](uint32_t x, uint32_t, uint32_t) { return 2 + std::sin(w * x); };
    const Picture blurred = [=](uint32_t x, uint32_t y, uint32_t frame) {
        return (waves(x - 1, y, frame) + waves(x, y, frame) + waves(x + 1, y, frame)) / 3;
    };
    const Picture atLeft = [=](uint32_t x, uint32_t y, uint32_t frame) { return blurred(x + 1, y, frame); };
    const Picture right = [=](uint32_t x, uint32_t y, uint32_t frame) { return waves(x + 1, y, frame); };
    const double gain = (1 + 2 * std::cos(w)) / 3;
    const auto sharpOf = [&](const Picture& test) {
        return measured({.test = {noisy(test, 0.1, 27), noisy(test, 0.1, 28)},
                         .reference = {noisy(right, 0.1, 29), noisy(right, 0.1, 30)},
                         .frames = 16})
            .error.sharp.mean;
    };
    EXPECT_NEAR(sharpOf(right), 1, 0.02);
    EXPECT_TRUE(std::isnan(measured({.test = {waves, waves}, .reference = {noisy(flat, 0.1, 29), noisy(flat, 0.1, 30)}})
                               .error.sharp.mean));
    EXPECT_NEAR(sharpOf(atLeft), gain * gain, 0.02); // the cross spectrum of two blurred pictures
}

TEST(MotionFigures, FirefliesAreCountedPerMillion) {
    const Picture lit = [](uint32_t x, uint32_t y, uint32_t) { return x == 10 && y < 3 ? 15.0 : 1.0; };
    const Picture dim = [](uint32_t, uint32_t, uint32_t) { return 1.0; };
    const MotionBandFigures figures = measured({.test = {lit, dim}, .reference = {dim, dim}, .frames = 2});
    EXPECT_NEAR(figures.error.fireflies.mean, 1e6 * 3 / (kWidth * kHeight) / 2, 1e-6);
    EXPECT_EQ(measured({.test = {lit, lit}, .reference = {lit, lit}, .frames = 2}).error.fireflies.mean, 0);
}

/// The columns from 20 on are disoccluded in frame 4; a bright surface was before them.
TEST(MotionFigures, GhostsAndHealingFollowTheDisocclusion) {
    constexpr uint32_t kColumn = 20, kFrame = 4;
    const auto isNew = [](uint32_t x) { return x >= kColumn; };
    const Picture truth = [=](uint32_t x, uint32_t, uint32_t frame) { return isNew(x) && frame < kFrame ? 5.0 : 1.0; };
    const auto motion = [=](uint32_t frame) {
        SurfaceMotion result;
        for (uint32_t p = 0; frame == kFrame && p < kWidth * kHeight; ++p)
            result.push_back({p, isNew(p % kWidth) ? SurfaceOrigin::Hidden : SurfaceOrigin::Seen});
        return result;
    };
    const double n = 3;
    const auto error = [](const Picture& picture, uint32_t seed) { return noisy(picture, 0.1, seed); };
    const MotionBandFigures figures = measured({.test = {error(averaged(truth, n), 31), error(averaged(truth, n), 32)},
                                                .reference = {error(truth, 33), error(truth, 34)},
                                                .frames = 40,
                                                .warmUp = 3,
                                                .motion = motion});
    EXPECT_EQ(figures.ghost.disoccluded, (kWidth - kColumn) * kHeight);
    const double keep = n / (1 + n);
    for (size_t age = 0; age < 8; ++age)
        EXPECT_NEAR(figures.ghost.ghost[age].value, std::pow(keep, double(age) + 1), 0.01) << age;
    // Healed when the ghost's squared error 16 keep^(2 (age + 1)) is at most the noise's, 0.01.
    EXPECT_NEAR(figures.ghost.heal, std::ceil(std::log(0.01 / 16) / (2 * std::log(keep))) - 1, 1);
    const MotionBandFigures clean = measured({.test = {error(truth, 35), error(truth, 36)},
                                              .reference = {error(truth, 37), error(truth, 38)},
                                              .frames = 40,
                                              .warmUp = 3,
                                              .motion = motion});
    EXPECT_NEAR(clean.ghost.ghost[0].value, 0, 0.01);
    EXPECT_EQ(clean.ghost.heal, 0);
}

TEST(MotionFigures, PixelsGoToTheirBandAndBlackOnesToNone) {
    const std::vector<float> roughness = {0.05f, 0, 0, 1, 0.3f, 0, 0, 1, 0.8f, 0, 0, 1, 0.02f, 0, 0, 1};
    const std::vector<float> f0 = {0.04f, 0, 0, 1, 0, 0.04f, 0, 1, 0, 0, 0.9f, 1, 0, 0, 0, 1};
    EXPECT_EQ(*pixelBands(roughness, f0), (std::vector<uint8_t>{0, 1, 2, kNoBand}));
}

TEST(FrameSeries, HasMeanPercentileAndError) {
    FrameSeries series;
    for (int i = 1; i <= 100; ++i)
        series.add(i);
    EXPECT_EQ(series.figure().mean, 50.5);
    EXPECT_EQ(series.figure().p95, 95);
    EXPECT_NEAR(series.figure().standardError, std::sqrt(101.0 / 12 * 100 / 99 * 99 / 100), 1e-1);
    EXPECT_TRUE(std::isnan(FrameSeries().figure().mean));
    FrameSeries squares;
    squares.add(9);
    squares.add(25);
    squares.add(-1);
    EXPECT_NEAR(squares.root().mean, std::sqrt(11.0), 1e-12);
    EXPECT_EQ(squares.root().p95, 5);
}

/// With one seed the products' mean is the whole error, and nothing tells its parts apart.
TEST(MotionFigures, OneSeedKnowsTheWholeErrorAlone) {
    const Picture wrong = [](uint32_t x, uint32_t y, uint32_t frame) { return stripes(x, y, frame) + 0.3; };
    MotionMeter meter(0, {});
    const auto bands = std::make_shared<std::vector<uint8_t>>(kWidth * kHeight, kGlossyBand);
    const Picture noise = noisy(wrong, 0.2, 1), a = noisy(stripes, 0.03, 3), b = noisy(stripes, 0.03, 4);
    for (uint32_t i = 0; i < 8; ++i) {
        const Radiance seed = paint(noise, i);
        meter.add({kWidth, kHeight, {seed, seed}, {paint(a, i), paint(b, i)}, bands}, {});
    }
    const MotionBandFigures figures = ofOneSeed(meter.figures())[kGlossyBand];
    const MotionBandFigures two =
        measured({.test = {noisy(wrong, 0.2, 1), noisy(wrong, 0.2, 2)}, .reference = {a, b}, .frames = 8});
    EXPECT_NEAR(figures.error.relativeMse.mean, two.error.relativeMse.mean, 0.05 * two.error.relativeMse.mean);
    EXPECT_NEAR(figures.error.energy.mean, two.error.energy.mean, 0.01);
    EXPECT_NEAR(figures.flicker.tPsnr, two.flicker.tPsnr, 0.3);
    for (const SeriesFigure& unknown :
         {figures.error.bias, figures.error.noise, figures.error.sharp, figures.flicker.flicker, figures.flicker.swim})
        EXPECT_TRUE(std::isnan(unknown.mean) && std::isnan(unknown.p95) && std::isnan(unknown.standardError));
}

} // namespace motion_figures_test
} // namespace glint::measure
