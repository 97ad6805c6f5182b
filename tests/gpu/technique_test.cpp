// The promises of every marcher, on synthetic frames with known answers. Runs over the registry: a new technique is
// tested once it is listed.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/trace/technique.hpp"

#include <glm/gtc/constants.hpp>

namespace glint::test {
namespace technique_test {

constexpr double kWallZ = -3;

/// A floor mirror at y = 0 and a wall at z = -3 whose colour is its position: red = x, green = y.
std::optional<SyntheticSurface> mirrorAndWall(const glm::dvec3& origin, const glm::dvec3& direction) {
    const double toFloor = direction.y < 0 ? -origin.y / direction.y : 1e9;
    const double toWall = direction.z < 0 ? (kWallZ - origin.z) / direction.z : 1e9;
    if (toFloor > 1e8 && toWall > 1e8)
        return std::nullopt;
    SyntheticSurface hit;
    if (toFloor < toWall) {
        hit.distance = toFloor;
        hit.normalWS = {0, 1, 0};
        hit.f0 = glm::vec3(1);
    } else {
        const glm::dvec3 position = origin + direction * toWall;
        hit.distance = toWall;
        hit.normalWS = {0, 0, 1};
        hit.radiance = glm::vec3(position.x + 10, position.y + 10, 1);
    }
    return hit;
}

class TechniqueTest : public LibraryTest, public testing::WithParamInterface<size_t> {
protected:
    static const reflect::Technique& technique() { return reflect::techniques()[GetParam()]; }

    static Settings plainSettings() {
        Settings settings;
        settings.screen.march = technique().march;
        settings.fade.border = FadeBorder::None_;
        settings.fade.uncertain = false; // certainty_test.cpp
        settings.screen.inferred = 0;    // the marchers' own answers; guesses are less exact (outcome_test.cpp)
        settings.probes.enabled = false; // only their volumes are used
        return settings;
    }

    struct Picture {
        std::vector<float> composite;
        std::vector<float> weight;
        std::vector<float> hitUV;
        Statistics statistics;
    };

    static Picture trace(const SyntheticScene& scene, const SyntheticCamera& camera, uint32_t width, uint32_t height,
                         const Settings& settings) {
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, width, height);
        Reflections reflections = must(Reflections::create(library(), {width, height, settings, true, true}));
        must(reflections.setInputs(host.gbuffer));
        const TestVolumes fitting = TestVolumes::giveTo(reflections, gpu(), library(), {wallVolume()});
        HostImage composite;
        run([&](VkCommandBuffer commands) { composite = reflections.record(commands, camera.view(width, height)); });
        Picture picture;
        picture.composite = download(gpu(), composite);
        picture.statistics = reflections.statistics();
        const auto view = [&](const char* name) {
            HostImage image;
            run([&](VkCommandBuffer commands) { image = must(reflections.recordView(commands, name)); });
            return download(gpu(), image);
        };
        picture.weight = view("weight");
        picture.hitUV = view("hitUV");
        return picture;
    }
};

TEST_P(TechniqueTest, reflectionLandsWithinOnePixelOfThePrediction) {
    const SyntheticCamera camera;
    for (const glm::uvec2 size : {glm::uvec2(160, 90), glm::uvec2(127, 71)}) {
        const Picture picture = trace(mirrorAndWall, camera, size.x, size.y, plainSettings());
        size_t predicted = 0;
        size_t hits = 0;
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x) {
                const glm::dvec3 direction = camera.rayThrough(x, y, size.x, size.y);
                const auto floor = mirrorAndWall(camera.position, direction);
                if (!floor || floor->f0.x == 0)
                    continue;
                const glm::dvec3 start = camera.position + direction * floor->distance;
                const glm::dvec3 reflected(direction.x, -direction.y, direction.z);
                if (reflected.z >= 0)
                    continue;
                const glm::dvec3 end = start + reflected * ((kWallZ - start.z) / reflected.z);
                const glm::dvec2 expected = camera.project(end, size.x, size.y);
                const bool visible =
                    expected.x > 1 && expected.y > 1 && expected.x < size.x - 1.0 && expected.y < size.y - 1.0;
                // One lookup cannot detect the wall where its pixel shows the floor.
                const auto shown = mirrorAndWall(camera.position,
                                                 camera.rayThrough(static_cast<uint32_t>(expected.x),
                                                                   static_cast<uint32_t>(expected.y), size.x, size.y));
                if (!visible || (!technique().walks && shown && shown->f0.x > 0))
                    continue;
                ++predicted;
                const size_t i = (y * size.x + x) * 4;
                if (picture.weight[i] <= 0)
                    continue;
                ++hits;
                const glm::dvec2 found = glm::dvec2(picture.hitUV[i], picture.hitUV[i + 1]) * glm::dvec2(size);
                ASSERT_LT(glm::length(found - expected), 1.0) << technique().name << " at " << x << "," << y;
            }
        EXPECT_GT(predicted, size.x * size.y / 8);
        EXPECT_GE(hits, predicted * 99 / 100) << technique().name;
    }
}

TEST_P(TechniqueTest, raysFromJustAboveTheFloorReachTheWall) {
    // Close to the floor, almost all of a ray's way is within a pixel of its end on screen, its hit too.
    SyntheticCamera camera;
    camera.position = {0, 0.002, 3};
    camera.target = {0, 0.3, 0};
    camera.near = 0.001;
    const uint32_t width = 96;
    const uint32_t height = 64;
    const Picture picture = trace(mirrorAndWall, camera, width, height, plainSettings());
    size_t floor = 0;
    size_t hits = 0;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const auto shown = mirrorAndWall(camera.position, camera.rayThrough(x, y, width, height));
            if (!shown || shown->f0.x == 0)
                continue;
            ++floor;
            hits += picture.weight[(y * width + x) * 4] > 0;
        }
    EXPECT_GT(floor, 500u);
    EXPECT_GE(hits, technique().walks ? floor * 995 / 1000 : floor / 2) << technique().name;
}

TEST_P(TechniqueTest, theFloorMirrorsTheWallFromTheirContactOn) {
    if (!technique().walks)
        GTEST_SKIP() << "one lookup cannot detect the wall where its pixel shows the floor";
    const uint32_t width = 64;
    const uint32_t height = 160;
    Settings settings = plainSettings();
    settings.adaptive.steps = 12; // of many pixels each
    for (const double up : {0.4, 0.41, 0.42, 0.43, 0.44, 0.9}) {
        SyntheticCamera camera;
        camera.position.y = up;
        const Picture picture = trace(mirrorAndWall, camera, width, height, settings);
        const auto isFloor = [&](uint32_t x, uint32_t y) {
            const auto shown = mirrorAndWall(camera.position, camera.rayThrough(x, y, width, height));
            return shown && shown->f0.x > 0;
        };
        for (uint32_t x = 0; x < width; ++x) {
            uint32_t first = 0;
            while (first < height && !isFloor(x, first))
                ++first;
            ASSERT_LT(first, height - 4);
            for (uint32_t y = first; y < first + 4; ++y)
                ASSERT_GT(picture.weight[(y * width + x) * 4], 0)
                    << technique().name << " at " << x << "," << y << ", the floor begins at " << first << ", eye at "
                    << up;
        }
    }
}

TEST_P(TechniqueTest, backgroundAndUnreflectivePixelsGetNothing) {
    const SyntheticCamera camera;
    const uint32_t width = 64;
    const uint32_t height = 36;
    const Picture picture = trace(mirrorAndWall, camera, width, height, plainSettings());
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const auto hit = mirrorAndWall(camera.position, camera.rayThrough(x, y, width, height));
            if (!hit || hit->f0.x == 0) {
                ASSERT_EQ(picture.weight[(y * width + x) * 4], 0);
            }
        }
}

TEST_P(TechniqueTest, brokenColoursDoNotSpread) {
    const SyntheticCamera camera;
    const auto broken = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = mirrorAndWall(origin, direction);
        if (hit && hit->f0.x == 0) {
            const int which = static_cast<int>(std::floor(hit->radiance.x * 8)) % 4;
            const float values[] = {NAN, INFINITY, -5, 1e30f};
            hit->radiance = glm::vec3(values[which]);
        }
        return hit;
    };
    const uint32_t width = 97;
    const uint32_t height = 53;
    const Picture picture = trace(broken, camera, width, height, plainSettings());
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const auto hit = mirrorAndWall(camera.position, camera.rayThrough(x, y, width, height));
            if (!hit || hit->f0.x == 0)
                continue; // the host's own pixels stay as they are
            for (uint32_t c = 0; c < 3; ++c) {
                const float value = picture.composite[(y * width + x) * 4 + c];
                ASSERT_TRUE(std::isfinite(value) && value >= 0 && value <= 65504.0f) << x << "," << y << ": " << value;
            }
        }
}

TEST_P(TechniqueTest, oddSizesWork) {
    const SyntheticCamera camera;
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(17, 9), glm::uvec2(3, 257)}) {
        const Picture picture = trace(mirrorAndWall, camera, size.x, size.y, plainSettings());
        uint64_t pixels = 0;
        for (const Statistics::Outcome& outcome : picture.statistics.outcomes)
            pixels += outcome.count;
        EXPECT_EQ(pixels, uint64_t(size.x) * size.y) << "every pixel has exactly one outcome";
    }
}

TEST_P(TechniqueTest, sameInputSameBits) {
    const SyntheticCamera camera;
    Settings settings = plainSettings();
    settings.rough.factor = 0.3f;
    const Picture first = trace(mirrorAndWall, camera, 64, 36, settings);
    const Picture second = trace(mirrorAndWall, camera, 64, 36, settings);
    EXPECT_EQ(first.composite, second.composite);
    EXPECT_EQ(first.hitUV, second.hitUV);
}

TEST_P(TechniqueTest, exhaustedStepsAreNeverAHit) {
    const SyntheticCamera camera;
    Settings settings = plainSettings();
    settings.screen.maxSteps = 3;
    settings.hiz.maxIterations = 3;
    settings.adaptive.steps = 3;
    settings.adaptive.pixelSpacing = 64;
    const Picture picture = trace(mirrorAndWall, camera, 160, 90, settings);
    uint64_t outOfSteps = 0;
    for (const Statistics::Outcome& outcome : picture.statistics.outcomes)
        if (outcome.name == "outOfSteps")
            outOfSteps = outcome.count;
    EXPECT_LE(picture.statistics.lookups95, technique().maxLookups(settings));
    if (technique().canRunOut)
        EXPECT_GT(outOfSteps, technique().march == March::Hiz ? 300u : 1000u);
    else
        EXPECT_EQ(outOfSteps, 0u) << "its steps, if it has any, always span the whole ray";
}

INSTANTIATE_TEST_SUITE_P(Registry, TechniqueTest, testing::Range<size_t>(0, reflect::techniques().size()),
                         [](const auto& test) { return std::string(reflect::techniques()[test.param].name); });

} // namespace technique_test
} // namespace glint::test
