// rough.cones: without noise, a rough surface's mirror ray answers with the mean of the picture over its lobe. Held
// against the lobe's own mean, from many directions through the scene.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace glint::test {
namespace cones_test {

constexpr uint32_t kWidth = 160;
constexpr uint32_t kHeight = 90;

class ConesTest : public LibraryTest {
protected:
    static Settings coneSettings() {
        Settings settings = plainSettings();
        settings.rough.cones = true;
        settings.reflect.roughnessFadeStart = 1;
        settings.reflect.maxRoughness = 1;
        return settings;
    }
    static Picture show(const SyntheticScene& scene, const Settings& settings) {
        return trace(scene, camera(), kWidth, kHeight, settings);
    }
    static SyntheticCamera camera() {
        SyntheticCamera camera;
        camera.position = {0, 0.7, 3};
        return camera;
    }
    static glm::vec3 answered(const Picture& picture, size_t pixel) {
        return glm::vec3(picture.reflection[pixel * 4], picture.reflection[pixel * 4 + 1],
                         picture.reflection[pixel * 4 + 2]) /
               picture.weight[pixel * 4];
    }
};

/// A rough floor before a wall whose radiance is `radiance(x, y)`.
SyntheticScene paintedWall(float floorRoughness, const std::function<float(double x, double y)>& radiance) {
    Stage stage = floorAndWall();
    stage.floorRoughness = floorRoughness;
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = glm::vec3(radiance(hit->radiance.x - 10.0, hit->radiance.y - 10.0));
        return hit;
    };
}

/// Mean radiance that the lobe of a floor point receives: facets by visible normals (Heitz 2018, "Sampling the GGX
/// Distribution of Visible Normals", JCGT 7(4)), each weighed by what the other facets let through.
double meanOfLobe(const SyntheticScene& scene, const glm::dvec3& at, const glm::dvec3& toEye, double alpha) {
    const auto shadowed = [&](double cosine) { // Smith's Lambda of GGX
        return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
    };
    const glm::dvec3 eye = glm::normalize(glm::dvec3(alpha * toEye.x, toEye.y, alpha * toEye.z));
    double sum = 0;
    double total = 0;
    constexpr int kSide = 48;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double turn = 2 * glm::pi<double>() * (i % kSide + 0.5) / kSide;
        const double up = (1 - (double(i) / kSide / kSide)) * (1 + eye.y) - eye.y; // spherical cap
        const double out = std::sqrt(std::max(0.0, 1 - up * up));
        const glm::dvec3 h = glm::dvec3(out * std::cos(turn), up, out * std::sin(turn)) + eye;
        const glm::dvec3 facet = glm::normalize(glm::dvec3(alpha * h.x, h.y, alpha * h.z));
        const glm::dvec3 direction = glm::reflect(-toEye, facet);
        if (direction.y <= 1e-4)
            continue;
        const double weight = (1 + shadowed(toEye.y)) / (1 + shadowed(toEye.y) + shadowed(direction.y));
        const auto hit = scene(at + direction * 1e-6, direction);
        sum += weight * (hit ? hit->radiance.x : 0);
        total += weight;
    }
    return sum / total;
}

/// Mean and largest error of the floor's answers.
struct Errors {
    double mean = 0;
    double largest = 0;
};

Errors errorsOf(const Picture& picture, const SyntheticScene& scene, const SyntheticCamera& camera, double alpha) {
    Errors errors;
    size_t compared = 0;
    for (uint32_t y = 1; y < kHeight; y += 5)
        for (uint32_t x = 2; x < kWidth; x += 5) {
            const size_t pixel = size_t{y} * kWidth + x;
            const glm::dvec3 direction = camera.rayThrough(x, y, kWidth, kHeight);
            if (direction.y >= 0 || !picture.hit(pixel))
                continue;
            const glm::dvec3 eye = camera.originThrough(x, y, kWidth, kHeight);
            const glm::dvec3 at = eye - direction * (eye.y / direction.y);
            const double error = std::abs(picture.reflection[pixel * 4] / picture.weight[pixel * 4] -
                                          meanOfLobe(scene, at, -direction, alpha));
            errors.mean += error;
            errors.largest = std::max(errors.largest, error);
            ++compared;
        }
    EXPECT_GT(compared, 150u);
    errors.mean /= static_cast<double>(std::max<size_t>(compared, 1));
    return errors;
}

TEST_F(ConesTest, theAnswerIsTheMeanOfTheLobe) {
    struct Case {
        const char* name;
        std::function<float(double x, double y)> radiance;
        double meanShare; ///< of the error that sharp answers have; most of those are right beside a single border
    };
    const Case cases[] = {
        {"upright stripe", [](double x, double) { return std::abs(x) < 0.15 ? 1.0f : 0.0f; }, 0.35},
        {"level stripe", [](double, double y) { return std::abs(y - 0.6) < 0.1 ? 1.0f : 0.0f; }, 0.35},
        {"border", [](double x, double) { return x > 0 ? 1.0f : 0.0f; }, 1.1},
    };
    for (const Case& wall : cases)
        for (const float roughness : {0.2f, 0.35f, 0.5f}) {
            SCOPED_TRACE(testing::Message() << wall.name << ", roughness " << roughness);
            const SyntheticScene scene = paintedWall(roughness, wall.radiance);
            Settings settings = coneSettings();
            const Errors blurred = errorsOf(show(scene, settings), scene, camera(), roughness * roughness);
            settings.rough.cones = false;
            const Errors sharp = errorsOf(show(scene, settings), scene, camera(), roughness * roughness);
            std::printf("%s, roughness %.2f: mean error %.3f, largest %.2f; mirror directions %.3f, %.2f\n", wall.name,
                        static_cast<double>(roughness), blurred.mean, blurred.largest, sharp.mean, sharp.largest);
            // Across, this lobe is less than half a pixel wide: traced pixels do not tell where between them an edge
            // is.
            const bool subpixel = wall.name == std::string_view("upright stripe") && roughness < 0.3f;
            EXPECT_LT(blurred.largest, (subpixel ? 0.65 : 0.5) * sharp.largest);
            EXPECT_LT(blurred.mean, (subpixel ? 0.55 : wall.meanShare) * sharp.mean);
        }
}

/// A pixel between traced pixels mixes their lobes.
TEST_F(ConesTest, aQuarterOfTheRaysShowTheLobeAsWell) {
    for (const float roughness : {0.2f, 0.35f, 0.5f}) {
        const SyntheticScene scene =
            paintedWall(roughness, [](double x, double) { return std::abs(x) < 0.15 ? 1.0f : 0.0f; });
        Settings settings = coneSettings();
        const Errors all = errorsOf(show(scene, settings), scene, camera(), roughness * roughness);
        settings.screen.resolutionScale = 0.5f;
        const Errors quarter = errorsOf(show(scene, settings), scene, camera(), roughness * roughness);
        std::printf("roughness %.2f: mean error %.4f, largest %.3f; of a quarter of the rays %.4f, %.3f\n",
                    static_cast<double>(roughness), all.mean, all.largest, quarter.mean, quarter.largest);
        EXPECT_LT(quarter.mean, 1.25 * all.mean);
        EXPECT_LT(quarter.largest, 1.5 * all.largest);
    }
}

/// No traced pixel around shows its surface, so there is nothing to mix.
TEST_F(ConesTest, aRoughLineBetweenTracedPixelsHasAnAnswer) {
    const uint32_t row = kHeight / 2 + 21; // rays start from odd rows
    ASSERT_EQ(row % 2, 0u);
    const auto floorZ = [](uint32_t y) {
        const glm::dvec3 direction = camera().rayThrough(kWidth / 2, y, kWidth, kHeight);
        return camera().position.z - direction.z * camera().position.y / direction.y;
    };
    const double near = 0.5 * (floorZ(row) + floorZ(row + 1));
    const double far = 0.5 * (floorZ(row) + floorZ(row - 1));
    const SyntheticScene wall = paintedWall(0.2f, [](double, double) { return 1.0f; });
    const SyntheticScene scene = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = wall(origin, direction);
        const double z = hit ? origin.z + direction.z * hit->distance : 0;
        if (hit && hit->f0.x > 0 && z > far && z < near)
            hit->perceptualRoughness = 0.6f;
        return hit;
    };
    Settings settings = coneSettings();
    const Picture all = show(scene, settings);
    settings.screen.resolutionScale = 0.5f;
    const Picture quarter = show(scene, settings);
    size_t answered = 0;
    for (uint32_t x = 8; x + 8 < kWidth; ++x) {
        const size_t pixel = size_t{row} * kWidth + x;
        if (!all.hit(pixel))
            continue;
        EXPECT_GT(quarter.weight[pixel * 4], 0.9f) << x;
        ++answered;
    }
    EXPECT_GT(answered, 50u);
}

TEST_F(ConesTest, theAnswerIsTheMeanOfTheLobeForParallelRaysToo) {
    SyntheticCamera camera;
    camera.position = {0, 1.5, 3};
    camera.target = {0, 0.3, 0};
    camera.orthoHeight = 4;
    const SyntheticScene scene =
        paintedWall(0.35f, [](double, double y) { return std::abs(y - 0.6) < 0.1 ? 1.0f : 0.0f; });
    Settings settings = coneSettings();
    const auto errors = [&] {
        return errorsOf(trace(scene, camera, kWidth, kHeight, settings), scene, camera, 0.35 * 0.35);
    };
    const Errors blurred = errors();
    settings.rough.cones = false;
    const Errors sharp = errors();
    EXPECT_LT(blurred.largest, 0.5 * sharp.largest);
    EXPECT_LT(blurred.mean, 0.35 * sharp.mean);
}

TEST_F(ConesTest, oneColourStaysThatColour) {
    const SyntheticScene scene = paintedWall(0.3f, [](double, double) { return 0.75f; });
    for (const float scale : {1.0f, 0.5f}) {
        Settings settings = coneSettings();
        settings.screen.resolutionScale = scale;
        const Picture picture = show(scene, settings);
        const double foot = camera().project({0, 0, -3}, kWidth, kHeight).y;
        size_t compared = 0;
        double sum = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            if (picture.weight[i * 4] > 0 && picture.hitPX(i).y < foot - 8) {
                // The lowest part of the lobe goes along the black floor. Of a smaller trace, hitUV is a neighbour's.
                const float answer = answered(picture, i).x;
                // Of mixed pixels radiance, weight and their product are halves, and the view's weight has ten bits.
                const float rounding = 1.0f / 1024 + 0.5f / 1023 / picture.weight[i * 4];
                // The mean's radiance is a half, and so is its weight.
                ASSERT_LE(answer, 0.7505f * (1 + (scale == 1 ? 1.0f / 1024 : rounding)));
                if (scale == 1) {
                    ASSERT_GE(answer, 0.94f * 0.75f) << i % kWidth << "," << i / kWidth;
                }
                sum += answer;
                ++compared;
            }
        EXPECT_GT(compared, scale == 1 ? 1000u : 200u);
        EXPECT_NEAR(sum / static_cast<double>(compared), 0.75, 0.01);
    }
}

TEST_F(ConesTest, mirrorsAndSampledRaysKeepTheirBits) {
    const auto painted = [](double x, double y) { return std::sin(20 * x) * std::sin(20 * y) > 0 ? 1.0f : 0.1f; };
    Settings settings = coneSettings();
    const auto withAndWithout = [&](float roughness) {
        settings.rough.cones = true;
        const Picture with = show(paintedWall(roughness, painted), settings);
        settings.rough.cones = false;
        return with.reflection == show(paintedWall(roughness, painted), settings).reflection;
    };
    EXPECT_TRUE(withAndWithout(0)) << "mirrors";
    settings.screen.resolutionScale = 0.5f;
    EXPECT_TRUE(withAndWithout(0)) << "mirrors between traced pixels";
    EXPECT_FALSE(withAndWithout(0.3f));
    settings.screen.resolutionScale = 1;
    EXPECT_FALSE(withAndWithout(0.3f));
    settings.denoise.enabled = true;
    EXPECT_TRUE(withAndWithout(0.3f)) << "rays sample the lobe";
    settings.denoise.enabled = false;
    settings.blur.strength = 0.1f;
    EXPECT_TRUE(withAndWithout(0.3f)) << "the blur is all of it";
    settings.blur.strength = 0;
    settings.rough.factor = 0.2f;
    EXPECT_TRUE(withAndWithout(0.3f)) << "rays are jittered";
}

TEST_F(ConesTest, whatStandsOnTheEyesSideOfAHitStaysOutOfItsLobe) {
    // The card stands behind all of the floor that reflects the wall, and is seen before the wall.
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.25f;
    stage.floorEndZ = -1e9;
    stage.cards.push_back({.low = {-0.15, 0.3}, .high = {0.15, 0.6}, .z = 1.2});
    const SyntheticScene scene = [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = glm::vec3(origin.z + direction.z * hit->distance > 0 ? 5.0f : 1.0f);
        return hit;
    };
    const Picture picture = show(scene, coneSettings());
    size_t compared = 0;
    size_t bright = 0;
    double excess = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const size_t pixel = size_t{y} * kWidth + x;
            const glm::dvec3 direction = camera().rayThrough(x, y, kWidth, kHeight);
            const double z = 3 - direction.z * 0.7 / direction.y;
            if (direction.y >= 0 || z > 1 || z < -1.5 || !picture.hit(pixel))
                continue;
            ++compared;
            bright += answered(picture, pixel).x > 1.5f;
            excess += answered(picture, pixel).x - 1;
        }
    EXPECT_GT(compared, 1000u);
    EXPECT_EQ(bright, 0u);                                    // 30 if all that the picture shows beside the hit counts
    EXPECT_LT(excess, 0.003 * static_cast<double>(compared)); // 0.015
}

TEST_F(ConesTest, thePreviousFramesPictureIsBlurredWhereHitsTakeItsColours) {
    Settings settings = coneSettings();
    settings.screen.colorSource = ColorSource::Previous;
    const auto stripes = [](float low, float high) {
        return paintedWall(0.3f, [=](double x, double) { return std::sin(12 * x) > 0 ? high : low; });
    };
    const auto render = [](const SyntheticScene& scene) {
        return SyntheticGBuffer::render(gpu(), scene, camera(), kWidth, kHeight);
    };
    const SyntheticGBuffer before = render(stripes(1, 3));
    const SyntheticGBuffer now = render(stripes(11, 13));
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(before.gbuffer));
    View view = camera().view(kWidth, kHeight);
    const Picture first = trace(made, view);
    must(made.setInputs(now.gbuffer));
    view.frameIndex = 1;
    const Picture second = trace(made, view);
    size_t between = 0;
    size_t hits = 0;
    for (size_t i = 0; i < second.pixels(); ++i) {
        if (!second.hit(i))
            continue;
        ++hits;
        ASSERT_LT(answered(second, i).x, 3.05f) << "of this frame";
        const float answer = answered(second, i).x;
        between += answer > 1.3f && answer < 2.7f;
    }
    EXPECT_GT(hits, 1500u);
    EXPECT_GT(between, hits / 4) << "blurred";
    EXPECT_TRUE(std::ranges::any_of(first.reflection, [](float value) { return value > 1.3f && value < 2.7f; }))
        << "the first frame blurs its own picture";
}

} // namespace cones_test
} // namespace glint::test
