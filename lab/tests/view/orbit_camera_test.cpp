#include "lab/view/canvas.hpp"
#include "lab/view/orbit_camera.hpp"

#include "base/file.hpp"
#include "tests/support/temp_folder.hpp"

#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>

namespace glint::view {
namespace orbit_camera_test {

scene::Camera cameraAt(const glm::vec3& position, const glm::vec3& target) {
    scene::Camera camera;
    camera.viewToWorld = scene::lookAt(position, target);
    return camera;
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-4f) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << " " << a.y << " " << a.z << ", expected " << b.x << " " << b.y << " " << b.z;
}

void expectRigid(const glm::mat4& matrix) {
    const glm::mat3 axes(matrix);
    const glm::mat3 product = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-5);
    EXPECT_NEAR(glm::determinant(axes), 1, 1e-5);
}

TEST(OrbitCamera, ShowsTheScenesCameraUntouched) {
    scene::Camera rolled = cameraAt({1, 2, 3}, {0, 0, 0});
    std::swap(rolled.viewToWorld[0], rolled.viewToWorld[1]);
    rolled.viewToWorld[0] = -rolled.viewToWorld[0];
    const OrbitCamera camera(rolled, 4);
    EXPECT_EQ(camera.camera().viewToWorld, rolled.viewToWorld);
    EXPECT_FALSE(camera.moved());
    EXPECT_NEAR(camera.distance(), 4, 1e-5);
}

TEST(OrbitCamera, TurnsAboutItsTargetWithTheHand) {
    OrbitCamera camera(cameraAt({0, 0, 5}, {0, 0, 0}), 5);
    camera.orbit(glm::half_pi<float>(), 0); // the side that faced us goes right: we see the left one
    expectNear(camera.position(), {-5, 0, 0});
    expectNear(camera.target(), {0, 0, 0});
    camera.orbit(0, -0.5f); // pulled down: from above
    EXPECT_GT(camera.position().y, 1);
    EXPECT_NEAR(camera.distance(), 5, 1e-4);
    expectRigid(camera.camera().viewToWorld);
    EXPECT_TRUE(camera.moved());
}

TEST(OrbitCamera, StopsShortOfThePoles) {
    OrbitCamera camera(cameraAt({0, 0, 5}, {0, 0, 0}), 5);
    for (int i = 0; i < 20; ++i)
        camera.orbit(0.1f, -0.5f);
    expectRigid(camera.camera().viewToWorld);
    EXPECT_LT(camera.position().y, 5);
    EXPECT_GT(camera.position().y, 4.9f);
}

TEST(OrbitCamera, PansByThePicturesHeight) {
    scene::Camera lens = cameraAt({0, 0, 2}, {0, 0, 0});
    lens.fovY = glm::half_pi<float>(); // at distance 2 the picture is 4 metres high
    OrbitCamera camera(lens, 2);
    camera.pan(0.5f, -0.25f);
    expectNear(camera.position(), {2, -1, 2});
    expectNear(camera.target(), {2, -1, 0});
}

TEST(OrbitCamera, ComesCloserButNeverThrough) {
    OrbitCamera camera(cameraAt({0, 0, 5}, {0, 0, 0}), 5);
    camera.dolly(0.5f);
    expectNear(camera.position(), {0, 0, 2.5f});
    for (int i = 0; i < 200; ++i)
        camera.dolly(0.5f);
    EXPECT_GT(camera.position().z, 0);
    expectRigid(camera.camera().viewToWorld);
}

TEST(OrbitCamera, FliesInItsOwnAxes) {
    OrbitCamera camera(cameraAt({0, 0, 0}, {1, 0, 0}), 3);
    camera.fly({0, 0, 2});
    expectNear(camera.position(), {2, 0, 0});
    camera.fly({1, 0.5f, 0});
    expectNear(camera.position(), {2, 0.5f, 1});
    EXPECT_NEAR(camera.distance(), 3, 1e-4);
}

TEST(OrbitCamera, LooksAroundFromItsPlace) {
    OrbitCamera camera(cameraAt({1, 1, 1}, {1, 1, 0}), 1);
    camera.look(glm::half_pi<float>(), 0);
    expectNear(camera.position(), {1, 1, 1});
    expectNear(camera.target(), {2, 1, 1});
}

TEST(OrbitCamera, FocusTurnsToThePoint) {
    OrbitCamera camera(cameraAt({0, 0, 5}, {0, 0, 0}), 5);
    camera.focus({3, 0, 0});
    expectNear(camera.target(), {3, 0, 0});
    expectNear(glm::normalize(camera.target() - camera.position()), -glm::vec3(camera.camera().viewToWorld[2]));
    camera.focus(camera.position()); // nowhere to turn to
    expectRigid(camera.camera().viewToWorld);
}

TEST(OrbitCamera, IsWhatItsFileSays) {
    const test::TempFolder folder;
    const std::string path = folder + "view.camera.json";
    OrbitCamera camera(cameraAt({0.1f, 1.7f, 5.3f}, {0, 0.3f, 0}), 5);
    camera.orbit(0.37f, 0.21f);
    ASSERT_TRUE(writeFile(path, camera.json(320, 180)));
    const auto read = scene::readCameraFile(path);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->width, 320);
    EXPECT_EQ(read->viewToWorld, camera.camera().viewToWorld); // to the bit
    camera.settle(*read);
    EXPECT_EQ(camera.camera().fovY, read->fovY);
    EXPECT_TRUE(camera.moved());
}

TEST(Canvas, ZoomKeepsThePointUnderTheMouse) {
    Zoom zoom;
    const glm::uvec2 window(400, 200);
    const glm::vec2 mouse(300, 50);
    const glm::vec2 before = makeCanvas(zoom, window).toUV(mouse);
    zoom = zoomed(zoom, window, mouse, 8);
    const glm::vec2 after = makeCanvas(zoom, window).toUV(mouse);
    EXPECT_NEAR(after.x, before.x, 1e-5);
    EXPECT_NEAR(after.y, before.y, 1e-5);
    const glm::vec2 back = makeCanvas(zoom, window).toPX(before);
    EXPECT_NEAR(back.x, mouse.x, 1e-2);
    EXPECT_NEAR(zoomed(zoom, window, mouse, 1e9f).factor, 256, 0);
    EXPECT_NEAR(zoomed(zoom, window, mouse, 1e-9f).factor, 1, 0);
}

TEST(Canvas, NeverLeavesThePicture) {
    const Canvas canvas = makeCanvas({4, glm::vec2(2, -1)}, {100, 100});
    EXPECT_LE(canvas.highUV.x, 1);
    EXPECT_GE(canvas.lowUV.y, 0);
}

} // namespace orbit_camera_test
} // namespace glint::view
