// Camera files, looking at points, framing boxes.
#include "lab/scene/camera.hpp"

#include "lab/scene/pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace glint::test {
namespace camera_test {

using scene::Bounds;
using scene::Camera;
using testing::HasSubstr;

Result<Camera> readText(const std::string& text) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "glint-camera-test.json";
    std::ofstream(path) << text;
    auto camera = scene::readCameraFile(path.string());
    std::filesystem::remove(path);
    return camera;
}

std::string errorOf(const std::string& text) {
    const auto camera = readText(text);
    return camera ? "read without error" : camera.error().message;
}

TEST(CameraFile, Perspective) {
    const auto camera =
        readText(R"({"position":[0,1,5],"target":[0,1,0],"fovY":90,"width":640,"height":320,"near":0.5})");
    ASSERT_TRUE(camera) << camera.error().message;
    EXPECT_NEAR(camera->fovY, std::acos(0.0), 1e-6);
    EXPECT_EQ(camera->width, 640);
    EXPECT_EQ(camera->height, 320);
    EXPECT_EQ(camera->aspectRatio, 2);
    EXPECT_EQ(camera->near, 0.5f);
    EXPECT_TRUE(std::isinf(camera->far));
    EXPECT_EQ(camera->viewToWorld[3], glm::vec4(0, 1, 5, 1));
    EXPECT_FALSE(camera->orthographic);
}

TEST(CameraFile, Orthographic) {
    const auto camera = readText(R"({"position":[0,9,0],"target":[0,0,0],"orthoHeight":4})");
    ASSERT_TRUE(camera) << camera.error().message;
    EXPECT_TRUE(camera->orthographic);
    EXPECT_EQ(camera->orthoHeight, 4);
    EXPECT_TRUE(std::isfinite(camera->far));
}

TEST(CameraFile, MistakesNameTheKeyAndItsLine) {
    EXPECT_THAT(errorOf("{\"position\":[0,0,1],\n \"target\":[0,0,0],\n \"fovY\": 190}"),
                HasSubstr("camera-test.json:3: fovY must be a number between"));
    EXPECT_THAT(errorOf("{\"position\":[0,0],\n\"target\":[0,0,0],\"fovY\":40}"),
                HasSubstr(".json:1: position must be three"));
    EXPECT_THAT(errorOf(R"({"target":[0,0,0],"fovY":40})"), HasSubstr(".json: position must be three numbers"));
    EXPECT_THAT(errorOf(R"({"position":[0,0,0],"target":[0,0,0],"fovY":40})"),
                HasSubstr("target must differ from position"));
    EXPECT_THAT(errorOf(R"({"position":[0,0,1],"target":[0,0,0]})"), HasSubstr("fovY or orthoHeight must be given"));
    EXPECT_THAT(errorOf(R"({"position":[0,0,1],"target":[0,0,0],"fovY":40,"orthoHeight":1})"),
                HasSubstr("and not both"));
    EXPECT_THAT(errorOf(R"({"position":[0,0,1],"target":[0,0,0],"fov":40})"),
                HasSubstr("fov is not a key of camera files"));
    EXPECT_THAT(errorOf(R"({"position":[0,0,1],"target":[0,0,0],"fovY":40,"near":2,"far":1})"),
                HasSubstr("far must be larger"));
    EXPECT_THAT(errorOf(R"({"position":[0,0,1],"target":[0,0,0],"fovY":40,"width":0})"),
                HasSubstr("width must be a number"));
    EXPECT_THAT(errorOf("{\n\"position\": }"), HasSubstr("line 2"));
    EXPECT_THAT(errorOf("[]"), HasSubstr("must be one JSON object"));
    EXPECT_THAT(errorOf(""), HasSubstr("is empty"));
    EXPECT_EQ(scene::readCameraFile("/nowhere/a.json").error().code, ErrorCode::NotFound);
}

TEST(LookAt, IsRigidAndLooksThere) {
    const glm::vec3 positions[] = {{3, 4, 5}, {0, 9, 0}, {0, -9, 0}, {-1, 0, 0}};
    for (const glm::vec3& position : positions) {
        const glm::mat4 viewToWorld = scene::lookAt(position, glm::vec3(0));
        const glm::mat3 axes(viewToWorld);
        EXPECT_NEAR(glm::determinant(axes), 1, 1e-5);
        EXPECT_NEAR(glm::length(axes[0]), 1, 1e-5);
        EXPECT_NEAR(glm::distance(-axes[2], glm::normalize(-position)), 0, 1e-5);
        EXPECT_GE(axes[1].y, -1e-5f) << "not upside down";
    }
    EXPECT_NEAR(scene::lookAt({0, 9, 0}, glm::vec3(0))[1].z, -1, 1e-5) << "from above, -Z is up";
}

void expectFits(const Bounds& bounds, float aspectRatio) {
    const Camera camera = scene::frameBounds(bounds, aspectRatio);
    const glm::mat4 worldToView = glm::inverse(camera.viewToWorld);
    const float tanY = std::tan(camera.fovY / 2);
    float widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 point(corner & 1 ? bounds.max.x : bounds.min.x, corner & 2 ? bounds.max.y : bounds.min.y,
                              corner & 4 ? bounds.max.z : bounds.min.z, 1);
        const glm::vec4 view = worldToView * point;
        ASSERT_GT(-view.z, camera.near);
        const float x = std::abs(view.x / view.z) / (tanY * aspectRatio);
        const float y = std::abs(view.y / view.z) / tanY;
        widest = std::max({widest, x, y});
    }
    EXPECT_LE(widest, 1.0f);
    EXPECT_GT(widest, 0.9f) << "the box should fill the picture";
    EXPECT_GT(camera.viewToWorld[3].z, (bounds.min.z + bounds.max.z) / 2) << "from the front, +Z";
    EXPECT_GT(camera.viewToWorld[3].y, (bounds.min.y + bounds.max.y) / 2) << "from above";
}

TEST(FrameBounds, EveryCornerFits) {
    for (const float aspectRatio : {0.5f, 1.0f, 16.0f / 9}) {
        expectFits({glm::vec3(-1), glm::vec3(1)}, aspectRatio);
        expectFits({{100, 100, 100}, {100.5f, 120, 101}}, aspectRatio);
        expectFits({{-1e-4f, 0, -1e-4f}, {1e-4f, 1e-5f, 1e-4f}}, aspectRatio);
        expectFits({{-5000, -1, -20}, {5000, 300, 20}}, aspectRatio);
        expectFits({{-1, 0, -1}, {1, 0, 1}}, aspectRatio);
    }
}

TEST(FrameBounds, NothingAndOnePoint) {
    for (const Bounds& bounds : {Bounds(), Bounds{glm::vec3(3), glm::vec3(3)}}) {
        const Camera camera = scene::frameBounds(bounds, 1);
        EXPECT_GT(camera.near, 0);
        EXPECT_TRUE(std::isfinite(camera.viewToWorld[3].z));
        EXPECT_NEAR(glm::determinant(glm::mat3(camera.viewToWorld)), 1, 1e-5);
    }
}

} // namespace camera_test
} // namespace glint::test
