// Pages without their values: the files of lab/cli/report/page, embedded by the build (cmake/embed_page.cmake).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>

namespace glint::cli {

struct PagePart {
    enum class Kind {
        Text, ///< `text`, unchanged
        Title,
        Data, ///< JSON, for a script element
    };
    Kind kind = Kind::Text;
    std::string_view text;
};

/// The page of a report, in order.
std::span<const PagePart> pageParts();
/// The page of a sweep, in order.
std::span<const PagePart> sweepPageParts();

/// JSON for a script element, as filledPage writes it.
std::string scriptJson(const nlohmann::ordered_json& json);

/// Returns the page with its values. `data`  scriptJson
std::string filledPage(std::span<const PagePart> parts, std::string_view title, std::string_view data);

} // namespace glint::cli
