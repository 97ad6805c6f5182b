// The key that captures a frame, with and without something that looks like RenderDoc.
#include "lab/tests/window/view_program.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace glint::test {
namespace render_doc_test {

const std::string kScript = "still\nquiet\nscreenshot before.png\nkey F9\nframe 2\nscreenshot after.png\n";

TEST_F(WindowTest, AKeyCapturesOneFrameForRenderDoc) {
    if (std::string(GLINT_SANITIZE) != "")
        GTEST_SKIP() << "a sanitizer wants to be the first library";
    std::ofstream(path("script.txt")) << kScript;
    auto viewer = start({"view", "builtin:exact", "--size", "320x180", "--validate", "--script", "script.txt"},
                        {std::string("LD_PRELOAD=") + GLINT_FAKE_RENDER_DOC});
    const Ended ended = viewer->wait();
    EXPECT_EQ(ended.code, 0) << ended.error;
    EXPECT_EQ(ended.out, "start\nend\n");
}

TEST_F(WindowTest, WithoutRenderDocTheKeySaysSo) {
    const Ended ended = runScript(kScript);
    EXPECT_EQ(ended.code, 0) << ended.error;
    EXPECT_TRUE(bytes("before.png") != bytes("after.png"));
}

} // namespace render_doc_test
} // namespace glint::test
