// Transparent layers as a host provides them: transmission, reflection, and errors.
#include "gpu/support/drawn_layer.hpp"
#include "gpu/support/library_test.hpp"

#include <fmt/format.h>
#include <glm/gtc/color_space.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace refraction_test {

/// A room whose walls' colour is their position.
constexpr glm::dvec3 kCenter = {0, 0, -3};
constexpr glm::dvec3 kHalf = {4, 3, 4};
const glm::dvec3 kShown = {5, 4, 8}; ///< added, so that no channel is negative

glm::dvec3 wallPoint(const glm::dvec3& origin, const glm::dvec3& direction) {
    double t = 1e30;
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0)
            t = std::min(t, (kCenter[axis] + std::copysign(kHalf[axis], direction[axis]) - origin[axis]) /
                                direction[axis]);
    return origin + direction * t;
}

std::optional<SyntheticSurface> room(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 at = wallPoint(origin, direction);
    glm::dvec3 normal(0);
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(std::abs(at[axis] - kCenter[axis]) - kHalf[axis]) < 1e-9)
            normal[axis] = at[axis] > kCenter[axis] ? -1 : 1;
    return SyntheticSurface{glm::length(at - origin), glm::normalize(normal), glm::vec3(0), 0, glm::vec3(at + kShown)};
}

glm::dvec3 snell(const glm::dvec3& d, const glm::dvec3& n, double eta) {
    const double cosine = -glm::dot(d, n);
    return eta * d + (eta * cosine - std::sqrt(1 - eta * eta * (1 - cosine * cosine))) * n;
}

struct GlassBall {
    glm::dvec3 center = {0.1, -0.1, -2};
    double radius = 0.8;
    double ior = 1.5;
    double dispersion = 0;

    std::optional<LayerSurface> operator()(const glm::dvec3& origin, const glm::dvec3& direction) const {
        const double b = glm::dot(origin - center, direction);
        const double c = glm::dot(origin - center, origin - center) - radius * radius;
        if (b * b < c)
            return std::nullopt;
        LayerSurface s;
        s.distance = -b - std::sqrt(b * b - c);
        s.normalWS = (origin + direction * s.distance - center) / radius;
        s.ior = static_cast<float>(ior);
        s.thickness = static_cast<float>(2 * radius);
        s.dispersion = static_cast<float>(dispersion);
        s.shape = BodyShape::Sphere;
        return s;
    }

    /// The point of the wall that a ray sees through the ball, which it hits at `hit`.
    glm::dvec3 wallBehind(const glm::dvec3& origin, const glm::dvec3& direction, const LayerSurface& hit) const {
        const glm::dvec3 entry = origin + direction * hit.distance;
        const glm::dvec3 inside = snell(direction, hit.normalWS, 1 / ior);
        const glm::dvec3 exit = entry - 2 * glm::dot(inside, entry - center) * inside;
        return wallPoint(exit, snell(inside, (center - exit) / radius, ior));
    }
};

class RefractionTest : public LibraryTest {
protected:
    static constexpr uint32_t kWidth = 160;
    static constexpr uint32_t kHeight = 120;
    const SyntheticCamera camera_ = {.position = {0.2, 0.1, 0.8}, .target = {0, 0, -3}, .fovY = 1.2};
    SyntheticGBuffer g_ = SyntheticGBuffer::render(gpu(), room, camera_, kWidth, kHeight);

    static Settings settings() {
        Settings settings;
        settings.screen.enabled = false;
        settings.sky.enabled = false;
        settings.refraction.borderWidth = 0;
        settings.refraction.reflections = false;
        settings.fade.border = FadeBorder::None_;
        return settings;
    }

    /// The image after the layers, the farthest first. `volumes`: of probes without images.
    std::vector<float> over(const std::vector<LayerScene>& scenes, const Settings& settings,
                            const EnvironmentMap& environment = {}, const std::vector<Probe>& volumes = {}) {
        std::vector<DrawnLayer> layers;
        for (const LayerScene& scene : scenes)
            layers.push_back(DrawnLayer::draw(gpu(), scene, camera_, kWidth, kHeight));
        ReflectionsDesc desc = {kWidth, kHeight, settings};
        desc.transparentLayers = true;
        Reflections reflections = must(Reflections::create(library(), desc));
        must(reflections.setInputs(g_.gbuffer, environment));
        std::optional<TestVolumes> given;
        if (!volumes.empty())
            given.emplace(TestVolumes::giveTo(reflections, gpu(), library(), volumes));
        HostImage picture;
        run([&](VkCommandBuffer commands) {
            picture = reflections.record(commands, camera_.view(kWidth, kHeight));
            for (const DrawnLayer& layer : layers)
                picture = must(reflections.recordLayer(commands, layer.layer, picture));
        });
        return download(gpu(), picture);
    }
    std::vector<float> without(const Settings& settings) { return over({}, settings); }

    /// An opaque surface of this radiance with an F0 of 0.2, seen at 63 degrees.
    static LayerSurface slanted(float radiance) {
        LayerSurface surface;
        surface.f0 = glm::vec3(0.2f);
        surface.radiance = glm::vec4(glm::vec3(radiance), 1);
        surface.transmittance = glm::vec4(0, 0, 0, 1);
        surface.normalWS = glm::normalize(glm::dvec3(2, 0, 1));
        return surface;
    }
    /// What the middle of the image shows of a pane that reflects a white sky alone.
    double underWhiteSky(const LayerSurface& surface, Settings wanted) {
        const TestEnvironment white =
            TestEnvironment::make(gpu(), 16, 4, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
        wanted.screen.enabled = wanted.refraction.screen = false;
        return shown(over({pane(-1, surface)}, wanted, white.map), (kHeight / 2) * kWidth + kWidth / 2).x;
    }

    static glm::dvec3 shown(const std::vector<float>& picture, size_t pixel) {
        return {picture[pixel * 4], picture[pixel * 4 + 1], picture[pixel * 4 + 2]};
    }
};

TEST_F(RefractionTest, WithIor1OrWithoutThicknessNothingIsSeen) {
    const std::vector<float> plain = without(settings());
    for (const BodyShape shape : {BodyShape::Straight, BodyShape::Sphere, BodyShape::Plane})
        for (const bool dense : {false, true}) {
            LayerSurface surface;
            surface.shape = shape;
            surface.ior = dense ? 1.5f : 1.0f;
            surface.thickness = dense ? 0.0f : 0.4f;
            const std::vector<float> picture = over({pane(-1, surface)}, settings());
            float worst = 0;
            for (size_t i = 0; i < plain.size(); ++i)
                worst = std::max(worst, std::abs(picture[i] - plain[i]));
            EXPECT_EQ(worst, 0) << static_cast<int>(shape) << " " << dense;
        }
}

/// Every pixel of a glass ball shows the exact point of the wall that its light comes from, if the frame shows that
/// point.
TEST_F(RefractionTest, ABallShowsWhatSnellSays) {
    const GlassBall ball;
    const std::vector<float> picture = over({ball}, settings());
    std::vector<double> errors;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 direction = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const std::optional<LayerSurface> hit = ball(camera_.position, direction);
        if (!hit || -glm::dot(hit->normalWS, direction) < 0.2) // at the rim a pixel sees half of the room
            continue;
        const glm::dvec3 wall = ball.wallBehind(camera_.position, direction, *hit);
        const glm::dvec2 px = camera_.project(wall, kWidth, kHeight);
        const bool seen = px.x > 2 && px.y > 2 && px.x < kWidth - 2 && px.y < kHeight - 2 && camera_.viewZ(wall) > 0.1;
        if (seen)
            errors.push_back(glm::distance(shown(picture, i) - kShown, wall));
    }
    ASSERT_GT(errors.size(), 1000u);
    std::sort(errors.begin(), errors.end());
    std::printf("%zu pixels: median %.4f m, 95 %% %.4f m, worst %.4f m\n", errors.size(), errors[errors.size() / 2],
                errors[errors.size() * 95 / 100], errors.back());
    // A pixel of the far wall, 7.8 m away, is 0.09 m wide; the frame is sampled at a pixel's centre or between four.
    EXPECT_LT(errors[errors.size() / 2], 0.05);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.15);
}

/// With the room as proxy a pixel of the ball shows the point of the wall that its light comes from; without a proxy
/// the point that the camera sees in the light's direction.
TEST_F(RefractionTest, TheProxySaysWhereLightComesFrom) {
    const GlassBall ball;
    Probe roomVolume;
    const glm::vec3 center(kCenter);
    const glm::vec3 half(kHalf);
    roomVolume.influence = {{center.x, center.y, center.z}, {0, 0, 0, 1}, {half.x + 1, half.y + 1, half.z + 1}};
    roomVolume.proxy = ProbeProxy::Box;
    roomVolume.proxyVolume = {{center.x, center.y, center.z}, {0, 0, 0, 1}, {half.x, half.y, half.z}};
    Settings wanted = settings();
    wanted.refraction.projection = RefractionProjection::Proxy;
    wanted.probes.enabled = false;
    for (const bool proxy : {true, false}) {
        const std::vector<float> picture =
            over({ball}, wanted, {}, proxy ? std::vector<Probe>{roomVolume} : std::vector<Probe>{});
        std::vector<double> errors;
        for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
            const glm::dvec3 direction = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const std::optional<LayerSurface> hit = ball(camera_.position, direction);
            if (!hit || -glm::dot(hit->normalWS, direction) < 0.2)
                continue;
            const glm::dvec3 entry = camera_.position + direction * hit->distance;
            const glm::dvec3 inside = snell(direction, hit->normalWS, 1 / ball.ior);
            const glm::dvec3 exit = entry - 2 * glm::dot(inside, entry - ball.center) * inside;
            const glm::dvec3 leaving = snell(inside, (ball.center - exit) / ball.radius, ball.ior);
            const glm::dvec3 wall = wallPoint(proxy ? exit : camera_.position, leaving);
            const glm::dvec2 px = camera_.project(wall, kWidth, kHeight);
            if (px.x > 2 && px.y > 2 && px.x < kWidth - 2 && px.y < kHeight - 2 &&
                camera_.viewZ(wall) > camera_.viewZ(entry) + 0.2)
                errors.push_back(glm::distance(shown(picture, i) - kShown, wall));
        }
        ASSERT_GT(errors.size(), 500u) << proxy;
        std::sort(errors.begin(), errors.end());
        std::printf("proxy %d, %zu pixels: median %.4f m, 95 %% %.4f m\n", int(proxy), errors.size(),
                    errors[errors.size() / 2], errors[errors.size() * 95 / 100]);
        EXPECT_LT(errors[errors.size() / 2], 0.05) << proxy;
        EXPECT_LT(errors[errors.size() * 95 / 100], 0.15) << proxy;
    }
}

/// A post behind the ball, which hides a part of the wall. Rays that pass behind the post hit it only if the bias
/// reaches that far.
TEST_F(RefractionTest, TheDepthBiasDecidesWhatPassesBehind) {
    const auto withPost = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        const double t = (-3.2 - origin.z) / direction.z;
        const double x = origin.x + direction.x * t;
        if (t > 0 && std::abs(x - 0.6) < 0.15)
            return std::optional(SyntheticSurface{t, glm::dvec3(0, 0, 1), glm::vec3(0), 0, glm::vec3(50)});
        return room(origin, direction);
    };
    g_ = SyntheticGBuffer::render(gpu(), withPost, camera_, kWidth, kHeight);
    const auto postPixels = [&](float bias) {
        Settings wanted = settings();
        wanted.refraction.hizDepthBias = bias;
        const std::vector<float> picture = over({GlassBall{}}, wanted);
        size_t count = 0;
        for (uint32_t i = 0; i < kWidth * kHeight; ++i)
            count += shown(picture, i).x > 40 &&
                     GlassBall{}(camera_.position, camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight));
        return count;
    };
    const size_t thin = postPixels(0);
    const size_t thick = postPixels(0.1f); // 0.4 m
    const size_t thickest = postPixels(1);
    EXPECT_GT(thin, 0u);
    EXPECT_GT(thick, thin);
    EXPECT_GT(thickest, thick + 20);
}

/// Stripes that the frame resolves and the ball shrinks: each pixel is nearer to their mean over the pixel than the
/// single point in its middle is.
TEST_F(RefractionTest, WhatABallShrinksIsAveraged) {
    const auto stripes = [](const glm::dvec3& at) {
        return 1.0 + std::copysign(1.0, std::sin(5 * at.x) * std::sin(5 * at.y) * std::sin(5 * at.z));
    };
    const auto striped = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        std::optional<SyntheticSurface> surface = room(origin, direction);
        surface->radiance = glm::vec3(static_cast<float>(stripes(wallPoint(origin, direction))));
        return surface;
    };
    g_ = SyntheticGBuffer::render(gpu(), striped, camera_, kWidth, kHeight);
    const GlassBall ball;
    const std::vector<float> picture = over({ball}, settings());
    constexpr uint32_t kSub = 15;
    double filtered = 0;
    double pointwise = 0;
    size_t pixels = 0;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        double mean = 0;
        double middle = 0;
        bool known = true;
        for (uint32_t s = 0; s < kSub * kSub && known; ++s) {
            const glm::dvec3 direction = camera_.rayThrough(
                (i % kWidth) * kSub + s % kSub, (i / kWidth) * kSub + s / kSub, kWidth * kSub, kHeight * kSub);
            const std::optional<LayerSurface> hit = ball(camera_.position, direction);
            known = hit && -glm::dot(hit->normalWS, direction) > 0.1;
            if (!known)
                break;
            const glm::dvec3 wall = ball.wallBehind(camera_.position, direction, *hit);
            const glm::dvec2 px = camera_.project(wall, kWidth, kHeight);
            known = px.x > 2 && px.y > 2 && px.x < kWidth - 2 && px.y < kHeight - 2 && camera_.viewZ(wall) > 0.1;
            mean += stripes(wall) / (kSub * kSub);
            if (s == kSub * kSub / 2)
                middle = stripes(wall);
        }
        if (!known)
            continue;
        ++pixels;
        filtered += std::pow(shown(picture, i).x - mean, 2);
        pointwise += std::pow(middle - mean, 2);
    }
    ASSERT_GT(pixels, 1000u);
    std::printf("%zu pixels: error %.3f, of one point %.3f\n", pixels, std::sqrt(filtered / double(pixels)),
                std::sqrt(pointwise / double(pixels)));
    EXPECT_LT(filtered, pointwise / 2); // the averaged frame itself has one point a pixel
}

TEST_F(RefractionTest, DispersionBendsEveryColourByItsOwnIndex) {
    // KHR_materials_dispersion: green has the index itself, red and blue differ by half of (n - 1) / 20 * dispersion.
    const double half = 0.5 * 0.025 * 8;
    std::vector<std::vector<float>> colors;
    for (const double ior : {1.5 - half, 1.5, 1.5 + half})
        colors.push_back(over({GlassBall{.ior = ior}}, settings()));
    const std::vector<float> dispersed = over({GlassBall{.dispersion = 8}}, settings());
    Settings asked = settings();
    asked.refraction.dispersion = 8;
    const std::vector<float> set = over({GlassBall{}}, asked);
    asked.refraction.dispersion = 0;
    EXPECT_EQ(over({GlassBall{.dispersion = 8}}, asked), colors[1]);
    float worst = 0;
    float change = 0;
    for (size_t i = 0; i < dispersed.size(); ++i) {
        worst = std::max(worst, i % 4 < 3 ? std::abs(dispersed[i] - colors[i % 4][i]) : 0);
        change = std::max(change, std::abs(dispersed[i] - colors[1][i]));
    }
    EXPECT_LT(worst, 0.12f); // a pixel: roundings of the index may sample the next one
    EXPECT_GT(change, 0.5f);
    EXPECT_EQ(set, dispersed);
}

TEST_F(RefractionTest, APlateShiftsWhatIsBehindItAndTurnsNothing) {
    LayerSurface surface;
    surface.shape = BodyShape::Plane;
    surface.thickness = 1.2f;
    const std::vector<float> picture = over({pane(-1, surface)}, settings());
    double worst = 0;
    for (uint32_t y = 30; y < kHeight - 30; ++y)
        for (uint32_t x = 30; x < kWidth - 30; ++x) {
            const glm::dvec3 d = camera_.rayThrough(x, y, kWidth, kHeight);
            const glm::dvec3 entry = camera_.position + d * ((-1 - camera_.position.z) / d.z);
            const glm::dvec2 inside = glm::dvec2(d) / 1.5;
            const double depth = std::sqrt(1 - glm::dot(inside, inside));
            const glm::dvec3 exit = entry + glm::dvec3(inside / depth, -1) * 1.2;
            worst = std::max(worst, glm::distance(shown(picture, y * kWidth + x) - kShown, wallPoint(exit, d)));
        }
    EXPECT_LT(worst, 0.12); // a pixel
}

TEST_F(RefractionTest, LightIsAbsorbedByDistance) {
    const std::vector<float> plain = without(settings());
    const size_t middle = (kHeight / 2) * kWidth + kWidth / 2; // nearly head-on
    for (const float thickness : {0.0f, 0.5f, 1.0f, 2.0f}) {
        LayerSurface surface;
        surface.shape = BodyShape::Plane;
        surface.ior = 1;
        surface.thickness = thickness;
        surface.absorption = {0.5f, 0.25f, 1, 1};
        const glm::dvec3 d = camera_.rayThrough(kWidth / 2, kHeight / 2, kWidth, kHeight);
        const double path = thickness / -d.z;
        const glm::dvec3 expected = shown(plain, middle) * glm::dvec3(std::pow(0.5, path), std::pow(0.25, path), 1);
        const glm::dvec3 got = shown(over({pane(-0.5, surface)}, settings()), middle);
        EXPECT_LT(glm::distance(got, expected), 0.004 * glm::length(expected)) << thickness;
        // The user's distance instead of the host's, and none at all.
        Settings other = settings();
        other.refraction.absorptionDistance = 2;
        const glm::dvec3 half = shown(plain, middle) * glm::dvec3(std::pow(0.5, path / 2), std::pow(0.25, path / 2), 1);
        EXPECT_LT(glm::distance(shown(over({pane(-0.5, surface)}, other), middle), half), 0.004 * glm::length(half));
        other.refraction.absorptionDistance = 0;
        EXPECT_LT(glm::distance(shown(over({pane(-0.5, surface)}, other), middle), shown(plain, middle)), 0.01);
    }
}

TEST_F(RefractionTest, TotalReflectionShowsTheMirrorImage) {
    LayerSurface surface;
    surface.shape = BodyShape::Plane;
    surface.thickness = 0.1f;
    surface.ior = 0.01f; // from half a degree on
    surface.normalWS = glm::normalize(glm::dvec3(0.9, 0, 0.44));
    const std::vector<float> picture = over({pane(-1.5, surface)}, settings());
    size_t looked = 0;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 d = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        if (-glm::dot(d, surface.normalWS) < 0.05) // such a surface would not be visible
            continue;
        const glm::dvec3 at = camera_.position + d * ((-1.5 - camera_.position.z) / d.z);
        const glm::dvec3 wall = wallPoint(at, glm::reflect(d, surface.normalWS));
        const glm::dvec2 px = camera_.project(wall, kWidth, kHeight);
        if (camera_.viewZ(wall) < 0.5 || px.x < 3 || px.y < 3 || px.x > kWidth - 3 || px.y > kHeight - 3)
            continue;
        const glm::dvec3 seen = shown(picture, i) - kShown;
        EXPECT_LT(glm::distance(seen, wall), 0.25) << i;
        ++looked;
    }
    EXPECT_GT(looked, 200u);
}

TEST_F(RefractionTest, WhatStandsInFrontOfALayerHidesIt) {
    LayerSurface surface;
    surface.transmittance = glm::vec4(0);
    surface.radiance = {9, 9, 9, 1};
    EXPECT_EQ(over({pane(-7.5, surface)}, settings()), without(settings())); // behind the wall
    const std::vector<float> picture = over({pane(-6.9, surface)}, settings());
    EXPECT_EQ(shown(picture, kHeight / 2 * kWidth + kWidth / 2), glm::dvec3(9));
}

TEST_F(RefractionTest, LayersLieOverEachOther) {
    LayerSurface dark; // transmittance of one half; a blended one covers half
    dark.transmittance = glm::vec4(0.5f);
    LayerSurface veil;
    veil.transmittance = glm::vec4(0, 0, 0, 1);
    veil.radiance = {1, 1, 1, 0.5f};
    const glm::dvec3 plain = shown(without(settings()), kHeight / 2 * kWidth + kWidth / 2);
    const auto middle = [&](const std::vector<LayerScene>& scenes) {
        return shown(over(scenes, settings()), kHeight / 2 * kWidth + kWidth / 2);
    };
    EXPECT_LT(glm::distance(middle({pane(-3, dark), pane(-1, veil)}), plain * 0.25 + 1.0), 0.02);
    EXPECT_LT(glm::distance(middle({pane(-3, veil), pane(-1, dark)}), (plain * 0.5 + 1.0) * 0.5), 0.02);
}

TEST_F(RefractionTest, ALayerBehindAnotherDoesNotGrow) {
    // Both cover all of their pixels, so no pixel blends in a layer that misses its centre.
    LayerSurface tinted;
    tinted.transmittance = glm::vec4(0.5f);
    const auto half = [&](bool right, double z) -> LayerScene {
        return [=, this](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<LayerSurface> s = pane(z, tinted)(origin, direction);
            if (s)
                s->missesCenter =
                    (camera_.project(origin + direction * s->distance, kWidth, kHeight).x > kWidth / 2) != right;
            return s;
        };
    };
    const std::vector<float> plain = without(settings());
    const std::vector<float> whole = over({pane(-2, tinted)}, settings());
    EXPECT_NE(whole, plain);
    EXPECT_EQ(over({half(true, -3), half(false, -2)}, settings()), whole);
}

TEST_F(RefractionTest, EdgesAreMixedByCoverage) {
    // A bright pane left of a slanted line. Of two adjacent pixels on the line, the pane covers one's centre and not
    // the other's.
    LayerSurface bright;
    bright.transmittance = glm::vec4(0);
    bright.radiance = {9, 5, 3, 1};
    const auto placed = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        std::optional<LayerSurface> s = pane(-2, bright)(origin, direction);
        const glm::dvec2 px = camera_.project(origin + direction * s.value_or(bright).distance, kWidth, kHeight);
        const double inside = kWidth / 2 + std::floor(px.y) - std::floor(px.x); // whole pixels left of the line
        if (!s || inside < -1)
            return std::optional<LayerSurface>();
        s->coverage = inside > 0 ? 1 : inside < 0 ? 0.25f : 0.5f;
        s->missesCenter = inside < 0;
        return s;
    };
    for (const bool encoded : {false, true}) {
        Settings wanted = settings();
        wanted.output.colorIsGamma = encoded;
        const std::vector<float> plain = without(settings());
        const std::vector<float> picture = over({placed}, wanted);
        const auto linear = [&](float stored) {
            return encoded ? glm::convertSRGBToLinear(glm::vec3(stored)).r : stored;
        };
        const int y = 20;
        for (int inside = -3; inside < 4; ++inside) {
            const size_t pixel = static_cast<size_t>(y * int(kWidth) + int(kWidth) / 2 + y - inside);
            const double part = inside > 0 ? 1 : inside == 0 ? 0.5 : inside == -1 ? 0.25 : 0;
            for (int c = 0; c < 3; ++c) {
                // Halves (2^-11), decoded (2.4 times that), and the neighbours' blend undone (twice).
                const double expected = glm::mix(double(plain[pixel * 4 + c]), double(bright.radiance[c]), part);
                EXPECT_NEAR(linear(picture[pixel * 4 + c]), expected, 0.003 * expected) << inside << " " << c;
            }
        }
    }
}

TEST_F(RefractionTest, EdgesBeforeAnotherLayerAreMixedToo) {
    // Left of a slanted line a bright pane stands in front of a dark one: where it is seen, it is the nearer layer, and
    // right of the line the dark pane is.
    LayerSurface bright;
    bright.transmittance = glm::vec4(0);
    bright.radiance = {9, 5, 3, 1};
    LayerSurface dark = bright;
    dark.radiance = {0.25f, 0.5f, 1, 1};
    // Whole pixels left of the line. One beside it is covered to a half, one right of it to a quarter.
    const auto leftOf = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        const std::optional<LayerSurface> s = pane(-2, bright)(origin, direction);
        const glm::dvec2 px = camera_.project(origin + direction * s->distance, kWidth, kHeight);
        return kWidth / 2 + std::floor(px.y) - std::floor(px.x);
    };
    const LayerScene nearer = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        const double inside = leftOf(origin, direction);
        std::optional<LayerSurface> s =
            inside < 0 ? pane(-3, dark)(origin, direction) : pane(-2, bright)(origin, direction);
        s->coverage = inside == 0 ? 0.5f : 1;
        s->inFront = inside == -1 ? 0.25f : 0;
        return s;
    };
    const LayerScene farther = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        return leftOf(origin, direction) < 0 ? std::nullopt : pane(-3, dark)(origin, direction);
    };
    const std::vector<float> picture = over({farther, nearer}, settings());
    const int y = 20;
    for (int inside = -3; inside < 4; ++inside) {
        const size_t pixel = static_cast<size_t>(y * int(kWidth) + int(kWidth) / 2 + y - inside);
        const double part = inside > 0 ? 1 : inside == 0 ? 0.5 : inside == -1 ? 0.25 : 0;
        for (int c = 0; c < 3; ++c) {
            const double expected = glm::mix(double(dark.radiance[c]), double(bright.radiance[c]), part);
            EXPECT_NEAR(picture[pixel * 4 + c], expected, 0.003 * expected) << inside << " " << c;
        }
    }
}

/// All visible radiance is 1, so transmission and reflection together are 1.
TEST_F(RefractionTest, AWhiteFurnaceStaysWhite) {
    g_ = SyntheticGBuffer::render(
        gpu(),
        [](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<SyntheticSurface> s = room(origin, direction);
            s->radiance = glm::vec3(1);
            return s;
        },
        camera_, kWidth, kHeight);
    const TestEnvironment white =
        TestEnvironment::make(gpu(), 16, 4, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    Settings settings;
    settings.screen.enabled = false;
    for (const int inner : {0, 1, 3})
        for (const BodyShape shape : {BodyShape::Straight, BodyShape::Sphere, BodyShape::Plane, BodyShape::Thin})
            for (const float roughness : {0.0f, 0.4f, 1.0f}) {
                settings.refraction.innerReflections = inner;
                LayerSurface surface;
                surface.shape = shape;
                surface.thickness = 0.5f;
                surface.roughness = roughness;
                surface.f0 = glm::vec3(0.04f);
                const std::vector<float> picture = over({pane(-1, surface)}, settings, white.map);
                for (size_t i = 0; i < picture.size(); i += 4) {
                    const std::string which = fmt::format("{} {} {} {}", inner, int(shape), roughness, i);
                    ASSERT_LE(picture[i], 1.002f) << which;
                    ASSERT_GE(picture[i], 0.995f) << which;
                }
            }
}

/// Where the bright wall behind the camera comes from: a plate sends back what its back side reflects, the more often
/// the light is followed inside. With a reflectance of `r` at each side, the sum of all that comes back inside is the
/// light that entered times `r`, of which the part `1 - r` leaves.
TEST_F(RefractionTest, APlateSendsBackWhatItsBackReflects) {
    const float r = 0.2f;
    LayerSurface surface;
    surface.shape = BodyShape::Plane;
    surface.thickness = 0.05f;
    surface.ior = 1.5f;
    surface.f0 = glm::vec3(r);
    // Behind the plate it is dark, before it the radiance is 1.
    g_ = SyntheticGBuffer::render(
        gpu(),
        [](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<SyntheticSurface> s = room(origin, direction);
            s->radiance = glm::vec3(0);
            return s;
        },
        camera_, kWidth, kHeight);
    const TestEnvironment front = TestEnvironment::make(
        gpu(), 16, 4, [](const glm::dvec3& d, uint32_t) { return glm::vec3(d.z > 0 ? 1.0f : 0.0f); });
    const size_t middle = (kHeight / 2) * kWidth + kWidth / 2; // nearly head-on
    const auto sentBack = [&](int inner) {
        Settings wanted = settings();
        wanted.sky.enabled = true;
        wanted.refraction.innerReflections = inner;
        return shown(over({pane(-1, surface)}, wanted, front.map), middle).x;
    };
    EXPECT_NEAR(sentBack(0), 0, 1e-4);
    EXPECT_NEAR(sentBack(1), (1 - r) * r, 0.01); // the last exit lets out all that is left
    EXPECT_NEAR(sentBack(2), (1 - r) * r * (1 - r), 0.01);
    EXPECT_NEAR(sentBack(3), (1 - r) * (r * (1 - r) + r * r * r), 0.01);
}

/// A glass ball shows the sky beside the camera by one reflection inside, where Snell says.
TEST_F(RefractionTest, ABallSendsBackWhatItsBackReflects) {
    const GlassBall ball;
    const TestEnvironment sky = TestEnvironment::make(
        gpu(), 64, 7, [](const glm::dvec3& d, uint32_t) { return glm::vec3(glm::normalize(d) + 1.0); });
    const auto reflecting = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        std::optional<LayerSurface> s = ball(origin, direction);
        if (s)
            s->f0 = glm::vec3(0.25f);
        return s;
    };
    Settings wanted = settings();
    wanted.sky.enabled = true;
    wanted.refraction.screen = false;
    const std::vector<float> none = over({reflecting}, wanted, sky.map);
    wanted.refraction.innerReflections = 1;
    const std::vector<float> one = over({reflecting}, wanted, sky.map);
    const auto shades = [](const glm::dvec3& direction) { return direction + 1.0; };
    size_t looked = 0;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 direction = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const std::optional<LayerSurface> hit = ball(camera_.position, direction);
        if (!hit || -glm::dot(hit->normalWS, direction) < 0.9) // Fresnel's reflectance is that of normal incidence
            continue;
        const glm::dvec3 entry = camera_.position + direction * hit->distance;
        glm::dvec3 inside = snell(direction, hit->normalWS, 1 / ball.ior);
        const glm::dvec3 back = entry - 2 * glm::dot(inside, entry - ball.center) * inside;
        const glm::dvec3 first = snell(inside, (ball.center - back) / ball.radius, ball.ior);
        inside = glm::reflect(inside, (ball.center - back) / ball.radius);
        const glm::dvec3 exit = back - 2 * glm::dot(inside, back - ball.center) * inside;
        const glm::dvec3 second = snell(inside, (ball.center - exit) / ball.radius, ball.ior);
        EXPECT_LT(glm::distance(shown(none, i), shades(first) * 0.75), 0.03) << i;
        EXPECT_LT(glm::distance(shown(one, i), (shades(first) * 0.75 + shades(second) * 0.25) * 0.75), 0.03) << i;
        ++looked;
    }
    EXPECT_GT(looked, 200u);
}

TEST_F(RefractionTest, WithIor1NothingIsReflectedInside) {
    LayerSurface surface;
    surface.shape = BodyShape::Sphere;
    surface.ior = 1;
    surface.thickness = 0.4f;
    Settings wanted = settings();
    wanted.refraction.innerReflections = 4;
    EXPECT_EQ(over({pane(-1, surface)}, wanted), over({pane(-1, surface)}, settings()));
}

TEST_F(RefractionTest, EverySettingActs) {
    LayerSurface surface;
    surface.shape = BodyShape::Sphere;
    surface.thickness = 0.5f;
    surface.f0 = glm::vec3(0.2f);
    surface.absorption = {0.5f, 0.7f, 0.9f, 1};
    surface.normalWS = glm::normalize(glm::dvec3(0.3, 0.2, 0.9));
    const TestEnvironment sky =
        TestEnvironment::make(gpu(), 16, 4, [](const glm::dvec3& d, uint32_t) { return glm::vec3(glm::abs(d)); });
    const Settings defaults;
    const std::vector<float> plain = over({pane(-2, surface)}, defaults, sky.map);
    for (const auto& [key, value] : std::vector<std::pair<const char*, const char*>>{{"enabled", "false"},
                                                                                     {"model", "plane"},
                                                                                     {"model", "none"},
                                                                                     {"model", "thin"},
                                                                                     {"projection", "proxy"},
                                                                                     {"screen", "false"},
                                                                                     {"reflections", "false"},
                                                                                     {"borderWidth", "0.4"},
                                                                                     {"hizMinLevel", "4"},
                                                                                     {"hizMaxIterations", "2"},
                                                                                     {"ior", "1.2"},
                                                                                     {"dispersion", "5"},
                                                                                     {"thickness", "0.1"},
                                                                                     {"thicknessMultiplier", "2"},
                                                                                     {"absorptionDistance", "0"}}) {
        Settings other;
        must(set(other, std::string("refraction.") + key, value));
        EXPECT_NE(over({pane(-2, surface)}, other, sky.map), plain) << key << " " << value;
    }
    Settings red;
    red.refraction.transmittanceRed = 1;
    red.refraction.transmittanceGreen = red.refraction.transmittanceBlue = 0.1f;
    EXPECT_NE(over({pane(-2, surface)}, red, sky.map), plain);
    Settings blue; // one channel alone: the others are the material's
    blue.refraction.transmittanceBlue = 0;
    const std::vector<float> withoutBlue = over({pane(-2, surface)}, blue, sky.map);
    for (size_t i = 0; i < plain.size(); i += 4) {
        EXPECT_EQ(withoutBlue[i], plain[i]);
        EXPECT_EQ(withoutBlue[i + 1], plain[i + 1]);
    }
    EXPECT_NE(withoutBlue, plain);
    Settings coarse; // faster, the same image
    coarse.refraction.hizMaxLevel = 0;
    coarse.refraction.hizMaxIterations = 1024;
    const std::vector<float> fine = over({pane(-2, surface)}, coarse, sky.map);
    size_t different = 0;
    for (size_t i = 0; i < plain.size(); i += 4)
        different += std::abs(fine[i] - plain[i]) > 0.1f;
    EXPECT_LT(different, plain.size() / 4 / 50);
}

/// A dark surface under a white sky shows its reflectance.
TEST_F(RefractionTest, SettingsOfReflectionActOnLayers) {
    const auto reflectance = [&](float strength, float exponent, bool fresnel) {
        Settings wanted;
        wanted.reflect.strength = strength;
        wanted.reflect.falloffExponent = exponent;
        wanted.reflect.fresnel = fresnel;
        return underWhiteSky(slanted(0), wanted);
    };
    const double full = reflectance(1, 1, true);
    EXPECT_GT(full, 0.22); // Schlick, at 63 degrees: 0.24
    EXPECT_NEAR(reflectance(1, 1, false), 0.2, 0.001);
    EXPECT_NEAR(reflectance(0.5f, 1, true), 0.5 * full, 0.001);
    EXPECT_NEAR(reflectance(1, 2, true), full * full, 0.001);
    EXPECT_NEAR(reflectance(2, 2, false), 0.16, 0.001);
}

/// Babylon.js' model: m = clamp((F * strength) ^ exponent), lit * (1 - m) + reflection * m.
TEST_F(RefractionTest, TheCompositeModelActsOnLayers) {
    const auto lerped = [&](float lit, float strength, float exponent, bool fresnel) {
        Settings wanted;
        wanted.composite.model = CompositeModel::Lerp;
        wanted.reflect.strength = strength;
        wanted.reflect.falloffExponent = exponent;
        wanted.reflect.fresnel = fresnel;
        return underWhiteSky(slanted(lit), wanted);
    };
    const glm::dvec3 eye = -camera_.rayThrough(kWidth / 2, kHeight / 2, kWidth, kHeight);
    const double schlick = 0.2 + 0.8 * std::pow(1 - glm::dot(slanted(0).normalWS, eye), 5);
    EXPECT_NEAR(lerped(0, 1, 1, true), schlick, 0.002);
    EXPECT_NEAR(lerped(0, 1, 1, false), 0.2 * schlick, 0.002) << "the colour takes the Fresnel term";
    EXPECT_NEAR(lerped(0, 2, 1, true), 2 * schlick, 0.002);
    EXPECT_NEAR(lerped(0, 1, 2, true), schlick * schlick, 0.002);
    EXPECT_NEAR(lerped(0, 10, 1, true), 1, 0.002) << "never more than the reflection";
    EXPECT_NEAR(lerped(1, 1, 1, true), 1, 0.002) << "white between white and white";
    EXPECT_NEAR(lerped(0.5f, 1, 1, true), 0.5 * (1 - schlick) + schlick, 0.002);
}

TEST_F(RefractionTest, WhatCannotBeIsSaid) {
    DrawnLayer drawn = DrawnLayer::draw(gpu(), pane(-1, {}), camera_, kWidth, kHeight);
    ReflectionsDesc desc = {kWidth, kHeight, settings()};
    Reflections without = must(Reflections::create(library(), desc));
    desc.transparentLayers = true;
    Reflections with = must(Reflections::create(library(), desc));
    run([&](VkCommandBuffer commands) {
        const auto said = [&](Reflections& reflections, const TransparentLayer& layer, const HostImage& picture) {
            const Result<HostImage> result = reflections.recordLayer(commands, layer, picture);
            return result ? std::string("nothing") : result.error().message;
        };
        EXPECT_THAT(said(without, drawn.layer, {}), testing::HasSubstr("set ReflectionsDesc::transparentLayers"));
        EXPECT_THAT(said(with, drawn.layer, {}), testing::HasSubstr("record a frame"));
        must(with.setInputs(g_.gbuffer, {}));
        const HostImage picture = with.record(commands, camera_.view(kWidth, kHeight));
        TransparentLayer broken = drawn.layer;
        broken.body = {};
        EXPECT_THAT(said(with, broken, picture), testing::HasSubstr("the layer's `body` is missing"));
        broken = drawn.layer;
        broken.normal.width = 7;
        EXPECT_THAT(said(with, broken, picture), testing::HasSubstr("`normal` is 7x120"));
        broken = drawn.layer;
        broken.radiance.layout = VK_IMAGE_LAYOUT_UNDEFINED;
        EXPECT_THAT(said(with, broken, picture), testing::HasSubstr("`radiance` is in no layout"));
        EXPECT_THAT(said(with, drawn.layer, g_.gbuffer.litRadiance), testing::HasSubstr("not the one"));
        EXPECT_TRUE(with.recordLayer(commands, drawn.layer, picture));
    });
}

TEST_F(RefractionTest, WithoutReflectionsTheSolidPictureIsTheHosts) {
    const TestEnvironment sky =
        TestEnvironment::make(gpu(), 16, 4, [](const glm::dvec3&, uint32_t) { return glm::vec3(3); });
    g_ = SyntheticGBuffer::render(
        gpu(),
        [](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<SyntheticSurface> s = room(origin, direction);
            s->f0 = glm::vec3(0.5f);
            s->radiance = glm::vec3(1, 2, 3); // a half stores it exactly
            return s;
        },
        camera_, kWidth, kHeight);
    Settings still;
    still.reflect.strength = 0;
    const auto nothing = [](const glm::dvec3&, const glm::dvec3&) { return std::optional<LayerSurface>(); };
    EXPECT_EQ(over({nothing}, still, sky.map), download(gpu(), g_.gbuffer.litRadiance));
}

TEST_F(RefractionTest, SwitchedOffItCostsNothing) {
    Settings off = settings();
    off.refraction.enabled = false;
    LayerSurface surface;
    surface.transmittance = glm::vec4(0.1f);
    EXPECT_EQ(over({pane(-1, surface)}, off), download(gpu(), g_.gbuffer.litRadiance)); // the host's own bits
}

} // namespace refraction_test
} // namespace glint::test
