// What glint trace tells of a run that succeeds.
#include "lab/cli/program.hpp"

#include "base/file.hpp"
#include "lab/scene/images/image_file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace glint::test {
namespace trace_command_test {

using testing::HasSubstr;
using testing::Not;

/// Traces a wall of 16 x 12 pixels and returns the notes of --stats.
std::string notesOf(const std::vector<std::string>& further) {
    const TempFolder temp;
    constexpr uint32_t kWidth = 16, kHeight = 12;
    std::vector<float> zeros(size_t{kWidth} * kHeight * 4, 0.0f), ones(zeros.size(), 1.0f), towardCamera;
    for (size_t i = 0; i < zeros.size(); i += 4)
        towardCamera.insert(towardCamera.end(), {0, 0, 1, 0});
    const scene::ExrLayer layers[] = {{"depth", "Z", false, ones},
                                      {"normal", "XYZ", false, towardCamera},
                                      {"scene", "RGB", false, ones},
                                      {"roughness", "Y", false, zeros},
                                      {"reflectivity", "RGB", false, zeros}};
    must(scene::writeExr(temp + "g.exr", kWidth, kHeight, layers));
    must(writeFile(temp + "c.json", R"({"position":[0,0,3],"target":[0,0,0],"fovY":50})"));
    std::vector<std::string> arguments = {"glint",        "trace",        temp + "g.exr", "--camera", temp + "c.json",
                                          "-o",           temp + "o.png", "--frames",     "1",        "--stats",
                                          temp + "s.json"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    std::vector<const char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    EXPECT_EQ(cli::runProgram(int(argv.size()), argv.data(), {}), cli::kDone);
    return nlohmann::json::parse(must(readFile(temp + "s.json", 1 << 20)))["notes"].dump();
}

/// The library's note speaks of a call that no user of the program can make.
TEST(TraceCommand, RaysAreMissedOnlyByThoseWhoAskedForThem) {
    for (const char* preset : {"real-time", "quality"})
        EXPECT_THAT(notesOf({"--preset", preset}), Not(HasSubstr("rays"))) << preset;
    EXPECT_THAT(notesOf({"--set", "rays.enabled=true"}), HasSubstr("a G-buffer has no triangles: rays take no part"));
    EXPECT_THAT(notesOf({"--set", "rays.enabled=true"}), Not(HasSubstr("setRays")));
}

} // namespace trace_command_test
} // namespace glint::test
