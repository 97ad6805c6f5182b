// `glint view` in a window, as a person uses it: keys, clicks, files dropped on it. Every run fails on any message of
// the validation layer.
#include "lab/tests/window/view_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace glint::test {
namespace view_test {

using testing::HasSubstr;

/// Of two files: a failure need not print a picture's bytes.
bool same(const std::string& a, const std::string& b) {
    return !a.empty() && a == b;
}

TEST_F(WindowTest, EveryKeyOfComputeSsrShowsWhatRenderShows) {
    const Ended ended = runScript("still\npicture composite.png\n"
                                  "key V\nstill\npicture scene.png\n"
                                  "key V\nstill\npicture reflection.png\n"
                                  "key V\nstill\npicture normal.png\n"
                                  "key V\nstill\npicture depth.png\n"
                                  "key V\nstill\npicture again.png\n"
                                  "key 2\nkey 3\nkey 6\nkey 8\nkey 9\nstill\npicture tuned.png\nsave tuned.json\n"
                                  "key 1\nkey 4\nkey 5\nkey 7\nkey 0\nframe 1\n");
    ASSERT_EQ(ended.code, 0) << ended.error;
    const Ended rendered = run({"render", "builtin:exact", "--size", "320x180", "-o", "r.png", "--view",
                                "composite,scene,reflection,normal,depth"});
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(same(bytes("composite.png"), bytes("r.png")));
    EXPECT_TRUE(same(bytes("again.png"), bytes("r.png")));
    for (const std::string view : {"scene", "reflection", "normal", "depth"})
        EXPECT_TRUE(same(bytes(view + ".png"), bytes("r." + view + ".png"))) << view;
    EXPECT_FALSE(same(bytes("tuned.png"), bytes("r.png")));
    EXPECT_THAT(bytes("tuned.json"), HasSubstr("\"strength\": 1.1"));
    EXPECT_THAT(bytes("tuned.json"), HasSubstr("\"maxDistance\": 800"));
    EXPECT_THAT(bytes("tuned.json"), HasSubstr("\"resolutionScale\": 0.9"));
    EXPECT_THAT(bytes("tuned.json"), HasSubstr("\"steps\": 72"));
}

TEST_F(WindowTest, SavedSettingsAndCameraRenderTheSamePicture) {
    const Ended ended = runScript("still\ndrag 200 100 230 90\npress W\nframe 5\nrelease W\nkey 9\nscroll 1\n"
                                  "drag 200 100 190 110 right\nkey Ctrl+P\ntype pixelspacing\nkey Escape\n"
                                  "still\nsave mine.json\nstill\npicture shown.png\npicture shown.exr\n",
                                  {"--set", "composite.model=lerp", "--preset", "babylon"});
    ASSERT_EQ(ended.code, 0) << ended.error;
    for (const std::string kind : {".png", ".exr"}) {
        const Ended rendered = run({"render", "builtin:exact", "--size", "320x180", "--settings", "mine.json",
                                    "--camera", "mine.camera.json", "-o", "rendered" + kind});
        ASSERT_EQ(rendered.code, 0) << rendered.error;
        EXPECT_FALSE(bytes("shown" + kind).empty());
        EXPECT_TRUE(same(bytes("shown" + kind), bytes("rendered" + kind))) << kind;
    }
}

TEST_F(WindowTest, ScreenshotAfterSomeFramesIsTheSameEachTime) {
    for (const std::string name : {"a.png", "b.png"}) {
        const Ended ended = run({"view", "builtin:exact", "--size", "320x180", "--validate", "--screenshot", name,
                                 "--frames", "2", "--view", "outcome"});
        ASSERT_EQ(ended.code, 0) << ended.error;
    }
    EXPECT_GT(bytes("a.png").size(), 1000u);
    EXPECT_TRUE(same(bytes("a.png"), bytes("b.png")));
}

TEST_F(WindowTest, TheWindowShowsThePictureItself) {
    const Ended ended = runScript("key F1\nstill\nframe 1\nscreenshot window.png\npicture picture.png\n");
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(same(bytes("window.png"), bytes("picture.png"))); // a pixel of the scene is one of the window's
}

TEST_F(WindowTest, PaletteChangesWhatItFinds) {
    // Down in the list of what "fresnel" finds, Enter turns the switch.
    const Ended ended =
        runScript("still\nkey Ctrl+P\ntype reflect.fresnel\nframe 2\nscreenshot palette.png\nkey Enter\n"
                  "key Escape\nstill\nsave a.json\nkey Ctrl+Z\nstill\nsave b.json\nkey Ctrl+Y\nstill\n"
                  "save c.json\nkey Ctrl+P\ntype view outcome\nkey Enter\nstill\npicture outcome.png\n");
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_THAT(bytes("a.json"), HasSubstr("\"fresnel\": false"));
    EXPECT_THAT(bytes("b.json"), HasSubstr("\"fresnel\": true"));
    EXPECT_TRUE(same(bytes("c.json"), bytes("a.json")));
    const Ended rendered = run(
        {"render", "builtin:exact", "--size", "320x180", "-o", "r.png", "--view", "outcome", "--settings", "c.json"});
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(same(bytes("outcome.png"), bytes("r.png")));
}

TEST_F(WindowTest, AskSplitZoomAndErrorOnTopOfEachOther) {
    const auto shot = [](const std::string& name) { return "still\nquiet\nscreenshot " + name + ".png\n"; };
    const Ended ended =
        runScript(shot("plain") + shot("same") + "click 160 140\n" + shot("ray") +
                      "key Home\nmove 170 120\nstill\nmove 100 150\nstill\nkey Escape\nkey B\n" + shot("split") +
                      "drag 160 90 240 90\n" + shot("line") + "key N\n" + shot("difference") + "key N\n" +
                      shot("flip") + "key N\nkey B\nkey PageUp\nkey PageUp\nkey PageUp\n" + shot("zoom") +
                      "key PageDown\nkey T\nkey H\n" + shot("panels"),
                  {"--frames", "2"});
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(same(bytes("plain.png"), bytes("same.png"))); // what differs below is not a message
    const std::vector<std::string> names = {"plain", "ray", "split", "line", "difference", "flip", "zoom", "panels"};
    for (size_t i = 0; i < names.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            EXPECT_FALSE(same(bytes(names[i] + ".png"), bytes(names[j] + ".png"))) << names[i] << " " << names[j];
}

TEST_F(WindowTest, DroppedFilesOpenOrSayWhatIsWrongWithThem) {
    std::ofstream(path("broken.glb")) << "glTF, but not for long";
    std::ofstream(path("broken.hdr")) << "#?RADIANCE";
    std::ofstream(path("words.txt")) << "words";
    const Ended ended = runScript("still\npicture before.png\nquiet\nscreenshot plain.png\nquiet\nscreenshot same.png\n"
                                  "quiet\ndrop broken.glb\nframe 1\nscreenshot glb.png\nquiet\n"
                                  "drop broken.hdr\nframe 1\nscreenshot hdr.png\ndrop words.txt\nframe 1\n"
                                  "drop missing.gltf\nframe 1\nstill\npicture after.png\n"
                                  "drop builtin:mirror\nstill\npicture mirror.png\n");
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(same(bytes("before.png"), bytes("after.png"))); // what was open stays open
    EXPECT_TRUE(same(bytes("plain.png"), bytes("same.png")));
    EXPECT_FALSE(same(bytes("plain.png"), bytes("glb.png"))); // and each says something else
    EXPECT_FALSE(same(bytes("plain.png"), bytes("hdr.png")));
    EXPECT_FALSE(same(bytes("glb.png"), bytes("hdr.png")));
    const Ended rendered = run({"render", "builtin:mirror", "--size", "320x180", "-o", "r.png"});
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(same(bytes("mirror.png"), bytes("r.png")));
}

TEST_F(WindowTest, AnotherSceneIsLitAsRenderLightsIt) {
    const Ended baked = run({"bake", "builtin:mirror", "--face", "16", "-o", "mirror.probes"});
    ASSERT_EQ(baked.code, 0) << baked.error;
    std::ofstream(path("script.txt")) << "still\ndrop builtin:hall\nstill\npicture hall.png\n";
    const Ended ended = run({"view", "builtin:mirror", "--size", "160x90", "--validate", "--planar", "auto", "--probes",
                             "mirror.probes", "--script", "script.txt", "--set", "denoise.enabled=false"});
    ASSERT_EQ(ended.code, 0) << ended.error;
    const Ended rendered = run({"render", "builtin:hall", "--size", "160x90", "--planar", "auto", "--set",
                                "denoise.enabled=false", "-o", "r.png"});
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    EXPECT_TRUE(same(bytes("hall.png"), bytes("r.png")));
}

TEST_F(WindowTest, AScriptEndsWhereAFileCannotBeWritten) {
    for (const std::string step : {"picture none/a.png", "picture a.jpg", "screenshot a.jpg", "save none/a.json"}) {
        const Ended ended = runScript("still\n" + step + "\npicture later.png\n");
        EXPECT_EQ(ended.code, 1) << step;
        EXPECT_THAT(ended.error, HasSubstr("script.txt: "));
        EXPECT_EQ(std::count(ended.error.begin(), ended.error.end(), '\n'), 1) << ended.error;
        EXPECT_TRUE(bytes("later.png").empty());
    }
}

TEST_F(WindowTest, RealKeysAndARealClick) {
    auto viewer = start({"view", "builtin:exact", "--size", "320x180", "--validate"});
    const auto press = [&](const char* key) { return tool({"key", key}).code == 0; };
    const Ended found = tool({"search", "--sync", "--onlyvisible", "--name", "Glint: builtin:exact"});
    ASSERT_EQ(found.code, 0) << found.error;
    tool({"mousemove", "--window", found.out.substr(0, found.out.find('\n')), "160", "120"});
    ASSERT_TRUE(press("F11"));
    ASSERT_TRUE(waitFor("glint-1.png")) << viewer->wait().error;
    ASSERT_TRUE(press("v"));
    ASSERT_TRUE(press("F11"));
    ASSERT_TRUE(waitFor("glint-2.png"));
    const auto quiet = [] { std::this_thread::sleep_for(std::chrono::milliseconds(3500)); }; // no message is left
    quiet();
    ASSERT_TRUE(press("F12"));
    ASSERT_TRUE(waitFor("glint-3.png"));
    tool({"mousemove_relative", "1", "1"});
    quiet();
    ASSERT_TRUE(press("F12"));
    ASSERT_TRUE(waitFor("glint-4.png"));
    tool({"click", "1"});
    quiet();
    ASSERT_TRUE(press("F12"));
    ASSERT_TRUE(waitFor("glint-5.png"));
    ASSERT_TRUE(press("ctrl+q"));
    const Ended ended = viewer->wait();
    EXPECT_EQ(ended.code, 0) << ended.error;
    const Ended rendered =
        run({"render", "builtin:exact", "--size", "320x180", "-o", "r.png", "--view", "composite,scene"});
    EXPECT_TRUE(same(bytes("glint-1.png"), bytes("r.png")));
    EXPECT_TRUE(same(bytes("glint-2.png"), bytes("r.scene.png")));
    EXPECT_TRUE(same(bytes("glint-3.png"), bytes("glint-4.png")));
    EXPECT_FALSE(same(bytes("glint-4.png"), bytes("glint-5.png"))); // the clicked pixel's ray is there
}

TEST_F(WindowTest, OddSizesMinimizedAndBack) {
    const Ended ended = runScript("still\npicture before.png\nresize 17 9\nstill\nresize 1 1\nframe 3\nresize 333 7\n"
                                  "still\nminimize\nframe 5\nrestore\nresize 320 180\nstill\npicture after.png\n");
    ASSERT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(same(bytes("before.png"), bytes("after.png")));
}

TEST_F(WindowTest, WithoutADisplayOneLineSaysWhatToDo) {
    Running viewer({GLINT_RUN, GLINT_PROGRAM, "view", "builtin:exact"}, folder_.path(), {"DISPLAY", "WAYLAND_DISPLAY"});
    const Ended ended = viewer.wait();
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.error.substr(0, 37), "glint: error: no display for a window");
    EXPECT_THAT(ended.error, HasSubstr("glint render"));
    EXPECT_EQ(std::count(ended.error.begin(), ended.error.end(), '\n'), 1);
}

TEST_F(WindowTest, BadArgumentsAreSaidBeforeAnyWindow) {
    std::ofstream(path("bad.txt")) << "frame 1\njump\n";
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"view", "builtin:exact", "--script", "bad.txt"}, "bad.txt:2: unknown word 'jump'"},
        {{"view", "builtin:exact", "--script", "none.txt"}, "none.txt"},
        {{"view", "builtin:exact", "--view", "depht"}, "depht"},
        {{"view", "builtin:exact", "--screenshot", "a.jpg"}, "--screenshot a.jpg"},
        {{"view", "missing.glb"}, "missing.glb"},
    };
    for (const auto& [arguments, part] : cases) {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.code, 2) << part;
        EXPECT_THAT(ended.error, HasSubstr(part));
        EXPECT_EQ(std::count(ended.error.begin(), ended.error.end(), '\n'), 1) << ended.error;
    }
}

} // namespace view_test
} // namespace glint::test
