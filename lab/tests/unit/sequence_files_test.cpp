// The files of a sequence: numbered names, and the video that another program makes of them.
#include "lab/cli/sequence/sequence_files.hpp"

#include "base/file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace glint::cli {
namespace sequence_files_test {

using test::must;

TEST(FramePattern, NumbersFrames) {
    const FramePattern padded = must(FramePattern::parse("out/frame_%04d.png"));
    EXPECT_EQ(padded.path(7), "out/frame_0007.png");
    EXPECT_EQ(padded.path(12345), "out/frame_12345.png");
    EXPECT_EQ(padded.folder(), "out");
    EXPECT_EQ(padded.video(), "out/frame.mp4");
    EXPECT_EQ(padded.inFolder("2-fast").path(1), "out/2-fast/frame_0001.png");
    const FramePattern plain = must(FramePattern::parse("%d.exr"));
    EXPECT_EQ(plain.path(7), "7.exr");
    EXPECT_EQ(plain.kind(), PictureKind::Exr);
    EXPECT_EQ(plain.video(), "video.mp4");
}

TEST(FramePattern, RefusesNamesWithoutOneNumber) {
    for (const char* text : {"frame.png", "-", "%s.png", "%4d.png", "%0d.png", "%d%d.png", "%d_100%.png", "%04d"})
        EXPECT_EQ(FramePattern::parse(text).error().code, ErrorCode::InvalidArgument) << text;
}

TEST(SequenceVideo, IsMadeByTheProgramFromAllFrames) {
    const test::TempFolder folder;
    const std::string program = folder + "maker", arguments = folder + "arguments";
    must(writeFile(program, "#!/bin/sh\necho \"$@\" > " + arguments + "\n"));
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const FramePattern pattern = must(FramePattern::parse(folder + "f_%04d.png"));
    must(writeVideo(pattern, 29.97, program));
    EXPECT_THAT(must(readFile(arguments, 1 << 16)),
                testing::AllOf(testing::HasSubstr("-framerate 29.97 "),
                               testing::HasSubstr("-i " + folder.path() + "f_%04d.png"),
                               testing::HasSubstr(folder + "f.mp4")));
    must(writeFile(program, "#!/bin/sh\necho no codec >&2\nexit 3\n"));
    const auto failed = writeVideo(pattern, 60, program);
    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().message, testing::HasSubstr("no codec"));
    EXPECT_EQ(writeVideo(pattern, 60, folder + "none").error().code, ErrorCode::NotFound);
}

} // namespace sequence_files_test
} // namespace glint::cli
