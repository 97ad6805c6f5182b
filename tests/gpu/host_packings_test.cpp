// The scalars of a host's material, each in the image and channel where the host has it: every packing of one frame
// gives the picture of Glint's own packing.
#include "gpu/pass.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/samples.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <list>

namespace glint::test {
namespace host_packings_test {

using testing::AllOf;
using testing::HasSubstr;

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 36;
constexpr uint32_t kPixels = kWidth * kHeight;
constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;

/// Multiples of 1/17, which eight bits hold exactly: 255 = 15 * 17.
struct Texel {
    glm::vec3 baseColor;
    float metallic;
    float roughness;
    float specular;
    float occlusion;
    glm::vec3 f0() const { return glm::mix(glm::vec3(0.08f * specular), baseColor, metallic); }
};

/// Materials of all kinds, in squares.
Texel texelAt(uint32_t i) {
    const uint32_t square = i % kWidth / 8 + i / kWidth / 6 * 8;
    const auto part = [&](uint32_t prime, uint32_t most) { return float(square * prime % (most + 1)) / 17; };
    return {{part(3, 17), part(5, 17), part(7, 17)}, part(11, 17), part(13, 8), part(2, 17), part(7, 17)};
}

class HostPackingsTest : public LibraryTest {
protected:
    using Wide = std::function<glm::vec4(const Texel&)>;

    /// Images live as long as the test.
    HostImage wide(const Wide& texel) {
        std::vector<glm::vec4> texels;
        for (uint32_t i = 0; i < kPixels; ++i)
            texels.push_back(texel(texelAt(i)));
        return keep(uploadTestImage(gpu(), "test/wide", kWide, kWidth, kHeight, bytesOf(texels)));
    }
    /// Eight bits a channel.
    HostImage bytes(const Wide& texel) {
        std::vector<glm::u8vec4> texels;
        for (uint32_t i = 0; i < kPixels; ++i)
            texels.emplace_back(texel(texelAt(i)) * 255.0f + 0.5f);
        return keep(uploadTestImage(gpu(), "test/bytes", VK_FORMAT_R8G8B8A8_UNORM, kWidth, kHeight, bytesOf(texels)));
    }
    HostImage oneByte(const std::function<float(const Texel&)>& texel) {
        std::vector<uint8_t> texels;
        for (uint32_t i = 0; i < kPixels; ++i)
            texels.push_back(static_cast<uint8_t>(texel(texelAt(i)) * 255.0f + 0.5f));
        return keep(uploadTestImage(gpu(), "test/byte", VK_FORMAT_R8_UNORM, kWidth, kHeight, bytesOf(texels)));
    }
    HostImage keep(gpu::Image image) { return asHostImage(images_.emplace_back(std::move(image))); }

    /// The frame without a material.
    GBuffer bare() {
        GBuffer gbuffer = host().gbuffer;
        gbuffer.material = {};
        return gbuffer;
    }
    /// The same of a host with glTF's model: its base colour in 8 bits a channel, with something else in alpha.
    GBuffer metals() {
        GBuffer gbuffer = bare();
        gbuffer.conventions.material = MaterialKind::MetallicRoughness;
        gbuffer.baseColor = bytes([](const Texel& t) { return glm::vec4(t.baseColor, 0.3f); });
        return gbuffer;
    }
    const SyntheticGBuffer& host() {
        if (!host_)
            host_ = SyntheticGBuffer::render(gpu(), floorAndWall(), camera_, kWidth, kHeight);
        return *host_;
    }

    Picture show(const GBuffer& gbuffer, const Settings& settings = plainSettings(),
                 const EnvironmentMap& environment = {}) {
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(gbuffer, environment));
        return trace(made, camera_.view(kWidth, kHeight));
    }
    /// Glint's own packing: one image, F0 and roughness.
    Picture expected(float specular = -1) {
        GBuffer gbuffer = bare();
        gbuffer.material = wide([&](Texel t) {
            t.specular = specular >= 0 ? specular : t.specular;
            return glm::vec4(t.f0(), t.roughness);
        });
        return show(gbuffer);
    }

    /// Colours are halves, up to 16.
    static void expectSame(const Picture& a, const Picture& b, const char* what) {
        uint64_t hits = 0;
        for (uint32_t i = 0; i < kPixels; ++i) {
            ASSERT_EQ(a.outcome(i), b.outcome(i)) << what << ", pixel " << i;
            hits += a.hit(i);
            const glm::vec3 difference = glm::abs(a.color(i) - b.color(i));
            ASSERT_LE(std::max({difference.x, difference.y, difference.z}), 0x1p-6f) << what << ", pixel " << i;
        }
        ASSERT_GT(hits, 200u) << what;
    }
    static bool differs(const Picture& a, const Picture& b) {
        uint32_t different = 0;
        for (uint32_t i = 0; i < kPixels; ++i)
            different += glm::distance(a.color(i), b.color(i)) > 0.05f || a.outcome(i) != b.outcome(i);
        return different > kPixels / 20;
    }

    SyntheticCamera camera_;
    std::optional<SyntheticGBuffer> host_;
    std::list<gpu::Image> images_;
};

TEST_F(HostPackingsTest, RoughnessInAlbedoAndMetalnessInAnImageOfItsOwn) {
    const Picture wanted = expected(0.5f);
    GBuffer g = metals();
    g.baseColor = bytes([](const Texel& t) { return glm::vec4(t.baseColor, t.roughness); });
    g.roughness = {g.baseColor, 3};
    g.metallic = {oneByte([](const Texel& t) { return t.metallic; })};
    expectSame(show(g), wanted, "albedo.a and R8");
    g.roughness.channel = 2;
    EXPECT_TRUE(differs(show(g), wanted)) << "the statement is read";
}

TEST_F(HostPackingsTest, ScalarsBesideTheNormal) {
    const Picture wanted = expected(0.5f);
    std::vector<glm::vec4> normals;
    const auto surfaces = seen(floorAndWall(), camera_, kWidth, kHeight);
    for (uint32_t i = 0; i < kPixels; ++i) {
        const glm::vec2 n = encodeOctahedral(surfaces[i] ? surfaces[i]->normalWS : glm::dvec3(0, 1, 0));
        normals.emplace_back(n, texelAt(i).metallic, texelAt(i).roughness);
    }
    GBuffer g = metals();
    g.normal = keep(uploadTestImage(gpu(), "test/normal", kWide, kWidth, kHeight, bytesOf(normals)));
    g.roughness = {g.normal, 3};
    g.metallic = {g.normal, 2};
    expectSame(show(g), wanted, "normal.a and normal.b");
}

TEST_F(HostPackingsTest, TheSameImageInAnyLayoutIsReturnedInIt) {
    // Roughness and metalness share an image that is none of the others; it comes and goes in GENERAL.
    const Picture wanted = expected(0.5f);
    GBuffer g = metals();
    HostImage packed = bytes([](const Texel& t) { return glm::vec4(t.occlusion, t.roughness, t.metallic, 0); });
    run([&](VkCommandBuffer commands) {
        gpu::Frame frame(gpu(), commands);
        frame.hand(images_.back(),
                   {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, VK_IMAGE_LAYOUT_GENERAL});
    });
    packed.layout = VK_IMAGE_LAYOUT_GENERAL;
    g.roughness = {packed, 1};
    g.metallic = {packed, 2};
    Reflections made = reflections(kWidth, kHeight);
    must(made.setInputs(g));
    for (int frame = 0; frame < 2; ++frame) // the second finds the image as the first left it
        expectSame(trace(made, camera_.view(kWidth, kHeight)), wanted, "occlusion, roughness, metallic");
}

TEST_F(HostPackingsTest, EveryMeaningOfRoughness) {
    const Picture wanted = expected(0.5f);
    const auto with = [&](RoughnessKind kind, float scale, float bias, const std::function<float(float)>& store) {
        GBuffer g = metals();
        g.conventions.roughness = kind;
        g.material = wide([&](const Texel& t) { return glm::vec4(9, store(t.roughness), t.metallic, 9); });
        g.roughness = {.channel = 1, .scale = scale, .bias = bias};
        return show(g);
    };
    expectSame(with(RoughnessKind::Alpha, 1, 0, [](float r) { return r * r; }), wanted, "alpha");
    expectSame(with(RoughnessKind::Smoothness, 1, 0, [](float r) { return 1 - r; }), wanted, "smoothness");
    expectSame(with(RoughnessKind::Perceptual, 0.01f, -0.5f, [](float r) { return 100 * r + 50; }), wanted, "percent");
    expectSame(with(RoughnessKind::Perceptual, -1, 1, [](float r) { return 1 - r; }), wanted, "smoothness by scale");
    EXPECT_TRUE(differs(with(RoughnessKind::Perceptual, 1, 0, [](float r) { return r * r; }), wanted));
}

TEST_F(HostPackingsTest, SpecularSetsTheDielectrics) {
    const Picture wanted = expected();
    GBuffer g = metals();
    g.material = bytes([](const Texel& t) { return glm::vec4(t.specular, t.roughness, t.metallic, 0); });
    g.roughness.channel = 1;
    EXPECT_TRUE(differs(show(g), wanted)) << "without it, every dielectric reflects 4 %";
    g.specular = {.channel = 0};
    expectSame(show(g), wanted, "0.08 * specular");
    g.specular = {.image = wide([](const Texel& t) { return glm::vec4(0, 0.08f * t.specular, 0, 0); }),
                  .channel = 1,
                  .scale = 12.5f};
    expectSame(show(g), wanted, "F0 itself");
}

TEST_F(HostPackingsTest, ConstantsNeedNoImage) {
    GBuffer one = bare();
    one.material =
        wide([](const Texel& t) { return glm::vec4(glm::mix(glm::vec3(0.04f), t.baseColor, 0.75f), 0.25f); });
    GBuffer g = metals();
    g.roughness = {.scale = 0, .bias = 0.25f};
    g.metallic = {.scale = 0, .bias = 0.75f};
    expectSame(show(g), show(one), "constants");
}

TEST_F(HostPackingsTest, SeveralSamplesAPixel) {
    // All samples of a pixel show one surface, so the picture is that of one sample.
    const auto surfaces = seen(floorAndWall(), camera_, kWidth, kHeight);
    const auto of = [&](uint32_t x, uint32_t y) { return surfaces[y * kWidth + x].value_or(SyntheticSurface{}); };
    const auto samples = [&](const char* name, VkFormat format, const auto& texel) {
        return keep(makeSamples(gpu(), name, format, kWidth, kHeight,
                                [&](uint32_t x, uint32_t y, uint32_t) { return texel(x, y); }));
    };
    const glm::dmat3 worldToView(camera_.worldToView());
    GBuffer g = metals();
    g.depth = samples("test/depth", VK_FORMAT_R32_SFLOAT, [&](uint32_t x, uint32_t y) {
        const double viewZ = -(worldToView * camera_.rayThrough(x, y, kWidth, kHeight)).z * of(x, y).distance;
        return glm::vec4(of(x, y).distance > 0 ? float(camera_.deviceDepth(viewZ)) : 0);
    });
    g.normal = samples("test/normal", kWide, [&](uint32_t x, uint32_t y) {
        return glm::vec4(encodeOctahedral(of(x, y).normalWS), 0, texelAt(y * kWidth + x).metallic);
    });
    g.baseColor = samples("test/albedo", VK_FORMAT_R8G8B8A8_UNORM, [&](uint32_t x, uint32_t y) {
        return glm::vec4(texelAt(y * kWidth + x).baseColor, texelAt(y * kWidth + x).roughness);
    });
    g.roughness = {g.baseColor, 3};
    g.metallic = {g.normal, 3};
    expectSame(show(g), expected(0.5f), "samples");
}

TEST_F(HostPackingsTest, OcclusionDarkensWhatNoRayHasTested) {
    const TestEnvironment sky =
        TestEnvironment::make(gpu(), 8, 1, [](const auto&, uint32_t) { return glm::vec3(0.5f); });
    GBuffer open = bare();
    open.material = wide([](const Texel& t) { return glm::vec4(1, 1, 1, t.roughness); });
    GBuffer occluded = open;
    occluded.occlusion = {oneByte([](const Texel& t) { return t.occlusion; })};
    Settings skyAlone = plainSettings();
    skyAlone.screen.enabled = false;
    const Picture without = show(open, skyAlone, sky.map);
    const Picture with = show(occluded, skyAlone, sky.map);
    const auto surfaces = seen(floorAndWall(), camera_, kWidth, kHeight);
    double darkest = 1;
    for (uint32_t i = 0; i < kPixels; ++i) {
        ASSERT_EQ(with.weight[i * 4], without.weight[i * 4]) << "the sky still answers: nothing leaks in its place";
        if (!surfaces[i])
            continue;
        // Lagarde, de Rousiers 2014, listing 26.
        const glm::dvec3 ray = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const double NoV = std::max(glm::dot(-ray, surfaces[i]->normalWS), 0.0);
        const double ao = texelAt(i).occlusion;
        const double alpha = std::pow(texelAt(i).roughness, 2);
        const double factor = std::clamp(std::pow(NoV + ao, std::exp2(-16 * alpha - 1)) - 1 + ao, 0.0, 1.0);
        darkest = std::min(darkest, factor);
        ASSERT_NEAR(with.reflection[i * 4], without.reflection[i * 4] * factor, 0.002) << i;
    }
    EXPECT_LT(darkest, 0.05);

    // Hits of rays keep their bits, and so does everything at occlusion 1.
    const Picture hits = show(open);
    const Picture hitsOccluded = show(occluded);
    EXPECT_EQ(hits.composite, hitsOccluded.composite);
    occluded.occlusion = {oneByte([](const Texel&) { return 1.0f; })};
    EXPECT_EQ(show(occluded, skyAlone, sky.map).composite, without.composite);
}

// ---------------------------------------------------------------- mistakes

TEST_F(HostPackingsTest, UndefinedStatementsAreOneErrorEach) {
    Reflections made = reflections(kWidth, kHeight);
    const auto refuses = [&](auto matcher, auto change) {
        GBuffer g = metals();
        g.material = bytes([](const Texel&) { return glm::vec4(0.5f); });
        must(made.setInputs(g));
        change(g);
        const Result<void> result = made.setInputs(g);
        ASSERT_FALSE(result);
        EXPECT_THAT(result.error().message, matcher);
        EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
    };
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    refuses(AllOf(HasSubstr("`roughness`"), HasSubstr("channel 4")), [](GBuffer& g) { g.roughness.channel = 4; });
    refuses(AllOf(HasSubstr("`metallic`"), HasSubstr("channel 1"), HasSubstr("1 channels")), [&](GBuffer& g) {
        g.metallic = {oneByte([](const Texel&) { return 1.0f; }), 1};
    });
    refuses(AllOf(HasSubstr("`specular`"), HasSubstr("scale nan")), [&](GBuffer& g) { g.specular.scale = kNan; });
    refuses(AllOf(HasSubstr("`occlusion`"), HasSubstr("bias inf")),
            [](GBuffer& g) { g.occlusion.bias = std::numeric_limits<float>::infinity(); });
    refuses(AllOf(HasSubstr("`roughness`"), HasSubstr("missing"), HasSubstr("scale 0")),
            [](GBuffer& g) { g.material = {}; });
    refuses(AllOf(HasSubstr("`metallic`"), HasSubstr("missing")), [](GBuffer& g) {
        g.metallic.image = g.material;
        g.metallic.image.view = VK_NULL_HANDLE;
    });
    refuses(AllOf(HasSubstr("`metallic`"), HasSubstr("63x36"), HasSubstr("64x36")), [](GBuffer& g) {
        g.metallic.image = g.baseColor;
        g.metallic.image.width = 63;
    });
    refuses(AllOf(HasSubstr("`roughness`"), HasSubstr("`baseColor`"), HasSubstr("layout")), [](GBuffer& g) {
        g.roughness.image = g.baseColor;
        g.roughness.image.layout = VK_IMAGE_LAYOUT_GENERAL;
    });
    refuses(AllOf(HasSubstr("`roughness`"), HasSubstr("integer")), [](GBuffer& g) {
        g.roughness.image = g.baseColor;
        g.roughness.image.format = VK_FORMAT_R8G8B8A8_UINT;
    });
    refuses(AllOf(HasSubstr("`metallic`"), HasSubstr("material kind")), [](GBuffer& g) {
        g.conventions.material = MaterialKind::F0Roughness;
        g.metallic.image = g.baseColor;
    });
    refuses(HasSubstr("RoughnessKind::Alpha"), [](GBuffer& g) {
        g.conventions.material = MaterialKind::SpecularGlossiness;
        g.conventions.roughness = RoughnessKind::Alpha;
    });
    refuses(HasSubstr("linearDepthScale is 0"), [](GBuffer& g) {
        g.conventions.depth = DepthKind::LinearViewZ;
        g.conventions.linearDepthScale = 0;
    });
    refuses(HasSubstr("linearDepthScale is nan"), [&](GBuffer& g) { g.conventions.linearDepthScale = kNan; });
    refuses(AllOf(HasSubstr("linearDepthScale is -1"), HasSubstr("LinearViewZ")),
            [](GBuffer& g) { g.conventions.linearDepthScale = -1; });
}

} // namespace host_packings_test
} // namespace glint::test
