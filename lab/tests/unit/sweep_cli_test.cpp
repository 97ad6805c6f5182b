// glint sweep from arguments to exit codes and lines, as far as no device is needed.
#include "base/file.hpp"
#include "lab/cli/program.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace glint::cli {
namespace sweep_cli_test {

class SweepCli : public testing::Test {
protected:
    SweepCli() { EXPECT_TRUE(writeFile(plan_, R"({"scenes": ["builtin:exact"], "configs": ["fast"], "seeds": 3})")); }

    int run(std::vector<std::string> arguments) {
        std::vector<const char*> argv = {"glint", "sweep"};
        for (const std::string& argument : arguments)
            argv.push_back(argument.c_str());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = runProgram(static_cast<int>(argv.size()), argv.data(), {});
        out_ = testing::internal::GetCapturedStdout();
        error_ = testing::internal::GetCapturedStderr();
        return code;
    }

    void expectBadInput(std::vector<std::string> arguments, std::string_view part) {
        EXPECT_EQ(run(std::move(arguments)), kBadInput) << error_;
        EXPECT_NE(error_.find(part), error_.npos) << error_;
        EXPECT_EQ(std::ranges::count(error_, '\n'), 1) << error_;
        EXPECT_EQ(out_, "");
    }

    const test::TempFolder temp_;
    const std::string plan_ = temp_ + "plan.json";
    const std::string folder_ = temp_ + "sweep";
    std::string out_, error_;
};

TEST_F(SweepCli, JobsAreListed) {
    ASSERT_EQ(run({plan_, "--list"}), kDone) << error_;
    EXPECT_EQ(std::ranges::count(out_, '\n'), 3);
    EXPECT_NE(out_.find("  builtin:exact, fast, seed 2\n"), out_.npos) << out_;
    ASSERT_EQ(run({plan_, "--list", "--shard", "1/3", "--out", folder_}), kDone) << error_;
    EXPECT_EQ(std::ranges::count(out_, '\n'), 1);
    EXPECT_NE(out_.find("  builtin:exact, fast, seed 1  to do\n"), out_.npos) << out_;
    EXPECT_FALSE(std::filesystem::exists(folder_)) << "a list writes nothing";
}

TEST_F(SweepCli, BadInputIsOneLine) {
    expectBadInput({}, "give a plan, or --merge DIR");
    expectBadInput({plan_}, "give --out DIR");
    expectBadInput({temp_ + "none.json", "--list"}, "none.json: No such file");
    expectBadInput({plan_, "--out", folder_, "--shard", "3/3"}, "--shard 3/3: expected I/N");
    expectBadInput({plan_, "--merge", folder_}, "--merge takes neither a plan nor");
    expectBadInput({"--merge", folder_, "--list"}, "--merge takes neither a plan nor");
    expectBadInput({plan_, "--list", "--partial"}, "--partial and --mixed go with --merge");
    expectBadInput({"--merge", folder_}, "sweep.json: No such file");
    EXPECT_TRUE(writeFile(plan_, R"({"scenes": ["builtin:exact"], "configs": ["fast+screen.step=0"]})"));
    expectBadInput({plan_, "--out", folder_}, "plan.json: fast+screen.step=0 on builtin:exact: --set screen.step=0");
    EXPECT_FALSE(std::filesystem::exists(folder_)) << "a wrong plan makes no folder";
}

TEST_F(SweepCli, AFolderThatCannotBeMadeIsSaid) {
    EXPECT_EQ(run({plan_, "--out", plan_ + "/sweep"}), kFailed);
    EXPECT_NE(error_.find("--out "), error_.npos) << error_;
    EXPECT_EQ(std::ranges::count(error_, '\n'), 1) << error_;
}

TEST_F(SweepCli, ResultsThatAreMissingAreNamed) {
    std::filesystem::create_directories(folder_ + "/jobs");
    const std::string job = R"({"name": "0123", "kind": "still", "scene": "s", "size": "", "config": "c", "seed": 0})";
    EXPECT_TRUE(
        writeFile(folder_ + "/sweep.json",
                  R"({"format": "glint sweep 1", "program": "p", "plan": "plan.json", "jobs": [)" + job + "]}"));
    EXPECT_EQ(run({"--merge", folder_}), kFailed);
    EXPECT_NE(error_.find("1 of 1 jobs have no result: 0123; run their shards again"), error_.npos) << error_;
    EXPECT_EQ(run({"--merge", folder_, "--partial"}), kFailed);
    EXPECT_NE(error_.find("no job has a result"), error_.npos) << error_;
}

} // namespace sweep_cli_test
} // namespace glint::cli
