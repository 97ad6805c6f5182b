// Warnings and progress notes for a person, on standard error. Errors are values (base/result.hpp), not log lines.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace glint::log {

/// Where lines go; replaced by tests and by the viewer. Default: "glint: warning: ..." on standard error.
using Sink = void (*)(std::string_view line, void* user);
void setSink(Sink sink, void* user);

void warningText(std::string_view text);

/// One line; the same text is printed once per process, so that a warning in a loop stays readable.
template <class... Args>
void warning(fmt::format_string<Args...> format, Args&&... args) {
    warningText(fmt::format(format, std::forward<Args>(args)...));
}

} // namespace glint::log
