// Which object a click in a window means.
#include "lab/scene/pick.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace glint::scene {
namespace pick_test {

class PickTest : public testing::Test {
protected:
    PickTest() {
        triangle_.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
        triangle_.indices = {0, 1, 2};
    }
    void add(const glm::mat4& localToWorld) {
        DrawItem item;
        item.geometry = &triangle_;
        item.localToWorld = localToWorld;
        pose_.items.push_back(item);
    }
    std::optional<size_t> ahead(float x, float y) const { return pickItem(pose_, {x, y, 10}, {0, 0, -1}); }

    Geometry triangle_;
    Pose pose_;
};

TEST_F(PickTest, TheNearestSurfaceCountsWhateverItsScale) {
    add(glm::translate(glm::mat4(1), glm::vec3(0, 0, -5)));
    add(glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, 0, 2)), glm::vec3(0.5f, 0.5f, 3)));
    EXPECT_EQ(ahead(0, 0), std::optional<size_t>(1));
    EXPECT_EQ(ahead(0, -0.9f), std::optional<size_t>(0)) << "beside the nearer one, which is half as large";
    EXPECT_EQ(ahead(2, 0), std::nullopt);
    EXPECT_EQ(pickItem(pose_, {0, 0, -1}, {0, 0, -1}), std::optional<size_t>(0)) << "not what is behind";
    EXPECT_EQ(pickItem(pose_, {0, 0, -10}, {0, 0, 1}), std::optional<size_t>(0)) << "from its back, too";
}

TEST_F(PickTest, LinesAreNotPicked) {
    triangle_.topology = Topology::Lines;
    add(glm::mat4(1));
    EXPECT_EQ(ahead(0, 0), std::nullopt);
}

TEST_F(PickTest, RaysGoThroughThePointOfTheImage) {
    Camera camera;
    camera.viewToWorld = lookAt({1, 2, 3}, {1, 2, -3});
    camera.fovY = glm::radians(90.0f);
    const CameraRay middle = cameraRay(camera, {0.5f, 0.5f}, 2);
    EXPECT_EQ(middle.originWS, glm::vec3(1, 2, 3));
    EXPECT_NEAR(glm::distance(middle.directionWS, glm::vec3(0, 0, -1)), 0, 1e-6);
    const CameraRay corner = cameraRay(camera, {0, 0}, 2);
    EXPECT_NEAR(glm::distance(corner.directionWS, glm::normalize(glm::vec3(-2, 1, -1))), 0, 1e-6);
    camera.orthographic = true;
    camera.orthoHeight = 4;
    const CameraRay parallel = cameraRay(camera, {1, 1}, 2);
    EXPECT_NEAR(glm::distance(parallel.originWS, glm::vec3(5, 0, 3)), 0, 1e-6);
    EXPECT_NEAR(glm::distance(parallel.directionWS, glm::vec3(0, 0, -1)), 0, 1e-6);
}

} // namespace pick_test
} // namespace glint::scene
