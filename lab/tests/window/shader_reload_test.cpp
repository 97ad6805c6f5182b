// Shaders changed while `glint view` runs.
#include "lab/tests/window/view_program.hpp"

#include <filesystem>
#include <fstream>

namespace glint::test {
namespace shader_reload_test {

class ShaderReloadTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (IsSkipped())
            return;
        std::filesystem::create_directories(path("lab"));
        for (const std::string folder : {"shaders", "lab/shaders"})
            std::filesystem::copy(GLINT_SOURCE_DIR "/" + folder, path(folder),
                                  std::filesystem::copy_options::recursive);
    }
    /// Puts `to` in the place of `from`, which must be there.
    void edit(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = bytes("shaders/" + file);
        const size_t at = text.find(from);
        ASSERT_NE(at, text.npos) << file << " has no " << from;
        std::ofstream(path("shaders/" + file)) << text.replace(at, from.size(), to);
    }
    void press(const char* key) { EXPECT_EQ(tool({"key", key}).code, 0); }
    /// The next file of F11 or F12.
    std::string shot(const char* key) {
        const std::string name = "glint-" + std::to_string(++shots_) + ".png";
        press(key);
        EXPECT_TRUE(waitFor(name)) << name;
        return bytes(name);
    }

private:
    int shots_ = 0;
};

TEST_F(ShaderReloadTest, AChangeIsShownAndAMistakeLeavesThePictureAsItWas) {
    auto viewer = start({"view", "builtin:exact", "--size", "320x180", "--validate", "--shaders", "."});
    ASSERT_FALSE(waitForWindow("builtin:exact").empty());
    const std::string before = shot("F11");

    // A shader of the library's, then what several of our own include.
    edit("composite/composite_main.glsl", "vec4(result, stored.a)", "vec4(result.brg, stored.a)");
    press("F5");
    const std::string turned = shot("F11");
    EXPECT_TRUE(turned != before && !turned.empty());
    edit("lib/color.glsl", "vec3 encodeSrgb(vec3 ",
         "vec3 encodeSrgb(vec3 unused) { return vec3(0.5); }\nvec3 no(vec3 ");
    press("F5");
    const std::string grey = shot("F11");
    EXPECT_TRUE(grey != turned && !grey.empty());

    press("F5"); // nothing has changed: whatever stands in the window then, it is no mistake
    edit("composite/composite_main.glsl", "void main() {", "void main() { mistake");
    press("F5");
    EXPECT_TRUE(shot("F11") == grey);
    const std::string said = shot("F12");

    // What compiles and is no shader of this pass is refused by the program, and no less gently.
    edit("composite/composite_main.glsl", "mistake", "");
    edit("composite/composite_main.glsl", "image2D composite;", "image2D other;");
    edit("composite/composite_main.glsl", "imageStore(composite", "imageStore(other");
    press("F5");
    EXPECT_TRUE(shot("F11") == grey);

    edit("composite/composite_main.glsl", "image2D other;", "image2D composite;");
    edit("composite/composite_main.glsl", "imageStore(other", "imageStore(composite");
    edit("composite/composite_main.glsl", "result.brg", "result");
    std::filesystem::copy_file(std::string(GLINT_SOURCE_DIR) + "/shaders/lib/color.glsl",
                               path("shaders/lib/color.glsl"), std::filesystem::copy_options::overwrite_existing);
    press("F5");
    EXPECT_TRUE(shot("F11") == before);
    EXPECT_TRUE(shot("F12") != said);
    press("ctrl+q");
    const Ended ended = viewer->wait();
    EXPECT_EQ(ended.code, 0) << ended.error;
}

TEST_F(ShaderReloadTest, WhatIsNoFolderOfSourcesIsSaid) {
    const Ended ended = run({"view", "builtin:exact", "--shaders", "shaders"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.error,
              "glint: error: shaders: not the folder of Glint's sources: it must hold shaders/variants.txt and "
              "lab/shaders/variants.txt\n");
}

} // namespace shader_reload_test
} // namespace glint::test
