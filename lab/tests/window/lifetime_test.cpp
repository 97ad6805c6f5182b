// How `glint view` ends, whatever ends it, and what it keeps on the way there.
#include "lab/tests/window/view_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace glint::test {
namespace lifetime_test {

using testing::HasSubstr;

/// Each resize makes everything anew that has the window's size, and is shown in three frames.
/// GLINT_RESIZES=10000 makes it ten thousand of them, which takes minutes.
TEST_F(WindowTest, ResizingLeavesMemoryAsItIs) {
    const char* const asked = std::getenv("GLINT_RESIZES");
    // Of the 100 after the first third each would leave an image of 64x48, some 200 kB with its mips, if one were kept.
    const int resizes = asked ? std::max(std::atoi(asked), 30) : 150;
    std::string script = "still\n";
    for (int i = 0; i < resizes; ++i) // the first third warms up what keeps memory for good: the driver's own caches
        script += "resize " + std::to_string(40 + i % 7) + " " + std::to_string(30 + i % 5) + "\n" +
                  (i == resizes / 3 ? "resize 43 33\nstill\nstats middle.json\n" : "");
    std::ofstream(path("script.txt")) << script << "resize 43 33\nstill\nstats end.json\nframe 16000\n";
    auto viewer = start({"view", "builtin:exact", "--size", "64x48", "--script", "script.txt"});
    ASSERT_TRUE(waitFor("middle.json", 60 + resizes * 0.1));
    const long middle = viewer->residentKilobytes();
    ASSERT_TRUE(waitFor("end.json", 60 + resizes * 0.2));
    const long end = viewer->residentKilobytes();
    const auto device = [&](const char* name) {
        return nlohmann::json::parse(bytes(name)).at("deviceBytes").get<size_t>();
    };
    std::printf("%d sizes: resident %ld kB after a third, %ld kB at the end; device %zu and %zu bytes\n", resizes,
                middle, end, device("middle.json"), device("end.json"));
    EXPECT_GT(middle, 0);
    EXPECT_LT(end, middle + 16 * 1024);
    EXPECT_EQ(device("middle.json"), device("end.json"));
}

TEST_F(WindowTest, ClosedWhileASceneIsReadItEndsWithoutAPicture) {
    auto viewer = start({"view", "builtin:hall", "--size", "320x180", "--validate"});
    ASSERT_FALSE(waitForWindow("builtin:hall").empty()); // it says "reading ..."
    EXPECT_EQ(tool({"key", "ctrl+q"}).code, 0);
    const Ended ended = viewer->wait();
    EXPECT_EQ(ended.code, 0) << ended.error;
    EXPECT_EQ(ended.error, "");
}

TEST_F(WindowTest, AWindowThatIsTakenAwayIsSaid) {
    for (const std::string how : {"windowclose", "windowkill"}) { // destroyed; its program thrown out by the server
        auto viewer = start({"view", "builtin:exact", "--size", "320x180", "--validate"});
        const std::string window = waitForWindow("builtin:exact");
        EXPECT_EQ(tool({how, window}).code, 0);
        const Ended ended = viewer->wait();
        EXPECT_EQ(ended.code, 1) << how;
        EXPECT_THAT(ended.error, HasSubstr(how == "windowclose" ? "the window is gone" : "the display is gone"));
        EXPECT_EQ(std::count(ended.error.begin(), ended.error.end(), '\n'), 1) << ended.error;
    }
}

/// Destroyed as soon as it appears: nearly always before Vulkan has a surface for it.
TEST_F(WindowTest, AWindowTakenAwayBeforeItIsDrawnIntoIsSaid) {
    auto viewer = start({"view", "builtin:exact", "--size", "320x180", "--validate"});
    // Not `search --sync`, which looks twice a second: the viewer has its surface by then.
    while (viewer->runs() &&
           tool({"search", "--onlyvisible", "--name", "Glint: builtin:exact", "windowclose"}).code != 0) {
    }
    const Ended ended = viewer->wait();
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.error, "glint: error: the window is gone: something else has destroyed it\n");
}

TEST_F(WindowTest, ADisplayThatEndsIsSaid) {
    auto viewer = start({"view", "builtin:exact", "--size", "320x180"});
    waitForWindow("builtin:exact");
    endDisplay();
    const Ended ended = viewer->wait();
    EXPECT_EQ(ended.code, 1);
    EXPECT_THAT(ended.error, HasSubstr("glint: error: the connection to the display is gone"));
    EXPECT_EQ(std::count(ended.error.begin(), ended.error.end(), '\n'), 1) << ended.error;
}

} // namespace lifetime_test
} // namespace glint::test
