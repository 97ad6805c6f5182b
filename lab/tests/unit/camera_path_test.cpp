// Camera paths: the built-in movements around a camera, and path files.
#include "lab/scene/camera_path.hpp"

#include "base/file.hpp"
#include "lab/scene/pose.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace glint::scene {
namespace camera_path_test {

using test::must;

Camera someCamera() {
    Camera camera;
    camera.viewToWorld = lookAt({1, 2, 5}, {1, 1, 0});
    camera.fovY = glm::radians(50.0f);
    return camera;
}

glm::vec3 positionOf(const Camera& camera) {
    return glm::vec3(camera.viewToWorld[3]);
}

glm::vec3 forwardOf(const Camera& camera) {
    return -glm::vec3(camera.viewToWorld[2]);
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5f) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << " " << a.y << " " << a.z << " for " << b.x << " " << b.y << " " << b.z;
}

TEST(CameraPath, EveryMovementPassesThroughTheCamera) {
    const Camera camera = someCamera();
    for (size_t move = 0; move < cameraMoves().size(); ++move) {
        const CameraPath path = CameraPath::move(static_cast<CameraMove>(move), camera, 3, 4, 1.5);
        const Camera middle = path.at(1.5);
        expectNear(positionOf(middle), positionOf(camera));
        expectNear(forwardOf(middle), forwardOf(camera));
        const bool moves = path.at(1).viewToWorld != camera.viewToWorld;
        EXPECT_EQ(moves, static_cast<CameraMove>(move) != CameraMove::Still) << cameraMoves()[move];
    }
}

TEST(CameraPath, MovementsGoWhereTheirNamesSay) {
    const Camera camera = someCamera();
    const auto after = [&](CameraMove move) { return CameraPath::move(move, camera, 2, 4, 0).at(0.5); };
    const glm::vec3 right(camera.viewToWorld[0]);
    expectNear(positionOf(after(CameraMove::Truck)), positionOf(camera) + right);
    expectNear(positionOf(after(CameraMove::Dolly)), positionOf(camera) + glm::vec3(0, 0, -1));
    expectNear(positionOf(after(CameraMove::Pan)), positionOf(camera));
    EXPECT_GT(glm::dot(forwardOf(after(CameraMove::Pan)), right), 0.2f);
    EXPECT_NEAR(forwardOf(after(CameraMove::Pan)).y, forwardOf(camera).y, 1e-6f);
    const glm::vec3 focus = positionOf(camera) + 4.0f * forwardOf(camera);
    const Camera orbit = after(CameraMove::Orbit);
    EXPECT_GT(glm::dot(positionOf(orbit) - positionOf(camera), right), 0.5f);
    expectNear(positionOf(orbit) + 4.0f * forwardOf(orbit), focus);
}

/// At `focusSpeed`, a point at the focus moves by the pixels asked for.
TEST(CameraPath, TheSpeedIsInPixelsOfThePicture) {
    const Camera camera = someCamera();
    const double distance = 4, fps = 60, pixels = 3, height = 180;
    const double speed = focusSpeed(camera, distance, uint32_t(height), pixels, fps);
    const Camera moved = CameraPath::move(CameraMove::Truck, camera, speed, distance, 0).at(1 / fps);
    const glm::vec3 focus = positionOf(camera) + float(distance) * forwardOf(camera);
    const glm::vec3 focusVS = glm::vec3(glm::inverse(moved.viewToWorld) * glm::vec4(focus, 1));
    EXPECT_NEAR(focusVS.x / -focusVS.z / std::tan(camera.fovY / 2) * height / 2, -pixels, 1e-3);
}

TEST(CameraPath, TheFocusIsTheScenesCentreButNeverBehindTheCamera) {
    const Camera camera = someCamera();
    const Bounds ahead = {{0, 0, -1}, {2, 2, 1}};
    EXPECT_NEAR(focusDistance(camera, ahead), glm::dot(glm::vec3(0, -1, -5), forwardOf(camera)), 1e-5);
    const Bounds behind = {{0, 0, 19}, {2, 2, 21}};
    EXPECT_NEAR(focusDistance(camera, behind), std::sqrt(12.0) / 20, 1e-5);
    EXPECT_EQ(focusDistance(camera, Bounds()), 1);
}

class PathFileTest : public testing::Test {
protected:
    Result<std::vector<PathKey>> read(const std::string& text) {
        must(writeFile(file_, text));
        return readPathFile(file_);
    }
    const test::TempFolder folder_;
    const std::string file_ = folder_ + "path.json";
};

TEST_F(PathFileTest, KeysAreReachedAndBetweenThemTheMovementIsSmooth) {
    const auto keys = must(read(R"({"keys": [
        {"time": 1, "position": [0, 1, 5], "target": [0, 0, 0], "fovY": 40},
        {"time": 2, "position": [2, 1, 5], "target": [0, 1, 0], "fovY": 60},
        {"time": 4, "position": [6, 1, 5], "target": [0, 3, 0], "fovY": 60}]})"));
    const CameraPath path = must(CameraPath::through(keys, someCamera()));
    expectNear(positionOf(path.at(0)), {0, 1, 5});
    expectNear(positionOf(path.at(2)), {2, 1, 5});
    expectNear(positionOf(path.at(9)), {6, 1, 5});
    EXPECT_NEAR(path.at(1).fovY, glm::radians(40.0f), 1e-6f);
    expectNear(positionOf(path.at(1.25)), {0.5f, 1, 5}); // keys on a line at one speed: that speed all along
    expectNear(positionOf(path.at(3)), {4, 1, 5});
    const double e = 1e-3; // the same speed on both sides of a key
    const double before = path.at(2).fovY - path.at(2 - e).fovY, after = path.at(2 + e).fovY - path.at(2).fovY;
    EXPECT_NEAR(before, after, 1e-5);
    EXPECT_GT(before, 1e-5);
    expectNear(glm::normalize(glm::vec3(-2, 0, -5)), forwardOf(path.at(2)));
}

TEST_F(PathFileTest, WithoutAnglesTheCamerasLensStays) {
    const auto keys = must(read(R"({"keys": [{"time": 0, "position": [0, 1, 5], "target": [0, 0, 0]}]})"));
    Camera camera = someCamera();
    EXPECT_EQ(must(CameraPath::through(keys, camera)).at(3).fovY, camera.fovY);
    camera.orthographic = true;
    EXPECT_TRUE(CameraPath::through(keys, camera));
    std::vector<PathKey> angle = keys;
    angle[0].fovY = 1.0f;
    EXPECT_EQ(CameraPath::through(angle, camera).error().code, ErrorCode::InvalidInput);
}

TEST_F(PathFileTest, ErrorsNameTheKeyAndTheField) {
    const std::string good = R"({"time": 0, "position": [0, 1, 5], "target": [0, 0, 0]})";
    const std::pair<std::string, std::string_view> cases[] = {
        {"{", "path.json: "},
        {"[]", "must be {\"keys\": [...]}"},
        {R"({"keys": []})", "at least one key"},
        {R"({"keys": [1]})", "keys[0]: must be an object"},
        {R"({"keys": [{"time": 0, "position": [0, 1], "target": [0, 0, 0]}]})", "keys[0]: position must be three"},
        {R"({"keys": [{"time": 0, "position": [0, 1, 1e99], "target": [0, 0, 0]}]})", "keys[0]: position must be"},
        {R"({"keys": [{"time": "a", "position": [0, 1, 5], "target": [0, 0, 0]}]})", "keys[0]: time must be a number"},
        {R"({"keys": [{"time": 0, "position": [0, 0, 0], "target": [0, 0, 0]}]})", "target must differ"},
        {R"({"keys": [{"time": 0, "position": [0, 1, 5], "target": [0, 0, 0], "fovY": 180}]})", "fovY must be"},
        {R"({"keys": [{"time": 0, "position": [0, 1, 5], "target": [0, 0, 0], "fov": 40}]})", "fov is not a field"},
        {"{\"keys\": [" + good + "," + good + "]}", "keys[1]: time must be larger"},
        {"{\"keys\": [" + good + R"(,{"time": 1, "position": [0, 1, 5], "target": [0, 0, 0], "fovY": 40}]})",
         "keys[1]: either every key has fovY or none"},
    };
    for (const auto& [text, part] : cases) {
        const auto keys = read(text);
        ASSERT_FALSE(keys) << text;
        EXPECT_EQ(keys.error().code, ErrorCode::InvalidInput) << text;
        EXPECT_NE(keys.error().message.find(part), std::string::npos) << keys.error().message;
    }
    EXPECT_EQ(readPathFile(folder_ + "none.json").error().code, ErrorCode::NotFound);
}

} // namespace camera_path_test
} // namespace glint::scene
