// Which passes a frame has, for every preset and for whatever a host provides. Needs no device.
#include "reflect/frame_plan.hpp"

#include "reflect/optional_stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace glint::reflect {
namespace {

using Names = std::set<std::string, std::less<>>;

Settings preset(std::string_view name) {
    Settings settings;
    EXPECT_TRUE(applyPreset(settings, name)) << name;
    return settings;
}

/// A host that provides everything but what changes the shape of the frame for all presets alike.
PlanInputs host(const Settings& settings) {
    PlanInputs inputs;
    inputs.settings = settings;
    inputs.width = inputs.extentWidth = 1280;
    inputs.height = inputs.extentHeight = 720;
    inputs.backDepth = inputs.backDepthFits = true;
    inputs.environment = inputs.scene = inputs.mirrors = inputs.probes = true;
    return inputs;
}

/// What is decided for.
Names decided(const PlanInputs& inputs) {
    Names names;
    for (const FrameDecision& decision : decisionsOf(planFrame(inputs)))
        if (decision.value)
            names.insert(std::string(decision.name));
    return names;
}

/// The inputs that are either so or so.
constexpr bool PlanInputs::*kSwitches[] = {&PlanInputs::views,
                                           &PlanInputs::inspection,
                                           &PlanInputs::statistics,
                                           &PlanInputs::transparentLayers,
                                           &PlanInputs::manySamples,
                                           &PlanInputs::resolvesMaterial,
                                           &PlanInputs::backDepth,
                                           &PlanInputs::backDepthFits,
                                           &PlanInputs::transparentDepth,
                                           &PlanInputs::environment,
                                           &PlanInputs::compositeOutput,
                                           &PlanInputs::reflectionOutput,
                                           &PlanInputs::scene,
                                           &PlanInputs::shadesHits,
                                           &PlanInputs::mirrors,
                                           &PlanInputs::probes,
                                           &PlanInputs::coat};

/// Settings that presets do not have.
std::vector<Settings> manySettings() {
    std::vector<Settings> all;
    for (const std::string_view name : presetNames())
        all.push_back(preset(name));
    const auto with = [&](std::string_view name, const auto& change) { change(all.emplace_back(preset(name))); };
    with("balanced", [](Settings& s) { s.reflect.strength = 0; });
    with("balanced", [](Settings& s) { s.debug.outcome = true; });
    with("balanced", [](Settings& s) { s.refraction.enabled = false; });
    with("hdrp", [](Settings& s) { s.screen.transparents = true; });
    with("hdrp", [](Settings& s) { s.screen.enabled = false; });
    with("hdrp", [](Settings& s) { s.rough.cones = false; });
    with("quality", [](Settings& s) { s.denoise.stabilizeSeconds = 0.2f; });
    with("quality", [](Settings& s) { s.denoise.antilag = Antilag::Gradient; });
    with("quality", [](Settings& s) { s.denoise.antilag = Antilag::Off; });
    with("babylon", [](Settings& s) { s.blur.downsample = 1; });
    with("hybrid", [](Settings& s) { s.rays.interpolate = 0.1f; });
    with("hybrid", [](Settings& s) { s.planar.enabled = s.probes.enabled = s.sky.enabled = false; });
    return all;
}

template <class Check>
void forEveryInput(const Check& check) {
    for (const Settings& settings : manySettings())
        for (uint32_t bits = 0; bits < 1u << std::size(kSwitches); ++bits) {
            PlanInputs inputs = host(settings);
            for (size_t i = 0; i < std::size(kSwitches); ++i)
                inputs.*kSwitches[i] = (bits >> i & 1) != 0;
            check(inputs);
            if (testing::Test::HasFailure())
                return;
        }
}

TEST(FramePlan, everyPresetHasItsPasses) {
    const Names anyScreen = {"screen", "planar", "probes", "sky", "reflects", "records", "tracesScreen", "composites"};
    const Names anyRays = {"rays", "planar", "probes", "sky", "reflects", "records", "composites", "keepsRecord"};
    const auto all = [](Names names, const Names& more, std::string_view without = {}) {
        names.insert(more.begin(), more.end());
        names.erase(std::string(without));
        return names;
    };
    const Names hiz = {"pyramid", "backFaces", "backFacesInPlace"};
    const Names denoised = all(hiz, {"denoise", "keepsRecord", "findsChange"});
    const std::map<std::string_view, Names> expected = {
        {"babylon", all(anyScreen, {"classifiesEarly", "blur", "keepsRecord", "pyramid"}, "sky")},
        {"balanced", all(anyScreen, all(denoised, {"followsPlaces", "ratesRays"}))},
        {"compute-ssr", all(anyScreen, {"keepsRecord", "upsample"}, "sky")},
        {"fast", all(anyScreen, {"keepsRecord", "upsample", "pyramid", "cones"})},
        {"hdrp", all(anyScreen, {"classifiesEarly", "keepsRecord", "pyramid", "cones", "previousColors"})},
        {"hybrid", all(anyScreen, all(hiz, {"rays", "classifiesEarly", "cones", "keepsRecord", "previousEnds"}))},
        {"quality", all(anyScreen, all(denoised, {"rays", "followsPaths", "sampleLights", "previousEnds"}))},
        {"ray-query", all(anyRays, {"backFaces", "backFacesInPlace", "previousEnds"})},
        {"real-time", all(anyScreen, all(denoised, {"rays", "followsPaths", "ratesRays", "previousEnds"}))},
        {"reference", all(anyRays, {"backFaces", "backFacesInPlace", "sampleLights"})},
    };
    for (const std::string_view name : presetNames()) {
        ASSERT_TRUE(expected.contains(name)) << name;
        EXPECT_EQ(decided(host(preset(name))), expected.at(name)) << name;
    }
}

/// Each input changes a decision, and each decision is taken both ways.
TEST(FramePlan, everyInputAndEveryDecisionActs) {
    std::set<size_t> acting;
    std::vector<FrameDecision> first;
    std::vector<bool> changes;
    forEveryInput([&](const PlanInputs& inputs) {
        const FramePlan plan = planFrame(inputs);
        const std::vector<FrameDecision> decisions = decisionsOf(plan);
        if (first.empty())
            first = decisions;
        changes.resize(first.size());
        for (size_t i = 0; i < decisions.size(); ++i)
            if (decisions[i].value != first[i].value)
                changes[i] = true;
        for (size_t i = 0; i < std::size(kSwitches); ++i) {
            if (acting.contains(i))
                continue;
            PlanInputs other = inputs;
            other.*kSwitches[i] = !(inputs.*kSwitches[i]);
            if (planFrame(other) != plan)
                acting.insert(i);
        }
    });
    EXPECT_EQ(acting.size(), std::size(kSwitches));
    for (size_t i = 0; i < changes.size(); ++i)
        EXPECT_TRUE(changes[i]) << first[i].name;
}

TEST(FramePlan, decisionsAgreeWithEachOther) {
    const auto implies = [](bool one, bool other) { return !one || other; };
    forEveryInput([&](const PlanInputs& inputs) {
        const FramePlan plan = planFrame(inputs);
        ASSERT_TRUE(implies(plan.reflects, plan.records));
        ASSERT_EQ(plan.tracesScreen, plan.screen && plan.reflects);
        ASSERT_TRUE(implies(plan.blur || plan.upsample || plan.cones || plan.transparents, plan.tracesScreen));
        ASSERT_TRUE(implies(plan.denoise, !plan.blur && !plan.upsample && !plan.cones && !plan.classifiesEarly));
        ASSERT_TRUE(implies(plan.storesListedOnly, plan.classifiesEarly && !plan.keepsRecord && !plan.combines));
        ASSERT_TRUE(implies(plan.storesListedOnly,
                            !plan.rays && (inputs.settings.reflect.strength <= 0 || (!plan.planar && !plan.probes))));
        ASSERT_TRUE(implies(plan.blur || plan.upsample || plan.denoise || plan.rays, plan.keepsRecord));
        ASSERT_FALSE(plan.followsPaths && plan.followsPlaces);
        ASSERT_TRUE(implies(plan.followsPaths, plan.findsChange && plan.rays && !plan.shadesHits));
        ASSERT_TRUE(implies(plan.followsPlaces, plan.findsChange && plan.screen));
        ASSERT_TRUE(implies(plan.findsChange || plan.ratesRays || plan.stabilizes, plan.denoise));
        ASSERT_TRUE(implies(plan.sampleLights || plan.interpolatesRays, plan.rays && !plan.shadesHits));
        ASSERT_TRUE(implies(plan.previousEnds, plan.rays && !plan.shadesHits && plan.composites));
        ASSERT_TRUE(implies(plan.backFacesInPlace, plan.backFaces && !plan.manySamples));
        ASSERT_TRUE(implies(plan.layers, plan.composites && plan.pyramid));
        ASSERT_TRUE(implies(inputs.reflectionOutput || inputs.manySamples, plan.combines));
        ASSERT_TRUE(implies(plan.coat, inputs.coat && plan.combines && plan.composites && !plan.classifiesEarly));
    });
}

/// A pass that a plan has belongs to a stage that the list has created for its settings.
TEST(FramePlan, whatIsRecordedIsMade) {
    const auto implies = [](bool one, bool other) { return !one || other; };
    forEveryInput([&](const PlanInputs& inputs) {
        const FramePlan plan = planFrame(inputs);
        ASSERT_TRUE(implies(plan.pyramid, DepthPyramid::wanted(inputs)));
        ASSERT_TRUE(implies(plan.cones, ConePicture::wanted(inputs.settings)));
        ASSERT_TRUE(implies(plan.transparents, TransparentTrace::wanted(inputs.settings)));
        ASSERT_EQ(plan.denoise, Denoiser::wanted(inputs.settings));
        ASSERT_TRUE(implies(plan.rays, RaysSource::wanted(inputs.settings)));
        ASSERT_TRUE(implies(plan.layers, Refraction::wanted(inputs)));
        ASSERT_TRUE(implies(plan.countsRays, RayCounts::wanted(inputs)));
    });
}

/// Images are made for all pixels; a frame that uses fewer of them has no pass that these do not have.
TEST(FramePlan, aSmallerExtentNeedsNoMore) {
    for (const Settings& settings : manySettings())
        for (uint32_t side = 1; side <= 720; ++side) {
            PlanInputs inputs = host(settings);
            const FramePlan whole = planFrame(inputs);
            inputs.extentWidth = side;
            inputs.extentHeight = side;
            FramePlan used = planFrame(inputs);
            ASSERT_TRUE(whole.upsample || !used.upsample) << side;
            used.upsample = whole.upsample;
            ASSERT_EQ(used, whole) << side;
        }
}

/// Optional stages that the frame records at their moments have rows of their own, by the names of their passes.
TEST(FramePlan, theListDescribesItsStages) {
    OptionalStages stages;
    const auto rows = [&](const Settings& settings) {
        stages.plan(host(settings));
        std::vector<FrameDecision> all;
        stages.describe(all);
        std::map<std::string_view, bool> byName;
        for (const FrameDecision& row : all)
            byName[row.name] = row.value;
        return byName;
    };
    Settings settings = preset("hdrp");
    settings.screen.transparents = true;
    EXPECT_EQ(rows(settings), (std::map<std::string_view, bool>{
                                  {"resolve/lobe", true}, {"trace/picture", true}, {"trace/transparents", true}}));
    EXPECT_EQ(rows(preset("quality")),
              (std::map<std::string_view, bool>{
                  {"resolve/lobe", false}, {"trace/picture", false}, {"trace/transparents", false}}));
}

} // namespace
} // namespace glint::reflect
