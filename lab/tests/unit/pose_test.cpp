// Scenes at a moment: who overrides whom, what is left out, what the bounds hold.
#include "lab/scene/pose.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace glint::test {
namespace pose_test {

using scene::Scene;

/// A triangle whose one morph target lifts it by 1, drawn by node 0.
Scene morphScene() {
    Scene scene;
    scene::Primitive primitive;
    primitive.geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.geometry.normals.assign(3, {0, 0, 1});
    primitive.geometry.indices = {0, 1, 2};
    primitive.morphTargets.resize(1);
    primitive.morphTargets[0].positions.assign(3, {0, 0, 1});
    scene.meshes.push_back({"mesh", {primitive}, {0.25f}});
    scene.nodes.resize(1);
    scene.nodes[0].mesh = 0;
    scene.scenes = {{"", {0}}};
    return scene;
}

float heightOf(const Scene& scene, double time = 0) {
    const auto pose = scene::pose(scene, time);
    return pose->items.at(0).geometry->positions[0].z;
}

TEST(Pose, MorphWeightsComeFromAnimationThenNodeThenMesh) {
    Scene scene = morphScene();
    EXPECT_FLOAT_EQ(heightOf(scene), 0.25f);
    scene.nodes[0].weights = {0.5f};
    EXPECT_FLOAT_EQ(heightOf(scene), 0.5f);
    scene::AnimationChannel channel;
    channel.node = 0;
    channel.path = scene::AnimationPath::Weights;
    channel.times = {0, 1};
    channel.values = {1, 3};
    scene.animations = {{"lift", {channel}}};
    EXPECT_FLOAT_EQ(heightOf(scene, 0.5), 2);
    EXPECT_FLOAT_EQ(heightOf(scene, 100), 3);
    EXPECT_FLOAT_EQ(heightOf(scene, -100), 1);
}

TEST(Pose, ItemsKeepTheirOrderAndCountOverTime) {
    // Motion vectors pair the vertices of two poses.
    const Scene scene = morphScene();
    const auto before = scene::pose(scene, 0);
    const auto after = scene::pose(scene, 1);
    ASSERT_EQ(before->items.size(), after->items.size());
    EXPECT_EQ(before->items[0].geometry->positions.size(), after->items[0].geometry->positions.size());
}

TEST(Pose, TransformsAreInherited) {
    Scene scene = morphScene();
    scene.nodes.resize(3);
    scene.nodes[1].children = {0};
    scene.nodes[0].parent = 1;
    scene.nodes[1].translation = {1, 2, 3};
    scene.nodes[1].scale = {-2, 2, 2};
    scene.nodes[0].matrix = glm::translate(glm::mat4(1), {1, 0, 0});
    scene.scenes = {{"", {1}}, {"", {2}}};
    const auto pose = scene::pose(scene, 0);
    ASSERT_EQ(pose->items.size(), 1u);
    EXPECT_EQ(pose->items[0].localToWorld[3], glm::vec4(-1, 2, 3, 1));
    EXPECT_LT(glm::determinant(glm::mat3(pose->items[0].localToWorld)), 0) << "mirroring is the renderer's to handle";
    EXPECT_TRUE(scene::pose(scene, 0, 1)->items.empty());
}

TEST(Pose, BoundsHoldWhatIsDrawn) {
    Scene scene = morphScene();
    scene.nodes[0].translation = {10, 0, 0};
    const scene::Bounds bounds = scene::pose(scene, 0)->boundsWS;
    EXPECT_EQ(bounds.min, glm::vec3(10, 0, 0.25f));
    EXPECT_EQ(bounds.max, glm::vec3(11, 1, 0.25f));
    scene.nodes[0].mesh = -1;
    EXPECT_TRUE(scene::pose(scene, 0)->boundsWS.empty());
}

TEST(Pose, BeyondTheRangeOfAFloatNothingIsDrawn) {
    Scene scene = morphScene();
    scene.nodes.resize(3);
    for (int i = 0; i < 3; ++i)
        scene.nodes[size_t(i)].scale = glm::vec3(1e20f);
    scene.nodes[1].children = {0};
    scene.nodes[2].children = {1};
    scene.nodes[0].parent = 1;
    scene.nodes[1].parent = 2;
    scene.scenes = {{"", {2}}};
    const auto pose = scene::pose(scene, 0);
    EXPECT_TRUE(pose->items.empty());
    EXPECT_TRUE(pose->boundsWS.empty());
}

TEST(Pose, CamerasAreRigidWhateverTheScale) {
    Scene scene;
    scene::Lens lens;
    lens.aspectRatio = 1.5f;
    scene.cameras = {lens};
    scene.nodes.resize(1);
    scene.nodes[0].name = "from the side";
    scene.nodes[0].camera = 0;
    scene.nodes[0].matrix = glm::translate(glm::mat4(1), {5, 0, 0}) *
                            glm::rotate(glm::mat4(1), std::acos(0.0f), glm::vec3(0, 1, 0)) *
                            glm::scale(glm::mat4(1), {3, 2, 7});
    scene.scenes = {{"", {0}}};
    const auto pose = scene::pose(scene, 0);
    ASSERT_EQ(pose->cameras.size(), 1u);
    const scene::Camera& camera = pose->cameras[0];
    EXPECT_EQ(camera.name, "from the side");
    EXPECT_EQ(camera.aspectRatio, 1.5f);
    const glm::mat3 axes(camera.viewToWorld);
    EXPECT_NEAR(glm::determinant(axes), 1, 1e-5);
    EXPECT_NEAR(glm::distance(axes[2], glm::vec3(1, 0, 0)), 0, 1e-5); // turned to look along -X
    EXPECT_NEAR(camera.viewToWorld[3].x, 5, 1e-6);
}

TEST(Pose, UnknownScene) {
    const auto pose = scene::pose(morphScene(), 0, 1);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().code, ErrorCode::InvalidArgument);
}

} // namespace pose_test
} // namespace glint::test
