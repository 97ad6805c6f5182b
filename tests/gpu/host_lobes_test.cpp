// What a host's surfaces reflect besides F0 and roughness: F90, and clear coats, whose lobe has answers of its own.
#include "gpu/support/library_test.hpp"
#include "gpu/support/samples.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <list>

namespace glint::test {
namespace host_lobes_test {

using testing::HasSubstr;

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 36;
constexpr uint32_t kPixels = kWidth * kHeight;
constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;

/// Materials in squares, so that every pair of values occurs.
struct Texel {
    float f0, f90, roughness, coat, coatRoughness, metallic;
};

Texel texelAt(uint32_t i) {
    const uint32_t square = i % kWidth / 8 + i / kWidth / 6 * 8;
    const auto part = [&](uint32_t prime, uint32_t most) { return float(square * prime % (most + 1)) / float(most); };
    return {0.0625f + 0.875f * part(3, 16), part(5, 8), part(7, 8), part(11, 4), 0.6f * part(13, 6), part(2, 4)};
}

double schlick(double f0, double f90, double cosine) {
    return f0 + (f90 - f0) * std::pow(1 - cosine, 5);
}

class HostLobesTest : public LibraryTest {
protected:
    using Wide = std::function<glm::vec4(const Texel&)>;

    /// Images live as long as the test.
    HostImage wide(const Wide& texel) {
        std::vector<glm::vec4> texels;
        for (uint32_t i = 0; i < kPixels; ++i)
            texels.push_back(texel(texelAt(i)));
        return keep(uploadTestImage(gpu(), "test/wide", kWide, kWidth, kHeight, bytesOf(texels)));
    }
    HostImage keep(gpu::Image image) { return asHostImage(images_.emplace_back(std::move(image))); }

    /// A floor before a wall, all of it with this material.
    GBuffer with(const Wide& material) {
        GBuffer gbuffer = host().gbuffer;
        gbuffer.material = wide(material);
        return gbuffer;
    }
    const SyntheticGBuffer& host() {
        if (!host_)
            host_ = SyntheticGBuffer::render(gpu(), litBy(floorAndWall(), glm::vec3(0)), camera_, kWidth, kHeight);
        return *host_;
    }
    /// The sky alone, which is all that is lit: radiance 1 from everywhere, so that a pixel shows its response.
    std::vector<float> responses(const GBuffer& gbuffer, Settings settings = skyAlone()) {
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(gbuffer, even().map));
        return trace(made, camera_.view(kWidth, kHeight)).composite;
    }
    static Settings skyAlone() {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        return settings;
    }
    const TestEnvironment& even() {
        if (!even_)
            even_ = TestEnvironment::make(gpu(), 8, 1, [](const auto&, uint32_t) { return glm::vec3(1); });
        return *even_;
    }
    /// Cosine between the normal and the line of sight; negative: no surface.
    double cosineAt(uint32_t i) {
        if (surfaces_.empty())
            surfaces_ = seen(floorAndWall(), camera_, kWidth, kHeight);
        const glm::dvec3 ray = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        return surfaces_[i] ? std::clamp(glm::dot(-ray, surfaces_[i]->normalWS), 0.0, 1.0) : -1;
    }

    SyntheticCamera camera_;
    std::optional<SyntheticGBuffer> host_;
    std::optional<TestEnvironment> even_;
    std::vector<std::optional<SyntheticSurface>> surfaces_;
    std::list<gpu::Image> images_;
};

TEST_F(HostLobesTest, ResponsesAreLinearInF90) {
    const auto f0AndRoughness = [](const Texel& t) { return glm::vec4(glm::vec3(t.f0), t.roughness); };
    GBuffer gbuffer = with(f0AndRoughness);
    const std::vector<float> all = responses(gbuffer);
    gbuffer.f90 = {.scale = 0, .bias = 0};
    const std::vector<float> none = responses(gbuffer);
    gbuffer.f90 = {wide([](const Texel& t) { return glm::vec4(0, t.f90, 0, 0); }), 1};
    const std::vector<float> some = responses(gbuffer);
    double lowest = 1;
    for (uint32_t i = 0; i < kPixels; ++i) {
        if (cosineAt(i) < 0)
            continue;
        const Texel texel = texelAt(i);
        ASSERT_NEAR(some[4 * i], none[4 * i] + texel.f90 * (all[4 * i] - none[4 * i]), 0.002) << i;
        if (texel.roughness == 0) {
            ASSERT_NEAR(none[4 * i], schlick(texel.f0, 0, cosineAt(i)), 0.01) << i;
            lowest = std::min(lowest, double(none[4 * i]) / texel.f0);
        }
    }
    EXPECT_LT(lowest, 0.8) << "some pixels are seen at grazing angles";
}

TEST_F(HostLobesTest, F90OfEveryMaterialKind) {
    GBuffer gbuffer = with([](const Texel& t) { return glm::vec4(glm::vec3(t.f0), t.roughness); });
    const HostImage f90 = wide([](const Texel& t) { return glm::vec4(t.f90, 0, 0, 0); });
    gbuffer.f90 = {f90, 0};
    const std::vector<float> wanted = responses(gbuffer);
    GBuffer glossy = with([](const Texel& t) { return glm::vec4(glm::vec3(t.f0), 1 - t.roughness); });
    glossy.conventions.material = MaterialKind::SpecularGlossiness;
    glossy.f90 = {f90, 0};
    EXPECT_THAT(responses(glossy), testing::Pointwise(testing::FloatNear(0.002f), wanted));

    // Metals have F90 1, whatever the dielectric part has.
    const auto mixed = [](const Texel& t) { return 0.04f + t.metallic * (t.f0 - 0.04f); };
    GBuffer metals = with([](const Texel& t) { return glm::vec4(0, 0, t.metallic, t.roughness); });
    metals.conventions.material = MaterialKind::MetallicRoughness;
    metals.baseColor = wide([](const Texel& t) { return glm::vec4(glm::vec3(t.f0), 0); });
    metals.f90 = {f90, 0};
    GBuffer same = with([&](const Texel& t) { return glm::vec4(glm::vec3(mixed(t)), t.roughness); });
    same.f90 = {wide([](const Texel& t) { return glm::vec4(t.f90 + t.metallic * (1 - t.f90), 0, 0, 0); }), 0};
    EXPECT_THAT(responses(metals), testing::Pointwise(testing::FloatNear(0.002f), responses(same)));
}

TEST_F(HostLobesTest, F90OneKeepsEveryBit) {
    GBuffer gbuffer = with([](const Texel& t) { return glm::vec4(glm::vec3(t.f0), t.roughness); });
    const std::vector<float> wanted = responses(gbuffer);
    gbuffer.f90 = {wide([](const Texel&) { return glm::vec4(1); }), 0};
    EXPECT_EQ(responses(gbuffer), wanted) << "prepare stores F0 as the same halves";
}

/// The base loses what the coat reflects: whatever both are, an even light comes back as it was from white metal.
TEST_F(HostLobesTest, CoatsOverWhiteMetalAreAFurnace) {
    GBuffer gbuffer = with([](const Texel& t) { return glm::vec4(1, 1, 1, t.roughness); });
    const HostImage coat = wide([](const Texel& t) { return glm::vec4(t.coat, t.coatRoughness, 0, 0); });
    gbuffer.coat = {coat, 0};
    gbuffer.coatRoughness = {coat, 1};
    const std::vector<float> white = responses(gbuffer);
    gbuffer.material = wide([](const Texel& t) { return glm::vec4(0, 0, 0, t.roughness); });
    const std::vector<float> alone = responses(gbuffer);
    for (uint32_t i = 0; i < kPixels; ++i) {
        if (cosineAt(i) < 0)
            continue;
        ASSERT_NEAR(white[4 * i], 1, 0.005) << i;
        ASSERT_NEAR(alone[4 * i], texelAt(i).coat * schlick(0.04, 1, std::max(cosineAt(i), 1e-3)), 0.002) << i;
    }
}

/// The coat's ray starts along the coat's normal, and meets what the scene shows.
TEST_F(HostLobesTest, ACoatMirrorsTheScreenWithItsOwnNormal) {
    const auto stage = [&](float floorF0) {
        Stage scene = floorAndWall();
        scene.floorF0 = floorF0;
        return SyntheticGBuffer::render(gpu(), scene, camera_, kWidth, kHeight);
    };
    const SyntheticGBuffer mirror = stage(1);
    Reflections made = reflections(kWidth, kHeight);
    must(made.setInputs(mirror.gbuffer));
    const Picture wanted = trace(made, camera_.view(kWidth, kHeight));

    const SyntheticGBuffer black = stage(0);
    std::vector<glm::vec4> bumpy; // the floor below the coat faces anywhere
    std::vector<glm::vec4> film;
    for (uint32_t i = 0; i < kPixels; ++i) {
        const bool isFloor = cosineAt(i) >= 0 && surfaces_[i]->f0.x > 0;
        const glm::dvec3 normal =
            isFloor ? glm::normalize(glm::dvec3(0.5 * std::sin(double(i)), 1, 0)) : glm::dvec3(0, 0, 1);
        bumpy.emplace_back(encodeOctahedral(normal), 0, 0);
        film.emplace_back(isFloor ? 1 : 0, 0, 0, 0);
    }
    GBuffer gbuffer = black.gbuffer;
    gbuffer.coatNormal = gbuffer.normal;
    gbuffer.normal = keep(uploadTestImage(gpu(), "test/bumpy", kWide, kWidth, kHeight, bytesOf(bumpy)));
    gbuffer.coat = {keep(uploadTestImage(gpu(), "test/film", kWide, kWidth, kHeight, bytesOf(film))), 0};
    must(made.setInputs(gbuffer));
    const Picture shown = trace(made, camera_.view(kWidth, kHeight));
    uint32_t compared = 0, others = 0;
    for (uint32_t i = 0; i < kPixels; ++i) {
        if (film[i].x == 0 || !wanted.hit(i))
            continue;
        const double reflectance = schlick(0.04, 1, cosineAt(i));
        bool same = true;
        for (int c = 0; c < 3; ++c) // halves up to 16
            same &= std::abs(shown.composite[4 * i + c] - reflectance * wanted.reflection[4 * i + c]) < 0.01;
        compared += same;
        others += !same;
    }
    EXPECT_GT(compared, 300u);
    EXPECT_EQ(others, 0u);

    // Without the coat, in the same Reflections, the floor is black again.
    gbuffer.coat = {.scale = 0, .bias = 0};
    must(made.setInputs(gbuffer));
    const Picture without = trace(made, camera_.view(kWidth, kHeight));
    for (uint32_t i = 0; i < kPixels; ++i)
        if (film[i].x > 0) {
            ASSERT_EQ(without.composite[4 * i], 0) << i;
        }
}

TEST_F(HostLobesTest, SeveralSamplesAPixel) {
    // All samples of a pixel show one surface, so the picture is that of one sample; F90 has 127 steps.
    const auto of = [&](uint32_t x, uint32_t y) { return surfaces_[y * kWidth + x].value_or(SyntheticSurface{}); };
    cosineAt(0);
    const auto samples = [&](const char* name, VkFormat format, const auto& texel) {
        return keep(makeSamples(gpu(), name, format, kWidth, kHeight,
                                [&](uint32_t x, uint32_t y, uint32_t) { return texel(x, y); }));
    };
    const glm::dmat3 worldToView(camera_.worldToView());
    const auto both = [&](const Wide& texel) {
        return std::pair(wide(texel), samples("test/samples", kWide,
                                              [&](uint32_t x, uint32_t y) { return texel(texelAt(y * kWidth + x)); }));
    };
    const auto material = both([](const Texel& t) { return glm::vec4(glm::vec3(t.f0), t.roughness); });
    const auto lobes = both([](const Texel& t) { return glm::vec4(t.f90, t.coat, t.coatRoughness, 0); });
    const auto state = [](GBuffer& g, const HostImage& image) {
        g.f90 = {image, 0};
        g.coat = {image, 1};
        g.coatRoughness = {image, 2};
    };
    GBuffer one = host().gbuffer;
    one.material = material.first;
    state(one, lobes.first);
    GBuffer many = one;
    many.depth = samples("test/depth", VK_FORMAT_R32_SFLOAT, [&](uint32_t x, uint32_t y) {
        const double viewZ = -(worldToView * camera_.rayThrough(x, y, kWidth, kHeight)).z * of(x, y).distance;
        return glm::vec4(of(x, y).distance > 0 ? float(camera_.deviceDepth(viewZ)) : 0);
    });
    many.normal = samples("test/normal", kWide,
                          [&](uint32_t x, uint32_t y) { return glm::vec4(encodeOctahedral(of(x, y).normalWS), 0, 0); });
    many.material = material.second;
    state(many, lobes.second);
    EXPECT_THAT(responses(many), testing::Pointwise(testing::FloatNear(0.006f), responses(one)));
}

TEST_F(HostLobesTest, MistakesAreOneErrorEach) {
    Reflections made = reflections(kWidth, kHeight);
    GBuffer gbuffer = with([](const Texel& t) { return glm::vec4(glm::vec3(t.f0), t.roughness); });
    const auto message = [&](auto change) {
        GBuffer changed = gbuffer;
        change(changed);
        const Result<void> result = made.setInputs(changed);
        return result ? std::string("accepted") : result.error().message;
    };
    EXPECT_THAT(message([](GBuffer& g) { g.coat = {.channel = 5, .scale = 1}; }), HasSubstr("`coat`"));
    EXPECT_THAT(message([](GBuffer& g) { g.coatNormal = g.normal, g.coatNormal.width = 3; }),
                HasSubstr("`coatNormal`"));
    EXPECT_THAT(message([](GBuffer& g) {
                    g.conventions.material = MaterialKind::Standard;
                    g.f90.image = g.normal;
                }),
                HasSubstr("`f90`"));
}

} // namespace host_lobes_test
} // namespace glint::test
