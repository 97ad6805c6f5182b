// What a frame costs, as the help panel says it.
#include "lab/tests/window/view_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace glint::test {
namespace figures_test {

using nlohmann::json;

/// Sum of the passes whose names begin so; of all others where `but`.
double sum(const json& stats, const std::string& start, bool but = false) {
    double ms = 0;
    for (const json& pass : stats.at("passes"))
        if (pass.at("name").get<std::string>().starts_with(start) != but)
            ms += pass.at("ms").get<double>();
    return ms;
}

std::vector<std::string> names(const json& stats) {
    std::vector<std::string> all;
    for (const json& pass : stats.at("passes"))
        all.push_back(pass.at("name"));
    return all;
}

/// Against the passes of the very same frames: two runs on a busy software device differ by more than 10 %, whichever
/// program makes them. That both programs have the same passes is compared by name.
TEST_F(WindowTest, TheHelpPanelSaysWhatStatsSay) {
    const std::vector<std::string> picture = {
        "builtin:exact",         "--size", "160x90", "--frames", "2", "--set", "screen.colorSource=previous", "--set",
        "display.antialias=none"};
    std::ofstream(path("script.txt")) << "key H\nstill\nstats view.json\n";
    std::vector<std::string> view = {"view", "--validate", "--script", "script.txt"};
    std::vector<std::string> render = {"render", "-o", "r.png", "--stats", "render.json"};
    view.insert(view.begin() + 1, picture.begin(), picture.end());
    render.insert(render.begin() + 1, picture.begin(), picture.end());
    const Ended viewed = run(view), rendered = run(render);
    ASSERT_EQ(viewed.code, 0) << viewed.error;
    ASSERT_EQ(rendered.code, 0) << rendered.error;
    const json shown = json::parse(bytes("view.json")), stats = json::parse(bytes("render.json"));
    EXPECT_THAT(names(stats), testing::IsSupersetOf(names(shown)));
    if (!stats.contains("gpuMs"))
        GTEST_SKIP() << "the device has no timestamps";
    const double all = sum(shown, "");
    EXPECT_GT(all, 0);
    EXPECT_GT(sum(shown, "trace/"), 0);
    EXPECT_NEAR(shown.at("gpuMs").get<double>(), all, 0.1 * all);
    EXPECT_NEAR(shown.at("gpuComputeMs").get<double>(), sum(shown, "trace/"), 0.1 * sum(shown, "trace/"));
    EXPECT_GT(shown.at("gpuRenderMs").get<double>(), 0);
    EXPECT_LT(shown.at("gpuRenderMs").get<double>(), 1.1 * sum(shown, "trace/", true));
    double elsewhere = 0; // of the same passes
    for (const json& pass : stats.at("passes"))
        if (const auto known = names(shown); std::ranges::count(known, pass.at("name").get<std::string>()) > 0)
            elsewhere += pass.at("ms").get<double>();
    std::printf("help panel %.3f ms, --stats of the same frames %.3f ms, of glint render's %.3f ms\n",
                shown.at("gpuMs").get<double>(), all, elsewhere);
}

} // namespace figures_test
} // namespace glint::test
