// The panel that opens files.
#include "lab/tests/window/view_program.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace glint::test {
namespace open_panel_test {

TEST_F(WindowTest, ThePanelOpensWhatItFindsAndRemembersIt) {
    std::filesystem::create_directory(path("rooms"));
    const Ended saved = runScript("still\nkey 2\nsave rooms/mine.json\n");
    ASSERT_EQ(saved.code, 0) << saved.error;
    const Ended ended = runScript("still\nkey Ctrl+O\nframe 3\nscreenshot panel.png\ntype rooms\nkey Enter\nframe 2\n"
                                  "type mine.json\nkey Enter\nframe 2\nstill\nsave opened.json\n"
                                  "key Ctrl+O\ntype builtin:mirror\nkey Enter\nstill\npicture mirror.png\n"
                                  "key Ctrl+O\nkey Escape\nframe 2\n");
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_THAT(bytes("opened.json"), testing::HasSubstr("\"strength\": 1.1"));
    const Ended rendered =
        run({"render", "builtin:mirror", "--size", "320x180", "--settings", "opened.json", "-o", "r.png"});
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(bytes("mirror.png") == bytes("r.png"));
    EXPECT_EQ(bytes("state/glint/recent"), "builtin:mirror\n" + path("rooms/mine.json") + "\nbuiltin:exact\n");
}

} // namespace open_panel_test
} // namespace glint::test
