// Helpers on text for messages.
#include "base/text.hpp"

#include <gtest/gtest.h>

namespace glint {
namespace text_test {

TEST(Text, ListsReadAsASentence) {
    EXPECT_EQ(listText({}, " or "), "");
    const std::vector<std::string> names = {"a", "b", "c"};
    EXPECT_EQ(listText(std::span(names).first(1), " or "), "a");
    EXPECT_EQ(listText(std::span(names).first(2), " or "), "a or b");
    EXPECT_EQ(listText(names, " or "), "a, b or c");
}

TEST(Text, CaseOfLettersIsIgnoredAndNothingElse) {
    EXPECT_TRUE(equalIgnoringCase("HiZ", "hiz"));
    EXPECT_TRUE(equalIgnoringCase("", ""));
    EXPECT_FALSE(equalIgnoringCase("hiz", "hi"));
    EXPECT_FALSE(equalIgnoringCase("[", "{")); // 0x20 apart, as letters' cases are
    EXPECT_EQ(editDistance("Kitten", "SITTING"), 3u);
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("abc", ""), 3u);
}

TEST(Text, LikelyMeantIsNearOrNothing) {
    const std::vector<std::string_view> names = {"sitting", "step"};
    EXPECT_EQ(likelyMeant("Stp", names), "step");
    EXPECT_EQ(likelyMeant("siting", names), "sitting");
    EXPECT_EQ(likelyMeant("kitten", names), "");
    EXPECT_EQ(likelyMeant("", names), "");
    EXPECT_EQ(likelyMeant("step", {}), "");
    EXPECT_EQ(likelyMeant(std::string(100000, 's'), names), "");
}

TEST(Text, PrintableIsOneLineAndShort) {
    EXPECT_EQ(printable("plain"), "plain");
    EXPECT_EQ(printable("a\nb\x7f\x1b"), "a?b??");
    EXPECT_EQ(printable("0123456789", 4), "0123...");
}

} // namespace text_test
} // namespace glint
