// builtin:motion and its variants: the test track for moving pictures (docs/motion.md). A floor in strips of roughness
// lies before a chequered wall, and each variant adds one thing that moves, so that a figure has one cause. The
// movement is the scene's own animation, eight seconds of it.
//
// Only floor, spheres and panels reflect: everything else has F0 = 0, so that figures count reflections of moving
// objects and not the objects.
#include "lab/scene/builtin/noise.hpp"
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/textures.hpp"
#include "lab/scene/builtin/turned.hpp"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <array>
#include <functional>

namespace glint::scene::builtin {

namespace {

constexpr std::array kStrips = {0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.8f}; ///< perceptual roughness, from left to right
constexpr float kStripWidth = 1;                                      // metres
constexpr float kWallZ = -3, kFrontZ = 4.2f;
constexpr float kSeconds = 8;
constexpr int kKeysPerSecond = 30;
constexpr glm::vec2 kPanelHalf(0.5f, 0.36f); // metres
constexpr float kTurn = 2 * glm::pi<float>();

Material dull(std::string name, const glm::vec3& albedo) {
    Material m = dielectric(std::move(name), albedo, 0.9f);
    m.specularFactor = 0;
    return m;
}

/// A vertical tube around its own centre.
Geometry rod(float radius, float height, int columns) {
    return translated(cylinder(radius, height, columns), {0, -height / 2, 0});
}

/// Samples a movement of period `seconds` evenly, from 0 to kSeconds.
AnimationChannel moving(int node, AnimationPath path, float seconds,
                        const std::function<std::vector<float>(float phase)>& at) {
    AnimationChannel channel;
    channel.node = node;
    channel.path = path;
    constexpr int kKeys = static_cast<int>(kSeconds) * kKeysPerSecond;
    for (int i = 0; i <= kKeys; ++i) {
        const float time = static_cast<float>(i) / kKeysPerSecond;
        channel.times.push_back(time);
        for (const float value : at(time / seconds * kTurn))
            channel.values.push_back(value);
    }
    return channel;
}

std::vector<float> rotationY(float radians) {
    return {0, std::sin(radians / 2), 0, std::cos(radians / 2)};
}

class Motion {
public:
    Motion(std::string name, const MotionParts& parts) : b_(std::move(name)), parts_(parts) {}

    Scene make() {
        b_.camera("main", {0, 1.25f, 4.6f}, {0, 0.1f, 1.4f}, 45);
        b_.camera("low", {-1.2f, 0.5f, 3.6f}, {0.2f, 0.3f, 0}, 45);
        floor();
        room();
        spheres();
        if (parts_.objects)
            objects();
        if (parts_.hidden)
            hidden();
        if (parts_.lamp)
            lamp();
        if (parts_.grille)
            grille();
        if (parts_.panels)
            panels();
        if (parts_.emitters)
            emitters();
        return b_.take();
    }

private:
    /// Each strip is metal on its left half and a dark dielectric on its right half.
    void floor() {
        TextureSlot bumps;
        if (parts_.bumpyFloor)
            bumps = b_.texture(ripples("floor ripples", 0.004f));
        const float centerZ = (kWallZ + kFrontZ) / 2, halfLength = (kFrontZ - kWallZ) / 2;
        for (size_t i = 0; i < kStrips.size(); ++i) {
            const float left = kStripWidth * (static_cast<float>(i) - static_cast<float>(kStrips.size()) / 2);
            std::array halves = {metal(fmt::format("floor {} metal", kStrips[i]), glm::vec3(0.85f), kStrips[i]),
                                 dielectric(fmt::format("floor {} glaze", kStrips[i]), glm::vec3(0.08f), kStrips[i])};
            for (size_t half = 0; half < halves.size(); ++half) {
                halves[half].normalTexture = bumps;
                const float x = left + kStripWidth * (0.25f + 0.5f * static_cast<float>(half));
                b_.add(halves[half].name, plane({kStripWidth / 4, halfLength}), b_.material(halves[half]),
                       {{x, 0, centerZ}});
            }
        }
    }

    void room() {
        Material wall = dull("wall", glm::vec3(1));
        wall.baseColorTexture =
            b_.texture(checker("wall", 256, 4, {0.55f, 0.5f, 0.42f}, {0.12f, 0.16f, 0.22f}), glm::vec2(0.8f));
        b_.add("wall", boxSide({4, 1.2f, 0}, Side::PlusZ), b_.material(wall), {{0, 1.2f, kWallZ}});
        const int thin = b_.material(emission("thin lamp", {9, 7, 4}));
        b_.add("thin lamp", rod(0.015f, 1.3f, 12), thin, {{-2.75f, 0.75f, -1}});
        const int strip = b_.material(emission("wall strip", {0.8f, 2.2f, 4}));
        b_.add("wall strip", box({2.6f, 0.012f, 0.012f}), strip, {{0, 1.05f, kWallZ + 0.05f}});
        Light sun;
        sun.name = "sun";
        sun.color = {1, 0.95f, 0.88f};
        sun.intensity = 1.6f; // lux, in the scene's scale: white paper in the sun has about 0.5
        b_.light(sun, {-4, 5, 4}, {0, 0, 0});
    }

    void spheres() {
        b_.add("mirror ball", sphere(0.38f, 96, 48), b_.material(metal("mirror ball", glm::vec3(0.9f), 0.02f)),
               {{-1.4f, 0.38f, -1.1f}});
        b_.add("gold ball", sphere(0.38f, 96, 48), b_.material(metal("gold ball", {0.95f, 0.64f, 0.25f}, 0.25f)),
               {{0, 0.38f, -1.1f}});
        b_.add("red ball", sphere(0.38f, 96, 48), b_.material(dull("red ball", {0.7f, 0.06f, 0.04f})),
               {{1.4f, 0.38f, -1.1f}});
    }

    void objects() {
        const int ball = b_.add("moving ball", sphere(0.25f), b_.material(emission("moving ball", {2.4f, 1.9f, 0.5f})));
        b_.animate(moving(ball, AnimationPath::Translation, 4, [](float phase) {
            return std::vector{2 * std::sin(phase), 0.4f, 0.35f};
        }));
        Material paint = dull("moving box", glm::vec3(1));
        paint.baseColorTexture =
            b_.texture(checker("box", 128, 4, {0.9f, 0.9f, 0.85f}, {0.02f, 0.25f, 0.08f}), glm::vec2(3));
        const int box = b_.add("moving box", builtin::box(glm::vec3(0.22f)), b_.material(paint));
        b_.animate(moving(box, AnimationPath::Translation, 4, [](float phase) {
            return std::vector{-2 * std::sin(phase), 0.34f, -0.35f};
        }));
        b_.animate(moving(box, AnimationPath::Rotation, 8, rotationY));
    }

    /// Above what the default camera sees.
    void hidden() {
        const int ball = b_.add("hidden ball", sphere(0.3f), b_.material(emission("hidden ball", {0.6f, 3, 1.2f})));
        b_.animate(moving(ball, AnimationPath::Translation, 4, [](float phase) {
            return std::vector{2 * std::sin(phase), 2.1f, -1.5f};
        }));
    }

    /// A tube over all strips. glTF cannot animate light. A shell of light shrinks into a dark lamp instead: nothing
    /// else changes, and nothing moves by more than the lamp's radius. At 60 frames per second it goes off at frame 32,
    /// on at 64, and changes every 15 frames from then on.
    void lamp() {
        const Place across = {{0, 0.55f, -1.9f}, glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 0, 1))};
        b_.add("lamp", rod(0.04f, 5.3f, 24), b_.material(dull("lamp", glm::vec3(0.1f))), across);
        const int shell =
            b_.add("lamp light", rod(0.05f, 5.4f, 24), b_.material(emission("lamp light", {9, 4, 2})), across);
        AnimationChannel channel;
        channel.node = shell;
        channel.path = AnimationPath::Scale;
        channel.interpolation = Interpolation::Step;
        const auto change = [&](float frame, bool on) {
            channel.times.push_back(frame > 0 ? (frame - 0.5f) / 60 : 0); // between frames, whatever the rounding
            channel.values.insert(channel.values.end(), 3, on ? 1.0f : 0.5f);
        };
        change(0, true);
        change(32, false);
        bool on = true;
        for (float frame = 64; frame < kSeconds * 60; frame += 15, on = !on)
            change(frame, on);
        b_.animate(std::move(channel));
    }

    void grille() {
        const int iron = b_.material(dull("iron", glm::vec3(0.06f)));
        const int pole = b_.mesh("pole", rod(0.02f, 1.2f, 12), iron);
        for (const float x : {-1.9f, -1.3f, -0.7f})
            b_.place(pole, {{x, 0.6f, 1.2f}});
        const int bar = b_.mesh("bar", rod(0.008f, 0.8f, 8), iron);
        for (int i = 0; i < 12; ++i)
            b_.place(bar, {{0.9f + 0.07f * static_cast<float>(i), 0.45f, 1.2f}});
        for (const float y : {0.07f, 0.83f})
            b_.add("rail", box({0.42f, 0.012f, 0.012f}), iron, {{1.285f, y, 1.2f}});
        Material green = dull("leaf", {0.08f, 0.4f, 0.05f});
        green.doubleSided = true;
        const int leaf = b_.mesh("leaf", plane({0.05f, 0.025f}), b_.material(green));
        constexpr uint32_t kLeaves = 40;
        for (uint32_t i = 0; i < kLeaves; ++i) {
            const auto any = [&](uint32_t k) { return hashUnit(i, k, 71) - 0.5f; };
            b_.place(leaf, {{-1.3f + 0.5f * any(0), 0.7f + 0.8f * any(1), 1.2f + 0.4f * any(2)},
                            glm::normalize(glm::quat(any(3), any(4), any(5), any(6)))});
        }
    }

    /// Above the spheres. What they reflect stands behind the camera: posts of light.
    void panels() {
        const Geometry flat = boxSide({kPanelHalf, 0}, Side::PlusZ);
        Material bumpy = metal("bumpy panel", glm::vec3(0.9f), 0.05f);
        bumpy.normalTexture = b_.texture(ripples("panel ripples", 0.012f), glm::vec2(2));
        const std::array<std::pair<Geometry, int>, 5> panels = {{
            {flat, b_.material(metal("mirror panel", glm::vec3(0.9f), 0.02f))},
            {flat, b_.material(metal("glossy panel", glm::vec3(0.9f), 0.2f))},
            {flat, b_.material(bumpy)},
            {curvedPanel(1.2f), b_.material(metal("convex panel", glm::vec3(0.9f), 0.05f))},
            {curvedPanel(-1.2f), b_.material(metal("concave panel", glm::vec3(0.9f), 0.05f))},
        }};
        for (size_t i = 0; i < panels.size(); ++i) {
            const float x = 1.15f * (static_cast<float>(i) - 2);
            const int node = b_.add("panel", panels[i].first, panels[i].second, {{x, 1.16f, -2}});
            b_.animate(moving(node, AnimationPath::Rotation, 4,
                              [](float phase) { return rotationY(0.35f * std::sin(phase)); }));
        }
        const std::array posts = {
            b_.mesh("post", rod(0.15f, 2.4f, 16), b_.material(emission("warm post", {2, 0.9f, 0.2f}))),
            b_.mesh("post", rod(0.15f, 2.4f, 16), b_.material(emission("cool post", {0.2f, 0.7f, 2})))};
        for (size_t i = 0; i < 13; ++i)
            b_.place(posts[i % 2], {{static_cast<float>(i) - 6, 1.2f, 5.6f}});
    }

    /// A part of an upright cylinder that faces +Z: convex for a positive radius, concave for a negative one.
    static Geometry curvedPanel(float radius) {
        Geometry panel = lattice(32, 1, [&](int column, int row) {
            const float x = kPanelHalf.x * (static_cast<float>(column) / 16 - 1);
            const float sine = x / radius, cosine = std::sqrt(1 - sine * sine);
            const float y = row == 0 ? -kPanelHalf.y : kPanelHalf.y;
            return SurfacePoint{{x, y, radius * (cosine - 1)}, {sine, 0, cosine}, {x, -y}};
        });
        computeTangents(panel);
        return panel;
    }

    /// One to four pixels each at 640 x 360.
    void emitters() {
        constexpr std::array<glm::vec3, 3> kColors = {glm::vec3(1000, 700, 300), {300, 800, 1000}, {1000, 250, 500}};
        for (int i = 0; i < 6; ++i) {
            const auto k = static_cast<float>(i);
            const int material =
                b_.material(emission(fmt::format("emitter {}", i), kColors[static_cast<size_t>(i) % kColors.size()]));
            const int node = b_.add("emitter", sphere(0.008f, 12, 6), material);
            b_.animate(moving(node, AnimationPath::Translation, 8, [&](float phase) {
                return std::vector{-2.5f + k + 0.4f * std::sin(2 * phase + k),
                                   0.35f + 0.2f * std::sin(3 * phase + 2 * k),
                                   0.4f + 0.7f * std::cos(phase + 1.7f * k)};
            }));
        }
    }

    /// A normal map of soft bumps. `depth` as for normalMap.
    static Image ripples(const std::string& name, float depth) {
        constexpr int kSize = 256;
        std::vector<float> heights;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                heights.push_back(fractalNoise(glm::vec2(x, y) * (8.0f / kSize), 8, 5, 2));
        return normalMap(name, heights, kSize, depth);
    }

    SceneBuilder b_;
    MotionParts parts_;
};

} // namespace

Scene makeMotion(std::string name, const MotionParts& parts) {
    return Motion(std::move(name), parts).make();
}

} // namespace glint::scene::builtin
