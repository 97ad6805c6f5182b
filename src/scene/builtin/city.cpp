// builtin:city, a scene of real size: streets after rain at night, between houses of a few storeys with shops, neon and
// lamps. Its geometry is instanced: about 0.45 million triangles are stored, one to ten million drawn.
//
// The plan is a grid of square cells: a block of four houses, pavement around it, half of each street beside it. Cells
// are added, nearest to the default camera first, until the asked number of triangles is reached.
#include "scene/builtin/city_facade.hpp"
#include "scene/builtin/city_street.hpp"
#include "scene/builtin/city_textures.hpp"
#include "scene/builtin/noise.hpp"
#include "scene/builtin/scene_builder.hpp"
#include "scene/builtin/scenes.hpp"
#include "scene/builtin/shapes.hpp"
#include "scene/builtin/sign.hpp"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace glint::scene::builtin {

namespace {

// The plan, in metres.
constexpr float kHouse = 2 * kBuildingHalf;
constexpr float kAlley = 2; ///< between two houses
constexpr float kPavement = 3.5f;
constexpr float kBlockHalf = kHouse + kAlley / 2 + kPavement;
constexpr float kRoadHalf = 6;
constexpr float kCell = 2 * (kBlockHalf + kRoadHalf);
constexpr float kKerb = 0.14f; ///< height

constexpr glm::vec3 kSodium(1.f, 0.56f, 0.22f), kNight(0.55f, 0.68f, 1.f);
constexpr std::array<glm::vec3, 4> kNeon = {glm::vec3(1.f, 0.07f, 0.3f), glm::vec3(0.05f, 0.6f, 1.f),
                                            glm::vec3(0.15f, 1.f, 0.35f), glm::vec3(1.f, 0.45f, 0.05f)};
constexpr std::array<const char*, 4> kNeonWords = {"GLINT", "LIT", "GILT", "TIN"};

/// What decides by chance, the same in every run.
struct Dice {
    uint32_t seed;
    float unit(uint32_t what) const { return hashUnit(seed, what, 77); }
    uint32_t of(uint32_t what, size_t count) const {
        return std::min(static_cast<uint32_t>(unit(what) * static_cast<float>(count)),
                        static_cast<uint32_t>(count) - 1);
    }
    Dice next(uint32_t what) const { return {hash(seed * 31 + what)}; }
};

class City {
public:
    explicit City(int millions)
        : b_(millions == 1 ? "builtin:city" : fmt::format("builtin:city-{}", millions)),
          asked_(static_cast<size_t>(millions) * 1'000'000) {}

    Scene make() {
        b_.camera("street", {1.4f, 1.6f, 20}, {-0.6f, 2.5f, -30}, 50);
        b_.camera("puddle", {-2.6f, 0.35f, 6}, {1.5f, 1.9f, -30}, 48);
        b_.camera("crossing", {9, 7, 30}, {-6, 1.5f, -16}, 50);
        b_.camera("roofs", {-30, 46, 62}, {10, 0, -60}, 45);
        materials();
        storeys();
        street();
        for (const glm::ivec2& at : cellsByDistance()) {
            if (triangles_ >= asked_)
                break;
            cell(at);
        }
        lights();
        return b_.take();
    }

private:
    // ---------------------------------------------------------------- materials

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

    void materials() {
        asphalt_ = ground("wet asphalt", wetAsphalt(512), 13);
        pavement_ = ground("wet pavement", wetPavement(256), 4);
        kerb_ = b_.material(dielectric("kerb", glm::vec3(0.2f), 0.35f));
        marking_ = b_.material(dielectric("road marking", glm::vec3(0.55f), 0.3f));
        walls();
        windows();
        shops();
        smallThings();
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
            const auto heights = kind.bricks ? brickHeights(kSize, seed) : blockHeights(kSize, 1, 2, seed);
            const glm::vec2 repeats(kind.bricks ? 1.f : 0.4f);
            const TextureSlot normals =
                b_.texture(normalMap(fmt::format("{} normals", kind.name), heights, kSize, 0.006f), repeats);
            const TextureSlot colors = b_.texture(
                blockColors(fmt::format("{} colour", kind.name), heights, kSize, glm::vec3(0.8f), seed), repeats);
            for (size_t i = 0; i < kind.albedos.size(); ++i) {
                Material m = dielectric(fmt::format("{} {}", kind.name, i), kind.albedos[i] / 0.8f, 0.6f);
                m.baseColorTexture = colors;
                m.normalTexture = normals;
                walls_[style][i] = b_.material(m);
            }
            trims_[style] =
                b_.material(dielectric(fmt::format("{} trim", kind.name), kind.albedos[0] * 0.7f + 0.1f, 0.5f));
            frames_[style] = b_.material(style == 3 ? metal("window steel", glm::vec3(0.4f), 0.3f)
                                                    : dielectric(fmt::format("{} frames", kind.name),
                                                                 glm::vec3(style % 2 == 0 ? 0.5f : 0.06f), 0.4f));
        }
    }

    void windows() {
        constexpr std::array<glm::vec3, 3> tints = {glm::vec3(1.f, 0.72f, 0.42f), glm::vec3(1.f, 0.85f, 0.65f),
                                                    glm::vec3(0.6f, 0.8f, 1.f)};
        for (size_t i = 0; i < glasses_.size(); ++i)
            glasses_[i] = b_.material(dielectric(fmt::format("dark glass {}", i), glm::vec3(0.006f + 0.004f * float(i)),
                                                 0.01f + 0.02f * static_cast<float>(i)));
        for (uint32_t room = 0; room < 4; ++room) {
            const TextureSlot picture = b_.texture(litRoom(fmt::format("room {}", room), 128, 600 + room));
            for (const glm::vec3& tint : tints)
                rooms_.push_back(lit(fmt::format("room {} window {}", room, rooms_.size() % tints.size()), picture,
                                     tint * 0.9f, 0.03f));
        }
    }

    void shops() {
        constexpr std::array<glm::vec3, 4> tints = {glm::vec3(1.6f, 1.35f, 1.f), glm::vec3(1.1f, 1.4f, 1.7f),
                                                    glm::vec3(1.7f, 1.f, 0.6f), glm::vec3(1.5f, 0.9f, 1.4f)};
        for (uint32_t i = 0; i < 4; ++i) {
            const TextureSlot picture = b_.texture(shopWindow(fmt::format("shop {}", i), 256, 700 + i));
            for (size_t k = 0; k < tints.size(); ++k)
                shopWindows_.push_back(lit(fmt::format("shop {} window {}", i, k), picture, tints[k], 0.03f));
        }
        for (uint32_t i = 0; i < 8; ++i) {
            const bool inverse = i % 2 == 1; // dark letters on a bright board
            const TextureSlot board =
                b_.texture(signBoard(fmt::format("sign {}", i), 256, kSignAspect, 800 + i,
                                     glm::vec3(inverse ? 0.7f : 0.01f), glm::vec3(inverse ? 0.02f : 1.f)));
            for (size_t k = 0; k < kNeon.size(); ++k)
                signs_.push_back(lit(fmt::format("sign {} {}", i, k), board, kNeon[k] * 2.2f + 0.08f, 0.2f));
        }
        for (uint32_t i = 0; i < 12; ++i) {
            const glm::vec3 c(hashUnit(i, 900, 1), hashUnit(i, 900, 2), hashUnit(i, 900, 3));
            Material cloth = dielectric(fmt::format("awning {}", i), 0.02f + 0.5f * c * c, 0.8f);
            cloth.doubleSided = true;
            awnings_.push_back(b_.material(cloth));
        }
    }

    void smallThings() {
        for (uint32_t i = 0; i < 24; ++i) {
            const glm::vec3 c(hashUnit(i, 910, 1), hashUnit(i, 910, 2), hashUnit(i, 910, 3));
            const float grey = i % 3 == 0 ? 1.f : 0.f; // most cars have no colour
            paints_.push_back(b_.material(dielectric(
                fmt::format("car paint {}", i), 0.01f + 0.5f * glm::mix(c * c, glm::vec3(c.x * c.x), grey), 0.08f)));
        }
        roofs_ = {b_.material(dielectric("roof felt", glm::vec3(0.05f), 0.5f)),
                  b_.material(dielectric("roof gravel", glm::vec3(0.12f), 0.7f)),
                  b_.material(dielectric("roof slate", glm::vec3(0.06f, 0.065f, 0.075f), 0.3f))};
        plant_ = b_.material(metal("air conditioner", glm::vec3(0.5f), 0.4f));
        tank_ = b_.material(dielectric("tank timber", glm::vec3(0.12f, 0.07f, 0.04f), 0.6f));
        iron_ = b_.material(metal("painted iron", glm::vec3(0.08f), 0.35f));
        lampHead_ = b_.material(emission("lamp", kSodium * 9.f));
        carGlass_ = b_.material(dielectric("car glass", glm::vec3(0.005f), 0.f));
        tyre_ = b_.material(dielectric("tyre", glm::vec3(0.015f), 0.7f));
        rim_ = b_.material(metal("wheel rim", glm::vec3(0.6f), 0.2f));
        headlamp_ = b_.material(dielectric("headlamp", glm::vec3(0.5f), 0.05f));
        tailLamp_ = b_.material(emission("tail lamp", glm::vec3(1.2f, 0.02f, 0.01f)));
        bark_ = b_.material(dielectric("bark", glm::vec3(0.06f, 0.045f, 0.03f), 0.8f));
        for (uint32_t i = 0; i < 3; ++i) {
            Material m = dielectric(fmt::format("leaves {}", i), glm::vec3(1), 0.5f);
            m.baseColorTexture = b_.texture(leaves(fmt::format("leaves {}", i), 128, 920 + i));
            m.alphaMode = AlphaMode::Mask;
            m.doubleSided = true;
            leaves_.push_back(b_.material(m));
        }
        red_ = b_.material(dielectric("hydrant red", glm::vec3(0.4f, 0.02f, 0.015f), 0.2f));
        bin_ = b_.material(dielectric("bin green", glm::vec3(0.02f, 0.08f, 0.04f), 0.3f));
        stop_ = b_.material(emission("red light", glm::vec3(6, 0.15f, 0.08f)));
        amber_ = b_.material(dielectric("amber light, off", glm::vec3(0.15f, 0.08f, 0.01f), 0.1f));
        go_ = b_.material(emission("green light", glm::vec3(0.1f, 4, 1.6f)));
        for (size_t i = 0; i < kNeon.size(); ++i)
            neon_[i] = b_.material(emission(fmt::format("neon {}", i), kNeon[i] * 3.f));
    }

    // ---------------------------------------------------------------- meshes

    struct Part {
        int mesh = -1;
        size_t triangles = 0;
    };

    Part part(std::string name, std::vector<std::pair<Geometry, int>> primitives) {
        std::erase_if(primitives, [](const auto& p) { return p.first.indices.empty(); });
        Part out;
        for (auto& p : primitives) {
            out.triangles += p.first.indices.size() / 3;
            computeTangents(p.first);
        }
        out.mesh = b_.mesh(std::move(name), std::move(primitives));
        return out;
    }

    void put(const Part& what, const Place& place) {
        b_.place(what.mesh, place);
        triangles_ += what.triangles;
    }

    void storeys() {
        for (int style = 0; style < kFacadeStyles; ++style) {
            const auto s = static_cast<size_t>(style);
            for (uint32_t i = 0; i < kStoreyKinds; ++i) {
                const Dice dice = {hash(static_cast<uint32_t>(style) * 16 + i)};
                Storey storey = windowStorey(style, dice.seed);
                const uint32_t room = dice.of(1, rooms_.size());
                storeys_[s].push_back(part(fmt::format("storey {} {}", style, i),
                                           {{std::move(storey.wall), walls_[s][i % 2]},
                                            {std::move(storey.trim), trims_[s]},
                                            {std::move(storey.frame), frames_[s]},
                                            {std::move(storey.glass), glasses_[i % glasses_.size()]},
                                            {std::move(storey.rooms[0]), rooms_[room]},
                                            {std::move(storey.rooms[1]),
                                             rooms_[(room + 1 + dice.of(2, rooms_.size() - 1)) % rooms_.size()]}}));
            }
        }
        for (uint32_t i = 0; i < 12; ++i) {
            const Dice dice = {hash(1000 + i)};
            const size_t style = i % kFacadeStyles;
            ShopStorey shop = shopStorey(dice.seed);
            std::vector<std::pair<Geometry, int>> primitives = {{std::move(shop.wall), walls_[style][i / 6]},
                                                                {std::move(shop.trim), trims_[style]},
                                                                {std::move(shop.frame), frames_[style]},
                                                                {std::move(shop.awning), awnings_[i]}};
            for (uint32_t side = 0; side < 4; ++side) {
                primitives.emplace_back(std::move(shop.windows[side]),
                                        shopWindows_[dice.of(10 + side, shopWindows_.size())]);
                primitives.emplace_back(std::move(shop.signs[side]), signs_[dice.of(20 + side, signs_.size())]);
            }
            shops_.push_back(part(fmt::format("shops {}", i), std::move(primitives)));
        }
        for (uint32_t i = 0; i < 3; ++i) {
            Roof roof = flatRoof(1100 + i);
            roofParts_.push_back(part(
                fmt::format("roof {}", i),
                {{std::move(roof.cover), roofs_[i]}, {std::move(roof.plant), plant_}, {std::move(roof.tank), tank_}}));
        }
        for (size_t i = 0; i < kNeonWords.size(); ++i)
            neonParts_.push_back(
                part(fmt::format("neon {}", kNeonWords[i]), {{neonText(kNeonWords[i], 1.1f, 0.05f), neon_[i]}}));
    }

    void street() {
        bracket_ = part("bracket", {{box({1.8f, 0.025f, 0.025f}), iron_}});
        road_ = part("road", {{plane(glm::vec2(kCell / 2)), asphalt_}});
        const glm::vec3 block(kBlockHalf, kKerb / 2, kBlockHalf);
        pavementPart_ = part("pavement", {{translated(boxSide(block, Side::PlusY), {0, kKerb / 2, 0}), pavement_},
                                          {translated(kerbStones(block), {0, kKerb / 2, 0}), kerb_}});
        dash_ = part("dash", {{plane({0.08f, 1.5f}), marking_}});
        Geometry stripes;
        for (int i = 0; i < 10; ++i)
            append(stripes, translated(plane({0.28f, 1.5f}), {(static_cast<float>(i) - 4.5f) * 1.12f, 0, 0}));
        crossing_ = part("crossing", {{std::move(stripes), marking_}});
        StreetLamp lamp = streetLamp();
        lamp_ = part("lamp", {{std::move(lamp.pole), iron_}, {std::move(lamp.head), lampHead_}});
        const Car shape = car();
        for (const int paint : paints_)
            cars_.push_back(part("car", {{shape.body, paint},
                                         {shape.windows, carGlass_},
                                         {shape.tyres, tyre_},
                                         {shape.rims, rim_},
                                         {shape.headlamps, headlamp_},
                                         {shape.tailLamps, tailLamp_}}));
        for (uint32_t i = 0; i < leaves_.size(); ++i) {
            Tree t = tree(1200 + i);
            trees_.push_back(part("tree", {{std::move(t.trunk), bark_}, {std::move(t.leaves), leaves_[i]}}));
        }
        bollard_ = part("bollard", {{bollard(), iron_}});
        binPart_ = part("bin", {{litterBin(), bin_}});
        hydrant_ = part("hydrant", {{hydrant(), red_}});
        for (const bool go : {false, true}) {
            TrafficLight light = trafficLight();
            const int dark = iron_;
            signals_.push_back(
                part(go ? "traffic light, go" : "traffic light, stop", {{std::move(light.housing), iron_},
                                                                        {std::move(light.red), go ? dark : stop_},
                                                                        {std::move(light.amber), amber_},
                                                                        {std::move(light.green), go ? go_ : dark}}));
        }
    }

    static Geometry kerbStones(const glm::vec3& half) {
        Geometry out;
        for (const Side side : {Side::PlusX, Side::MinusX, Side::PlusZ, Side::MinusZ})
            append(out, boxSide(half, side));
        return out;
    }

    // ---------------------------------------------------------------- cells

    /// The avenue runs along x = 0, between the columns -1 and 0; rows go away from the camera.
    static glm::vec3 center(const glm::ivec2& at) {
        return {(static_cast<float>(at.x) + 0.5f) * kCell, 0, -static_cast<float>(at.y) * kCell};
    }

    static std::vector<glm::ivec2> cellsByDistance() {
        std::vector<glm::ivec2> cells;
        for (int x = -8; x < 8; ++x)
            for (int y = -4; y <= 16; ++y)
                cells.emplace_back(x, y);
        const auto rank = [](const glm::ivec2& at) {
            const glm::vec3 c = center(at) - glm::vec3(0, 0, -kCell);
            return std::tuple(std::abs(c.x) * 1.5f + std::abs(c.z), at.y, at.x);
        };
        std::ranges::sort(cells, {}, rank);
        return cells;
    }

    void cell(const glm::ivec2& at) {
        const glm::vec3 c = center(at);
        const Dice dice = {hash(static_cast<uint32_t>(at.x + 64) * 256 + static_cast<uint32_t>(at.y + 64))};
        put(road_, {c});
        put(pavementPart_, {c});
        for (uint32_t i = 0; i < 4; ++i) {
            const float half = (kHouse + kAlley) / 2;
            const glm::vec3 corner(i % 2 == 0 ? -half : half, kKerb, i < 2 ? -half : half);
            house(c + corner, corner, dice.next(i));
        }
        for (uint32_t side = 0; side < 4; ++side)
            sideOfStreet(c, 90.f * static_cast<float>(side), dice.next(10 + side));
    }

    /// `outward`: points away from the block's middle.
    void house(const glm::vec3& foot, const glm::vec3& outward, const Dice& dice) {
        const uint32_t style = dice.of(1, kFacadeStyles);
        const uint32_t color = dice.of(2, 2);
        const uint32_t count = 2 + dice.of(3, 4);
        put(shops_[style + kFacadeStyles * color], {foot, turnedY(90.f * static_cast<float>(dice.of(4, 4)))});
        glm::vec3 at = foot + glm::vec3(0, kShopHeight, 0);
        for (uint32_t i = 0; i < count; ++i, at.y += kStoreyHeight) {
            const uint32_t kind = 2 * dice.of(20 + i, kStoreyKinds / 2) + color;
            put(storeys_[style][kind], {at, turnedY(90.f * static_cast<float>(dice.of(40 + i, 4)))});
        }
        put(roofParts_[dice.of(5, roofParts_.size())], {at});
        if (dice.unit(6) < 0.6f) { // a sign that stands out over the pavement
            const float s = outward.x < 0 ? -1.f : 1.f;
            const float y = kKerb + kShopHeight + 1 + 2.5f * dice.unit(7);
            const glm::vec3 wall(foot.x + s * kBuildingHalf, y, foot.z + (dice.unit(9) - 0.5f) * 8);
            const size_t word = dice.of(8, neonParts_.size());
            put(neonParts_[word], {wall + glm::vec3(s * 1.9f, 0, 0)});
            put(bracket_, {wall + glm::vec3(s * 1.7f, -0.12f, 0)});
            put(bracket_, {wall + glm::vec3(s * 1.7f, 1.1f + 0.12f, 0)});
        }
    }

    /// One of the four sides of a block; without a turn it lies at +Z and its street runs along X.
    void sideOfStreet(const glm::vec3& c, float degrees, const Dice& dice) {
        const glm::quat turn = turnedY(degrees);
        const auto at = [&](float x, float y, float z) { return c + turn * glm::vec3(x, y, z); };
        const float kerbZ = kBlockHalf - 0.5f, middleZ = kBlockHalf + kRoadHalf;
        for (const float x : {-15.f, 0.f, 15.f}) {
            put(lamp_, {at(x, kKerb, kerbZ), turn * turnedY(-90)});
            lamps_.push_back(at(x, kKerb + kLampHeight, kerbZ + kLampReach));
        }
        for (int i = 0; i < 9; ++i) // the middle line belongs to both sides: only two of four draw it
            if (degrees < 180)
                put(dash_, {at(-20.f + 5.f * static_cast<float>(i), 0.008f, middleZ), turn * turnedY(90)});
        put(crossing_, {at(kBlockHalf - 2, 0.01f, middleZ), turn * turnedY(90)});
        for (uint32_t i = 0; i < 6; ++i) {
            const float x = -16.f + 6.4f * static_cast<float>(i);
            if (dice.unit(100 + i) < 0.55f)
                put(cars_[dice.of(110 + i, cars_.size())], {at(x + dice.unit(120 + i), 0, kBlockHalf + 1.15f),
                                                            turn * turnedY(dice.unit(130 + i) < 0.9f ? 0 : 180)});
        }
        for (uint32_t i = 0; i < 2; ++i)
            put(trees_[dice.of(140 + i, trees_.size())],
                {at(i == 0 ? -8.f : 7.f, kKerb, kerbZ - 0.3f), turnedY(360 * dice.unit(150 + i)),
                 glm::vec3(0.85f + 0.3f * dice.unit(160 + i))});
        for (const float x : {-1.2f, 1.2f})
            put(bollard_, {at(kBlockHalf - 3 + x, kKerb, kerbZ + 0.1f)});
        put(binPart_, {at(3, kKerb, kerbZ)});
        if (dice.unit(170) < 0.5f)
            put(hydrant_, {at(-11, kKerb, kerbZ), turn});
        put(signals_[static_cast<size_t>(degrees / 90) % 2],
            {at(kBlockHalf - 0.4f, kKerb, kerbZ + 0.1f), turn * turnedY(-90)});
    }

    // ---------------------------------------------------------------- lights

    /// The night, the lamps nearest to the default camera, and neon's glow: twenty. Lamps further away shine and light
    /// nothing.
    void lights() {
        constexpr size_t kSpots = 13;
        Light night;
        night.name = "night";
        night.color = kNight;
        night.intensity = 0.2f;
        b_.light(night, {-30, 60, 25}, {0, 0, 0});
        const auto rank = [](const glm::vec3& p) {
            return std::tuple(std::abs(p.x) + 0.6f * std::abs(p.z + 8), p.z, p.x);
        };
        std::ranges::sort(lamps_, {}, rank);
        for (size_t i = 0; i < std::min(kSpots, lamps_.size()); ++i) {
            Light light;
            light.name = "lamp";
            light.type = LightType::Spot;
            light.color = kSodium;
            light.intensity = 170;
            light.innerConeAngle = glm::radians(35.f);
            light.outerConeAngle = glm::radians(72.f);
            light.range = 30;
            b_.light(light, lamps_[i], lamps_[i] - glm::vec3(0, 1, 0));
        }
        for (uint32_t i = 0; i < 6; ++i) {
            Light light;
            light.name = "neon glow";
            light.type = LightType::Point;
            light.color = kNeon[i % kNeon.size()];
            light.intensity = 7;
            light.range = 25;
            const glm::vec3 at(i % 2 == 0 ? -kRoadHalf - 1.5f : kRoadHalf + 1.5f, 4.2f,
                               8.f - 11.f * static_cast<float>(i));
            b_.light(light, at, at - glm::vec3(0, 1, 0));
        }
    }

    static constexpr uint32_t kStoreyKinds = 6; ///< of each style: two colours, three patterns of lit windows

    SceneBuilder b_;
    size_t asked_;
    size_t triangles_ = 0;
    std::vector<glm::vec3> lamps_; ///< where they shine

    int asphalt_ = -1, pavement_ = -1, kerb_ = -1, marking_ = -1, plant_ = -1, tank_ = -1, iron_ = -1, lampHead_ = -1;
    int carGlass_ = -1, tyre_ = -1, rim_ = -1, headlamp_ = -1, tailLamp_ = -1, bark_ = -1, red_ = -1, bin_ = -1;
    int stop_ = -1, amber_ = -1, go_ = -1;
    std::array<std::array<int, 2>, kFacadeStyles> walls_ = {};
    std::array<int, kFacadeStyles> trims_ = {}, frames_ = {};
    std::array<int, 3> glasses_ = {}, roofs_ = {};
    std::array<int, 4> neon_ = {};
    std::vector<int> rooms_, shopWindows_, signs_, awnings_, paints_, leaves_;

    std::array<std::vector<Part>, kFacadeStyles> storeys_;
    std::vector<Part> shops_, roofParts_, neonParts_, cars_, trees_, signals_;
    Part road_, pavementPart_, dash_, crossing_, lamp_, bollard_, binPart_, hydrant_, bracket_;
};

} // namespace

Scene makeCity(int millions) {
    return City(millions).make();
}

} // namespace glint::scene::builtin
