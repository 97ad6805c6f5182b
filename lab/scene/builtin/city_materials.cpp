#include "lab/scene/builtin/city_materials.hpp"

#include "lab/scene/builtin/city_textures.hpp"
#include "lab/scene/builtin/noise.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace glint::scene::builtin {

namespace {

class Maker {
public:
    explicit Maker(SceneBuilder& builder) : b_(builder) {}

    CityMaterials make() {
        m_.asphalt = ground("wet asphalt", wetAsphalt(512), 13);
        m_.pavement = ground("wet pavement", wetPavement(256), 4);
        m_.kerb = b_.material(dielectric("kerb", glm::vec3(0.2f), 0.35f));
        m_.marking = b_.material(dielectric("road marking", glm::vec3(0.55f), 0.3f));
        walls();
        windows();
        shops();
        smallThings();
        return std::move(m_);
    }

private:
    int lit(std::string name, const TextureSlot& picture, const glm::vec3& tint, float roughness) {
        Material m = dielectric(std::move(name), glm::vec3(0.02f), roughness);
        m.emissiveFactor = tint;
        m.emissiveTexture = picture;
        return b_.material(m);
    }

    int ground(const char* name, GroundImages images, float metres) {
        const glm::vec2 repeats(1 / metres);
        Material m = dielectric(name, glm::vec3(1), 1);
        m.baseColorTexture = b_.texture(std::move(images.surface.baseColor), repeats);
        m.metallicRoughnessTexture = b_.texture(std::move(images.surface.metallicRoughness), repeats);
        m.normalTexture = b_.texture(std::move(images.normal), repeats);
        return b_.material(m);
    }

    void walls() {
        constexpr int kSize = 256;
        struct Kind {
            const char* name;
            bool bricks;
            std::array<glm::vec3, 2> albedos;
        };
        constexpr std::array<Kind, kFacadeStyles> kinds = {{
            {"brick", true, {glm::vec3(0.24f, 0.08f, 0.05f), glm::vec3(0.17f, 0.11f, 0.08f)}},
            {"plaster", false, {glm::vec3(0.36f, 0.3f, 0.2f), glm::vec3(0.22f, 0.29f, 0.3f)}},
            {"limestone", false, {glm::vec3(0.34f, 0.3f, 0.25f), glm::vec3(0.25f, 0.25f, 0.26f)}},
            {"panels", false, {glm::vec3(0.09f, 0.1f, 0.12f), glm::vec3(0.14f, 0.12f, 0.1f)}},
            {"yellow brick", true, {glm::vec3(0.33f, 0.25f, 0.13f), glm::vec3(0.3f, 0.13f, 0.08f)}},
            {"concrete", false, {glm::vec3(0.2f, 0.19f, 0.18f), glm::vec3(0.13f, 0.14f, 0.16f)}},
        }};
        for (size_t style = 0; style < kinds.size(); ++style) {
            const Kind& kind = kinds[style];
            const auto seed = static_cast<uint32_t>(500 + style);
            const auto heights = kind.bricks ? blockHeights(kSize, 4, 12, seed) : blockHeights(kSize, 1, 2, seed);
            const glm::vec2 repeats(kind.bricks ? 1.f : 0.4f);
            const TextureSlot normals =
                b_.texture(normalMap(fmt::format("{} normals", kind.name), heights, kSize, 0.006f), repeats);
            const TextureSlot colors = b_.texture(
                blockColors(fmt::format("{} colour", kind.name), heights, kSize, glm::vec3(0.8f), seed), repeats);
            for (size_t i = 0; i < kind.albedos.size(); ++i) {
                Material m = dielectric(fmt::format("{} {}", kind.name, i), kind.albedos[i] / 0.8f, 0.6f);
                m.baseColorTexture = colors;
                m.normalTexture = normals;
                m_.walls[style][i] = b_.material(m);
            }
            m_.trims[style] =
                b_.material(dielectric(fmt::format("{} trim", kind.name), kind.albedos[0] * 0.7f + 0.1f, 0.5f));
            m_.frames[style] = b_.material(style == 3 ? metal("window steel", glm::vec3(0.4f), 0.3f)
                                                      : dielectric(fmt::format("{} frames", kind.name),
                                                                   glm::vec3(style % 2 == 0 ? 0.5f : 0.06f), 0.4f));
        }
    }

    void windows() {
        constexpr std::array<glm::vec3, 3> tints = {glm::vec3(1.f, 0.72f, 0.42f), glm::vec3(1.f, 0.85f, 0.65f),
                                                    glm::vec3(0.6f, 0.8f, 1.f)};
        for (size_t i = 0; i < m_.glasses.size(); ++i)
            m_.glasses[i] =
                b_.material(dielectric(fmt::format("dark glass {}", i), glm::vec3(0.006f + 0.004f * float(i)),
                                       0.01f + 0.02f * static_cast<float>(i)));
        for (uint32_t room = 0; room < 4; ++room) {
            const TextureSlot picture = b_.texture(litRoom(fmt::format("room {}", room), 128, 600 + room));
            for (const glm::vec3& tint : tints)
                m_.rooms.push_back(lit(fmt::format("room {} window {}", room, m_.rooms.size() % tints.size()), picture,
                                       tint * 0.9f, 0.03f));
        }
    }

    void shops() {
        constexpr std::array<glm::vec3, 4> tints = {glm::vec3(1.6f, 1.35f, 1.f), glm::vec3(1.1f, 1.4f, 1.7f),
                                                    glm::vec3(1.7f, 1.f, 0.6f), glm::vec3(1.5f, 0.9f, 1.4f)};
        for (uint32_t i = 0; i < 4; ++i) {
            const TextureSlot picture = b_.texture(shopWindow(fmt::format("shop {}", i), 256, 700 + i));
            for (size_t k = 0; k < tints.size(); ++k)
                m_.shopWindows.push_back(lit(fmt::format("shop {} window {}", i, k), picture, tints[k], 0.03f));
        }
        for (uint32_t i = 0; i < 8; ++i) {
            const bool inverse = i % 2 == 1; // dark letters on a bright board
            const TextureSlot board =
                b_.texture(signBoard(fmt::format("sign {}", i), 256, kSignAspect, 800 + i,
                                     glm::vec3(inverse ? 0.7f : 0.01f), glm::vec3(inverse ? 0.02f : 1.f)));
            for (size_t k = 0; k < kNeonColors.size(); ++k)
                m_.signs.push_back(lit(fmt::format("sign {} {}", i, k), board, kNeonColors[k] * 2.2f + 0.08f, 0.2f));
        }
        for (uint32_t i = 0; i < 12; ++i) {
            const glm::vec3 c(hashUnit(i, 900, 1), hashUnit(i, 900, 2), hashUnit(i, 900, 3));
            Material cloth = dielectric(fmt::format("awning {}", i), 0.02f + 0.5f * c * c, 0.8f);
            cloth.doubleSided = true;
            m_.awnings.push_back(b_.material(cloth));
        }
    }

    void smallThings() {
        for (uint32_t i = 0; i < 24; ++i) {
            const glm::vec3 c(hashUnit(i, 910, 1), hashUnit(i, 910, 2), hashUnit(i, 910, 3));
            const float grey = i % 3 == 0 ? 1.f : 0.f; // a third of the cars is grey
            m_.paints.push_back(b_.material(dielectric(
                fmt::format("car paint {}", i), 0.01f + 0.5f * glm::mix(c * c, glm::vec3(c.x * c.x), grey), 0.08f)));
        }
        m_.roofs = {b_.material(dielectric("roof felt", glm::vec3(0.05f), 0.5f)),
                    b_.material(dielectric("roof gravel", glm::vec3(0.12f), 0.7f)),
                    b_.material(dielectric("roof slate", glm::vec3(0.06f, 0.065f, 0.075f), 0.3f))};
        m_.plant = b_.material(metal("air conditioner", glm::vec3(0.5f), 0.4f));
        m_.tank = b_.material(dielectric("tank timber", glm::vec3(0.12f, 0.07f, 0.04f), 0.6f));
        m_.iron = b_.material(metal("painted iron", glm::vec3(0.08f), 0.35f));
        m_.lampHead = b_.material(emission("lamp", kLampColor * 9.f));
        m_.carGlass = b_.material(dielectric("car glass", glm::vec3(0.005f), 0.f));
        m_.tyre = b_.material(dielectric("tyre", glm::vec3(0.015f), 0.7f));
        m_.rim = b_.material(metal("wheel rim", glm::vec3(0.6f), 0.2f));
        m_.headlamp = b_.material(dielectric("headlamp", glm::vec3(0.5f), 0.05f));
        m_.tailLamp = b_.material(emission("tail lamp", glm::vec3(1.2f, 0.02f, 0.01f)));
        m_.bark = b_.material(dielectric("bark", glm::vec3(0.06f, 0.045f, 0.03f), 0.8f));
        for (uint32_t i = 0; i < 3; ++i) {
            Material m = dielectric(fmt::format("leaves {}", i), glm::vec3(1), 0.5f);
            m.baseColorTexture = b_.texture(leaves(fmt::format("leaves {}", i), 128, 920 + i));
            m.alphaMode = AlphaMode::Mask;
            m.doubleSided = true;
            m_.leaves.push_back(b_.material(m));
        }
        m_.red = b_.material(dielectric("hydrant red", glm::vec3(0.4f, 0.02f, 0.015f), 0.2f));
        m_.bin = b_.material(dielectric("bin green", glm::vec3(0.02f, 0.08f, 0.04f), 0.3f));
        m_.stop = b_.material(emission("red light", glm::vec3(6, 0.15f, 0.08f)));
        m_.amber = b_.material(dielectric("amber light, off", glm::vec3(0.15f, 0.08f, 0.01f), 0.1f));
        m_.go = b_.material(emission("green light", glm::vec3(0.1f, 4, 1.6f)));
        for (size_t i = 0; i < kNeonColors.size(); ++i)
            m_.neon[i] = b_.material(emission(fmt::format("neon {}", i), kNeonColors[i] * 3.f));
    }

    SceneBuilder& b_;
    CityMaterials m_;
};

} // namespace

CityMaterials cityMaterials(SceneBuilder& builder) {
    return Maker(builder).make();
}

} // namespace glint::scene::builtin
