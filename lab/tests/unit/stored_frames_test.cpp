// Frames that another program made: which layers are read, and what is said of files that do not fit.
#include "lab/measure/motion/stored_frames.hpp"

#include "lab/tests/support/exr_writer.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace glint::measure {
namespace stored_frames_test {

using test::ExrPlane;
using test::must;
using testing::HasSubstr;

constexpr int kWide = 3, kHigh = 2;

class StoredFramesTest : public testing::Test {
protected:
    /// Each channel of the file has a value of its own: 1, 2, 3, ...
    std::string write(const std::string& name, const std::vector<std::string>& channels, int width = kWide,
                      float last = 0) {
        test::ExrPart part{"", width, kHigh, {}};
        for (const std::string& channel : channels)
            part.planes.emplace_back(channel, std::vector<float>(size_t(width) * kHigh, float(part.planes.size() + 1)));
        if (last != 0)
            part.planes.back().second.back() = last;
        test::writeExrFile(folder_ + name, std::move(part));
        return folder_ + name;
    }
    std::string reflection(const std::string& name) {
        return write(name, {"reflection.R", "reflection.G", "reflection.B"});
    }
    static Error errorOf(std::vector<std::vector<std::string>> files, size_t frame = 0) {
        auto stored = StoredFrames::open(std::move(files));
        if (!stored)
            return stored.error();
        auto read = stored->read(stored->seeds() - 1, frame);
        return read ? Error{} : read.error();
    }

    test::TempFolder folder_;
};

TEST_F(StoredFramesTest, TheLayerIsTheReflectionAndTheRootTheComposite) {
    const std::string path = write("a.exr", {"B", "G", "R", "reflection.R", "reflection.G", "reflection.B", "depth.Z"});
    const StoredFrames stored = must(StoredFrames::open({{path}}));
    EXPECT_EQ(stored.seeds(), 1u);
    EXPECT_EQ(stored.width(), uint32_t(kWide));
    EXPECT_EQ(stored.height(), uint32_t(kHigh));
    EXPECT_TRUE(stored.hasComposite());
    const StoredFrame frame = must(stored.read(0, 0));
    ASSERT_EQ(frame.reflection.size(), size_t(4 * kWide * kHigh));
    EXPECT_EQ((std::vector<float>(frame.reflection.end() - 4, frame.reflection.end())),
              (std::vector<float>{4, 5, 6, 1}));
    EXPECT_EQ((std::vector<float>(frame.composite.begin(), frame.composite.begin() + 4)),
              (std::vector<float>{3, 2, 1, 1}));
}

TEST_F(StoredFramesTest, WithoutTheLayerTheRootIsTheReflection) {
    const StoredFrames stored = must(StoredFrames::open({{write("a.exr", {"R", "G", "B", "A"})}}));
    EXPECT_FALSE(stored.hasComposite());
    const StoredFrame frame = must(stored.read(0, 0));
    EXPECT_EQ(frame.reflection[2], 3);
    EXPECT_TRUE(frame.composite.empty());
}

/// Only what both seeds have can be measured.
TEST_F(StoredFramesTest, TheCompositeOfOneSeedAloneIsLeftOut) {
    const std::string both = write("a.exr", {"R", "G", "B", "reflection.R", "reflection.G", "reflection.B"});
    EXPECT_FALSE(must(StoredFrames::open({{both}, {reflection("b.exr")}})).hasComposite());
    EXPECT_FALSE(must(StoredFrames::open({{reflection("b.exr")}, {both}})).hasComposite());
}

TEST_F(StoredFramesTest, WhatDoesNotFitIsNamed) {
    const std::string good = reflection("good.exr"), none = folder_ + "none.exr";
    const std::string root = write("root.exr", {"R", "G", "B"});
    const std::string lacks = write("lacks.exr", {"depth.Z", "reflection.R"});
    const std::string wide = write("wide.exr", {"reflection.R", "reflection.G", "reflection.B"}, 4);
    const Error missing = errorOf({{good, none}});
    EXPECT_EQ(missing.code, ErrorCode::NotFound);
    EXPECT_THAT(missing.message, HasSubstr(none + ": no such frame; the files of 2 frames are needed"));
    const Error channels = errorOf({{lacks}});
    EXPECT_EQ(channels.code, ErrorCode::InvalidInput);
    EXPECT_THAT(channels.message, HasSubstr(lacks + ": no layer reflection with channels R, G, B"));
    EXPECT_THAT(channels.message, HasSubstr("it has depth.Z, reflection.R"));
    EXPECT_THAT(errorOf({{good}, {root}}).message, HasSubstr(root + ": it has no layer reflection, unlike " + good));
    EXPECT_THAT(errorOf({{good, wide}}, 1).message, HasSubstr(wide + ": 4x2 pixels, but " + good + " has 3x2"));
    EXPECT_THAT(errorOf({{good, lacks}}, 1).message,
                HasSubstr(lacks + ": no channels R, G, B of layer reflection, which " + good + " has"));
    EXPECT_EQ(errorOf({{good}, {good}}).message, "");
}

TEST_F(StoredFramesTest, EveryValueIsAFiniteNumber) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        const std::string path = write("bad.exr", {"R", "G", "B"}, kWide, value);
        const Error error = errorOf({{path}});
        EXPECT_EQ(error.code, ErrorCode::InvalidInput);
        EXPECT_THAT(error.message,
                    HasSubstr(path + ": channel B of pixel 2, 1 is " + (std::isnan(value) ? "nan" : "inf")));
    }
}

} // namespace stored_frames_test
} // namespace glint::measure
