// Where a marcher of equal steps takes no samples because a cell of the depth pyramid says that the space is open,
// every sample would have been clearly in front of what the picture shows (shaders/trace/open_space.glsl).
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::test {
namespace open_space_test {

constexpr uint32_t kWidth = 161; // odd: the last cells reach beyond the picture
constexpr uint32_t kHeight = 91;

/// A mirror floor with things near and far on it, and a gap through which the background shows.
Stage room() {
    Stage stage;
    stage.cards.push_back({.low = {-9, 0}, .high = {1.2, 1.4}, .z = -3});
    stage.cards.push_back({.low = {-0.6, 0.1}, .high = {-0.1, 0.7}, .z = -1, .f0 = 0.5f});
    stage.cards.push_back({.low = {0.4, 0}, .high = {0.8, 0.5}, .z = -0.5, .f0 = 0.5f});
    return stage;
}

class OpenSpaceTest : public LibraryTest {
protected:
    static Settings settings() {
        Settings settings = plainSettings(March::Linear);
        settings.screen.step = 1;
        settings.screen.inferred = 0;
        return settings;
    }

    static RayInspection inspect(Reflections& made, uint32_t x, uint32_t y) {
        run([&](VkCommandBuffer commands) { must(made.recordInspection(commands, x, y)); });
        return made.inspection();
    }
};

/// A place on a ray's way: 1 / depth is linear on screen.
struct Place {
    glm::dvec2 px;
    double invDepth;
};

Place placeAt(const Place& from, const Place& to, double share) {
    return {glm::mix(from.px, to.px, share), glm::mix(from.invDepth, to.invDepth, share)};
}

TEST_F(OpenSpaceTest, everySampleThatIsLeftOutIsClearlyInFront) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), room(), camera, kWidth, kHeight);
    Reflections made = must(Reflections::create(library(), {kWidth, kHeight, settings(), true, true, true}));
    must(made.setInputs(host.gbuffer));
    run([&](VkCommandBuffer commands) { made.record(commands, camera.view(kWidth, kHeight)); });
    const std::vector<float> depth = readView(made, "depth");

    size_t leftOut = 0;
    for (uint32_t y = 0; y < kHeight; y += 3)
        for (uint32_t x = 0; x < kWidth; x += 4) {
            const RayInspection ray = inspect(made, x, y);
            if (!ray.traced || ray.samples.empty())
                continue;
            SCOPED_TRACE(testing::Message() << "pixel " << x << "," << y);
            EXPECT_TRUE(ray.sameAsFrame);
            const Place start = {{ray.start.px[0], ray.start.px[1]}, 1.0 / ray.start.depth};
            for (const RaySample& sample : ray.samples) {
                if (sample.level == 0 || (sample.decision != "front" && sample.decision != "empty"))
                    continue;
                const Place enters = {{sample.positionPX[0], sample.positionPX[1]}, 1.0 / sample.rayDepth};
                const glm::dvec2 way = glm::abs(enters.px - start.px);
                const double pixels = std::max(way.x, way.y); // the row of samples: one for each of them
                if (pixels < 1)
                    continue;
                const glm::ivec2 cell = glm::ivec2(enters.px) >> static_cast<int>(sample.level);
                for (double i = std::ceil(pixels);; ++i) {
                    const Place at = placeAt(start, enters, i / pixels);
                    const glm::ivec2 px(glm::floor(at.px));
                    // Space is known up to the middle of the last pixels.
                    const bool known =
                        at.px.x >= 0.5 && at.px.y >= 0.5 && at.px.x <= kWidth - 0.5 && at.px.y <= kHeight - 0.5;
                    if (!known || px >> static_cast<int>(sample.level) != cell || at.invDepth <= 0)
                        break;
                    const float shown = depth[(static_cast<size_t>(px.y) * kWidth + static_cast<size_t>(px.x)) * 4];
                    if (shown > 0) { // else the background
                        EXPECT_LT(1 / at.invDepth, shown * 0.997) << "at " << px.x << "," << px.y;
                    }
                    ++leftOut;
                }
            }
        }
    EXPECT_GT(leftOut, 10000u);
}

TEST_F(OpenSpaceTest, mostSamplesAreLeftOut) {
    const SyntheticCamera camera;
    const Picture picture = trace(room(), camera, 640, 360, settings());
    double pixels = 0; // of the ways to all hits: as many samples, if none was left out
    double lookups = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.hit(i))
            continue;
        const glm::dvec2 way = glm::abs(picture.hitPX(i) - glm::dvec2(i % 640 + 0.5, i / 640 + 0.5));
        pixels += std::max(way.x, way.y);
        lookups += picture.lookups[i * 4];
    }
    RecordProperty("lookupsAPixel", std::to_string(lookups / pixels));
    EXPECT_LT(lookups, pixels / 3) << pixels;
    EXPECT_GT(lookups, 0);
}

} // namespace open_space_test
} // namespace glint::test
