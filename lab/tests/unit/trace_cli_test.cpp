// glint trace with bad input: one line of error and exit code 2, before any device is needed.
#include "lab/cli/program.hpp"

#include "base/file.hpp"
#include "lab/gbuffer_files/gbuffer_mapping.hpp"
#include "lab/tests/support/exr_writer.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::cli {
namespace trace_cli_test {

using test::must;
using testing::HasSubstr;

constexpr int kWidth = 16, kHeight = 12;

class TraceCliTest : public testing::Test {
protected:
    TraceCliTest() { must(writeFile(camera_, R"({"position":[0,1,3],"target":[0,0,0],"fovY":50})")); }

    /// A complete G-buffer for the preset "glint": a plane that faces the camera.
    static test::ExrPart gbuffer() {
        const size_t pixels = size_t{kWidth} * kHeight;
        test::ExrPart part = {"", kWidth, kHeight, {}};
        for (const char* zero :
             {"normal.X", "normal.Y", "scene.R", "reflectivity.R", "reflectivity.G", "reflectivity.B", "roughness.Y"})
            part.planes.emplace_back(zero, std::vector<float>(pixels, 0.0f));
        for (const char* one : {"depth.Z", "normal.Z", "scene.G", "scene.B"})
            part.planes.emplace_back(one, std::vector<float>(pixels, 1.0f));
        return part;
    }

    static std::vector<float>& plane(test::ExrPart& part, std::string_view name) {
        return std::ranges::find(part.planes, name, &test::ExrPlane::first)->second;
    }

    /// Runs `glint trace` and returns its line of error, after checking that it is one and that the exit code is 2.
    std::string errorOf(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"glint", "trace"});
        if (std::ranges::find(arguments, "-o") == arguments.end())
            arguments.insert(arguments.end(), {"-o", temp_ + "out.exr"});
        std::vector<const char*> argv;
        for (const std::string& argument : arguments)
            argv.push_back(argument.c_str());
        testing::internal::CaptureStderr();
        EXPECT_EQ(runProgram(int(argv.size()), argv.data(), {}), kBadInput);
        const std::string error = testing::internal::GetCapturedStderr();
        EXPECT_THAT(error, testing::StartsWith("glint: error: "));
        EXPECT_EQ(std::ranges::count(error, '\n'), 1) << error;
        EXPECT_FALSE(std::filesystem::exists(temp_ + "out.exr"));
        return error;
    }
    std::string errorOfFile(const std::vector<std::string>& further = {}) {
        std::vector<std::string> arguments = {file_, "--camera", camera_};
        arguments.insert(arguments.end(), further.begin(), further.end());
        return errorOf(arguments);
    }

    const test::TempFolder temp_;
    const std::string file_ = temp_ + "g.exr", camera_ = temp_ + "camera.json";
};

TEST_F(TraceCliTest, FilesAndCameraMustBeGiven) {
    EXPECT_THAT(errorOf({}), HasSubstr("GBUFFER is required"));
    EXPECT_THAT(errorOf({file_}), HasSubstr("--camera is required"));
    EXPECT_THAT(errorOfFile(), HasSubstr("No such file"));
    EXPECT_THAT(errorOf({file_, "--camera", temp_ + "none.json"}), HasSubstr("none.json: no such file"));
    test::writeExrFile(file_, gbuffer());
    EXPECT_THAT(errorOfFile({"--color", temp_ + "none.exr"}), HasSubstr("none.exr: No such file"));
    EXPECT_THAT(errorOfFile({"--mapping", "maya"}), HasSubstr("--mapping maya: no such file, and no such preset"));
    EXPECT_THAT(errorOfFile({"--env", temp_ + "none.hdr"}), HasSubstr("none.hdr: No such file"));
    EXPECT_THAT(errorOfFile({"--probes", temp_ + "none.probes"}), HasSubstr("none.probes: No such file"));
    EXPECT_THAT(errorOfFile({"--set", "screen.stepp=3"}), HasSubstr("screen.step"));
}

TEST_F(TraceCliTest, FilesOfOtherKinds) {
    must(writeFile(file_, "not a picture"));
    EXPECT_THAT(errorOfFile(), HasSubstr("g.exr: is not an OpenEXR file"));
    test::writeDeepExr(file_, kWidth, kHeight);
    EXPECT_THAT(errorOfFile(), HasSubstr("deep"));
    test::writeExrFile(file_, gbuffer());
    const std::string whole = must(readFile(file_, 1 << 20));
    must(writeFile(file_, whole.substr(0, whole.size() / 2)));
    EXPECT_THAT(errorOfFile(), HasSubstr("g.exr: OpenEXR: "));
}

/// Layers that are there but cannot be read are no sign of another preset.
TEST_F(TraceCliTest, DamagedFilesAreNotTakenForThoseOfAnotherMapping) {
    test::ExrPart part = {"", 64, 256, {}};
    float value = 0;
    for (const char* name : {"depth.Z", "normal.X", "normal.Y", "normal.Z", "roughness.Y", "reflectivity.R",
                             "reflectivity.G", "reflectivity.B", "scene.R", "scene.G", "scene.B"}) {
        std::vector<float>& plane = part.planes.emplace_back(name, std::vector<float>(size_t{64} * 256)).second;
        for (float& pixel : plane)
            pixel = value = std::fmod(value * 1.7f + 0.31f, 1.0f); // hardly compressed
    }
    test::writeExrFile(file_, part);
    const std::string whole = must(readFile(file_, 1 << 22));
    must(writeFile(file_, whole.substr(0, whole.size() * 3 / 4)));
    const std::string declared = errorOfFile({"--mapping", "glint"}), fitting = errorOfFile();
    EXPECT_THAT(fitting, HasSubstr("truncated"));
    EXPECT_EQ(fitting, declared);
}

TEST_F(TraceCliTest, MissingLayersAreNamed) {
    test::ExrPart part = gbuffer();
    std::erase_if(part.planes, [](const test::ExrPlane& plane) { return plane.first.starts_with("normal"); });
    test::writeExrFile(file_, part);
    EXPECT_THAT(errorOfFile(), HasSubstr("its layers are those of neither preset (blender and glint)"));
    EXPECT_THAT(errorOfFile({"--mapping", "glint"}),
                HasSubstr("normal: no layer is called normal; the file has depth"));
}

TEST_F(TraceCliTest, DepthWithoutNumbersShowsNoSurface) {
    test::ExrPart part = gbuffer();
    plane(part, "depth.Z").assign(plane(part, "depth.Z").size(), std::numeric_limits<float>::quiet_NaN());
    test::writeExrFile(file_, part);
    EXPECT_THAT(errorOfFile({"--mapping", "glint"}), HasSubstr("no pixel shows a surface"));
}

TEST_F(TraceCliTest, SizesMustAgree) {
    test::writeExrFile(file_, gbuffer());
    test::writeExrFile(
        temp_ + "c.exr",
        {"",
         4,
         2,
         {{"R", std::vector<float>(8, 1.0f)}, {"G", std::vector<float>(8, 1.0f)}, {"B", std::vector<float>(8, 1.0f)}}});
    EXPECT_THAT(errorOfFile({"--mapping", "glint", "--color", temp_ + "c.exr"}),
                HasSubstr("c.exr: has 4x2 pixels, but"));
    must(writeFile(camera_, R"({"position":[0,1,3],"target":[0,0,0],"fovY":50,"width":100,"height":100})"));
    EXPECT_THAT(errorOfFile(), HasSubstr("the camera is made for 100x100 pixels, but"));
}

TEST_F(TraceCliTest, SequencesHaveNumbers) {
    for (const char* wrong : {"3", "3-", "5-4", "1-2-3", "a-b", "0-4000000000"})
        EXPECT_THAT(errorOfFile({"--sequence", wrong}), HasSubstr(std::string("--sequence ") + wrong)) << wrong;
    EXPECT_THAT(errorOfFile({"--sequence", "1-3"}), HasSubstr("g.exr: --sequence needs %d or %04d in it"));
    EXPECT_THAT(errorOf({temp_ + "g.%03d.exr", "--camera", camera_, "--sequence", "1-3"}),
                HasSubstr("out.exr: --sequence needs %d or %04d in it"));
    EXPECT_THAT(errorOf({temp_ + "g.%03d.exr", "--camera", camera_, "--sequence", "7-9", "-o", temp_ + "o.%d.exr"}),
                HasSubstr("g.007.exr: No such file"));
}

TEST_F(TraceCliTest, NoInputIsReplaced) {
    test::writeExrFile(file_, gbuffer());
    const std::string whole = must(readFile(file_, 1 << 20)), camera = must(readFile(camera_, 1 << 20));
    EXPECT_THAT(errorOfFile({"-o", file_}), HasSubstr("g.exr: this is the file of GBUFFER, which would be replaced"));
    EXPECT_THAT(errorOfFile({"-o", temp_.path() + "./g.exr"}), HasSubstr("this is the file of GBUFFER"));
    std::filesystem::create_symlink("g.exr", temp_ + "link.exr");
    EXPECT_THAT(errorOfFile({"-o", temp_ + "link.exr"}), HasSubstr("link.exr: this is the file of GBUFFER"));
    EXPECT_THAT(errorOfFile({"--stats", camera_}), HasSubstr("--stats " + camera_ + ": this is the file of --camera"));
    std::filesystem::copy(file_, temp_ + "c.exr");
    EXPECT_THAT(errorOfFile({"--color", temp_ + "c.exr", "-o", temp_ + "c.exr"}), HasSubstr("the file of --color"));
    EXPECT_THAT(errorOfFile({"--env", temp_ + "c.exr", "-o", temp_ + "c.exr"}), HasSubstr("the file of --env"));
    EXPECT_THAT(errorOfFile({"--probes", temp_ + "c.exr", "-o", temp_ + "c.exr"}), HasSubstr("the file of --probes"));
    must(writeFile(temp_ + "m.json", std::string(must(scene::mappingPresetText("glint")))));
    EXPECT_THAT(errorOfFile({"--mapping", temp_ + "m.json", "--stats", temp_ + "m.json"}),
                HasSubstr("the file of --mapping"));
    must(writeFile(temp_ + "s.json", "{}"));
    EXPECT_THAT(errorOfFile({"--settings", temp_ + "s.json", "--stats", temp_ + "s.json"}),
                HasSubstr("the file of --settings"));
    EXPECT_THAT(errorOfFile({"-o", temp_ + "new.exr", "--stats", temp_ + "./new.exr"}),
                HasSubstr("--stats " + (temp_ + "./new.exr") + ": this is the file of -o too"));
    EXPECT_EQ(must(readFile(file_, 1 << 20)), whole);
    EXPECT_EQ(must(readFile(camera_, 1 << 20)), camera);
}

TEST_F(TraceCliTest, NoFrameOfASequenceReplacesAnother) {
    for (const char* name : {"s1.exr", "s2.exr"})
        test::writeExrFile(temp_ + name, gbuffer());
    EXPECT_THAT(errorOf({temp_ + "s%d.exr", "--camera", camera_, "--sequence", "1-2", "-o", temp_ + "s%d.exr"}),
                HasSubstr("s1.exr: this is the file of GBUFFER"));
    std::filesystem::create_symlink("s2.exr", temp_ + "o1.exr"); // what the first frame writes, the second reads
    EXPECT_THAT(errorOf({temp_ + "s%d.exr", "--camera", camera_, "--sequence", "1-2", "-o", temp_ + "o%d.exr"}),
                HasSubstr("o1.exr: this is the file of GBUFFER"));
}

TEST_F(TraceCliTest, PrintMappingIsAMappingFile) {
    testing::internal::CaptureStdout();
    const char* argv[] = {"glint", "trace", "--print-mapping", "--mapping", "blender"};
    EXPECT_EQ(runProgram(5, argv, {}), kDone);
    EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr(R"("fallbackSpecular": {"times": "GlossCol")"));
}

} // namespace trace_cli_test
} // namespace glint::cli
