// Channels against closed forms: step, linear, spherical and cubic; before, between and after the keys.
#include "lab/scene/animation_sampling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace glint::test {
namespace animation_sampling_test {

using scene::Animation;
using scene::AnimationChannel;
using scene::AnimationPath;
using scene::Interpolation;
using scene::sampleChannel;
using testing::ElementsAre;
using testing::FloatNear;

AnimationChannel channel(AnimationPath path, Interpolation interpolation, std::vector<float> times,
                         std::vector<float> values) {
    AnimationChannel result;
    result.node = 0;
    result.path = path;
    result.interpolation = interpolation;
    result.times = std::move(times);
    result.values = std::move(values);
    return result;
}

TEST(AnimationSampling, StepHoldsUntilTheNextKey) {
    const auto steps = channel(AnimationPath::Weights, Interpolation::Step, {1, 2, 4}, {10, 20, 30});
    const std::pair<double, float> expected[] = {{0, 10}, {1, 10}, {1.999, 10}, {2, 20}, {3.5, 20}, {4, 30}, {9, 30}};
    for (const auto& [time, value] : expected)
        EXPECT_EQ(sampleChannel(steps, time)[0], value) << time;
}

TEST(AnimationSampling, StepTimesAreThoseOfChanges) {
    scene::Scene scene;
    scene.animations.push_back(
        {"a",
         {channel(AnimationPath::Translation, Interpolation::Step, {1, 2, 4}, {0, 0, 0, 0, 0, 0, 0, 5, 0}),
          channel(AnimationPath::Scale, Interpolation::Step, {0, 3, 4}, {1, 1, 1, 2, 2, 2, 1, 1, 1}),
          channel(AnimationPath::Rotation, Interpolation::Linear, {0, 7}, {0, 0, 0, 1, 0, 1, 0, 0})}});
    scene.animations.push_back( // not played: drives the same property
        {"b", {channel(AnimationPath::Scale, Interpolation::Step, {0, 9}, {1, 1, 1, 2, 2, 2})}});
    EXPECT_THAT(scene::stepTimes(scene), ElementsAre(3, 4));
    EXPECT_TRUE(scene::stepTimes(scene::Scene()).empty());
}

TEST(AnimationSampling, LinearIsClampedAtBothEnds) {
    const auto line = channel(AnimationPath::Translation, Interpolation::Linear, {1, 3}, {0, 0, 0, 2, 4, -6});
    EXPECT_THAT(sampleChannel(line, -5), ElementsAre(0, 0, 0));
    EXPECT_THAT(sampleChannel(line, 1.5), ElementsAre(0.5f, 1, -1.5f));
    EXPECT_THAT(sampleChannel(line, 3), ElementsAre(2, 4, -6));
    EXPECT_THAT(sampleChannel(line, 1e12), ElementsAre(2, 4, -6));
}

TEST(AnimationSampling, OneKeyIsAConstant) {
    EXPECT_THAT(sampleChannel(channel(AnimationPath::Scale, Interpolation::Linear, {2}, {1, 2, 3}), 7),
                ElementsAre(1, 2, 3));
    EXPECT_THAT(sampleChannel(channel(AnimationPath::Weights, Interpolation::CubicSpline, {2}, {9, 5, 9}), 0),
                ElementsAre(5));
}

TEST(AnimationSampling, EqualTimesJumpToTheLater) {
    const auto jump = channel(AnimationPath::Weights, Interpolation::Linear, {0, 1, 1, 2}, {0, 1, 5, 6});
    EXPECT_EQ(sampleChannel(jump, 1)[0], 5);
    EXPECT_FLOAT_EQ(sampleChannel(jump, 0.5)[0], 0.5f);
    EXPECT_FLOAT_EQ(sampleChannel(jump, 1.5)[0], 5.5f);
}

TEST(AnimationSampling, RotationsTurnEvenlyAlongTheShorterArc) {
    const float h = std::sqrt(0.5f);
    for (const float sign : {1.0f, -1.0f}) { // q and -q are the same rotation
        const auto turn =
            channel(AnimationPath::Rotation, Interpolation::Linear, {0, 1}, {0, 0, 0, 1, 0, 0, sign * h, sign * h});
        for (const double t : {0.0, 0.25, 0.5, 0.9}) {
            const double half = t * std::acos(-1.0) / 4; // 90 degrees in all
            const std::vector<float> q = sampleChannel(turn, t);
            EXPECT_NEAR(q[2], std::sin(half), 1e-6);
            EXPECT_NEAR(q[3], std::cos(half), 1e-6);
        }
    }
}

TEST(AnimationSampling, CubicSplineReproducesACubic) {
    // f(t) = t^3 - 2t + 1 with its own derivatives as tangents is met exactly, on segments of unequal length too.
    const auto f = [](double t) { return t * t * t - 2 * t + 1; };
    const auto derivative = [](double t) { return 3 * t * t - 2; };
    std::vector<float> times = {0, 0.5f, 2}, values;
    for (const float t : times)
        for (const double v : {derivative(t), f(t), derivative(t)})
            values.push_back(float(v));
    const auto spline = channel(AnimationPath::Weights, Interpolation::CubicSpline, times, values);
    for (double t = 0; t <= 2; t += 0.0625)
        EXPECT_NEAR(sampleChannel(spline, t)[0], f(t), 2e-6) << t;
    EXPECT_THAT(sampleChannel(spline, 5)[0], FloatNear(5, 1e-6f));
}

TEST(AnimationSampling, CubicRotationsAreUnit) {
    const auto spline = channel(AnimationPath::Rotation, Interpolation::CubicSpline, {0, 1},
                                {0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 3, 4, 4, 3, 2, 1, 0, 1, 0, 0, 0, 0, 0, 0});
    for (double t = 0; t <= 1; t += 0.1) {
        const std::vector<float> q = sampleChannel(spline, t);
        EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-5);
    }
}

TEST(PlayedAnimations, CollidingOnesAreLeftOutWhole) {
    scene::Scene scene;
    const auto on = [](int node, AnimationPath path) {
        AnimationChannel result = channel(path, Interpolation::Step, {0}, {0, 0, 0});
        result.node = node;
        return result;
    };
    scene.animations = {{"walk", {on(0, AnimationPath::Translation), on(1, AnimationPath::Translation)}},
                        {"run", {on(2, AnimationPath::Translation), on(1, AnimationPath::Translation)}},
                        {"blink", {on(1, AnimationPath::Scale)}},
                        {"lamp", {on(2, AnimationPath::Translation)}}};
    std::vector<std::string> names;
    for (const Animation* animation : scene::playedAnimations(scene))
        names.push_back(animation->name);
    EXPECT_THAT(names, ElementsAre("walk", "blink", "lamp"));
}

} // namespace animation_sampling_test
} // namespace glint::test
