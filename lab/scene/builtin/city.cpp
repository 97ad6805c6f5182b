// builtin:city, a scene of real size: streets after rain at night, between houses of a few storeys with shops, neon and
// lamps. Its geometry is instanced: about 0.45 million triangles are stored, one to ten million drawn.
//
// The plan is a grid of square cells: a block of four houses, pavement around it, half of each street beside it. Cells
// are added, nearest to the default camera first, until the asked number of triangles is reached.
#include "lab/scene/builtin/city_facade.hpp"
#include "lab/scene/builtin/city_materials.hpp"
#include "lab/scene/builtin/city_street.hpp"
#include "lab/scene/builtin/noise.hpp"
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/sign.hpp"

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

constexpr glm::vec3 kNight(0.55f, 0.68f, 1.f);
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
        : b_(millions == 1 ? "builtin:city" : fmt::format("builtin:city-{}", millions)), m_(cityMaterials(b_)),
          asked_(static_cast<size_t>(millions) * 1'000'000) {}

    Scene make() {
        b_.camera("street", {1.4f, 1.6f, 20}, {-0.6f, 2.5f, -30}, 50);
        b_.camera("puddle", {-2.6f, 0.35f, 6}, {1.5f, 1.9f, -30}, 48);
        b_.camera("crossing", {9, 7, 30}, {-6, 1.5f, -16}, 50);
        b_.camera("roofs", {-30, 46, 62}, {10, 0, -60}, 45);
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
                const uint32_t room = dice.of(1, m_.rooms.size());
                storeys_[s].push_back(
                    part(fmt::format("storey {} {}", style, i),
                         {{std::move(storey.wall), m_.walls[s][i % 2]},
                          {std::move(storey.trim), m_.trims[s]},
                          {std::move(storey.frame), m_.frames[s]},
                          {std::move(storey.glass), m_.glasses[i % m_.glasses.size()]},
                          {std::move(storey.rooms[0]), m_.rooms[room]},
                          {std::move(storey.rooms[1]),
                           m_.rooms[(room + 1 + dice.of(2, m_.rooms.size() - 1)) % m_.rooms.size()]}}));
            }
        }
        for (uint32_t i = 0; i < 12; ++i) {
            const Dice dice = {hash(1000 + i)};
            const size_t style = i % kFacadeStyles;
            ShopStorey shop = shopStorey(dice.seed);
            std::vector<std::pair<Geometry, int>> primitives = {{std::move(shop.wall), m_.walls[style][i / 6]},
                                                                {std::move(shop.trim), m_.trims[style]},
                                                                {std::move(shop.frame), m_.frames[style]},
                                                                {std::move(shop.awning), m_.awnings[i]}};
            for (uint32_t side = 0; side < 4; ++side) {
                primitives.emplace_back(std::move(shop.windows[side]),
                                        m_.shopWindows[dice.of(10 + side, m_.shopWindows.size())]);
                primitives.emplace_back(std::move(shop.signs[side]), m_.signs[dice.of(20 + side, m_.signs.size())]);
            }
            shops_.push_back(part(fmt::format("shops {}", i), std::move(primitives)));
        }
        for (uint32_t i = 0; i < 3; ++i) {
            Roof roof = flatRoof(1100 + i);
            roofParts_.push_back(part(fmt::format("roof {}", i), {{std::move(roof.cover), m_.roofs[i]},
                                                                  {std::move(roof.plant), m_.plant},
                                                                  {std::move(roof.tank), m_.tank}}));
        }
        for (size_t i = 0; i < kNeonWords.size(); ++i)
            neonParts_.push_back(
                part(fmt::format("neon {}", kNeonWords[i]), {{neonText(kNeonWords[i], 1.1f, 0.05f), m_.neon[i]}}));
    }

    void street() {
        bracket_ = part("bracket", {{box({1.8f, 0.025f, 0.025f}), m_.iron}});
        road_ = part("road", {{plane(glm::vec2(kCell / 2)), m_.asphalt}});
        const glm::vec3 block(kBlockHalf, kKerb / 2, kBlockHalf);
        pavementPart_ = part("pavement", {{translated(boxSide(block, Side::PlusY), {0, kKerb / 2, 0}), m_.pavement},
                                          {translated(kerbStones(block), {0, kKerb / 2, 0}), m_.kerb}});
        dash_ = part("dash", {{plane({0.08f, 1.5f}), m_.marking}});
        Geometry stripes;
        for (int i = 0; i < 10; ++i)
            append(stripes, translated(plane({0.28f, 1.5f}), {(static_cast<float>(i) - 4.5f) * 1.12f, 0, 0}));
        crossing_ = part("crossing", {{std::move(stripes), m_.marking}});
        StreetLamp lamp = streetLamp();
        lamp_ = part("lamp", {{std::move(lamp.pole), m_.iron}, {std::move(lamp.head), m_.lampHead}});
        const Car shape = car();
        for (const int paint : m_.paints)
            cars_.push_back(part("car", {{shape.body, paint},
                                         {shape.windows, m_.carGlass},
                                         {shape.tyres, m_.tyre},
                                         {shape.rims, m_.rim},
                                         {shape.headlamps, m_.headlamp},
                                         {shape.tailLamps, m_.tailLamp}}));
        for (uint32_t i = 0; i < m_.leaves.size(); ++i) {
            Tree t = tree(1200 + i);
            trees_.push_back(part("tree", {{std::move(t.trunk), m_.bark}, {std::move(t.leaves), m_.leaves[i]}}));
        }
        bollard_ = part("bollard", {{bollard(), m_.iron}});
        binPart_ = part("bin", {{litterBin(), m_.bin}});
        hydrant_ = part("hydrant", {{hydrant(), m_.red}});
        for (const bool go : {false, true}) {
            TrafficLight light = trafficLight();
            const int dark = m_.iron;
            signals_.push_back(
                part(go ? "traffic light, go" : "traffic light, stop", {{std::move(light.housing), m_.iron},
                                                                        {std::move(light.red), go ? dark : m_.stop},
                                                                        {std::move(light.amber), m_.amber},
                                                                        {std::move(light.green), go ? m_.go : dark}}));
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
            light.color = kLampColor;
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
            light.color = kNeonColors[i % kNeonColors.size()];
            light.intensity = 7;
            light.range = 25;
            const glm::vec3 at(i % 2 == 0 ? -kRoadHalf - 1.5f : kRoadHalf + 1.5f, 4.2f,
                               8.f - 11.f * static_cast<float>(i));
            b_.light(light, at, at - glm::vec3(0, 1, 0));
        }
    }

    static constexpr uint32_t kStoreyKinds = 6; ///< of each style: two colours, three patterns of lit windows

    SceneBuilder b_;
    CityMaterials m_;
    size_t asked_;
    size_t triangles_ = 0;
    std::vector<glm::vec3> lamps_; ///< where they shine

    std::array<std::vector<Part>, kFacadeStyles> storeys_;
    std::vector<Part> shops_, roofParts_, neonParts_, cars_, trees_, signals_;
    Part road_, pavementPart_, dash_, crossing_, lamp_, bollard_, binPart_, hydrant_, bracket_;
};

} // namespace

Scene makeCity(int millions) {
    return City(millions).make();
}

} // namespace glint::scene::builtin
