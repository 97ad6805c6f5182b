// The whole search on a small scene: the curve, the choice, and a search that was interrupted.
#include "lab/cli/tune/tune_output.hpp"
#include "lab/tune/tune.hpp"

#include "base/file.hpp"
#include "gpu/context.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace glint::test {
namespace tune_test {

using Json = nlohmann::json;

/// Few settings of a small scene; without denoising a picture takes one frame.
tune::TunePlan smallPlan(uint32_t generations) {
    tune::TunePlan plan;
    const auto settings = [](const std::string& preset) {
        return must(render::loadSettings(
            {.defaults = {}, .preset = preset, .file = {}, .assignments = {"denoise.enabled=false"}}));
    };
    render::RenderJob job;
    job.scene = "builtin:exact";
    job.width = 64;
    job.height = 36;
    job.settings = settings("balanced");
    plan.evaluation.jobs = {job};
    plan.evaluation.reference = settings("reference");
    plan.evaluation.referenceFrames = 1;
    plan.evaluation.counted = true;
    plan.search.start = job.settings.reflections;
    plan.search.vary = {"hiz", "screen.thicknessMode", "screen.resolutionScale"};
    plan.search.population = 8;
    plan.search.generations = generations;
    plan.target.mostShare = 0.8;
    plan.startName = "balanced";
    plan.timedFrames = 1;
    return plan;
}

/// The JSON without what a clock measured.
Json figuresOf(const tune::TuneResult& result) {
    Json json = Json::parse(cli::tuneJson(result, {{"builtin:exact"}, "balanced", 0}));
    for (Json& point : json["points"])
        point.erase("measured");
    for (Json& preset : json["presets"])
        preset.erase("measured");
    json["choice"].erase("measured");
    return json;
}

TEST(Tune, AnInterruptedSearchEndsAsOneThatWasNot) {
    const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = true}));
    const TempFolder folder;
    const tune::TuneResult whole = must(tune::tuneSettings(*context, smallPlan(2), {}));

    // Killed twice, among the settings that are tried alone and after the first generation: the files that were there
    // then are all that is left.
    tune::TunePlan plan = smallPlan(1);
    plan.stateFile = folder + "state.json";
    plan.secondsPerSave = 0;
    const std::string early = folder + "early.json";
    const auto keepEarly = [&](const tune::SearchProgress& progress) {
        if (progress.generation == 0 && progress.tried == 5)
            std::filesystem::copy_file(plan.stateFile, early);
    };
    must(tune::tuneSettings(*context, plan, {.progress = keepEarly, .working = {}}));
    for (const std::string& left : {early, plan.stateFile}) {
        plan.stateFile = left;
        plan.search.generations = 2;
        const tune::TuneResult resumed = must(tune::tuneSettings(*context, plan, {}));
        EXPECT_EQ(figuresOf(resumed), figuresOf(whole)) << left;
    }
    for (const std::string& message : context->validationMessages())
        ADD_FAILURE() << "validation: " << message;

    const Json json = figuresOf(whole);
    ASSERT_FALSE(json["points"].empty());
    for (size_t i = 1; i < json["points"].size(); ++i) {
        EXPECT_LT(json["points"][i - 1]["cost"], json["points"][i]["cost"]);
        EXPECT_GT(json["points"][i - 1]["error"], json["points"][i]["error"]);
    }
    size_t chosen = 0;
    for (const Json& point : json["points"]) {
        chosen += point["chosen"].get<bool>() ? 1 : 0;
        EXPECT_EQ(point["chosen"], point["settings"] == json["choice"]["settings"]);
    }
    EXPECT_EQ(chosen, 1u) << "the choice is a point of the curve";
    // Of the search's views: the budget. Of those held back: nothing is worse than the start.
    ASSERT_TRUE(whole.met);
    const Json start = json["presets"][0], choice = json["choice"];
    EXPECT_LE(choice["cost"].get<double>(), 0.8 * start["cost"].get<double>());
    EXPECT_FALSE(tune::dominates(whole.presets.front().held.figures, whole.choice.held.figures));
    if (whole.held) {
        EXPECT_LE(choice["held"]["error"], start["held"]["error"]);
    }

    // What differs from the start is the choice: the file draws the same picture.
    const std::string file = folder + "tuned.json";
    must(writeFile(file, cli::tunedSettings(whole, {{"builtin:exact"}, "balanced", 0})));
    const render::ProgramSettings read =
        must(render::loadSettings({.defaults = {}, .preset = {}, .file = file, .assignments = {}}));
    EXPECT_TRUE(tune::differences(read.reflections, whole.choice.settings).empty());
    EXPECT_EQ(json["sensitivities"].size(), choice["settings"].size());
}

} // namespace tune_test
} // namespace glint::test
