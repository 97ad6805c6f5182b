// builtin:mirror: emissive boxes over a perfect floor mirror. One formula (mirror y, project) gives the position of
// each box's reflection, so a test knows the pixel and its correct colour.
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/scenes.hpp"
#include "lab/scene/builtin/shapes.hpp"

#include <fmt/format.h>

#include <array>

namespace glint::scene {

namespace {

// Two rows, the back one higher and in the gaps of the front one: no box occludes another or its reflection, and the
// camera sees every face that the floor shows, so screen-space tracing can hit it.
constexpr glm::vec3 kHalf(0.28f, 0.22f, 0.12f);
constexpr std::array kBoxes = {
    MirrorBox{{-1.8f, 0.7f, 0.f}, kHalf, {1, 0, 0}},     MirrorBox{{-0.6f, 0.7f, 0.f}, kHalf, {0, 1, 0}},
    MirrorBox{{0.6f, 0.7f, 0.f}, kHalf, {0, 0, 1}},      MirrorBox{{1.8f, 0.7f, 0.f}, kHalf, {1, 1, 0}},
    MirrorBox{{-1.9f, 1.1f, -2.6f}, kHalf, {1, 0, 1}},   MirrorBox{{0.f, 1.1f, -2.6f}, kHalf, {0, 1, 1}},
    MirrorBox{{1.9f, 1.1f, -2.6f}, kHalf, {1, 0.5f, 0}},
};

} // namespace

std::span<const MirrorBox> mirrorBoxes() {
    return kBoxes;
}

Scene builtin::makeMirror() {
    SceneBuilder b("builtin:mirror");
    b.camera("main", {0, 1.6f, 5}, {0, 0.3f, 0}, 45);
    b.add("floor", translated(plane({8, 8}), {0, 0, -2}), b.material(perfectMirror("floor mirror")));
    for (size_t i = 0; i < kBoxes.size(); ++i) {
        const std::string name = fmt::format("box {}", i);
        b.add(name, box(kBoxes[i].halfExtent), b.material(emission(name, kBoxes[i].color)), {kBoxes[i].center});
    }
    return b.take();
}

} // namespace glint::scene
