// Files that other programs write: whatever their kind, the values come back or there is one line of error.
#include "lab/scene/images/exr_channels.hpp"

#include "base/file.hpp"
#include "lab/tests/support/exr_writer.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::scene {
namespace exr_channels_test {

using test::ExrPart;
using test::must;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

std::vector<float> ramp(int width, int height, float factor) {
    std::vector<float> values;
    for (int i = 0; i < width * height; ++i)
        values.push_back(factor * float(i));
    return values;
}

class ExrChannelsTest : public testing::Test {
protected:
    std::string path() const { return temp_ + "file.exr"; }
    std::string bytes() const { return must(readFile(path(), 1 << 24)); }
    static std::string errorOf(std::string bytes) {
        const auto file = ExrChannels::decode(std::move(bytes), "f.exr", 1 << 20);
        if (!file)
            return file.error().message;
        std::vector<size_t> all(file->names().size());
        for (size_t i = 0; i < all.size(); ++i)
            all[i] = i;
        const auto read = file->read(all);
        return read ? "" : read.error().message;
    }
    std::vector<float> plane(const std::string& name) const {
        const ExrChannels file = must(ExrChannels::open(path()));
        const auto found = std::ranges::find(file.names(), name);
        if (found == file.names().end())
            throw std::runtime_error("no channel " + name);
        const size_t index[] = {size_t(found - file.names().begin())};
        return must(file.read(index)).front();
    }
    const test::TempFolder temp_;
};

TEST_F(ExrChannelsTest, EveryCompressionIsRead) {
    const ExrPart part = {"", 20, 9, {{"depth.Z", ramp(20, 9, 0.25f)}, {"normal.X", ramp(20, 9, -1)}}};
    for (const Imf::Compression compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                               Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        test::writeExrFile(path(), part, compression);
        EXPECT_EQ(plane("depth.Z"), part.planes[0].second) << compression;
        EXPECT_EQ(plane("normal.X"), part.planes[1].second) << compression;
    }
    // Lossy ones keep the values nearly.
    for (const Imf::Compression compression : {Imf::PXR24_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        test::writeExrFile(path(), part, compression);
        const std::vector<float> read = plane("depth.Z");
        for (size_t i = 0; i < read.size(); ++i)
            EXPECT_NEAR(read[i], part.planes[0].second[i], 0.01) << compression;
    }
}

TEST_F(ExrChannelsTest, TilesAreRead) {
    const ExrPart part = {"", 50, 37, {{"Z", ramp(50, 37, 1)}}};
    test::writeTiledExr(path(), part, 16);
    EXPECT_EQ(plane("Z"), part.planes[0].second);
}

TEST_F(ExrChannelsTest, PartsAreNamedBeforeTheirChannels) {
    test::writeMultiPartExr(path(), {{"ViewLayer.Depth", 4, 2, {{"Z", ramp(4, 2, 1)}}},
                                     {"Normal", 4, 2, {{"Normal.X", ramp(4, 2, 2)}, {"Normal.Y", ramp(4, 2, 3)}}}});
    const ExrChannels file = must(ExrChannels::open(path()));
    EXPECT_THAT(file.names(), UnorderedElementsAre("ViewLayer.Depth.Z", "Normal.X", "Normal.Y"));
    EXPECT_EQ(plane("ViewLayer.Depth.Z"), ramp(4, 2, 1));
    EXPECT_EQ(plane("Normal.Y"), ramp(4, 2, 3));
}

/// The library writes no such file: all parts share one display window.
TEST_F(ExrChannelsTest, PartsOfDifferentSizesAreAnError) {
    test::writeMultiPartExr(path(), {{"a", 4, 2, {{"Z", ramp(4, 2, 1)}}}, {"b", 4, 2, {{"Z", ramp(4, 2, 1)}}}});
    std::string damaged = bytes();
    for (const std::string_view window : {"dataWindow", "displayWindow"}) {
        constexpr size_t kToMaxY = sizeof "box2i" + 4 + 12; // type, size, then minX, minY, maxX
        const size_t second = damaged.find(window, damaged.find(window) + 1);
        damaged[second + window.size() + 1 + kToMaxY] = 2;
    }
    EXPECT_THAT(errorOf(damaged), HasSubstr("4x2 and 4x3"));
}

TEST_F(ExrChannelsTest, DeepPixelsAreAnError) {
    test::writeDeepExr(path(), 4, 3);
    EXPECT_THAT(errorOf(bytes()), HasSubstr("deep"));
}

TEST_F(ExrChannelsTest, NumbersThatAreNoneComeBackAsTheyAre) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    test::writeExrFile(path(), {"", 3, 1, {{"Z", {nan, inf, -inf}}}});
    const std::vector<float> read = plane("Z");
    EXPECT_TRUE(std::isnan(read[0]));
    EXPECT_EQ(read[1], inf);
    EXPECT_EQ(read[2], -inf);
}

TEST_F(ExrChannelsTest, ACropRegionIsAnError) {
    ExrPart part = {"", 4, 3, {{"Z", ramp(4, 3, 1)}}};
    Imf::Header header = test::exrHeader(part);
    header.displayWindow() = Imath::Box2i({0, 0}, {7, 2});
    {
        Imf::OutputFile file(path().c_str(), header);
        file.setFrameBuffer(test::exrFrameBuffer(part));
        file.writePixels(3);
    }
    EXPECT_THAT(errorOf(bytes()), HasSubstr("display window"));
}

TEST_F(ExrChannelsTest, EveryTruncationIsOneLineOfError) {
    test::writeMultiPartExr(path(), {{"a", 9, 5, {{"Z", ramp(9, 5, 1)}}}, {"b", 9, 5, {{"X", ramp(9, 5, 2)}}}});
    const std::string whole = bytes();
    ASSERT_EQ(errorOf(whole), "");
    for (size_t length = 0; length < whole.size(); ++length) {
        const std::string message = errorOf(whole.substr(0, length));
        ASSERT_THAT(message, testing::StartsWith("f.exr: ")) << length;
        ASSERT_EQ(message.find('\n'), message.npos) << length;
    }
}

TEST_F(ExrChannelsTest, OtherFilesAreNoOpenExr) {
    EXPECT_THAT(errorOf(""), HasSubstr("not an OpenEXR file"));
    EXPECT_THAT(errorOf("\x89PNG\r\n"), HasSubstr("not an OpenEXR file"));
    EXPECT_EQ(ExrChannels::open(temp_ + "none.exr").error().code, ErrorCode::NotFound);
}

TEST_F(ExrChannelsTest, TooManyPixelsAreRefusedBeforeMemoryIsTaken) {
    test::writeExrFile(path(), {"", 40, 30, {{"Z", ramp(40, 30, 1)}}});
    const auto file = ExrChannels::decode(bytes(), "f.exr", 1000);
    ASSERT_FALSE(file.ok());
    EXPECT_THAT(file.error().message, HasSubstr("40 x 30"));
}

} // namespace exr_channels_test
} // namespace glint::scene
