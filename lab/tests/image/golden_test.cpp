// The image tests' own parts, without a device: reading cases, judging images.
#include "base/file.hpp"
#include "lab/tests/image/golden.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace glint::test {
namespace golden_test {

class GoldenTest : public testing::Test {
protected:
    Result<ImageCase> readCase(std::string_view json) const {
        EXPECT_TRUE(writeFile(folder_ + "a_case.json", json).ok());
        return readImageCase(folder_ + "a_case.json", "/some/assets");
    }
    void expectBad(std::string_view json, std::string_view part) const {
        const auto read = readCase(json);
        ASSERT_FALSE(read.ok()) << json;
        EXPECT_NE(read.error().message.find(part), std::string::npos) << read.error().message;
        EXPECT_NE(read.error().message.find("a_case.json"), std::string::npos) << read.error().message;
    }

    /// An image of 20 x 10 in one grey, `changed` of its pixels brighter by 100.
    std::vector<uint8_t> grey(size_t changed) const {
        std::vector<uint8_t> rgb(size_t(20) * 10 * 3, 100);
        std::fill_n(rgb.begin(), 3 * changed, uint8_t(200));
        return rgb;
    }
    Verdict judge(std::span<const uint8_t> rgb, bool software = true, uint32_t width = 20, uint32_t height = 10) const {
        return compareWithGolden(case_, {width, height, rgb}, places_, software);
    }
    bool isThere(const std::string& kind) const {
        return std::filesystem::exists(places_.failures + "/a_case." + kind + ".png");
    }

    const TempFolder temp_;
    const std::string& folder_ = temp_.path();
    const GoldenPlaces places_ = {folder_ + "goldens", folder_ + "failures"};
    ImageCase case_ = {.name = "a_case", .options = {}, .tolerance = {0.02, 0.01, 0.05}};
};

TEST_F(GoldenTest, ReadsEveryKey) {
    const auto read = readCase(R"({"description": "x", "scene": "assets:a/b.glb", "camera": "1", "environment": "sky",
        "size": [320, 180], "time": 1.5, "frames": 3, "seed": 7, "preset": "fast", "set": ["screen.step=4", "a=b"],
        "view": "weights", "tolerance": {"maxAbsDiff": 0.5, "failingFraction": 0.25, "meanFlip": 0.125}})");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->name, "a_case");
    EXPECT_TRUE(read->needsAssets);
    EXPECT_EQ(read->tolerance.maxAbsDiff, 0.5);
    EXPECT_EQ(read->tolerance.failingFraction, 0.25);
    EXPECT_EQ(read->tolerance.meanFlip, 0.125);
    EXPECT_EQ(commandOf(*read), "scripts/glint render '/some/assets/a/b.glb' --size 320x180 --camera '1' --env 'sky' "
                                "--preset 'fast' --set 'screen.step=4' --set 'a=b' --view 'weights' --time 1.5 "
                                "--frames 3 --seed 7 -o a_case.png");
}

TEST_F(GoldenTest, ACaseNeedsLittle) {
    const auto read = readCase(R"({"scene": "builtin:hall", "size": [2, 1]})");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_FALSE(read->needsAssets);
    EXPECT_EQ(commandOf(*read), "scripts/glint render 'builtin:hall' --size 2x1 -o a_case.png");
}

TEST_F(GoldenTest, MistakesInACaseAreNamed) {
    expectBad("", "not JSON");
    expectBad("[]", "expected a JSON object");
    expectBad(R"({"size": [2, 1]})", "\"scene\" is missing");
    expectBad(R"({"scene": "a"})", "\"size\" is missing");
    expectBad(R"({"scene": "a", "size": [2, 1], "veiw": "color"})", "\"veiw\"");
    for (const char* const wrong :
         {R"("size": [2])", R"("size": [2, -1])", R"("size": "2x1")", R"("scene": 1)", R"("time": "1")",
          R"("frames": 1.5)", R"("set": "a=b")", R"("set": [1])", R"("tolerance": 0.1)",
          R"("tolerance": {"maxabsdiff": 0})", R"("tolerance": {"meanFlip": "0"})", R"("seed": -1)"}) {
        const std::string json = std::string(R"({"scene": "a", "size": [2, 1], )") + wrong + "}";
        expectBad(json, "is unknown or has a value of another kind");
    }
    ASSERT_TRUE(writeFile(folder_ + "a-case.json", R"({"scene": "a", "size": [2, 1]})").ok());
    EXPECT_FALSE(readImageCase(folder_ + "a-case.json", "").ok());
    EXPECT_EQ(readImageCase(folder_ + "none.json", "").error().code, ErrorCode::NotFound);
}

TEST_F(GoldenTest, AMissingGoldenFailsAndSaysHowToMakeIt) {
    const Verdict verdict = judge(grey(0));
    EXPECT_FALSE(verdict.good);
    EXPECT_FALSE(verdict.meanFlip.has_value());
    EXPECT_NE(verdict.message.find("there is no golden " + places_.goldens), std::string::npos) << verdict.message;
    EXPECT_NE(verdict.message.find("GLINT_UPDATE_GOLDENS=1"), std::string::npos);
    EXPECT_TRUE(isThere("actual"));
}

TEST_F(GoldenTest, EqualPicturesMatch) {
    ASSERT_TRUE(writeGolden(case_, {20, 10, grey(7)}, places_).ok());
    const Verdict verdict = judge(grey(7));
    EXPECT_TRUE(verdict.good) << verdict.message;
    EXPECT_EQ(verdict.meanFlip, 0);
    EXPECT_FALSE(isThere("actual"));
}

TEST_F(GoldenTest, TheToleranceIsAShareOfPixels) {
    ASSERT_TRUE(writeGolden(case_, {20, 10, grey(0)}, places_).ok());
    EXPECT_TRUE(judge(grey(2)).good); // 1 %
    const Verdict verdict = judge(grey(3));
    EXPECT_FALSE(verdict.good);
    EXPECT_GT(verdict.meanFlip, 0);
    EXPECT_NE(verdict.message.find("max difference 0.3922, failing fraction 0.01500"), std::string::npos)
        << verdict.message;
    for (const char* const kind : {"actual", "golden", "flip"})
        EXPECT_TRUE(isThere(kind)) << kind;
    EXPECT_TRUE(judge(grey(1)).good);
    for (const char* const kind : {"actual", "golden", "flip"})
        EXPECT_FALSE(isThere(kind)) << kind;
}

TEST_F(GoldenTest, OtherDriversAreHeldAgainstWhatCanBeSeen) {
    ASSERT_TRUE(writeGolden(case_, {20, 10, grey(0)}, places_).ok());
    std::vector<uint8_t> allSlightlyOff = grey(0);
    for (uint8_t& value : allSlightlyOff)
        value = 101;
    EXPECT_TRUE(judge(allSlightlyOff, false).good);
    EXPECT_FALSE(judge(grey(100), false).good);
}

TEST_F(GoldenTest, AnotherSizeFails) {
    ASSERT_TRUE(writeGolden(case_, {20, 10, grey(0)}, places_).ok());
    const Verdict verdict = judge(grey(0), true, 10, 20);
    EXPECT_FALSE(verdict.good);
    EXPECT_NE(verdict.message.find("the golden is 20 x 10, the picture 10 x 20"), std::string::npos);
}

TEST_F(GoldenTest, ADamagedGoldenFails) {
    ASSERT_TRUE(writeGolden(case_, {20, 10, grey(0)}, places_).ok());
    ASSERT_TRUE(writeFile(places_.goldens + "/a_case.png", "not a picture").ok());
    EXPECT_FALSE(judge(grey(0)).good);
}

} // namespace golden_test
} // namespace glint::test
