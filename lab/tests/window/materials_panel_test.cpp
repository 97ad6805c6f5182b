// The materials panel: a click chooses a surface's material, a slider changes it live, and what is saved makes
// `glint render` draw the same picture.
#include "lab/tests/window/view_program.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace glint::test {
namespace materials_panel_test {

using testing::HasSubstr;
using testing::Not;

/// Figures are of single frames: what `render --stats` writes is the last frame and no mean.
const std::vector<std::string> kScene = {"builtin:mirror", "--size", "640x480", "--set", "display.antialias=none"};

std::vector<std::string> command(const char* name, std::vector<std::string> options) {
    options.insert(options.begin(), kScene.begin(), kScene.end());
    options.insert(options.begin(), name);
    return options;
}

/// A failure need not print a picture's bytes.
bool same(const std::string& a, const std::string& b) {
    return !a.empty() && a == b;
}

TEST_F(WindowTest, AMaterialIsChosenByAClickChangedAndSaved) {
    // The floor is right of the panel; drag: the slider of its roughness.
    std::ofstream(path("script.txt")) << "key Tab\nkey M\nstill\nclick 520 400\nframe 3\nscreenshot panel.png\n"
                                         "drag 20 221 80 221\nstill\npicture shown.png\nscreenshot changed.png\n"
                                         "key Ctrl+P\ntype changes of the materials\nkey Enter\nframe 3\n";
    const Ended viewed = run(command("view", {"--validate", "--script", "script.txt"}));
    ASSERT_EQ(viewed.code, 0) << viewed.error;
    const std::string saved = bytes("mirror.materials.json");
    EXPECT_THAT(saved, HasSubstr("\"floor mirror\": {\n      \"roughness\": 0."));
    EXPECT_THAT(saved, Not(HasSubstr("\"box")));
    const Ended rendered = run(command("render", {"-o", "r.png", "--stats", "stats.json"}));
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(same(bytes("shown.png"), bytes("r.png")));
    EXPECT_THAT(bytes("stats.json"), HasSubstr("materials are from mirror.materials.json"));
    const Ended plain = run(command("render", {"-o", "plain.png", "--materials", "none"}));
    ASSERT_EQ(plain.code, 0) << plain.error;
    EXPECT_FALSE(same(bytes("shown.png"), bytes("plain.png")));
}

TEST_F(WindowTest, DroppedMaterialsAreShownOrSaidToBeWrong) {
    std::ofstream(path("glass.materials.json"))
        << R"({"materials": {"floor mirror": {"metallic": 0, "transmission": 1}}})";
    std::ofstream(path("bad.materials.json")) << R"({"materials": {"flor mirror": {}}})";
    std::ofstream(path("script.txt")) << "drop glass.materials.json\nstill\npicture glass.png\n"
                                         "drop bad.materials.json\nstill\npicture still.png\n";
    const Ended viewed = run(command("view", {"--validate", "--script", "script.txt"}));
    ASSERT_EQ(viewed.code, 0) << viewed.error;
    const Ended rendered = run(command("render", {"-o", "r.png", "--materials", "glass.materials.json"}));
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(same(bytes("glass.png"), bytes("r.png")));
    EXPECT_TRUE(same(bytes("still.png"), bytes("glass.png"))) << "the open scene stays";
    const Ended refused = run(command("render", {"-o", "r.png", "--materials", "bad.materials.json"}));
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.error, "glint: error: bad.materials.json: flor mirror is no material of the scene; did you mean "
                             "'floor mirror'?\n");
}

} // namespace materials_panel_test
} // namespace glint::test
