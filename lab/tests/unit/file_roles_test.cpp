// No command replaces what it reads, or writes two results to one file.
#include "lab/cli/file_roles.hpp"

#include "base/file.hpp"
#include "lab/cli/program.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace glint::cli {
namespace file_roles_test {

using test::must;
using testing::HasSubstr;

class FileRolesTest : public testing::Test {
protected:
    static std::string errorOf(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
        const Result<void> checked = checkOutputs(inputs, outputs);
        return checked ? "" : checked.error().message;
    }

    /// Runs a command whose renderer must not be reached.
    static std::string errorOf(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "glint");
        std::vector<const char*> argv;
        for (const std::string& argument : arguments)
            argv.push_back(argument.c_str());
        testing::internal::CaptureStderr();
        const int code = runProgram(int(argv.size()), argv.data(), [](const render::RenderJob&) {
            ADD_FAILURE() << "rendered";
            return makeError(ErrorCode::Unsupported, "rendered");
        });
        const std::string error = testing::internal::GetCapturedStderr();
        EXPECT_EQ(code, kBadInput) << error;
        return error;
    }

    const test::TempFolder temp_;
};

TEST_F(FileRolesTest, OneFileUnderSeveralNames) {
    must(writeFile(temp_ + "a", "1"));
    must(writeFile(temp_ + "b", "1"));
    std::filesystem::create_symlink("a", temp_ + "link");
    std::filesystem::create_hard_link(temp_ + "a", temp_ + "hard");
    for (const char* name : {"a", "link", "hard", "./a"})
        EXPECT_THAT(errorOf({{"IN", temp_ + "a"}}, {{"-o", temp_ + name}}), HasSubstr("this is the file of IN"))
            << name;
    EXPECT_EQ(errorOf({{"IN", temp_ + "a"}}, {{"-o", temp_ + "b"}, {"--stats", temp_ + "c"}}), "");
}

TEST_F(FileRolesTest, OutputsThatAreNotThereYet) {
    std::filesystem::create_symlink("new", temp_ + "dangling");
    EXPECT_THAT(errorOf({}, {{"-o", temp_ + "new"}, {"--stats", temp_ + "dangling"}}), HasSubstr("the file of -o too"));
    EXPECT_EQ(errorOf({}, {{"-o", temp_ + "new"}, {"--stats", temp_ + "other"}}), "");
    // Written again for each frame.
    EXPECT_EQ(errorOf({}, {{"--stats", temp_ + "new"}, {"--stats", temp_ + "new"}}), "");
}

TEST_F(FileRolesTest, WhatIsNoFileIsNoConflict) {
    EXPECT_EQ(errorOf({{"--camera", "front"}, {"--probes", ""}}, {{"--stats", "front"}, {"-o", ""}}), "");
    EXPECT_EQ(errorOf({{"IN", "/dev/null"}}, {{"-o", "/dev/null"}, {"--stats", "-"}}), "");
}

TEST_F(FileRolesTest, CommandsRefuseBeforeAnyWork) {
    const std::string camera = temp_ + "c.json", materials = temp_ + "m.json", environment = temp_ + "e.exr";
    for (const std::string& file : {camera, materials, environment})
        must(writeFile(file, "kept"));
    const std::string scene = "builtin:mirror";
    EXPECT_THAT(errorOf({"render", scene, "--camera", camera, "-o", temp_ + "o.png", "--stats", camera}),
                HasSubstr("this is the file of --camera"));
    EXPECT_THAT(errorOf({"render", scene, "--env", environment, "-o", environment}), HasSubstr("the file of --env"));
    EXPECT_THAT(errorOf({"sequence", scene, "--materials", materials, "--json", materials}),
                HasSubstr("the file of --materials"));
    EXPECT_THAT(errorOf({"compare", scene, "--config", "balanced", "--camera", camera, "--json", camera}),
                HasSubstr("the file of --camera"));
    EXPECT_THAT(errorOf({"bench", scene, "--camera", camera, "--json", camera}), HasSubstr("the file of --camera"));
    EXPECT_THAT(errorOf({"bake", scene, "--camera", camera, "-o", camera}), HasSubstr("the file of --camera"));
    for (const std::string& file : {camera, materials, environment})
        EXPECT_EQ(must(readFile(file, 10)), "kept");
}

} // namespace file_roles_test
} // namespace glint::cli
