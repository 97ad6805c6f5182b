// The text of a thread's last error, for glint_last_error.
#pragma once

#include "glint/error.hpp"
#include "glint/glint.h"

namespace glint::c_api {

/// Keeps the error's message for glint_last_error and returns its code.
GlintResult fail(const Error& error);

/// As fail, for a pointer that is null though it must not be.
GlintResult failNull(const char* function, const char* pointer);

/// GLINT_SUCCESS, or as fail.
inline GlintResult outcome(const Result<void>& result) {
    return result ? GLINT_SUCCESS : fail(result.error());
}

} // namespace glint::c_api

/// Returns from a function of the C interface if one of its pointers is null.
#define GLINT_C_REQUIRE(pointer)                                                                                       \
    do {                                                                                                               \
        if (!(pointer))                                                                                                \
            return ::glint::c_api::failNull(__func__, #pointer);                                                       \
    } while (false)

/// `GLINT_C_TRY(view, readStruct<View>(in));` declares `view`, or returns the error's code.
#define GLINT_C_TRY(name, expression)                                                                                  \
    auto name##Read = (expression);                                                                                    \
    if (!name##Read)                                                                                                   \
        return ::glint::c_api::fail(name##Read.error());                                                               \
    auto& name = *name##Read

#define GLINT_C_CHECK(expression)                                                                                      \
    do {                                                                                                               \
        if (const auto glintCheck = (expression); !glintCheck)                                                         \
            return ::glint::c_api::fail(glintCheck.error());                                                           \
    } while (false)
