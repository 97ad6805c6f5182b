// Frustum: never hides a box that a view shows, and hides most of those that it does not.
#include "lab/renderer/frustum.hpp"

#include "lab/renderer/view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace glint::render {
namespace frustum_test {

scene::Camera cameraAt(const glm::vec3& position, const glm::vec3& target, bool orthographic) {
    scene::Camera camera;
    camera.orthographic = orthographic;
    camera.orthoHeight = 6;
    camera.near = 0.1f;
    camera.far = orthographic ? 100 : camera.far;
    camera.viewToWorld = scene::lookAt(position, target);
    return camera;
}

bool shows(const View& view, const glm::vec3& positionWS) {
    const glm::vec4 clip = view.worldToClip * glm::vec4(positionWS, 1);
    return std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z <= clip.w;
}

TEST(Frustum, ShowsEveryBoxOfWhichAPointIsInView) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-20, 20), half(0.01f, 3), unit(0, 1);
    for (const bool orthographic : {false, true}) {
        const View view = makeView(cameraAt({1, 2, 3}, {-4, 0, -9}, orthographic), 320, 180, {0.4f, -0.3f});
        const Frustum frustum(view.worldToClip);
        int seen = 0, hidden = 0, inVain = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::vec3 center(place(random), place(random), place(random));
            const glm::vec3 extent(half(random), half(random), half(random));
            const scene::Bounds box = {center - extent, center + extent};
            bool isSeen = false;
            for (int k = 0; k < 300 && !isSeen; ++k)
                isSeen = shows(view, glm::mix(box.min, box.max, glm::vec3(unit(random), unit(random), unit(random))));
            EXPECT_TRUE(!isSeen || frustum.mayShow(box)) << i;
            seen += isSeen;
            hidden += !frustum.mayShow(box);
            inVain += !isSeen && frustum.mayShow(box);
        }
        EXPECT_GT(seen, 100) << orthographic;
        EXPECT_GT(hidden, 2000) << orthographic;
        EXPECT_LT(inVain, 200) << orthographic; // beyond an edge or a corner of the view
    }
}

TEST(Frustum, HidesNothingThatIsNotANumber) {
    const Frustum frustum(makeView(cameraAt({0, 0, 5}, {0, 0, 0}, false), 64, 64).worldToClip);
    scene::Bounds box;
    box.min = box.max = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(frustum.mayShow(box));
}

} // namespace frustum_test
} // namespace glint::render
