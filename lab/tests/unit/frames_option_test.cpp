// `--config frames=...`: which files it names, and what it takes for a mistake.
#include "lab/cli/frames_option.hpp"

#include "lab/tests/support/exr_writer.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

namespace glint::cli {
namespace frames_option_test {

using test::must;
using testing::HasSubstr;

/// Two frames of one pixel, whose radiance is `value` and `value` + 1.
void writeFrames(const std::string& stem, float value) {
    for (const int frame : {0, 1}) {
        test::ExrPart part{"", 1, 1, {}};
        for (const char* channel : {"R", "G", "B"})
            part.planes.emplace_back(channel, std::vector<float>{value + float(frame)});
        test::writeExrFile(stem + std::to_string(frame) + ".exr", std::move(part));
    }
}

float radiance(const measure::StoredFrames& stored, size_t seed, size_t frame) {
    return must(stored.read(seed, frame)).reflection[0];
}

TEST(FramesOption, NamesFramesOfOneOrTwoSeeds) {
    const test::TempFolder folder;
    writeFrames(folder + "a:", 1); // colons may be in names
    writeFrames(folder + "b", 5);
    const std::string a = folder + "a:%d.exr", b = folder + "b%d.exr";
    EXPECT_TRUE(namesFrames("frames=" + a));
    EXPECT_FALSE(namesFrames("fast"));
    const measure::StoredFrames one = must(openFrames("frames=" + a, 2));
    EXPECT_EQ(one.seeds(), 1u);
    EXPECT_EQ(radiance(one, 0, 1), 2);
    const measure::StoredFrames two = must(openFrames("frames=" + a + ":" + b, 2));
    EXPECT_EQ(two.seeds(), 2u);
    EXPECT_EQ(radiance(two, 0, 0), 1);
    EXPECT_EQ(radiance(two, 1, 1), 6);
    EXPECT_EQ(openFrames("frames=" + b, 3).error().code, ErrorCode::NotFound);
}

TEST(FramesOption, OtherFormsAreErrorsThatSayWhatIsExpected) {
    for (const char* text : {"frames=", "frames=a.exr", "frames=a%d.png", "frames=a%d.exr:", "frames=a%d.exr:b.exr",
                             "frames=a%d.exr:b%d.exr:c%d.exr", "frames=a%d.exr,b%d.exr"}) {
        const auto opened = openFrames(text, 1);
        ASSERT_FALSE(opened) << text;
        EXPECT_EQ(opened.error().code, ErrorCode::InvalidArgument) << text;
        EXPECT_THAT(opened.error().message,
                    HasSubstr(std::string("--config ") + text + ": expected frames=A/%04d.exr"));
    }
    EXPECT_THAT(openFrames("frames=a%d.exr:a%d.exr", 1).error().message, HasSubstr("both seeds are the same files"));
}

} // namespace frames_option_test
} // namespace glint::cli
