#include "lab/cli/report/page_template.hpp"

#include <nlohmann/json.hpp>

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

} // namespace

/// A "<" occurs only in the strings of JSON, where \u003c is the same.
std::string scriptJson(const nlohmann::ordered_json& json) {
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

std::string filledPage(std::span<const PagePart> parts, std::string_view title, std::string_view data) {
    std::string page;
    for (const PagePart& part : parts)
        switch (part.kind) {
        case PagePart::Kind::Text: page += part.text; break;
        case PagePart::Kind::Title: page += escapedText(title); break;
        case PagePart::Kind::Data: page += data; break;
        }
    return page;
}

} // namespace glint::cli
