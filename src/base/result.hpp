// Short forms for creating and propagating errors (include/glint/error.hpp).
#pragma once

#include "base/format.hpp"
#include "glint/error.hpp"

#include <utility>

namespace glint {

/// `return invalidInput("{}: accessor {} is empty", file, index);`
template <class... Args>
Error invalidInput(fmt::format_string<Args...> format, Args&&... args) {
    return {ErrorCode::InvalidInput, formatText(format, std::forward<Args>(args)...)};
}
template <class... Args>
Error invalidArgument(fmt::format_string<Args...> format, Args&&... args) {
    return {ErrorCode::InvalidArgument, formatText(format, std::forward<Args>(args)...)};
}
template <class... Args>
Error makeError(ErrorCode code, fmt::format_string<Args...> format, Args&&... args) {
    return {code, formatText(format, std::forward<Args>(args)...)};
}

} // namespace glint

#define GLINT_CONCAT_(a, b) a##b
#define GLINT_CONCAT(a, b) GLINT_CONCAT_(a, b)

/// `GLINT_TRY(file, readFile(path));` declares `file`, or returns the error from the calling function.
#define GLINT_TRY(name, expression)                                                                                    \
    auto GLINT_CONCAT(glintTry_, __LINE__) = (expression);                                                             \
    if (!GLINT_CONCAT(glintTry_, __LINE__))                                                                            \
        return std::move(GLINT_CONCAT(glintTry_, __LINE__)).error();                                                   \
    auto name = std::move(GLINT_CONCAT(glintTry_, __LINE__)).value()

/// As GLINT_TRY, for a result whose value is not needed.
#define GLINT_CHECK(expression)                                                                                        \
    do {                                                                                                               \
        if (auto glintCheck = (expression); !glintCheck)                                                               \
            return std::move(glintCheck).error();                                                                      \
    } while (false)
