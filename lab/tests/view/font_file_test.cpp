// Which font file the panels are drawn with.
#include "lab/view/font_file.hpp"

#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace glint::view {
namespace font_file_test {

using namespace std::string_view_literals;

class FontFileTest : public testing::Test {
protected:
    std::string write(const std::string& name, std::string_view bytes) {
        std::ofstream(folder_ + name, std::ios::binary) << bytes;
        return folder_ + name;
    }
    static std::string find(const std::vector<std::string>& places) {
        std::vector<const char*> texts;
        for (const std::string& place : places)
            texts.push_back(place.c_str());
        return findFont(texts);
    }
    test::TempFolder folder_;
};

TEST_F(FontFileTest, TheFirstThatIsThereIsTaken) {
    const std::string trueType = write("a.ttf", "\0\1\0\0rest"sv), openType = write("b.otf", "OTTOrest");
    EXPECT_EQ(find({folder_ + "none.ttf", openType, trueType}), openType);
    EXPECT_EQ(find({folder_ + "none.ttf", trueType, openType}), trueType);
    EXPECT_EQ(find({folder_ + "none.ttf"}), "");
    EXPECT_EQ(find({}), "");
}

TEST_F(FontFileTest, WhatIsNoFontIsPassedOver) {
    const std::string font = write("a.ttf", "\0\1\0\0rest"sv);
    std::filesystem::create_directory(folder_ + "folder.ttf");
    EXPECT_EQ(find({write("empty.ttf", ""), write("short.ttf", "\0\1"sv), write("text.ttf", "Hello"),
                    folder_ + "folder.ttf", font}),
              font);
}

TEST_F(FontFileTest, ThePlacesAreWholePaths) {
    ASSERT_FALSE(fontPlaces().empty());
    for (const std::string_view place : fontPlaces())
        EXPECT_TRUE(place.starts_with("/usr/share/fonts/") || place.starts_with("C:/Windows/Fonts/")) << place;
}

} // namespace font_file_test
} // namespace glint::view
