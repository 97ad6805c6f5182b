// The source of hits' colour: screen.colorSource, and the encodings of input and output. A host's frame whose colour
// identifies it shows which frame's colours a reflection has.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

namespace glint::test {
namespace color_source_test {

constexpr uint32_t kWidth = 121;
constexpr uint32_t kHeight = 67;

const glm::vec3 kRed(1, 0, 0);
const glm::vec3 kGreen(0, 1, 0);

class ColorSourceTest : public LibraryTest {
protected:
    static Settings previousSettings() {
        Settings settings = plainSettings();
        settings.screen.colorSource = ColorSource::Previous;
        return settings;
    }
    static SyntheticGBuffer render(const SyntheticScene& scene, const SyntheticCamera& camera = {}) {
        return SyntheticGBuffer::render(gpu(), scene, camera, kWidth, kHeight);
    }
    static Picture frame(Reflections& made, const GBuffer& gbuffer, const SyntheticCamera& camera = {}) {
        must(made.setInputs(gbuffer));
        return trace(made, camera.view(kWidth, kHeight));
    }
    /// Pixels whose reflection is mostly this colour.
    static size_t count(const Picture& picture, const glm::vec3& color) {
        size_t n = 0;
        for (size_t i = 0; i < picture.pixels(); ++i) {
            const glm::vec3 got(picture.reflection[i * 4], picture.reflection[i * 4 + 1],
                                picture.reflection[i * 4 + 2]);
            n += picture.weight[i * 4] > 0.9f && glm::length(got - color) < 0.1f;
        }
        return n;
    }
};

TEST_F(ColorSourceTest, previousTakesTheLastFramesColours) {
    const SyntheticGBuffer red = render(litBy(floorAndWall(), kRed));
    const SyntheticGBuffer green = render(litBy(floorAndWall(), kGreen));
    Settings settings = previousSettings();
    Reflections made = reflections(kWidth, kHeight, settings);
    const Picture first = frame(made, red.gbuffer);
    EXPECT_GT(count(first, kRed), 1000u) << "the first frame has only itself";
    const Picture second = frame(made, green.gbuffer);
    EXPECT_EQ(count(second, kRed), count(first, kRed));
    EXPECT_EQ(count(frame(made, green.gbuffer), kGreen), count(first, kRed));

    // Off and on again: the history is then too old.
    settings.screen.colorSource = ColorSource::Current;
    must(made.setSettings(settings));
    EXPECT_GT(count(frame(made, red.gbuffer), kRed), 1000u);
    settings.screen.colorSource = ColorSource::Previous;
    must(made.setSettings(settings));
    EXPECT_GT(count(frame(made, green.gbuffer), kGreen), 1000u);
    EXPECT_GT(count(frame(made, red.gbuffer), kGreen), 1000u) << "and from then on it remembers";

    // A frame without reflections leaves no history.
    settings.reflect.strength = 0;
    must(made.setSettings(settings));
    frame(made, red.gbuffer);
    settings.reflect.strength = 1;
    must(made.setSettings(settings));
    EXPECT_GT(count(frame(made, red.gbuffer), kRed), 1000u);
}

TEST_F(ColorSourceTest, highlightsOfSmoothSurfacesStayWithTheEye) {
    const glm::vec3 shown(2, 1, 0.5f);
    constexpr float kShare = 0.25f;
    const auto wallOf = [&](float perceptualRoughness) -> SyntheticScene {
        return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto hit = floorAndWall()(origin, direction);
            if (hit && hit->f0.x == 0) {
                hit->radiance = shown;
                hit->alpha = kShare * (shown.r + shown.g + shown.b) / 3;
                hit->perceptualRoughness = perceptualRoughness;
            }
            return hit;
        };
    };
    const auto pixelsThatShow = [](const Picture& picture, const glm::vec3& color) {
        return std::pair(count(picture, color), count(picture, kShare * color));
    };
    for (const float resolutionScale : {1.0f, 0.5f}) {
        Settings settings = plainSettings();
        settings.screen.resolutionScale = resolutionScale;
        Reflections made = reflections(kWidth, kHeight, settings);
        SyntheticGBuffer smooth = render(wallOf(0.1f));
        SyntheticGBuffer rough = render(wallOf(0.8f));
        const auto [untold, untoldLess] = pixelsThatShow(frame(made, smooth.gbuffer), shown);
        EXPECT_GT(untold, 1000u) << "alpha means nothing yet";
        EXPECT_EQ(untoldLess, 0u);
        smooth.gbuffer.conventions.highlightsInAlpha = rough.gbuffer.conventions.highlightsInAlpha = true;
        EXPECT_EQ(pixelsThatShow(frame(made, smooth.gbuffer), shown), std::pair(size_t{0}, untold));
        EXPECT_EQ(pixelsThatShow(frame(made, rough.gbuffer), shown), std::pair(untold, size_t{0}));
        settings.screen.highlights = true;
        must(made.setSettings(settings));
        EXPECT_EQ(pixelsThatShow(frame(made, smooth.gbuffer), shown), std::pair(untold, size_t{0}));
    }
}

TEST_F(ColorSourceTest, aSmallerTraceRemembersToo) {
    const SyntheticGBuffer red = render(litBy(floorAndWall(), kRed));
    const SyntheticGBuffer green = render(litBy(floorAndWall(), kGreen));
    Settings settings = previousSettings();
    settings.screen.resolutionScale = 0.5f;
    Reflections made = reflections(kWidth, kHeight, settings);
    frame(made, red.gbuffer);
    EXPECT_GT(count(frame(made, green.gbuffer), kRed), 1000u);
}

TEST_F(ColorSourceTest, debugColoursAreNotRemembered) {
    const SyntheticGBuffer red = render(litBy(floorAndWall(), kRed));
    Settings settings = previousSettings();
    settings.debug.outcome = true;
    Reflections made = reflections(kWidth, kHeight, settings);
    frame(made, red.gbuffer);
    settings.debug.outcome = false;
    must(made.setSettings(settings));
    EXPECT_GT(count(frame(made, red.gbuffer), kRed), 1000u);
}

TEST_F(ColorSourceTest, hitsAreFoundAgainWhenTheCameraMoves) {
    // The wall shows its own position: the previous frame's colour of a hit is this frame's, wherever the hit was then.
    for (const double orthoHeight : {0.0, 2.5}) {
        SyntheticCamera before;
        before.position = {0.25, 1.1, 3.2};
        before.orthoHeight = orthoHeight;
        SyntheticCamera now;
        now.orthoHeight = orthoHeight;
        const SyntheticGBuffer first = render(floorAndWall(), before);
        const SyntheticGBuffer second = render(floorAndWall(), now);
        Reflections current = reflections(kWidth, kHeight, plainSettings());
        const Picture expected = frame(current, second.gbuffer, now);
        Reflections made = reflections(kWidth, kHeight, previousSettings());
        frame(made, first.gbuffer, before);
        // Another blue identifies whose colours they are.
        const auto marked = [](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto hit = floorAndWall()(origin, direction);
            if (hit)
                hit->radiance.b = 3;
            return hit;
        };
        const SyntheticGBuffer third = render(marked, now);
        const Picture picture = frame(made, third.gbuffer, now);
        size_t hits = 0;
        size_t remembered = 0;
        size_t elsewhere = 0;
        for (size_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.hit(i) || picture.hitDistance[i * 4] < 1e-3f)
                continue; // the floor's last row may start on the wall itself
            ++hits;
            const double error = std::abs(picture.reflection[i * 4] - expected.reflection[i * 4]) +
                                 std::abs(picture.reflection[i * 4 + 1] - expected.reflection[i * 4 + 1]);
            elsewhere += error > 0.04;
            remembered += std::abs(picture.reflection[i * 4 + 2] - 1) < 0.01f;
        }
        EXPECT_GT(hits, 500u);
        EXPECT_GT(remembered, hits * 3 / 4) << "the rest was off the previous screen";
        EXPECT_LT(remembered, hits) << orthoHeight;
        EXPECT_LE(elsewhere, hits / 100) << "a texel of the floor at the very foot of the wall may pass for it";
    }
}

TEST_F(ColorSourceTest, whatWasHiddenTakesThisFramesColour) {
    Stage hiding = floorAndWall();
    hiding.cards.push_back({.low = {-0.6, 0.3}, .high = {0.6, 1.2}, .z = 0.5});
    const SyntheticGBuffer first = render(litBy(hiding, kRed)); // the card is red, and so is the wall
    const SyntheticGBuffer second = render(litBy(floorAndWall(), kGreen));
    Reflections made = reflections(kWidth, kHeight, previousSettings());
    frame(made, first.gbuffer);
    const Picture picture = frame(made, second.gbuffer);
    const SyntheticCamera camera;
    size_t hidden = 0;
    for (size_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.hit(i))
            continue;
        const glm::dvec2 px = glm::floor(picture.hitPX(i));
        const glm::dvec3 d =
            camera.rayThrough(static_cast<uint32_t>(px.x), static_cast<uint32_t>(px.y), kWidth, kHeight);
        const bool was = hiding.cards[1].distance(camera.position, d).has_value();
        hidden += was;
        ASSERT_NEAR(picture.reflection[i * 4 + 1], was ? 1 : 0, 0.01) << "pixel " << i;
    }
    EXPECT_GT(hidden, 100u);
}

TEST_F(ColorSourceTest, motionFollowsWhatMoves) {
    // A card before a dark wall moves to the right by a quarter of the image.
    const auto cardAt = [](double x, const glm::vec3& color) {
        return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
            Stage stage;
            stage.cards.push_back({.low = {x - 0.4, 0}, .high = {x + 0.4, 1}, .z = -1});
            auto hit = stage(origin, direction);
            if (hit && hit->f0.x == 0)
                hit->radiance = color;
            return hit;
        };
    };
    const SyntheticCamera camera;
    const auto uv = [&](double x) {
        return camera.project({x, 0.5, -1}, kWidth, kHeight) / glm::dvec2(kWidth, kHeight);
    };
    const SyntheticGBuffer first = render(cardAt(-0.5, kRed));
    SyntheticGBuffer second = render(cardAt(0.5, kGreen));

    Reflections still = reflections(kWidth, kHeight, previousSettings());
    frame(still, first.gbuffer);
    const Picture without = frame(still, second.gbuffer);
    EXPECT_EQ(count(without, kRed), 0u) << "taken for at rest: there was nothing";
    EXPECT_GT(count(without, kGreen), 200u);

    // Motion in pixels and with the opposite sign, as the conventions declare.
    const glm::vec2 moved((uv(0.5) - uv(-0.5)) * glm::dvec2(kWidth, kHeight));
    const std::vector<glm::vec2> texels(size_t(kWidth) * kHeight, moved);
    const gpu::Image motion =
        uploadTestImage(gpu(), "test/motion", VK_FORMAT_R32G32_SFLOAT, kWidth, kHeight, bytesOf(texels));
    second.gbuffer.motion = asHostImage(motion);
    second.gbuffer.conventions.motionScale[0] = -1.0f / kWidth;
    second.gbuffer.conventions.motionScale[1] = -1.0f / kHeight;
    Reflections made = reflections(kWidth, kHeight, previousSettings());
    frame(made, first.gbuffer);
    const Picture with = frame(made, second.gbuffer);
    EXPECT_GT(count(with, kRed), count(without, kGreen) * 9 / 10);
}

TEST_F(ColorSourceTest, motionInDepthFollowsWhatApproaches) {
    // A card before a dark wall comes nearer by a metre, a quarter of its distance.
    const auto cardAt = [](double z, const glm::vec3& color) {
        return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
            Stage stage;
            stage.cards.push_back({.low = {-0.8, 0}, .high = {0.8, 1}, .z = z});
            auto hit = stage(origin, direction);
            if (hit && hit->f0.x == 0)
                hit->radiance = color;
            return hit;
        };
    };
    const SyntheticCamera camera;
    const SyntheticGBuffer first = render(cardAt(-2, kRed));
    SyntheticGBuffer second = render(cardAt(-1, kGreen));
    std::vector<glm::vec4> texels;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 eye = camera.originThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const glm::dvec3 ray = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const auto hit = cardAt(-1, kGreen)(eye, ray);
        const glm::dvec3 place = eye + ray * (hit ? hit->distance : 1);
        const glm::dvec3 before = hit && hit->radiance == kGreen ? place - glm::dvec3(0, 0, 1) : place;
        const glm::dvec2 moved = camera.project(before, kWidth, kHeight) - camera.project(place, kWidth, kHeight);
        texels.emplace_back(moved / glm::dvec2(kWidth, kHeight), camera.viewZ(before) - camera.viewZ(place), 0);
    }
    const gpu::Image motion =
        uploadTestImage(gpu(), "test/motion", VK_FORMAT_R32G32B32A32_SFLOAT, kWidth, kHeight, bytesOf(texels));
    second.gbuffer.motion = asHostImage(motion);
    const auto found = [&](float depthScale) {
        second.gbuffer.conventions.motionDepthScale = depthScale;
        Reflections made = reflections(kWidth, kHeight, previousSettings());
        frame(made, first.gbuffer);
        return count(frame(made, second.gbuffer), kRed);
    };
    EXPECT_EQ(found(0), 0u) << "nothing was there at the distance at which it is now";
    EXPECT_GT(found(1), 200u);
    EXPECT_EQ(found(-1), 0u) << "nor at the wrong one";
}

TEST_F(ColorSourceTest, motionMustFit) {
    SyntheticGBuffer host = render(floorAndWall());
    Reflections made = reflections(kWidth, kHeight, previousSettings());
    GBuffer gbuffer = host.gbuffer;
    gbuffer.motion = host.gbuffer.depth;
    gbuffer.motion.width = 3;
    EXPECT_FALSE(made.setInputs(gbuffer));
    gbuffer = host.gbuffer;
    gbuffer.conventions.motionScale[0] = NAN;
    EXPECT_FALSE(made.setInputs(gbuffer));
    gbuffer = host.gbuffer;
    gbuffer.conventions.motionDepthScale = NAN;
    EXPECT_FALSE(made.setInputs(gbuffer));
    const std::vector<glm::vec2> texels(size_t(kWidth) * kHeight);
    const gpu::Image motion =
        uploadTestImage(gpu(), "test/motion", VK_FORMAT_R32G32_SFLOAT, kWidth, kHeight, bytesOf(texels));
    gbuffer.motion = asHostImage(motion);
    gbuffer.conventions.motionDepthScale = 1;
    const Result<void> flat = made.setInputs(gbuffer);
    ASSERT_FALSE(flat);
    EXPECT_NE(flat.error().message.find("has 2 channels"), std::string::npos) << flat.error().message;
}

TEST_F(ColorSourceTest, aMirrorShowsTheReflectionsOfTheFrameBefore) {
    // Two mirrors: the floor, and a glossy card that stands on it. The floor's reflection of the card is black with
    // this frame's colours, and shows the card's own reflections with the previous frame's.
    const auto corner = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        Stage stage = floorAndWall();
        stage.floorF0 = 0.9f;
        stage.cards.push_back({.low = {-0.6, 0}, .high = {0.6, 0.8}, .z = 0, .f0 = 1});
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 1)
            hit->radiance = glm::vec3(0);
        return hit;
    };
    const TestEnvironment sky =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(0.5f); });
    const SyntheticGBuffer host = render(corner);
    const auto shows = [&](const Settings& settings, int frames) {
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(host.gbuffer, sky.map));
        Picture picture;
        for (int i = 0; i < frames; ++i)
            picture = trace(made, SyntheticCamera{}.view(kWidth, kHeight));
        size_t bright = 0;
        size_t dark = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            if (picture.weight[i * 4] > 0.9f)
                ++(picture.reflection[i * 4] > 0.4f && picture.reflection[i * 4] < 0.6f ? bright : dark);
        return std::pair(bright, dark);
    };
    const auto [brightNow, darkNow] = shows(plainSettings(), 2);
    const auto [brightBefore, darkBefore] = shows(previousSettings(), 2);
    EXPECT_EQ(brightNow, 0u);
    EXPECT_GT(brightBefore, 200u);
    EXPECT_EQ(brightNow + darkNow, brightBefore + darkBefore);
}

// ---------------------------------------------------------------- encodings

double encode(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

SyntheticScene encodedScene() {
    return [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = floorAndWall()(origin, direction);
        if (hit)
            for (int c = 0; c < 3; ++c)
                hit->radiance[c] = static_cast<float>(encode(hit->radiance[c] * 0.1));
        return hit;
    };
}
SyntheticScene linearScene() {
    return [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = floorAndWall()(origin, direction);
        if (hit)
            hit->radiance *= 0.1f;
        return hit;
    };
}

TEST_F(ColorSourceTest, encodedInputIsDecodedWhereverItIsRead) {
    const Picture linear = trace(linearScene(), SyntheticCamera{}, kWidth, kHeight, plainSettings());
    Settings settings = plainSettings();
    for (const float scale : {1.0f, 0.5f}) {
        settings.screen.resolutionScale = scale;
        settings.input.colorIsGamma = false;
        const Picture expected = trace(linearScene(), SyntheticCamera{}, kWidth, kHeight, settings);
        settings.input.colorIsGamma = true;
        const Picture picture = trace(encodedScene(), SyntheticCamera{}, kWidth, kHeight, settings);
        for (size_t i = 0; i < linear.composite.size(); ++i)
            ASSERT_NEAR(picture.composite[i], expected.composite[i], 0.002) << i;
    }
}

TEST_F(ColorSourceTest, outputIsEncodedAndRememberedInLinear) {
    const Picture linear = trace(linearScene(), SyntheticCamera{}, kWidth, kHeight, plainSettings());
    Settings settings = previousSettings();
    settings.output.colorIsGamma = true;
    const SyntheticGBuffer host = render(linearScene());
    Reflections made = reflections(kWidth, kHeight, settings);
    for (int i = 0; i < 2; ++i) {
        const Picture picture = frame(made, host.gbuffer);
        for (size_t k = 0; k < linear.composite.size(); ++k)
            if (k % 4 != 3) {
                ASSERT_NEAR(picture.composite[k], encode(linear.composite[k]), 0.003) << "frame " << i;
            }
    }
    // Encoded input and output: pixels that do not reflect keep their bits.
    settings.input.colorIsGamma = true;
    const Picture both = trace(encodedScene(), SyntheticCamera{}, kWidth, kHeight, settings);
    const auto seenPixels = seen(encodedScene(), SyntheticCamera{}, kWidth, kHeight);
    Settings off = plainSettings();
    const Picture plain = trace(encodedScene(), SyntheticCamera{}, kWidth, kHeight, off);
    for (size_t i = 0; i < both.pixels(); ++i)
        if (!seenPixels[i] || seenPixels[i]->f0.x == 0) {
            ASSERT_EQ(both.color(i), plain.color(i));
        }
}

TEST_F(ColorSourceTest, withEverySourceOffEncodingsChangeNothing) {
    const SyntheticGBuffer host = render(linearScene());
    Settings settings = plainSettings();
    settings.screen.enabled = false;
    settings.input.colorIsGamma = true;
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(host.gbuffer));
    HostImage result;
    run([&](VkCommandBuffer commands) { result = made.record(commands, SyntheticCamera{}.view(kWidth, kHeight)); });
    EXPECT_EQ(result.image, host.gbuffer.litRadiance.image);
}

} // namespace color_source_test
} // namespace glint::test
