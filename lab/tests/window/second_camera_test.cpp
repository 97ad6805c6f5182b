// The asked ray, seen by a second camera.
#include "lab/tests/window/view_program.hpp"

#include <fstream>

namespace glint::test {
namespace second_camera_test {

TEST_F(WindowTest, ASecondCameraSeesTheRayAndTurnsByHand) {
    const auto shot = [](const std::string& name) { return "still\nquiet\nscreenshot " + name + ".png\n"; };
    std::ofstream(path("script.txt")) << "still\npicture before.png\nkey O\n" + shot("none") + "click 60 130\n" +
                                             shot("ray") + "move 10 215\n" + shot("same") +
                                             "drag 310 190 340 180\nmove 10 215\n" + shot("turned") +
                                             "picture after.png\nkey O\n" + shot("closed");
    const Ended ended = run({"view", "builtin:exact", "--size", "400x225", "--validate", "--script", "script.txt"});
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(bytes("before.png") == bytes("after.png")); // the picture itself stays where it is
    EXPECT_TRUE(bytes("none.png") != bytes("ray.png"));
    EXPECT_TRUE(bytes("ray.png") == bytes("same.png"));
    EXPECT_TRUE(bytes("ray.png") != bytes("turned.png"));
    EXPECT_TRUE(bytes("turned.png") != bytes("closed.png"));
}

} // namespace second_camera_test
} // namespace glint::test
