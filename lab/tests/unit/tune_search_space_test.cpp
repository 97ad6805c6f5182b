// The settings table's column for searches, and candidates of a search.
#include "lab/tune/search_space.hpp"

#include "tests/support/must.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace glint::tune {
namespace tune_search_space_test {

using Scale = SettingSearch::Scale;
using test::must;
using testing::ElementsAre;
using testing::HasSubstr;

const SettingInfo& infoOf(std::string_view key) {
    return *std::ranges::find(settingsTable(), key, &SettingInfo::key);
}

size_t dimensionOf(const SearchSpace& space, std::string_view key) {
    for (size_t i = 0; i < space.size(); ++i)
        if (space[i].info->key == key)
            return i;
    ADD_FAILURE() << key << " is not varied";
    return 0;
}

Settings with(const std::vector<std::pair<std::string, std::string>>& values) {
    Settings settings;
    for (const auto& [key, value] : values)
        must(set(settings, key, value));
    return settings;
}

TEST(TuneSearchSpace, ConditionsOfTheTableNameKeysAndValuesThatExist) {
    size_t searched = 0;
    for (const SettingInfo& info : settingsTable()) {
        searched += info.search.scale != Scale::Never ? 1 : 0;
        for (const SettingSearch::Condition& condition : info.search.conditions) {
            ASSERT_NE(std::ranges::find(settingsTable(), condition.key, &SettingInfo::key), settingsTable().end())
                << info.key << " if " << condition.key;
            const SettingInfo& other = infoOf(condition.key);
            EXPECT_NE(condition.key, info.key);
            for (const std::string& value : condition.values) {
                Settings settings;
                EXPECT_TRUE(set(settings, condition.key, value).ok()) << info.key << " if " << condition.key;
                EXPECT_EQ(settingText(other, settingValue(other, &settings)), value);
            }
            if (condition.values.empty()) {
                EXPECT_LT(condition.above, other.range.max) << info.key;
            }
        }
    }
    EXPECT_GT(searched, 50u);
}

TEST(TuneSearchSpace, ASettingHasAnEffectWhereTheSettingsThatItNamesHaveOne) {
    EXPECT_TRUE(hasEffect(infoOf("hiz.minLevel"), {}));
    EXPECT_FALSE(hasEffect(infoOf("hiz.minLevel"), with({{"screen.march", "linear"}})));
    EXPECT_FALSE(hasEffect(infoOf("hiz.minLevel"), with({{"screen.enabled", "false"}}))); // the marcher has none
    EXPECT_FALSE(hasEffect(infoOf("reuse.radius"), with({{"reuse.samples", "0"}})));
    EXPECT_FALSE(hasEffect(infoOf("reuse.radius"), with({{"denoise.enabled", "false"}})));
    EXPECT_TRUE(hasEffect(infoOf("reuse.radius"), {}));
    EXPECT_FALSE(hasEffect(infoOf("screen.smooth"), with({{"screen.march", "linear"}})));
    EXPECT_TRUE(hasEffect(infoOf("screen.smooth"), with({{"screen.march", "linear"}, {"screen.step", "4"}})));
}

TEST(TuneSearchSpace, SettingsWithoutEffectAreNeverVaried) {
    const SearchSpace space = must(SearchSpace::create(Settings(), {}, true));
    const size_t enabled = dimensionOf(space, "screen.enabled"), march = dimensionOf(space, "screen.march");
    uint64_t state = 1;
    const auto next = [&state] { // any numbers do
        state = state * 6364136223846793005u + 1442695040888963407u;
        return double(state >> 33) / double(1u << 31);
    };
    size_t off = 0;
    for (int round = 0; round < 300; ++round) {
        Genes genes;
        for (size_t i = 0; i < space.size(); ++i)
            genes.push_back(space[i].isWhole() ? std::floor(next() * space[i].choices()) : next());
        const Candidate candidate = space.decode(genes);
        const Settings settings = space.settings(candidate);
        ASSERT_TRUE(validate(settings).ok()) << validate(settings).error().message;
        for (size_t i = 0; i < space.size(); ++i) {
            if (hasEffect(*space[i].info, settings))
                continue;
            ++off;
            EXPECT_EQ(candidate[i], space[i].start) << space[i].info->key;
        }
        EXPECT_EQ(space.canonical(candidate), candidate);
        // Genes of settings without effect change nothing.
        if (candidate[enabled] == 0) {
            Genes other = genes;
            other[march] = std::fmod(genes[march] + 1, space[march].choices());
            EXPECT_EQ(space.decode(other), candidate);
        }
    }
    EXPECT_GT(off, 1000u);
}

TEST(TuneSearchSpace, TheStartIsACandidateWhateverItsDigits) {
    Settings start;
    start.hiz.depthBias = 0.00123456f;
    start.screen.maxDistance = 31415.926f; // beyond what is worth searching
    start.reuse.samples = 11;
    const SearchSpace space = must(SearchSpace::create(start, {}, true));
    EXPECT_EQ(space.decode(space.encode(space.start())), space.start());
    EXPECT_TRUE(differences(start, space.settings(space.start())).empty());
}

TEST(TuneSearchSpace, GenesCoverTheIntervalOnItsScale) {
    const SearchSpace space =
        must(SearchSpace::create(Settings(), std::vector<std::string>{"hiz.maxIterations"}, false));
    ASSERT_EQ(space.size(), 1u);
    EXPECT_EQ(space.decode({0})[0], 8);
    EXPECT_EQ(space.decode({0.5})[0], 64); // the geometric mean of 8 and 512
    EXPECT_EQ(space.decode({1})[0], 512);
    EXPECT_EQ(space.wholeGenes(), 0u);
}

TEST(TuneSearchSpace, ValuesHaveThreeDigits) {
    const SearchSpace space = must(SearchSpace::create(Settings(), std::vector<std::string>{"fade.borderWidth"}, true));
    EXPECT_EQ(space.decode({0.41152263})[0], double(0.123f));
}

TEST(TuneSearchSpace, WithoutProbesNoProxyIsTried) {
    const std::vector<std::string> march = {"screen.march"};
    const Settings proxy = with({{"screen.march", "proxy"}});
    const double value = settingValue(infoOf("screen.march"), &proxy);
    EXPECT_EQ(must(SearchSpace::create(Settings(), march, false, true)).decode({value})[0], value);
    const SearchSpace without = must(SearchSpace::create(Settings(), march, false, false));
    EXPECT_TRUE(without.isLeftOut(0, value));
    EXPECT_EQ(without.decode({value}), without.start());
    EXPECT_FALSE(without.isLeftOut(0, without.start()[0]));
    // A start that has it keeps it.
    EXPECT_EQ(must(SearchSpace::create(proxy, march, false, false)).decode({value})[0], value);
}

TEST(TuneSearchSpace, WhatMattersInMotionOnlyIsVariedInMotionOnly) {
    const auto varies = [](const SearchSpace& space, std::string_view key) {
        for (size_t i = 0; i < space.size(); ++i)
            if (space[i].info->key == key)
                return true;
        return false;
    };
    EXPECT_FALSE(varies(must(SearchSpace::create(Settings(), {}, false)), "denoise.antilag"));
    EXPECT_TRUE(varies(must(SearchSpace::create(Settings(), {}, true)), "denoise.antilag"));
    EXPECT_FALSE(varies(must(SearchSpace::create(Settings(), {}, true)), "order.screen")); // never searched
}

TEST(TuneSearchSpace, UnknownNamesAreErrorsThatHelp) {
    const auto refused = [](const std::string& name) {
        return SearchSpace::create(Settings(), std::vector<std::string>{name}, false).error().message;
    };
    EXPECT_THAT(refused("hiz.maxIteration"), HasSubstr("did you mean hiz.maxIterations?"));
    EXPECT_THAT(refused("thicknessMode"), HasSubstr("did you mean screen.thicknessMode?"));
    EXPECT_THAT(refused("order"), HasSubstr("never varies"));
    EXPECT_THAT(refused("denoise.antilag"), HasSubstr("--paths pan"));
}

TEST(TuneSearchSpace, DifferencesNameWhatDiffers) {
    EXPECT_THAT(differences(Settings(), with({{"screen.step", "4"}, {"rays.enabled", "true"}})),
                ElementsAre("screen.step=4", "rays.enabled=true"));
}

} // namespace tune_search_space_test
} // namespace glint::tune
