// builtin:exact: all surfaces are emissive or perfect mirrors, so the correct image does not depend on a lighting
// model (docs/truth.md, "The exact picture"). There is no environment: rays that hit nothing are black.
//
// Most objects stand on the floor mirror without overhangs, so the mirror shows only surfaces that the camera sees too.
// From "front", nearly every one-bounce hit is on the screen, and an error there is the tracer's own; the other cameras
// see more hits that only world-space rays can find.
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/turned.hpp"

#include <array>
#include <string>

namespace glint::scene::builtin {

namespace {

constexpr float kSkylineZ = -5.5f;
constexpr float kSink = 0.02f; ///< metres below the floor: no face lies in the mirror's plane

// Flat colours, linear; any two differ by far more than 24/255 in sRGB, the threshold for a wrong pixel.
constexpr glm::vec3 kRed(0.85f, 0.05f, 0.04f), kOrange(0.95f, 0.32f, 0.02f), kYellow(0.95f, 0.75f, 0.05f);
constexpr glm::vec3 kLime(0.35f, 0.8f, 0.05f), kGreen(0.02f, 0.42f, 0.1f), kTeal(0.02f, 0.5f, 0.5f);
constexpr glm::vec3 kSky(0.15f, 0.55f, 1.f), kBlue(0.04f, 0.1f, 0.85f), kViolet(0.35f, 0.08f, 0.8f);
constexpr glm::vec3 kPink(1.f, 0.3f, 0.6f), kWhite(0.95f, 0.95f, 0.95f), kGrey(0.22f, 0.22f, 0.22f);
constexpr std::array kPalette = {kRed,  kSky,    kYellow, kViolet, kLime,  kPink,
                                 kBlue, kOrange, kTeal,   kWhite,  kGreen, kGrey};

class ExactScene {
public:
    ExactScene() : b_("builtin:exact") {
        for (size_t i = 0; i < kPalette.size(); ++i)
            colors_[i] = b_.material(emission("colour " + std::to_string(i), kPalette[i]));
        mirror_ = b_.material(perfectMirror("mirror"));
    }

    Scene make() {
        cameras();
        b_.add("floor", translated(plane({8, 7}), {0, 0, 0}), mirror_);
        skyline();
        boxes();
        spheres();
        silhouettes();
        poles();
        wallMirror();
        return b_.take();
    }

private:
    int color(size_t i) const { return colors_[i % colors_.size()]; }

    void cameras() {
        b_.camera("front", {0.2f, 1.3f, 6.4f}, {0, 0.62f, -2}, 45);
        b_.camera("left", {-4.2f, 1.9f, 4.6f}, {0.9f, 0.5f, -1.6f}, 45);
        b_.camera("low", {-0.9f, 0.3f, 5.6f}, {0.3f, 0.42f, -2}, 45);
        b_.camera("high", {1.2f, 4.2f, 6.2f}, {0, 0, -1.2f}, 45);
    }

    /// Towers of different heights against black: long straight silhouettes at the far end, with gaps for the star, the
    /// ring and the wall mirror.
    void skyline() {
        constexpr std::array heights = {1.1f, 0.f, 1.5f, 0.f, 1.0f, 1.8f, 2.6f, 1.3f, 2.1f, 0.9f, 1.7f, 2.3f, 0.f};
        for (size_t i = 0; i < heights.size(); ++i) {
            const float x = 0.72f * (static_cast<float>(i) - 6);
            // Storeys of different colours: a hit that is too high or too low has a wrong colour.
            const float storey = heights[i] / 4;
            if (storey == 0)
                continue;
            stand("tower", {0.36f, storey / 2, 0.15f}, color(i * 5 + 1), {x, 0, kSkylineZ});
            for (size_t k = 1; k < 4; ++k)
                b_.add("tower", box({0.36f, storey / 2, 0.15f}), color(i * 5 + 1 + 3 * k),
                       {{x, storey * (static_cast<float>(k) + 0.5f), kSkylineZ}});
        }
    }

    /// A box of one colour that stands on the floor.
    void stand(const std::string& name, const glm::vec3& half, int material, const glm::vec3& foot, float degrees = 0) {
        b_.add(name, box(half + glm::vec3(0, kSink / 2, 0)), material,
               {foot + glm::vec3(0, half.y - kSink / 2, 0), turnedY(degrees)});
    }

    /// A box with one colour per face, so that a hit on the wrong face is an error.
    int facedBox(const glm::vec3& half, size_t firstColor) {
        std::vector<std::pair<Geometry, int>> sides;
        sides.reserve(kAllSides.size());
        for (const Side side : kAllSides)
            sides.emplace_back(boxSide(half, side), color(firstColor + sides.size()));
        return b_.mesh("faced box", std::move(sides));
    }

    void boxes() {
        const auto standFaced = [&](const glm::vec3& half, size_t firstColor, const glm::vec3& foot, float degrees) {
            const int mesh = facedBox(half + glm::vec3(0, kSink / 2, 0), firstColor);
            b_.place(mesh, {foot + glm::vec3(0, half.y - kSink / 2, 0), turnedY(degrees)});
        };
        standFaced({0.4f, 0.4f, 0.4f}, 0, {-2.1f, 0, 1.2f}, 28);
        standFaced({0.3f, 0.75f, 0.3f}, 3, {1.1f, 0, -1.2f}, -35);
        standFaced({0.55f, 0.2f, 0.3f}, 6, {0.9f, 0, 1.9f}, 15);
        b_.place(facedBox({0.18f, 0.18f, 0.18f}, 8), {{-0.75f, 1.9f, -1.5f}, turnedY(40)}); // floats
    }

    /// Two near spheres are slightly sunk, with only black behind their feet; the ball and the dome are sunk to their
    /// equators, so that the camera sees all that their reflections show; one sphere floats.
    void spheres() {
        const auto add = [&](float radius, int material, const glm::vec3& center) {
            b_.add("sphere", sphere(radius, 64, 32), material, {center});
        };
        add(0.24f, color(7), {-0.66f, 0.14f, 2.5f});
        add(0.3f, color(4), {2.3f, 0.18f, 1.8f});
        add(0.6f, color(8), {-1.5f, 0, -2.2f});
        add(0.28f, color(5), {2.f, 1.5f, -2.6f});
        // Sectors: a reflection is flipped vertically, so the sectors must line up.
        constexpr int kSectors = 8;
        std::vector<std::pair<Geometry, int>> sectors;
        sectors.reserve(kSectors);
        for (int i = 0; i < kSectors; ++i)
            sectors.emplace_back(sphereSector(0.5f, 64, 32, 8 * i, 8 * i + 8), i % 2 == 0 ? color(9) : color(0));
        b_.place(b_.mesh("ball", std::move(sectors)), {{0.15f, 0, -3.4f}, turnedY(10)});
    }

    /// Shapes with edges at all angles. The crown, which has no overhang, stands near. The reflections of star, arch
    /// and ring show surfaces that the camera cannot see, so these stand in the gaps of the skyline or close to it.
    void silhouettes() {
        const std::array<glm::vec2, 9> crown = {glm::vec2(-0.6f, 0), {0.6f, 0},      {0.6f, 0.7f},
                                                {0.3f, 0.35f},       {0.15f, 0.9f},  {0.f, 0.4f},
                                                {-0.15f, 0.9f},      {-0.3f, 0.35f}, {-0.6f, 0.7f}};
        b_.add("crown", extrude(crown, 0.12f), color(2), {{0.05f, -kSink, -0.4f}, turnedY(12)});
        b_.add("star", extrude(starOutline(5, 0.6f, 0.26f), 0.1f), color(2), {{-3.6f, 0.48f, kSkylineZ}, turnedY(-6)});
        b_.add("arch", extrude(archOutline(1.5f, 1.3f, 0.55f), 0.2f), color(1), {{1.5f, -kSink, -5.1f}, turnedY(-8)});
        b_.add("ring", torus(0.44f, 0.05f, 64, 16), color(3), {{-2.16f, 0.5f, kSkylineZ}, turnedY(20)});
    }

    /// Thin objects: from about five pixels wide at 640x360 to less than one.
    void poles() {
        constexpr std::array radii = {0.04f, 0.03f, 0.02f, 0.015f, 0.01f, 0.006f};
        for (size_t i = 0; i < radii.size(); ++i) {
            const float t = static_cast<float>(i);
            b_.add("pole", cylinder(radii[i], 1.2f + 0.12f * t, 16), color(9 + 4 * i),
                   {{-2.9f + 1.05f * t, -kSink, i % 2 == 0 ? -2.6f : -0.2f}});
        }
    }

    /// A mirror that stands on the floor at the right and leans forward: most of it shows objects reflected in the
    /// floor, which takes two bounces.
    void wallMirror() {
        const glm::vec2 half(1.6f, 0.85f);
        const glm::quat leaning = glm::angleAxis(glm::radians(24.f), glm::vec3(1, 0, 0));
        const Place place{{3.86f, 0.8f, -1.6f}, turnedY(-68) * leaning};
        std::vector<std::pair<Geometry, int>> sides;
        sides.reserve(kAllSides.size());
        for (const Side side : kAllSides)
            sides.emplace_back(boxSide({half.x, half.y, 0.03f}, side), side == Side::PlusZ ? mirror_ : color(11));
        b_.place(b_.mesh("wall mirror", std::move(sides)), place);
        b_.add("mirror frame", frame(half, 0.06f, 0.1f), color(9), place);
    }

    SceneBuilder b_;
    std::array<int, kPalette.size()> colors_{};
    int mirror_ = -1;
};

} // namespace

Scene makeExact() {
    return ExactScene().make();
}

} // namespace glint::scene::builtin
