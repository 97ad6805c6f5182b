#include "lab/view/input_script.hpp"
#include "lab/view/script_player.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <gtest/gtest.h>

namespace glint::view {
namespace input_script_test {

std::string errorOf(std::string_view text) {
    const auto steps = readScript(text, "test.txt");
    return steps ? "read without error" : steps.error().message;
}

TEST(InputScript, ReadsWhatTheManualLists) {
    const auto steps = readScript("# people\n\nframe 3\nkey Ctrl+Shift+P\nclick 10 20\ntype reflect min\n"
                                  "resize 17 9\r\n  drop broken file.glb\nscreenshot a.png\ndrag 1 2 3 4 right\nclose",
                                  "test.txt");
    ASSERT_TRUE(steps) << steps.error().message;
    ASSERT_EQ(steps->size(), 9u);
    EXPECT_EQ((*steps)[0].numbers, std::vector<int>{3});
    EXPECT_EQ((*steps)[0].line, 3);
    EXPECT_EQ((*steps)[1].stroke.key, GLFW_KEY_P);
    EXPECT_EQ((*steps)[1].stroke.modifiers, (Modifiers{true, true, false}));
    EXPECT_EQ((*steps)[3].text, "reflect min");
    EXPECT_EQ((*steps)[4].numbers, (std::vector<int>{17, 9}));
    EXPECT_EQ((*steps)[5].text, "broken file.glb");
    EXPECT_EQ((*steps)[7].text, "right");
}

TEST(InputScript, SaysWhereAndWhat) {
    EXPECT_EQ(errorOf("frame 1\nkey Foo\n").substr(0, 26), "test.txt:2: 'Foo' is no ke");
    EXPECT_EQ(errorOf("click 10"), "test.txt:1: expected `click X Y`, got `click 10`");
    EXPECT_EQ(errorOf("click 10 20 30"), "test.txt:1: expected `click X Y`, got `click 10 20 30`");
    EXPECT_EQ(errorOf("resize 0 9"), "test.txt:1: expected `resize W H`, got `resize 0 9`");
    EXPECT_EQ(errorOf("type"), "test.txt:1: expected `type TEXT`, got `type`");
    EXPECT_EQ(errorOf("drag 1 2 3 4 up"),
              "test.txt:1: expected `drag X Y X2 Y2 [right|middle]`, got `drag 1 2 3 4 up`");
    EXPECT_EQ(errorOf("jump 3").substr(0, 32), "test.txt:1: unknown word 'jump';");
    EXPECT_EQ(errorOf("frame 99999999999999"), "test.txt:1: expected `frame N`, got `frame 99999999999999`");
}

TEST(InputScript, KeysHaveNames) {
    EXPECT_EQ(readKeyStroke("v")->key, GLFW_KEY_V);
    EXPECT_EQ(readKeyStroke("0")->key, GLFW_KEY_0);
    EXPECT_EQ(readKeyStroke("F12")->key, GLFW_KEY_F12);
    EXPECT_EQ(readKeyStroke("Home")->key, GLFW_KEY_HOME);
    for (const char* none : {"", "Ctrl+", "F13", "F0", "Hyper+P", "+", "ß"})
        EXPECT_FALSE(readKeyStroke(none)) << none;
}

TEST(ScriptPlayer, StepsTakeFramesAndWaitForWhatTheyAsk) {
    std::vector<std::string> asked;
    ScriptTarget target;
    target.resize = [&](uint32_t width, uint32_t height) { asked.push_back(fmt::format("{}x{}", width, height)); };
    target.request = [&](const ScriptStep& step) { asked.push_back(step.text); };
    ScriptPlayer player(*readScript("key V\nresize 4 5\nstill\nscreenshot a.png\nkey H", "test.txt"));
    const auto keys = [](const std::vector<InputEvent>& events) {
        int sum = 0;
        for (const InputEvent& event : events)
            sum += event.down ? event.key : -event.key;
        return sum;
    };
    EXPECT_EQ(keys(player.frame(target, true, false)), GLFW_KEY_V);
    EXPECT_EQ(keys(player.frame(target, true, false)), -GLFW_KEY_V);
    for (int i = 0; i < 3; ++i) // resized, and two frames for the window system
        EXPECT_TRUE(player.frame(target, true, false).empty());
    EXPECT_EQ(asked, std::vector<std::string>{"4x5"});
    for (int i = 0; i < 20; ++i) // the picture is not complete
        EXPECT_TRUE(player.frame(target, false, false).empty());
    EXPECT_EQ(asked.size(), 1u);
    for (int i = 0; i < 3; ++i)
        player.frame(target, true, false);
    EXPECT_EQ(asked.back(), "a.png");
    EXPECT_TRUE(player.frame(target, true, true).empty()); // not written yet
    EXPECT_EQ(keys(player.frame(target, true, false)), GLFW_KEY_H);
    EXPECT_EQ(keys(player.frame(target, true, false)), -GLFW_KEY_H);
    EXPECT_FALSE(player.playing());
}

} // namespace input_script_test
} // namespace glint::view
