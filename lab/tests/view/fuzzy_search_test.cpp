#include "lab/view/fuzzy_search.hpp"
#include "lab/view/palette_entries.hpp"

#include <gtest/gtest.h>

namespace glint::view {
namespace fuzzy_search_test {

TEST(FuzzySearch, LettersHaveToComeInOrder) {
    EXPECT_TRUE(fuzzyScore("rmin", "Reflect Min"));
    EXPECT_TRUE(fuzzyScore("REFLECT MIN", "reflect min"));
    EXPECT_FALSE(fuzzyScore("nim", "Min"));
    EXPECT_FALSE(fuzzyScore("reflectx", "Reflect Min"));
    EXPECT_FALSE(fuzzyScore("a", ""));
    EXPECT_EQ(fuzzyScore("", "anything"), 0);
    EXPECT_EQ(fuzzyScore("", ""), 0);
}

TEST(FuzzySearch, BeginningsOfWordsAndRunsCountMore) {
    EXPECT_GT(fuzzyScore("max", "screen.maxDistance"), fuzzyScore("max", "compare.marginax"));
    EXPECT_GT(fuzzyScore("md", "screen.maxDistance"), fuzzyScore("md", "aamaaad"));
    EXPECT_GT(fuzzyScore("step", "screen.step"), fuzzyScore("step", "screen.targetepochs"));
    EXPECT_GT(fuzzyScore("step", "step"), fuzzyScore("step", "a long name with a step in it"));
}

TEST(FuzzySearch, TakesTheBestOfSeveralWays) {
    // The first m is no good start: "march" follows later, in one piece.
    EXPECT_GT(fuzzyScore("march", "mode of march"), fuzzyScore("march", "m a r c h"));
}

TEST(Palette, ReflectMinStandsOnThePageThatComputeSsrHasItOn) {
    ASSERT_GE(palettePages().size(), 3u);
    const PaletteEntry& entry = palettePages()[2].entries.front();
    EXPECT_EQ(entry.name, "Reflect Min");
    ASSERT_TRUE(entry.setting);
    EXPECT_EQ(entry.setting->key, "reflect.threshold");
}

TEST(Palette, FindsCommandsAndSettingsByAnyOfTheirNames) {
    const auto first = [](std::string_view text) {
        const auto found = searchPalette(text);
        return found.empty() ? std::string("nothing") : found.front().name;
    };
    EXPECT_EQ(first("reflect min"), "Reflect Min");
    EXPECT_EQ(first("rfmin"), "Reflect Min");
    EXPECT_EQ(first("undo"), "Undo");
    EXPECT_EQ(first("screen.step"), "screen.step");
    EXPECT_EQ(first("attenuateFacingCamera"), "fade.facingCamera"); // Babylon.js's name
    EXPECT_EQ(first("qqqqzzz"), "nothing");
}

TEST(Palette, EachSettingIsFoundOnce) {
    size_t found = 0;
    for (const PaletteEntry& entry : searchPalette("threshold"))
        found += entry.setting && entry.setting->key == "reflect.threshold";
    EXPECT_EQ(found, 1u);
}

} // namespace fuzzy_search_test
} // namespace glint::view
