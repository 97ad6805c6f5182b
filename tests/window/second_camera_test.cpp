// The asked ray, seen by a second camera.
#include "window/view_program.hpp"

#include <fstream>

namespace glint::test {
namespace {

TEST_F(WindowTest, ASecondCameraSeesTheRayAndTurnsByHand) {
    const std::string quiet = "frame 190\n"; // no message is left
    std::ofstream(path("script.txt"))
        << "still\npicture before.png\nkey O\nstill\n" + quiet + "screenshot none.png\nclick 160 200\nstill\n" + quiet +
               "screenshot ray.png\nmove 10 350\nframe 3\nscreenshot same.png\n"
               "drag 560 300 600 290\nmove 10 350\nstill\nframe 3\nscreenshot turned.png\n"
               "picture after.png\nkey O\nstill\nframe 3\nscreenshot closed.png\n";
    const Ended ended = run({"view", "builtin:exact", "--size", "640x360", "--validate", "--script", "script.txt"});
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(bytes("before.png") == bytes("after.png")); // the picture itself stays where it is
    EXPECT_TRUE(bytes("none.png") != bytes("ray.png"));
    EXPECT_TRUE(bytes("ray.png") == bytes("same.png"));
    EXPECT_TRUE(bytes("ray.png") != bytes("turned.png"));
    EXPECT_TRUE(bytes("turned.png") != bytes("closed.png"));
}

} // namespace
} // namespace glint::test
