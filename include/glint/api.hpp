// What a shared library of Glint offers to its host; everything that is not marked stays inside.
#pragma once

#if defined(GLINT_SHARED) && (defined(__GNUC__) || defined(__clang__))
#define GLINT_API __attribute__((visibility("default")))
#else
#define GLINT_API
#endif
