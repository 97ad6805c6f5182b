// Compares settings on a built-in scene: the figures are as expected, and the report is complete.
#include "base/file.hpp"
#include "gpu/context.hpp"
#include "lab/cli/compare/comparison_output.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/report/report_figures.hpp"
#include "lab/cli/report/report_legends.hpp"
#include "lab/cli/report/report_page.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace glint::test {
namespace compare_test {

measure::ComparedConfig config(const std::string& scene, const std::string& text) {
    measure::ComparedConfig config;
    config.name = text;
    config.job.scene = scene;
    config.job.width = 320;
    config.job.height = 180;
    config.job.settings = must(render::loadSettings(must(cli::readConfig(text))));
    return config;
}

/// One comparison for all tests: a marcher that tests every pixel, one that tests every 16th, and none.
const measure::Comparison& comparison() {
    static const measure::Comparison made = [] {
        const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = true}));
        measure::Comparison result = must(measure::compareConfigs(
            *context,
            {config("builtin:exact", "screen.march=linear,fade.border=none"),
             config("builtin:exact", "babylon+gbuffer.depthFormat=float,screen.step=16,screen.smooth=false"),
             config("builtin:exact", "screen.enabled=false")},
            config("builtin:exact", "screen.march=linear,fade.border=none"), 2, {}, 2));
        for (const std::string& message : context->validationMessages())
            ADD_FAILURE() << "validation: " << message;
        return result;
    }();
    return made;
}

TEST(Compare, FiguresFollowTheSettings) {
    const auto& configs = comparison().configs;
    ASSERT_EQ(configs.size(), 3u);
    const measure::HitFigures& fine = configs[0].hits.all;
    const measure::HitFigures& coarse = configs[1].hits.all;
    const measure::HitFigures& none = configs[2].hits.all;
    EXPECT_GT(fine.recall(), 0.85);
    EXPECT_GT(fine.precision(), 0.95);
    EXPECT_LT(coarse.precision(), fine.precision());
    EXPECT_LT(coarse.lookupsMean, fine.lookupsMean / 2); // in open space neither takes samples: 9.7, 32.3
    EXPECT_EQ(fine.visibleTruths, coarse.visibleTruths);
    EXPECT_EQ(none.visibleTruths, fine.visibleTruths);
    EXPECT_EQ(none.reported, 0u);
    EXPECT_EQ(none.recall(), 0);
    EXPECT_EQ(configs[0].hits.bands[static_cast<size_t>(measure::RoughnessBand::Mirror)].rays, fine.rays)
        << "every surface is a perfect mirror";
    ASSERT_TRUE(configs[0].exact && configs[1].exact && configs[2].exact);
    EXPECT_LT(configs[0].exact->oneBounceShare(), configs[1].exact->oneBounceShare());
    EXPECT_EQ(configs[2].exact->share(), 1); // without reflections every reflecting pixel is wrong
}

TEST(Compare, PicturesAreHeldAgainstTheReference) {
    const auto& configs = comparison().configs;
    ASSERT_TRUE(configs[0].reference && configs[1].reference && configs[2].reference);
    EXPECT_EQ(configs[0].reference->relativeMse, 0); // it is the reference
    EXPECT_GT(configs[0].reference->mirrorPixels, 1000u);
    EXPECT_GT(configs[1].reference->psnr, configs[2].reference->psnr);
    EXPECT_GT(configs[1].reference->psnrMirrors, configs[2].reference->psnrMirrors);
    EXPECT_LT(configs[2].reference->psnrMirrors, configs[2].reference->psnr); // only mirrors differ
    const auto json = nlohmann::json::parse(cli::comparisonJson(comparison()));
    EXPECT_TRUE(json["configs"][0]["reference"]["psnr"].is_null()); // equal images have none
    EXPECT_GT(json["configs"][1]["reference"]["psnr"], 0);
}

TEST(Compare, TimesAreThoseOfTheEffectAlone) {
    for (const measure::ConfigFigures& figures : comparison().configs) {
        EXPECT_EQ(figures.times.frames(), 2u);
        EXPECT_GT(figures.times.floor().median, 0);
        for (const measure::PassSpread& pass : figures.times.passes())
            EXPECT_TRUE(pass.name.starts_with("render/back_faces") || // drawn for the reflections alone
                        (!pass.name.starts_with("render/") && !pass.name.starts_with("measure/")))
                << pass.name;
    }
    const measure::EffectTimes& fine = comparison().configs[0].times;
    EXPECT_GT(fine.total().median, fine.floor().median);
    EXPECT_GT(fine.floorMultiple(), 1);
}

TEST(Compare, TheFolderHasPicturesAndFigures) {
    const TempFolder temp;
    const std::string folder = temp + "report";
    ASSERT_TRUE(cli::writeComparisonFolder(folder, comparison()));
    size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        pictures += entry.path().extension() == ".png";
    EXPECT_EQ(pictures, 9u);
    EXPECT_TRUE(std::filesystem::exists(folder + "/1-screen.march-linear-fade.border-none.hits.png"));
    EXPECT_EQ(must(readFile(folder + "/figures.json", 1 << 20)), cli::comparisonJson(comparison()));

    const auto json = nlohmann::json::parse(cli::comparisonJson(comparison()));
    ASSERT_EQ(json["configs"].size(), 3u);
    EXPECT_EQ(json["width"], 320);
    EXPECT_EQ(json["configs"][1]["preset"], "babylon");
    EXPECT_EQ(json["configs"][1]["settings"]["screen"]["step"], 16);
    for (const char* key : {"hits", "exact", "effectMs", "floorMultiple", "passes", "outcomes"})
        EXPECT_TRUE(json["configs"][0].contains(key)) << key;
    const std::string text = cli::comparisonText(comparison());
    for (const char* part : {"precision", "recall", "floors", "wrong", "outcomes hit"})
        EXPECT_NE(text.find(part), text.npos) << part;
}

TEST(Compare, SeedsAreTheSameWithoutNoise) {
    for (const measure::ConfigFigures& figures : comparison().configs) {
        ASSERT_EQ(figures.seeds.size(), 1u);
        EXPECT_EQ(figures.seeds[0].composite, figures.composite) << "no setting of this config draws numbers";
        EXPECT_EQ(figures.seeds[0].reference->relativeMse, figures.reference->relativeMse);
        EXPECT_EQ(figures.seeds[0].exact->share(), figures.exact->share());
        // The last config runs no pass.
        EXPECT_EQ(figures.seeds[0].floorMultiple > 0, figures.settings.reflections.screen.enabled);
    }
}

/// The share of pixels whose colour is not in the legend. A hit has any shade of green.
double strangers(const std::vector<uint8_t>& rgb, const nlohmann::ordered_json& legend, bool shadesOfGreen) {
    std::vector<std::array<int, 3>> colors;
    for (const auto& entry : legend) {
        const int color = std::stoi(entry["color"].get<std::string>().substr(1), nullptr, 16);
        colors.push_back({color >> 16, color >> 8 & 255, color & 255});
    }
    size_t strange = 0;
    for (size_t i = 0; i < rgb.size(); i += 3) {
        const auto near = [&](const std::array<int, 3>& color) {
            return std::abs(color[0] - rgb[i]) <= 1 && std::abs(color[1] - rgb[i + 1]) <= 1 &&
                   std::abs(color[2] - rgb[i + 2]) <= 1;
        };
        const bool hit = shadesOfGreen && rgb[i] == 0 && rgb[i + 2] == 0;
        strange += !hit && std::ranges::none_of(colors, near);
    }
    return static_cast<double>(strange) / (static_cast<double>(rgb.size()) / 3);
}

TEST(Compare, LegendsHaveTheColoursOfTheMaps) {
    const nlohmann::ordered_json legends = cli::legendsJson();
    for (const measure::ConfigFigures& figures : comparison().configs) {
        EXPECT_EQ(strangers(figures.outcome, legends["outcome"], true), 0);
        EXPECT_EQ(strangers(figures.source, legends["source"], false), 0);
        EXPECT_EQ(strangers(measure::classColors(figures.hits.classes), legends["hits"], false), 0);
    }
    const auto& outcomes = comparison().configs[0].stats.outcomes;
    ASSERT_EQ(legends["outcome"].size(), outcomes.size());
    for (const auto& [name, pixels] : outcomes)
        EXPECT_TRUE(std::ranges::any_of(legends["outcome"], [&](const auto& entry) { return entry["name"] == name; }))
            << name;
}

TEST(Compare, APageIsMadeOfIt) {
    cli::Report report;
    report.scenes.push_back(cli::reportScene(comparison(), {"a", "b", "c"}, "1"));
    const std::vector<measure::ComparisonMaps>& maps = report.scenes[0].maps;
    EXPECT_EQ(maps[0].flipMean, 0) << "it is the reference";
    EXPECT_GT(maps[2].flipMean, maps[1].flipMean);
    const std::string page = must(cli::reportPage(report));
    EXPECT_LT(page.size(), 3000000u);
    EXPECT_NE(page.find("builtin:exact 320x180 camera 1"), page.npos);
    // Every figure is known with its noise, and most have none here.
    const std::vector<measure::Figure> figures = cli::reportFigures(report.scenes);
    for (const char* name : {"hits.recall.all", "exact.oneBounceWrong", "error.relativeMse.mirror", "error.flip"})
        EXPECT_EQ(std::ranges::count(figures, name, &measure::Figure::name), 3) << name;
    EXPECT_EQ(std::ranges::count(figures, "time.floors", &measure::Figure::name), 2) << "the last config runs no pass";
    for (const measure::Figure& figure : figures)
        EXPECT_TRUE(figure.name == "time.floors" || figure.estimate.standardError == 0) << figure.name;
}

} // namespace compare_test
} // namespace glint::test
