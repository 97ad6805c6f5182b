// Command lines in reports: what a shell reads back is what was meant.
#include "lab/cli/command_text.hpp"

#include <gtest/gtest.h>

namespace glint::cli {
namespace command_text_test {

TEST(CommandText, WordsAreQuotedWhereAShellWouldReadMore) {
    EXPECT_EQ(shellWord("builtin:hall"), "builtin:hall");
    EXPECT_EQ(shellWord("screen.step=4,a+b"), "screen.step=4,a+b");
    EXPECT_EQ(shellWord(""), "''");
    EXPECT_EQ(shellWord("my scene.glb"), "'my scene.glb'");
    EXPECT_EQ(shellWord("$(rm -r x)"), "'$(rm -r x)'");
    EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
}

TEST(CommandText, HasTheOptionsThatWereGiven) {
    CLI::App program("", "glint");
    CLI::App* const command = program.add_subcommand("report", "");
    std::vector<std::string> scenes, configs;
    std::string output = "report.html", size;
    bool validate = false;
    command->add_option("SCENE", scenes);
    command->add_option("-o,--output", output);
    command->add_option("--config", configs)->allow_extra_args(false);
    command->add_option("--size", size);
    command->add_flag("--validate", validate);
    const char* const argv[] = {"glint",    "report", "a b.glb",    "--config", "fast",  "builtin:hall",
                                "--config", "x=1",    "--validate", "-o",       "a.html"};
    program.parse(static_cast<int>(std::size(argv)), argv);
    EXPECT_EQ(commandText(*command),
              "glint report 'a b.glb' builtin:hall --output a.html --config fast --config x=1 --validate");
}

TEST(CommandText, AConfigRendersWithItsPresetAndSettings) {
    RenderOptions options;
    options.camera = "1";
    options.planar = "auto";
    options.settings.assignments = {"lights.shadows=rays"};
    EXPECT_EQ(renderCommand(options, "builtin:hall", "babylon+screen.step=4", 640, 360),
              "glint render builtin:hall --size 640x360 --camera 1 --planar auto --preset babylon "
              "--set lights.shadows=rays --set screen.step=4");
    EXPECT_EQ(renderCommand({}, "a.glb", "mine.json", 64, 36), "glint render a.glb --size 64x36 --settings mine.json");
}

} // namespace command_text_test
} // namespace glint::cli
