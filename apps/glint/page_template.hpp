// The page of a report without its values: the files of apps/glint/page, embedded by the build
// (cmake/embed_page.cmake).
#pragma once

#include <span>
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

/// In the order of the page.
std::span<const PagePart> pageParts();

} // namespace glint::cli
