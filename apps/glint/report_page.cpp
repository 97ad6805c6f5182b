#include "report_page.hpp"

#include "base/file.hpp"
#include "page_template.hpp"
#include "report_json.hpp"
#include "report_pictures.hpp"

#include <algorithm>

namespace glint::cli {
namespace {

/// For an element of HTML.
std::string escapedText(std::string_view text) {
    std::string out;
    for (const char c : text)
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        default: out += c;
        }
    return out;
}

/// For a script element: a "<" occurs only in the strings of JSON, where \u003c is the same.
std::string escapedJson(const nlohmann::ordered_json& json) {
    const std::string text = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    std::string out;
    out.reserve(text.size());
    for (const char c : text)
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    return out;
}

std::string titleOf(const Report& report) {
    std::string title = "Glint report:";
    for (const ReportScene& scene : report.scenes)
        title += (&scene == &report.scenes.front() ? " " : ", ") + scene.title;
    return title;
}

} // namespace

Result<std::string> reportPage(const Report& report) {
    nlohmann::ordered_json json = reportJson(report);
    size_t fixed = 100000; // of JSON around the images
    for (const PagePart& part : pageParts())
        fixed += part.text.size();
    fixed += escapedJson(json).size();
    if (fixed >= kMostPageBytes)
        return invalidArgument("the figures do not fit into a page: name fewer scenes and configs");
    GLINT_TRY(pictures, encodePictures(report.scenes, kMostPageBytes - fixed));
    json["pictureLoss"] = pictures.loss;
    json["images"] = std::move(pictures.images);

    std::string page;
    for (const PagePart& part : pageParts())
        switch (part.kind) {
        case PagePart::Kind::Text: page += part.text; break;
        case PagePart::Kind::Title: page += escapedText(titleOf(report)); break;
        case PagePart::Kind::Data: page += escapedJson(json); break;
        }
    return page;
}

Result<void> writeReportPage(const std::string& file, const Report& report) {
    GLINT_TRY(page, reportPage(report));
    return writeFile(file, page);
}

} // namespace glint::cli
