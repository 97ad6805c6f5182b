// builtin:hall, the show piece: a hall at nightfall. A nave between two arcades leads to a wall with the sign; its
// floor is dark polished stone that reflects the rest.
//
// Light: each emissive object (sign, ring, strips) has a punctual light of its colour beside it, as emission lights
// nothing in a rasteriser. Warm lights are on the right and at the far end, cool lights on the left, the moon above.
// Radiance is scaled so that 1 is white at exposure 0.
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/sign.hpp"
#include "lab/scene/builtin/sweep.hpp"
#include "lab/scene/builtin/textures.hpp"
#include "lab/scene/builtin/turned.hpp"

#include <glm/gtc/constants.hpp>

#include <array>

namespace glint::scene::builtin {

namespace {

// The plan, in metres. x: across, -z: along the nave.
constexpr float kBay = 4; ///< from column to column
constexpr int kBays = 6;
constexpr float kFrontZ = 8;                         ///< the first column pair, behind the default camera
constexpr float kBackZ = kFrontZ - kBays * kBay + 1; ///< inner face of the wall with the sign
constexpr float kEntranceZ = kFrontZ + 3;
constexpr float kColumnX = 3.3f;
constexpr float kWallX = 6.2f;
constexpr float kColumnHeight = 3.7f;
constexpr float kArcadeHeight = 2.5f;
constexpr float kCeiling = kColumnHeight + kArcadeHeight;
constexpr float kMiddleZ = (kBackZ + kEntranceZ) / 2, kHalfLength = (kEntranceZ - kBackZ) / 2;

// Colours of light, linear.
constexpr glm::vec3 kAmber(1.f, 0.42f, 0.1f), kWarmWhite(1.f, 0.72f, 0.45f), kIce(0.55f, 0.85f, 1.f);
constexpr glm::vec3 kCyan(0.05f, 0.62f, 1.f), kMagenta(1.f, 0.08f, 0.42f), kMoon(0.62f, 0.75f, 1.f);

class Hall {
public:
    Hall() : b_("builtin:hall") {}

    Scene make() {
        cameras();
        materials();
        building();
        arcades();
        signWall();
        strips();
        lanterns();
        metals();
        showPieces();
        wallMirror();
        lights();
        return b_.take();
    }

private:
    void cameras() {
        b_.camera("three-quarter", {1.15f, 1.5f, 8.6f}, {-0.55f, 1.38f, -4}, 45);
        b_.camera("nave", {0, 1.5f, 9.5f}, {0, 1.7f, -8}, 42);
        b_.camera("metals", {0.6f, 1.35f, 5.4f}, {-2.1f, 0.6f, 0.6f}, 46);
        b_.camera("mirror", {1.9f, 1.5f, 1.2f}, {-6, 1.35f, -2.2f}, 46);
    }

    void materials() {
        StoneFloor tiles;
        tiles.dark = {glm::vec3(0.008f, 0.009f, 0.011f), glm::vec3(0.022f, 0.024f, 0.028f),
                      glm::vec3(0.32f, 0.31f, 0.29f)};
        tiles.light = {glm::vec3(0.030f, 0.026f, 0.023f), glm::vec3(0.07f, 0.058f, 0.048f),
                       glm::vec3(0.42f, 0.36f, 0.28f)};
        SurfaceImages images = stoneFloor("floor", tiles);
        Material floor = dielectric("polished stone", glm::vec3(1), 1);
        const glm::vec2 perMetre(0.25f); // four tiles of one metre
        floor.baseColorTexture = b_.texture(std::move(images.baseColor), perMetre);
        floor.metallicRoughnessTexture = b_.texture(std::move(images.metallicRoughness), perMetre);
        floor_ = b_.material(floor);

        Material marbleColumn = dielectric("column stone", glm::vec3(1), 0.42f);
        marbleColumn.baseColorTexture = b_.texture(
            marble("column marble", 512,
                   {glm::vec3(0.42f, 0.38f, 0.33f), glm::vec3(0.6f, 0.55f, 0.48f), glm::vec3(0.3f, 0.25f, 0.2f)}, 5),
            glm::vec2(1, 0.5f));
        column_ = b_.material(marbleColumn);

        constexpr int kBlockSize = 512;
        const auto heights = blockHeights(kBlockSize, 2, 4, 21);
        Material wall = dielectric("dressed stone", glm::vec3(1), 0.7f);
        wall.baseColorTexture =
            b_.texture(blockColors("blocks", heights, kBlockSize, glm::vec3(0.2f, 0.18f, 0.165f), 21), glm::vec2(0.4f));
        wall.normalTexture = b_.texture(normalMap("block normals", heights, kBlockSize, 0.006f), glm::vec2(0.4f));
        wall_ = b_.material(wall);

        dark_ = b_.material(dielectric("dark timber", glm::vec3(0.035f, 0.028f, 0.024f), 0.5f));
        black_ = b_.material(dielectric("black granite", glm::vec3(0.012f), 0.12f));
        gold_ = b_.material(metal("brushed brass", {0.91f, 0.778f, 0.423f}, 0.28f));
    }

    /// Floor, walls, roof. The nave is open to the sky between the beams; the aisles are covered.
    void building() {
        b_.add("floor", translated(plane({kWallX, kHalfLength}, 12, 24), {0, 0, kMiddleZ}), floor_);
        // Walls and roof overlap: if they only touched, moonlight would leak through.
        const float innerX = kColumnX - 0.45f, outerX = kWallX + 0.4f, wallTop = kCeiling + 0.3f;
        const int side = b_.mesh("side wall", box({0.2f, wallTop / 2, kHalfLength + 0.4f}), wall_);
        const int roof = b_.mesh("aisle roof", box({(kWallX + 0.2f - innerX) / 2, 0.15f, kHalfLength + 0.2f}), dark_);
        for (const float s : {-1.f, 1.f}) {
            b_.place(side, {{s * (kWallX + 0.2f), wallTop / 2, kMiddleZ}});
            b_.place(roof, {{s * (kWallX + 0.2f + innerX) / 2, kCeiling + 0.16f, kMiddleZ}});
        }
        const int end = b_.mesh("end wall", box({outerX - 0.1f, wallTop / 2, 0.2f}), wall_);
        b_.place(end, {{0, wallTop / 2, kBackZ - 0.2f}});
        b_.place(end, {{0, wallTop / 2, kEntranceZ + 0.2f}});
        const int beam = b_.mesh("beam", roundedBox({kColumnX - 0.4f, 0.22f, 0.13f}, 0.02f, 1), dark_);
        for (int i = 0; i < 2 * kBays; ++i)
            b_.place(beam, {{0, kCeiling - 0.1f, kFrontZ - 0.5f * kBay * static_cast<float>(i)}});
    }

    void arcades() {
        ColumnShape shape;
        shape.height = kColumnHeight;
        const int column = b_.mesh("column", flutedColumn(shape), column_);
        const int arch = b_.mesh("arch", extrude(archOutline(kBay, kArcadeHeight, kBay / 2 - 0.42f), 0.7f), wall_);
        const int moulding = b_.mesh("moulding", roundedBox({0.42f, 0.06f, kHalfLength}, 0.02f, 1), column_);
        for (const float s : {-1.f, 1.f}) {
            for (int i = 0; i < kBays; ++i) {
                const float z = kFrontZ - kBay * static_cast<float>(i);
                b_.place(column, {{s * kColumnX, 0, z}});
                b_.place(arch, {{s * kColumnX, kColumnHeight, z - kBay / 2}, turnedY(90)});
            }
            b_.place(arch, {{s * kColumnX, kColumnHeight, kFrontZ + kBay / 2}, turnedY(90)});
            b_.place(moulding, {{s * kColumnX, kCeiling - 0.12f, kMiddleZ}});
        }
    }

    /// The far end: the word in ice white inside a ring of amber, slightly in front of the wall.
    void signWall() {
        const float y = 2.75f, z = kBackZ + 0.25f;
        const int ice = b_.material(emission("ice neon", kIce * 3.2f));
        const int amber = b_.material(emission("amber neon", kAmber * 3.f));
        b_.add("sign", neonText("GLINT", 0.84f, 0.045f), ice, {{0, y - 0.42f, z}});
        b_.add("ring", torus(2.25f, 0.075f, 128, 12), amber, {{0, y, z}});
        b_.add("inner ring", torus(2.08f, 0.014f, 128, 8), ice, {{0, y, z}});
        b_.add("backing", translated(cylinder(2.0f, 0.06f, 96), {0, -0.03f, 0}), black_,
               {{0, y, kBackZ + 0.06f}, glm::angleAxis(glm::half_pi<float>(), glm::vec3(1, 0, 0))});
    }

    /// Tubes of light that stand in the arches, cool on the left, warm on the right: long reflections across the nave.
    /// Two thin lines along the floor run to the sign.
    void strips() {
        const int cyan = b_.material(emission("cyan neon", kCyan * 2.4f));
        const int magenta = b_.material(emission("magenta neon", kMagenta * 2.4f));
        const int line = b_.material(emission("floor line", kWarmWhite * 2.f));
        const std::array<glm::vec3, 2> ends = {glm::vec3(0, 0.12f, 0), glm::vec3(0, 2.5f, 0)};
        const Geometry upright = tube(ends, 0.035f, 12);
        const int left = b_.mesh("cyan tube", upright, cyan), right = b_.mesh("magenta tube", upright, magenta);
        const int foot = b_.mesh("tube foot", cylinder(0.11f, 0.08f, 32), gold_);
        for (int i = 0; i < kBays; ++i) {
            const float z = kFrontZ - kBay * (static_cast<float>(i) + 0.5f);
            for (const float s : {-1.f, 1.f}) {
                b_.place(s < 0 ? left : right, {{s * kColumnX, 0, z}});
                b_.place(foot, {{s * kColumnX, 0, z}});
            }
        }
        const int edge = b_.mesh("floor line", roundedBox({0.02f, 0.02f, kHalfLength - 0.6f}, 0.008f, 1), line);
        for (const float s : {-1.f, 1.f})
            b_.place(edge, {{s * (kColumnX - 0.72f), 0.02f, kMiddleZ}});
    }

    /// Three tall panels on the entrance wall, behind the default camera, visible in the metals.
    void lanterns() {
        const int paper = b_.material(emission("lantern paper", kWarmWhite * 1.3f));
        const int panel = b_.mesh("lantern", roundedBox({0.55f, 1.5f, 0.05f}, 0.03f), paper);
        for (const float x : {-1.8f, 0.f, 1.8f})
            b_.place(panel, {{x, 2.1f, kEntranceZ - 0.1f}});
    }

    /// Six spheres in a row, from perfectly smooth to rough.
    void metals() {
        struct Kind {
            const char* name;
            glm::vec3 f0;
            float roughness;
        };
        // F0: Akenine-Moeller et al. 2018, "Real-Time Rendering", 4th edition, table 9.2 (steel: iron).
        constexpr std::array kinds = {
            Kind{"chrome", {0.549f, 0.556f, 0.554f}, 0.f},  Kind{"gold", {1, 0.782f, 0.344f}, 0.1f},
            Kind{"copper", {0.955f, 0.638f, 0.538f}, 0.2f}, Kind{"steel", {0.562f, 0.565f, 0.578f}, 0.35f},
            Kind{"gold", {1, 0.782f, 0.344f}, 0.6f},        Kind{"chrome", {0.549f, 0.556f, 0.554f}, 1.f}};
        constexpr float radius = 0.42f, plinth = 0.3f;
        const int foot = b_.mesh("plinth", roundedBox({0.4f, plinth / 2, 0.4f}, 0.015f), black_);
        for (size_t i = 0; i < kinds.size(); ++i) {
            const float t = static_cast<float>(i);
            const glm::vec3 base(-1.95f + 0.13f * t, 0, 4.3f - 2.05f * t);
            b_.place(foot, {base + glm::vec3(0, plinth / 2, 0)});
            b_.add(kinds[i].name, sphere(radius, 64, 32),
                   b_.material(metal(kinds[i].name, kinds[i].f0, kinds[i].roughness)),
                   {base + glm::vec3(0, plinth + radius, 0)});
        }
    }

    void showPieces() {
        const int pedestal = b_.mesh("pedestal", roundedBox({0.34f, 0.45f, 0.34f}, 0.02f), column_);
        const auto onPedestal = [&](const glm::vec2& xz, float degrees) {
            b_.place(pedestal, {{xz.x, 0.45f, xz.y}, turnedY(degrees)});
            return glm::vec3(xz.x, 0.9f, xz.y);
        };
        const int lacquer = b_.material(dielectric("red lacquer", glm::vec3(0.55f, 0.008f, 0.012f), 0.04f));
        b_.add("red sphere", sphere(0.36f, 64, 32), lacquer, {onPedestal({2.3f, 3.0f}, 20) + glm::vec3(0, 0.36f, 0)});
        b_.add("knot", torusKnot(2, 3, 0.4f, 0.085f), gold_, {onPedestal({2.1f, -1.9f}, -15) + glm::vec3(0, 0.3f, 0)});

        Material glass = dielectric("sea glass", glm::vec3(0.5f, 0.75f, 0.72f), 0);
        glass.transmissionFactor = 1;
        glass.ior = 1.5f;
        glass.thicknessFactor = 0.6f;
        glass.attenuationColor = {0.75f, 0.95f, 0.92f};
        glass.attenuationDistance = 0.8f;
        const int glassMaterial = b_.material(glass);
        b_.add("glass sphere", sphere(0.24f, 64, 32), glassMaterial, {{1.45f, 0.24f, 4.85f}});
        b_.add("glass block", roundedBox({0.11f, 0.32f, 0.11f}, 0.012f), glassMaterial,
               {{1.95f, 0.32f, 4.55f}, turnedY(35)});
    }

    void wallMirror() {
        const glm::vec2 half(1.25f, 1.35f);
        const Place place{{-kWallX + 0.06f, 1.85f, -2}, turnedY(90)};
        b_.add("wall mirror", box({half.x, half.y, 0.02f}), b_.material(perfectMirror("mirror glass")), place);
        b_.add("mirror frame", frame(half, 0.12f, 0.1f), gold_, place);
    }

    void lights() {
        directional("moon", kMoon, 0.9f, {-5.5f, 9, 3.5f}, {0, 0, 0});
        // Uplights at the feet of the columns, for arches and shafts.
        for (int i = 1; i < kBays - 1; ++i) {
            const float z = kFrontZ - kBay * static_cast<float>(i);
            for (const float s : {-1.f, 1.f})
                spot("uplight", kWarmWhite, 44, {s * (kColumnX - 0.75f), 0.1f, z}, {s * (kColumnX + 0.35f), 3.6f, z},
                     25, 60);
        }
        spot("metals spot", kWarmWhite, 110, {0.2f, 5.6f, 2.5f}, {-1.75f, 0.5f, 1.2f}, 12, 34);
        spot("pieces spot", kWarmWhite, 110, {0.3f, 5.6f, 3.5f}, {1.7f, 0.8f, 0.8f}, 10, 30);
        // At the foot of the wall, so that its highlight on the floor is away from the sign's reflection.
        for (const float s : {-1.f, 1.f})
            spot("sign wall wash", kAmber, 45, {s * 2.3f, 0.1f, kBackZ + 1.1f}, {s * 1.6f, 3.2f, kBackZ}, 25, 65);
        for (const float z : {2.f, -6.f}) {
            point("cyan glow", kCyan, 12, {-kColumnX - 0.15f, 1.6f, z});
            point("magenta glow", kMagenta, 12, {kColumnX + 0.15f, 1.6f, z});
        }
    }

    void directional(const char* name, const glm::vec3& color, float lux, const glm::vec3& from, const glm::vec3& to) {
        Light light;
        light.name = name;
        light.color = color;
        light.intensity = lux;
        b_.light(light, from, to);
    }

    void point(const char* name, const glm::vec3& color, float candela, const glm::vec3& at) {
        Light light;
        light.name = name;
        light.type = LightType::Point;
        light.color = color;
        light.intensity = candela;
        b_.light(light, at, at - glm::vec3(0, 1, 0));
    }

    /// Cone angles in degrees from the axis.
    void spot(const char* name, const glm::vec3& color, float candela, const glm::vec3& from, const glm::vec3& to,
              float inner, float outer) {
        Light light;
        light.name = name;
        light.type = LightType::Spot;
        light.color = color;
        light.intensity = candela;
        light.innerConeAngle = glm::radians(inner);
        light.outerConeAngle = glm::radians(outer);
        b_.light(light, from, to);
    }

    SceneBuilder b_;
    int floor_ = -1, column_ = -1, wall_ = -1, dark_ = -1, black_ = -1, gold_ = -1;
};

} // namespace

Scene makeHall() {
    return Hall().make();
}

} // namespace glint::scene::builtin
