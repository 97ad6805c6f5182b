// Warnings and progress notes for the user, on standard error. Errors are values (base/result.hpp), not log lines.
#pragma once

#include "base/format.hpp"

#include <string_view>

namespace glint::log {

/// Receives log lines; tests and the viewer replace it. Default: "glint: warning: ..." on standard error.
using Sink = void (*)(std::string_view line, void* user);
void setSink(Sink sink, void* user);

void warningText(std::string_view text);

/// Logs one line. The same text is logged once per process, so that a warning in a loop stays readable.
template <class... Args>
void warning(fmt::format_string<Args...> format, Args&&... args) {
    warningText(formatText(format, std::forward<Args>(args)...));
}

} // namespace glint::log
