// Text with values in it: fmt's format strings, checked by the compiler. fmt's code is compiled once, in format.cpp, so
// that files that format a message do not each compile it, and a host of the static library needs no fmt.
#pragma once

#include <fmt/core.h>

#include <string>

namespace glint {

std::string formatArguments(fmt::string_view text, fmt::format_args arguments);

/// `formatText("{}: accessor {} is empty", file, index)`
template <class... Args>
std::string formatText(fmt::format_string<Args...> text, Args&&... args) {
    return formatArguments(text, fmt::make_format_args(args...));
}

} // namespace glint
