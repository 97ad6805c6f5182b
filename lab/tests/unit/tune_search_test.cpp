// The search on objectives whose best settings are known: no pictures are drawn.
#include "lab/tune/search.hpp"

#include "tests/support/must.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::tune {
namespace tune_search_test {

using test::must;

/// Cost falls with what hiz.depthBias and hiz.minLevel leave out, error rises with it; hiz.maxLevel has no effect. The
/// best trade-off has depthBias at its lower end for every minLevel, so it has four points.
Evaluation traded(const Settings& settings) {
    const double level = settings.hiz.minLevel;
    const double bias = std::log10(double(settings.hiz.depthBias) / 1e-4);
    const double iterations = std::log2(settings.hiz.maxIterations / 8.0);
    const Figures figures = {10 - 2 * level + bias + iterations / 100, 1 + level * level + bias};
    return {figures, {{"view", figures}}, 0};
}

struct Searched {
    SearchOutcome outcome;
    uint32_t evaluated = 0;

    std::vector<Figures> figures() const {
        std::vector<Figures> result;
        for (const Tried& tried : outcome.tried)
            result.push_back(tried.evaluation.figures);
        return result;
    }
};

SearchPlan planOf(uint32_t generations, uint32_t seed = 0) {
    SearchPlan plan;
    plan.vary = {"hiz"};
    plan.population = 16;
    plan.generations = generations;
    plan.seed = seed;
    return plan;
}

Searched search(const SearchPlan& plan, SearchHooks hooks = {}) {
    Searched run;
    if (!hooks.evaluate)
        hooks.evaluate = [&run](const Settings& settings, double) -> Result<Evaluation> {
            ++run.evaluated;
            return traded(settings);
        };
    run.outcome = must(searchSettings(plan, hooks));
    return run;
}

TEST(TuneSearch, FindsTheCurve) {
    const Searched run = search(planOf(30));
    const std::vector<Figures> figures = run.figures();
    std::vector<Figures> front;
    for (const size_t i : paretoFront(figures))
        front.push_back(figures[i]);
    // Level 0 to 3 with the least bias and the fewest iterations: cost 10 - 2 level, error 1 + level^2.
    for (int level = 0; level <= 3; ++level) {
        const auto near = [&](const Figures& each) {
            return each.cost < 10 - 2 * level + 0.1 && each.error < 1 + level * level + 0.1;
        };
        EXPECT_TRUE(std::ranges::any_of(front, near)) << level;
    }
    EXPECT_EQ(run.outcome.generations, 30u);
}

TEST(TuneSearch, EvaluatesNothingTwice) {
    const Searched run = search(planOf(10));
    EXPECT_EQ(run.evaluated, run.outcome.tried.size());
    for (size_t i = 0; i < run.outcome.tried.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            EXPECT_FALSE(differences(run.outcome.tried[i].settings, run.outcome.tried[j].settings).empty());
}

TEST(TuneSearch, OneSeedGivesOneResultAndAnotherSeedAnother) {
    const Searched first = search(planOf(6, 3)), second = search(planOf(6, 3)), other = search(planOf(6, 4));
    ASSERT_EQ(first.outcome.tried.size(), second.outcome.tried.size());
    for (size_t i = 0; i < first.outcome.tried.size(); ++i)
        EXPECT_TRUE(differences(first.outcome.tried[i].settings, second.outcome.tried[i].settings).empty()) << i;
    EXPECT_NE(first.figures(), other.figures());
}

TEST(TuneSearch, AShorterSearchIsTheBeginningOfALongerOne) {
    const Searched shorter = search(planOf(3)), longer = search(planOf(6));
    ASSERT_LT(shorter.outcome.tried.size(), longer.outcome.tried.size());
    for (size_t i = 0; i < shorter.outcome.tried.size(); ++i)
        EXPECT_TRUE(differences(shorter.outcome.tried[i].settings, longer.outcome.tried[i].settings).empty()) << i;
}

TEST(TuneSearch, WhatIsDearIsTriedWithLessOfItAndPaidForElsewhere) {
    // Rays for everything are given up; rays for smooth surfaces take most of the error for little.
    SearchPlan plan = planOf(0);
    plan.vary = {"hiz", "rays"};
    plan.mostCost = 13; // the start costs 11.04
    SearchHooks hooks;
    hooks.evaluate = [](const Settings& settings, double mostCost) -> Result<Evaluation> {
        Evaluation evaluation = traded(settings);
        if (settings.rays.enabled) {
            const double traced = settings.rays.maxRoughness;
            evaluation.figures.cost += 40 * traced;
            evaluation.figures.error *= traced >= 0.1 ? 0.3 : 1;
            evaluation.views.front().figures = evaluation.figures;
        }
        const double infinite = std::numeric_limits<double>::infinity();
        return evaluation.figures.cost > mostCost ? Evaluation{{infinite, infinite}, {}, mostCost} : evaluation;
    };
    const Searched run = search(plan, hooks);
    const Figures start = run.figures().front();
    EXPECT_TRUE(std::ranges::any_of(run.figures(), [&](const Figures& each) {
        return each.cost < 1.1 * start.cost && each.error < 0.4 * start.error;
    }));
}

TEST(TuneSearch, WhatActsOnlyWithTheBestIsTriedThereAndTakenTogether) {
    // Rays for smooth surfaces are better; only then a second bounce and rays between which pixels interpolate matter.
    SearchPlan plan = planOf(0);
    plan.vary = {"hiz.minLevel", "denoise.enabled", "rays"};
    SearchHooks hooks;
    hooks.evaluate = [](const Settings& settings, double) -> Result<Evaluation> {
        Figures figures = {settings.denoise.enabled ? 20.0 : 10.0, settings.denoise.enabled ? 1.0 : 1.1};
        if (settings.rays.enabled) {
            figures.error *= std::array{0.8, 0.6, 0.3, 0.29}[static_cast<size_t>(settings.rays.bounces) - 1];
            const bool between = !settings.denoise.enabled && settings.rays.interpolate > 0;
            figures.cost += settings.rays.maxRoughness * 40 * (between ? 0.5 : 1) + 0.5;
        }
        return Evaluation{figures, {{"view", figures}}, 0};
    };
    const Searched run = search(plan, hooks);
    const auto isBest = [](const Tried& tried) {
        const RaysSettings& rays = tried.settings.rays;
        return !tried.settings.denoise.enabled && rays.enabled && rays.bounces >= 3 && rays.interpolate > 0 &&
               rays.maxRoughness < 0.2f;
    };
    EXPECT_TRUE(std::ranges::any_of(run.outcome.tried, isBest));
    EXPECT_EQ(run.outcome.tried.front().settings.rays.bounces, 1);
}

TEST(TuneSearch, ATimeLimitEndsItBetweenGenerations) {
    SearchHooks hooks;
    uint32_t asked = 0;
    hooks.evaluate = [](const Settings& settings, double) -> Result<Evaluation> { return traded(settings); };
    hooks.mayGoOn = [&] { return ++asked <= 2; };
    const Searched limited = search(planOf(6), hooks), whole = search(planOf(2));
    EXPECT_EQ(limited.outcome.generations, 2u);
    EXPECT_EQ(limited.figures(), whole.figures());
}

TEST(TuneSearch, SettingsThatChangeNothingAreFoundAndLeftAlone) {
    const Searched run = search(planOf(8));
    EXPECT_THAT(run.outcome.withoutEffect, testing::ElementsAre("hiz.maxLevel"));
    const Settings start;
    uint32_t varied = 0;
    for (const Tried& tried : run.outcome.tried)
        varied += tried.settings.hiz.maxLevel != start.hiz.maxLevel ? 1 : 0;
    EXPECT_LE(varied, 2u); // its own probes
}

TEST(TuneSearch, ConditionsHoldForEverythingTried) {
    SearchPlan plan = planOf(6);
    plan.vary = {"screen.march", "hiz", "adaptive"};
    const Searched run = search(plan);
    const Settings start;
    size_t linear = 0;
    for (const Tried& tried : run.outcome.tried) {
        if (tried.settings.screen.march == March::Hiz) {
            EXPECT_EQ(tried.settings.adaptive.steps, start.adaptive.steps);
        } else {
            EXPECT_EQ(tried.settings.hiz.minLevel, start.hiz.minLevel);
        }
        linear += tried.settings.screen.march == March::Linear ? 1 : 0;
    }
    EXPECT_EQ(linear, 1u); // nothing that is varied has an effect on it
}

TEST(TuneSearch, PresetsAreTriedAsTheyAre) {
    SearchPlan plan = planOf(1);
    Settings preset;
    preset.hiz.minLevel = 3;
    preset.screen.maxDistance = 77; // not varied
    plan.presets = {{"mine", preset}};
    const Searched run = search(plan);
    EXPECT_TRUE(differences(run.outcome.tried[0].settings, Settings()).empty());
    EXPECT_TRUE(differences(run.outcome.tried[1].settings, preset).empty());
}

TEST(TuneSearch, CandidatesThatWereGivenUpDoNotStopIt) {
    SearchPlan plan = planOf(30); // as many as the curve takes
    plan.mostCost = 11.5;         // the start costs 11.04
    SearchHooks hooks;
    hooks.evaluate = [](const Settings& settings, double mostCost) -> Result<Evaluation> {
        const Evaluation evaluation = traded(settings);
        const double infinite = std::numeric_limits<double>::infinity();
        return evaluation.figures.cost > mostCost ? Evaluation{{infinite, infinite}, {}, mostCost} : evaluation;
    };
    const Searched run = search(plan, hooks);
    const std::vector<Figures> figures = run.figures();
    EXPECT_TRUE(std::ranges::any_of(figures, [](const Figures& each) { return std::isinf(each.cost); }));
    EXPECT_LT(figures[paretoFront(figures).front()].cost, 4.5); // the cheapest has 4
}

TEST(TuneSearch, AFailedEvaluationEndsItWithItsError) {
    SearchHooks hooks;
    uint32_t evaluated = 0;
    hooks.evaluate = [&](const Settings& settings, double) -> Result<Evaluation> {
        if (++evaluated > 30) // in a generation: through the optimiser
            return makeError(ErrorCode::DeviceLost, "the device is lost");
        return traded(settings);
    };
    const auto outcome = searchSettings(planOf(8), hooks);
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(outcome.error().message, "the device is lost");
}

} // namespace tune_search_test
} // namespace glint::tune
