// Assertions for programming errors. Errors of input or environment are a Result (base/result.hpp), never an assertion.
#pragma once

#include "base/format.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

#if defined(GLINT_ASSERTS) || !defined(NDEBUG)
/// Ends the process with the condition, its source location and the values in the message.
#define GLINT_ASSERT(condition, ...)                                                                                   \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            std::fprintf(stderr, "%s:%d: assertion failed: %s: %s\n", __FILE__, __LINE__, #condition,                  \
                         glint::formatText(__VA_ARGS__).c_str());                                                      \
            std::abort();                                                                                              \
        }                                                                                                              \
    } while (false)
#else
#define GLINT_ASSERT(condition, ...) static_cast<void>(0)
#endif
