// One material in the conventions of every kind of host must produce the same image. Also tests the other inputs that a
// host may provide in its own way.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>

namespace glint::test {
namespace host_materials_test {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 36;
constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;

class HostMaterialsTest : public LibraryTest {
protected:
    struct Texel {
        glm::vec3 baseColor;
        float metallic;
        float roughness;
        glm::vec3 f0() const { return glm::mix(glm::vec3(0.04f), baseColor, metallic); } // glTF 2.0, B.2
    };
    /// Materials of all kinds, in squares.
    static Texel texel(uint32_t i) {
        const uint32_t square = i % kWidth / 8 + i / kWidth / 6 * 8;
        const auto part = [&](uint32_t prime) { return float(square * prime % 17) / 16; };
        return {{part(3), part(5), part(7)}, part(11), part(13) * 0.5f};
    }

    struct Images {
        gpu::Image material;
        gpu::Image baseColor;
    };
    /// The image of the floor with these materials on every surface.
    static Picture show(const std::function<glm::vec4(const Texel&)>& material,
                        const std::function<void(GBuffer&)>& state, bool withMaterial = true) {
        const SyntheticCamera camera;
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
        std::vector<glm::vec4> materials;
        std::vector<glm::vec4> baseColors;
        for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
            materials.push_back(material(texel(i)));
            baseColors.emplace_back(texel(i).baseColor, 0.3f);
        }
        const gpu::Image materialImage =
            uploadTestImage(gpu(), "test/material", kWide, kWidth, kHeight, bytesOf(materials));
        const gpu::Image baseColor =
            uploadTestImage(gpu(), "test/baseColor", kWide, kWidth, kHeight, bytesOf(baseColors));
        GBuffer gbuffer = host.gbuffer;
        gbuffer.material = withMaterial ? asHostImage(materialImage) : HostImage{};
        gbuffer.baseColor = asHostImage(baseColor);
        state(gbuffer);
        if (gbuffer.conventions.material != MaterialKind::MetallicRoughness)
            gbuffer.baseColor = {};
        Reflections made = reflections(kWidth, kHeight);
        must(made.setInputs(gbuffer));
        return trace(made, camera.view(kWidth, kHeight));
    }

    static void expectSame(const Picture& a, const Picture& b) {
        uint64_t hits = 0;
        for (uint32_t i = 0; i < a.pixels(); ++i) {
            ASSERT_EQ(a.outcome(i), b.outcome(i)) << i;
            hits += a.hit(i);
            const glm::vec3 difference = glm::abs(a.color(i) - b.color(i));
            ASSERT_LE(std::max({difference.x, difference.y, difference.z}), 0.02f) << i;
        }
        ASSERT_GT(hits, 200u);
    }
};

TEST_F(HostMaterialsTest, everyKindGivesThePictureOfItsF0AndRoughness) {
    const auto plain = [](const Texel& t) { return glm::vec4(t.f0(), t.roughness); };
    const Picture expected = show(plain, [](GBuffer&) {});
    expectSame(show([](const Texel& t) { return glm::vec4(9, t.roughness, t.metallic, 9); },
                    [](GBuffer& g) { // glTF's own channels
                        g.conventions.material = MaterialKind::MetallicRoughness;
                        g.roughness.channel = 1;
                    }),
               expected);
    expectSame(show([](const Texel& t) { return glm::vec4(t.metallic, 9, 9, 1 - t.roughness); },
                    [](GBuffer& g) {
                        g.conventions.material = MaterialKind::MetallicRoughness;
                        g.metallic.channel = 0;
                        g.conventions.roughness = RoughnessKind::Smoothness;
                    }),
               expected);
    expectSame(show([](const Texel& t) { return glm::vec4(t.f0(), 1 - t.roughness); },
                    [](GBuffer& g) { g.conventions.material = MaterialKind::SpecularGlossiness; }),
               expected);
}

TEST_F(HostMaterialsTest, standardMaterialsAreSharp) {
    const auto standard = [](GBuffer& g) { g.conventions.material = MaterialKind::Standard; };
    expectSame(show([](const Texel& t) { return glm::vec4(t.baseColor, 0.9f); }, standard),
               show([](const Texel& t) { return glm::vec4(t.baseColor, 0); }, [](GBuffer&) {}));
    // Without an image: a full mirror.
    expectSame(show([](const Texel&) { return glm::vec4(0.1f); }, standard, false),
               show([](const Texel&) { return glm::vec4(1, 1, 1, 0); }, [](GBuffer&) {}));
}

TEST_F(HostMaterialsTest, aKindThatIsStatedWronglyIsSeen) {
    const auto plain = [](const Texel& t) { return glm::vec4(t.f0(), t.roughness); };
    const Picture right = show(plain, [](GBuffer&) {});
    for (const MaterialKind kind :
         {MaterialKind::MetallicRoughness, MaterialKind::SpecularGlossiness, MaterialKind::Standard}) {
        const Picture wrong = show(plain, [&](GBuffer& g) { g.conventions.material = kind; });
        uint32_t different = 0;
        for (uint32_t i = 0; i < right.pixels(); ++i)
            different += glm::distance(right.color(i), wrong.color(i)) > 0.05f || right.outcome(i) != wrong.outcome(i);
        EXPECT_GT(different, right.pixels() / 20);
    }
}

TEST_F(HostMaterialsTest, halfDepthIsViewZInSixteenBits) {
    for (const bool orthographic : {false, true}) {
        SyntheticCamera camera;
        camera.orthoHeight = orthographic ? 3 : 0;
        camera.target.y = orthographic ? 0.5 : 1; // the horizon, if there is one, in the middle
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), Stage(), camera, kWidth, kHeight);
        const auto depth = [&](DepthFormat format) {
            Settings settings = plainSettings();
            settings.gbuffer.depthFormat = format;
            Reflections made = reflections(kWidth, kHeight, settings);
            must(made.setInputs(host.gbuffer));
            HostImage image;
            run([&](VkCommandBuffer commands) {
                made.record(commands, camera.view(kWidth, kHeight));
                image = must(made.recordView(commands, "depth"));
            });
            return download(gpu(), image);
        };
        const std::vector<float> full = depth(DepthFormat::Float);
        const std::vector<float> half = depth(DepthFormat::Half);
        uint32_t changed = 0;
        for (size_t i = 0; i < full.size(); i += 4) {
            ASSERT_EQ(half[i], glm::unpackHalf1x16(glm::packHalf1x16(half[i]))) << "no half";
            ASSERT_NEAR(half[i], full[i], full[i] / 1024);
            changed += half[i] != full[i];
        }
        EXPECT_GT(changed, kWidth * kHeight / 4);
        if (!orthographic) {
            EXPECT_EQ(full[0], 0) << "background, in both";
            EXPECT_EQ(half[0], 0);
        }
    }
}

TEST_F(HostMaterialsTest, probesMayBeUpsideDown) {
    // The upper half of the environment is red, the lower half blue; a floor mirrors the upper half.
    const TestEnvironment environment = TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3& direction, uint32_t) {
        return direction.y > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    });
    Stage stage;
    Settings settings = plainSettings();
    settings.screen.enabled = false;
    for (const bool flipped : {false, true}) {
        EnvironmentMap map = environment.map;
        map.flipY = flipped;
        map.rotation = 0.5f;
        const Picture picture = trace(stage, {}, kWidth, kHeight, settings, map);
        const glm::vec3 floor = picture.color((kHeight - 2) * kWidth + kWidth / 2);
        EXPECT_NEAR(floor.x, flipped ? 0 : 1, 0.02f);
        EXPECT_NEAR(floor.z, flipped ? 1 : 0, 0.02f);
    }
}

} // namespace host_materials_test
} // namespace glint::test
