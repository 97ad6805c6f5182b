#include "lab/view/ray_lines.hpp"
#include "lab/view/second_camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint::view {
namespace ray_lines_test {

scene::Camera cameraAt(const glm::vec3& position, const glm::vec3& target, bool orthographic = false) {
    scene::Camera camera;
    camera.viewToWorld = scene::lookAt(position, target);
    camera.orthographic = orthographic;
    if (orthographic)
        camera.far = 100;
    return camera;
}

/// Of a pixel on the ground 2 m ahead of the eye, mirrored into what lies 2 m farther.
RayInspection someRay() {
    RayInspection ray;
    ray.pixel = {50, 80};
    ray.depth = 2;
    ray.traced = ray.answered = true;
    ray.outcome = "hit";
    ray.positionWS = ray.start.positionWS = {0, -0.5f, -2};
    ray.end.positionWS = {0, 0, -4};
    RaySample sample;
    sample.positionPX = {50.5f, 60.5f};
    sample.rayDepth = 3;
    sample.sceneDepth = 3.5f;
    sample.decision = "front";
    ray.samples = {sample};
    return ray;
}

TEST(RayLines, APointAndItsPixelAreEachOthersWay) {
    for (const bool orthographic : {false, true}) {
        const render::View view = render::makeView(cameraAt({1, 2, 3}, {-2, 0.5f, -1}, orthographic), 160, 90);
        for (const glm::vec2 px : {glm::vec2(80, 45), glm::vec2(3.5f, 71.5f), glm::vec2(159, 0)}) {
            const Seen seen = seenFrom(view, pointAt(view, px, 4));
            EXPECT_NEAR(seen.px.x, px.x, 1e-2);
            EXPECT_NEAR(seen.px.y, px.y, 1e-2);
            EXPECT_NEAR(seen.depth, 4, 1e-4);
        }
    }
}

TEST(RayLines, HaveTheRayTheSamplesAndTheFrustum) {
    const render::View view = render::makeView(cameraAt({0, 0, 0}, {0, 0, -1}), 100, 100);
    const RayLines lines = rayLines(someRay(), view);
    const auto count = [&](RayLine::Kind kind) { return std::ranges::count(lines.lines, kind, &RayLine::kind); };
    EXPECT_EQ(count(RayLine::Kind::Ray), 1);
    EXPECT_EQ(count(RayLine::Kind::Gap), 1);
    EXPECT_EQ(count(RayLine::Kind::Sight), 1);
    EXPECT_EQ(count(RayLine::Kind::Frustum), 8);
    ASSERT_EQ(lines.points.size(), 3u);
    EXPECT_NEAR(lines.points[0].positionWS.z, -3, 1e-5); // the sample, at the ray's depth
    EXPECT_EQ(lines.points[1].kind, RayPoint::Kind::Start);
    EXPECT_EQ(lines.points[2].kind, RayPoint::Kind::Answer);
    EXPECT_EQ(lines.points[2].positionWS, glm::vec3(0, 0, -4));
}

TEST(RayLines, WhatLiesBehindTheCameraIsTakenOff) {
    const render::View view = render::makeView(cameraAt({0, 0, 0}, {0, 0, -1}), 100, 100);
    glm::vec3 from(0, 0, -3), to(0, 1, 1);
    ASSERT_TRUE(clipToNear(view, 1, from, to));
    EXPECT_EQ(from, glm::vec3(0, 0, -3));
    EXPECT_NEAR(to.z, -1, 1e-5);
    EXPECT_NEAR(to.y, 0.5, 1e-5);
    glm::vec3 behind(0, 0, 1), farther(0, 0, 2);
    EXPECT_FALSE(clipToNear(view, 1, behind, farther));
}

TEST(SecondCamera, SeesTheRayFromTheSideAndFromWhereItIsFree) {
    const scene::Camera asking = cameraAt({0, 0, 0}, {0, 0, -1});
    const render::View view = render::makeView(asking, 100, 100);
    const std::vector<float> depth(100 * 100, 8.0f); // a wall
    SecondCamera second;
    second.lookAt(someRay(), view, depth, asking);
    EXPECT_TRUE(second.placed);
    EXPECT_GT(second.camera.position().z, -8);
    EXPECT_NEAR(glm::distance(second.camera.target(), glm::vec3(0, -0.25f, -3)), 0, 1e-3);
    const glm::vec3 sight = glm::normalize(second.camera.target() - second.camera.position());
    EXPECT_LT(std::abs(glm::dot(sight, glm::normalize(glm::vec3(0, 0.5f, -2)))), 0.8f);

    second.view = render::makeView(second.camera.camera(), 10, 10);
    second.depth.assign(100, 2.0f);
    EXPECT_FALSE(second.hides({5, 5}, 1.9f));
    EXPECT_FALSE(second.hides({5, 5}, 2.01f)); // a point of the surface itself
    EXPECT_TRUE(second.hides({5, 5}, 2.1f));
    EXPECT_FALSE(second.hides({-1, 5}, 9)); // nobody knows
}

} // namespace ray_lines_test
} // namespace glint::view
