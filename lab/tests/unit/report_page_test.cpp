// The page of a report: one block of JSON that parses, every image that it names, and no text that turns into HTML.
#include "lab/cli/report/page_template.hpp"
#include "lab/cli/report/report_json.hpp"
#include "lab/cli/report/report_page.hpp"
#include "lab/cli/report/report_pictures.hpp"

#include "base/file.hpp"
#include "lab/scene/images/image_decode.hpp"
#include "lab/tests/unit/report_fixture.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace glint::cli {
namespace report_page_test {

Report madeUpReport() {
    Report report;
    report.command = "glint report '<script>alert(1)</script>'";
    report.scenes.push_back(test::madeUpScene("<script>alert(\"scene\")</script>"));
    test::addMadeUpMotion(report.scenes.front());
    return report;
}

size_t countOf(std::string_view text, std::string_view part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

/// The block of JSON as a browser takes it out: up to the first "</script".
nlohmann::json dataOf(const std::string& page) {
    const std::string_view begin = "<script type=\"application/json\" id=\"data\">";
    const size_t from = page.find(begin) + begin.size();
    return nlohmann::json::parse(page.substr(from, page.find("</script", from) - from));
}

/// All names of pictures: the values of "pictures", wherever they are.
void collectPictures(const nlohmann::json& json, std::set<std::string>& names) {
    if (json.is_object() && json.contains("pictures"))
        for (const auto& name : json["pictures"])
            names.insert(name.get<std::string>());
    if (json.is_structured())
        for (const auto& inner : json)
            collectPictures(inner, names);
}

TEST(ReportPage, HasOneBlockOfJsonThatSaysWhatTheReportDoes) {
    const std::string page = test::must(reportPage(madeUpReport()));
    const nlohmann::json data = dataOf(page);
    EXPECT_EQ(data["format"], "glint report 1");
    EXPECT_EQ(data["scenes"][0]["title"], "<script>alert(\"scene\")</script> 8x4");
    EXPECT_EQ(data["scenes"][0]["configs"][1]["name"], "</script><script>alert(1)</script>");
    EXPECT_EQ(data["device"]["name"], "device <b>");
    EXPECT_EQ(data["scenes"][0]["motion"]["strips"][2]["frame"], 2);
    for (const char* part : {"machine", "legends", "figures", "images", "clock"})
        EXPECT_TRUE(data.contains(part)) << part;
}

TEST(ReportPage, HasEveryImageThatItNames) {
    const nlohmann::json data = dataOf(test::must(reportPage(madeUpReport())));
    std::set<std::string> names;
    collectPictures(data["scenes"], names);
    EXPECT_EQ(names.size(), 2u + 2 * 7 + 2 * 3); // of the scene, of two configs, three frames of each
    for (const std::string& name : names)
        EXPECT_TRUE(data["images"].contains(name)) << name;
    EXPECT_EQ(data["images"].size(), names.size());
    for (const auto& [name, image] : data["images"].items())
        EXPECT_TRUE(image["src"].get<std::string>().starts_with("data:image/webp;base64,")) << name;
}

TEST(ReportPage, LetsNoNameTurnIntoHtml) {
    const std::string page = test::must(reportPage(madeUpReport()));
    EXPECT_EQ(page.find("<script>alert"), page.npos);
    EXPECT_EQ(countOf(page, "<script"), 2u) << "the data and the program";
    EXPECT_EQ(countOf(page, "</script"), 2u);
    EXPECT_NE(page.find("<title>Glint report: &lt;script&gt;alert"), page.npos);
}

TEST(ReportPage, AsksForNothingFromElsewhere) {
    const std::string page = test::must(reportPage(madeUpReport()));
    EXPECT_NE(page.find("default-src 'none'"), page.npos);
    for (const std::string_view link : {"src=\"http", "href=\"http", "url(", "@import", "fetch("})
        EXPECT_EQ(page.find(link), page.npos) << link;
}

TEST(ReportPage, TemplateIsPlainAndComplete) {
    size_t titles = 0, blocks = 0;
    for (const PagePart& part : pageParts()) {
        titles += part.kind == PagePart::Kind::Title;
        blocks += part.kind == PagePart::Kind::Data;
        EXPECT_TRUE(std::ranges::all_of(part.text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    }
    EXPECT_EQ(titles, 1u);
    EXPECT_EQ(blocks, 1u);
}

TEST(ReportPage, IsWrittenAsAFile) {
    const test::TempFolder folder;
    ASSERT_TRUE(writeReportPage(folder + "a.html", madeUpReport()));
    EXPECT_EQ(test::must(readFile(folder + "a.html", kMostPageBytes)), test::must(reportPage(madeUpReport())));
}

TEST(ReportPictures, Base64IsThatOfTheStandard) { // RFC 4648, section 10
    const std::pair<std::string_view, std::string_view> cases[] = {{"", ""},
                                                                   {"f", "Zg=="},
                                                                   {"fo", "Zm8="},
                                                                   {"foo", "Zm9v"},
                                                                   {"foob", "Zm9vYg=="},
                                                                   {"fooba", "Zm9vYmE="},
                                                                   {"foobar", "Zm9vYmFy"},
                                                                   {"\xff\xfe\xfd", "//79"}};
    for (const auto& [bytes, text] : cases)
        EXPECT_EQ(base64(bytes), text);
}

/// A scene with noise, which compresses badly.
std::vector<ReportScene> noisyScenes() {
    std::vector<ReportScene> scenes;
    scenes.push_back(test::madeUpScene("scene"));
    measure::Comparison& comparison = scenes.front().comparison;
    comparison.width = comparison.height = 64;
    uint32_t state = 1;
    const auto noise = [&](std::vector<uint8_t>& rgb) {
        rgb.resize(size_t(64) * 64 * 3);
        for (uint8_t& byte : rgb)
            byte = static_cast<uint8_t>((state = state * 1664525 + 1013904223) >> 24);
    };
    noise(comparison.withoutReflections);
    noise(comparison.referencePicture);
    for (size_t i = 0; i < 2; ++i) {
        measure::ComparisonMaps& maps = scenes[0].maps[i];
        for (std::vector<uint8_t>* rgb : {&comparison.configs[i].composite, &maps.difference, &maps.flip, &maps.worst})
            noise(*rgb);
        comparison.configs[i].outcome = comparison.configs[i].source = std::vector<uint8_t>(size_t(64) * 64 * 3, 7);
        comparison.configs[i].hits.classes.assign(size_t(64) * 64, measure::HitClass::Missed);
    }
    return scenes;
}

size_t bytesOf(const ReportPictures& pictures) {
    size_t bytes = 0;
    for (const auto& image : pictures.images)
        bytes += image["src"].get<std::string>().size();
    return bytes;
}

TEST(ReportPictures, LoseDetailOnlyWhereTheyWouldNotFit) {
    const std::vector<ReportScene> scenes = noisyScenes();
    const ReportPictures whole = test::must(encodePictures(scenes, 10000000));
    EXPECT_EQ(whole.loss, "WebP without loss");
    const ReportPictures small = test::must(encodePictures(scenes, bytesOf(whole) / 2));
    EXPECT_NE(small.loss, whole.loss);
    EXPECT_LE(bytesOf(small), bytesOf(whole) / 2 + small.images.size() * 23); // the prefixes of data
    EXPECT_EQ(small.images["0.0.outcome"], whole.images["0.0.outcome"]) << "its colours are names";
    const auto none = encodePictures(scenes, 1000);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(none.error().message.find("--size"), none.error().message.npos);
}

} // namespace report_page_test
} // namespace glint::cli
