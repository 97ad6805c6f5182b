// Weights of uncertain answers: what a wrong one would cost, and nothing where it costs nothing.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

namespace glint::test {
namespace certainty_test {

constexpr uint32_t kWidth = 121;
constexpr uint32_t kHeight = 67;
constexpr float kWall = 0.05f;

/// A lamp hangs before a dark wall, over a mirror floor. Behind the lamp, rays from the floor pass to the wall.
SyntheticScene lampBeforeWall(float lamp) {
    const Stage stage = {.cards = {{.z = -3}, {.low = {-0.5, 0.45}, .high = {0.5, 0.65}, .z = -1}}};
    return [stage, lamp](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0) {
            const double z = origin.z + direction.z * hit->distance;
            hit->radiance = glm::vec3(z > -2 ? lamp : kWall);
        }
        return hit;
    };
}

class CertaintyTest : public LibraryTest, public testing::WithParamInterface<March> {
protected:
    static Settings settings() {
        Settings settings = plainSettings(GetParam());
        settings.screen.thicknessMode = ThicknessMode::Constant;
        settings.screen.thickness = 3; // behind the lamp: `side`
        settings.fade.uncertain = true;
        return settings;
    }

    /// Under an even environment, a little brighter than the wall.
    static Picture show(float lamp, const Settings& settings) {
        const TestEnvironment sky =
            TestEnvironment::make(gpu(), 1, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(0.08f); });
        return trace(lampBeforeWall(lamp), SyntheticCamera{}, kWidth, kHeight, settings, sky.map);
    }

    /// Of the rays with this outcome, those that ended at the lamp.
    static std::vector<float> weightsOf(const Picture& picture, uint32_t outcome) {
        const SyntheticCamera camera;
        const SyntheticScene scene = lampBeforeWall(1);
        std::vector<float> weights;
        for (size_t i = 0; i < picture.pixels(); ++i) {
            if (picture.outcome(i) != outcome)
                continue;
            const glm::uvec2 px(picture.hitPX(i));
            const auto shown = scene(camera.position, camera.rayThrough(px.x, px.y, kWidth, kHeight));
            if (shown && shown->radiance.x == 1)
                weights.push_back(picture.weight[i * 4]);
        }
        return weights;
    }
};

TEST_P(CertaintyTest, aLampThatMayNotBeThereGetsLittle) {
    const std::vector<float> sides = weightsOf(show(8, settings()), shared::kOutcomeSide);
    ASSERT_GT(sides.size(), 50u);
    // Right with a probability of 0.66 at most; as bright as a display shows, 2, where the sky has 0.08.
    constexpr float kRight = 0.66f / (2 * 2 + 1);
    constexpr float kWrong = 0.34f / (0.08f * 0.08f + 1);
    EXPECT_LT(*std::ranges::max_element(sides), kRight / (kRight + kWrong));
    Settings off = settings();
    off.fade.uncertain = false;
    EXPECT_THAT(weightsOf(show(8, off), shared::kOutcomeSide), testing::Each(1.0f));
}

TEST_P(CertaintyTest, anUncertainAnswerIsBetterThanNone) {
    const Picture picture = trace(lampBeforeWall(8), SyntheticCamera{}, kWidth, kHeight, settings());
    EXPECT_GT(weightsOf(picture, shared::kOutcomeSide).size(), 50u);
    EXPECT_THAT(weightsOf(picture, shared::kOutcomeSide), testing::Each(1.0f));
}

TEST_P(CertaintyTest, whatIsAsBrightAsItsSurroundingsKeepsItsWeight) {
    const Picture picture = show(kWall, settings());
    EXPECT_GT(weightsOf(picture, shared::kOutcomeSide).size(), 50u);
    EXPECT_THAT(weightsOf(picture, shared::kOutcomeSide), testing::Each(testing::FloatNear(1, 0.001f)));
    EXPECT_THAT(weightsOf(picture, shared::kOutcomeHit), testing::Each(1.0f));
}

TEST_P(CertaintyTest, theMiddleOfALampIsCertain) {
    // Of the lamp's mirror image, four pixels high, the outer rows are silhouette.
    const Picture picture = show(8, settings());
    size_t certain = 0;
    size_t lamp = 0;
    for (size_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.hit(i) || picture.hitDistance[i * 4] > 2.5f)
            continue;
        ++lamp;
        certain += picture.weight[i * 4] == 1.0f;
    }
    EXPECT_GT(lamp, 40u);
    EXPECT_GT(certain, lamp / 4);
    EXPECT_LT(certain, lamp);
}

INSTANTIATE_TEST_SUITE_P(Marchers, CertaintyTest, testing::Values(March::Hiz, March::Linear, March::Adaptive));

} // namespace certainty_test
} // namespace glint::test
