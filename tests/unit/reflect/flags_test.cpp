// Flags of one word have bits of their own: read from the headers that shaders share, so that no flag is forgotten.
#include "base/file.hpp"

#include <gtest/gtest.h>

#include <map>
#include <regex>

namespace glint::reflect {
namespace {

struct Word {
    const char* file;
    const char* flags; ///< regular expression: their names
    size_t least;      ///< number of them, so that the test finds them
};

class FlagsTest : public testing::TestWithParam<Word> {};

TEST_P(FlagsTest, haveBitsOfTheirOwn) {
    const auto text = readFile(std::string(GLINT_SOURCE_DIR "/shaders/shared/") + GetParam().file, 1 << 20);
    ASSERT_TRUE(text) << text.error().message;
    const std::regex constant("GLINT_CONSTANT\\(uint, (" + std::string(GetParam().flags) + "),\\s*(\\d+)u?\\)");
    std::map<unsigned long, std::string> names;
    for (std::sregex_iterator found(text->begin(), text->end(), constant), end; found != end; ++found) {
        const unsigned long bit = std::stoul((*found)[2]);
        EXPECT_EQ(bit & (bit - 1), 0u) << (*found)[1];
        const auto [other, isNew] = names.emplace(bit, (*found)[1]);
        EXPECT_TRUE(isNew) << (*found)[1] << " and " << other->second << " are both " << bit;
    }
    EXPECT_GE(names.size(), GetParam().least);
}

INSTANTIATE_TEST_SUITE_P(
    Words, FlagsTest,
    testing::Values(Word{"frame_constants.h", "k(?:Input|History|Output|TraceTarget|Lobe)\\w*", 28},
                    Word{"trace_constants.h", "k(?:Trace|Fade)\\w+", 19},
                    Word{"rays_constants.h",
                         "kRays(?:AlphaTest|Mirror|Environment\\w*|Accumulate|Reuse\\w*|Transparent\\w*|"
                         "Sample\\w*|Branches|PreviousEnds|Cone)",
                         14}),
    [](const auto& word) { return std::string(word.param.file, word.param.file + 4); });

} // namespace
} // namespace glint::reflect
