// The value of a Result, or an exception with its error's message, which fails the test that runs.
#pragma once

#include "glint/error.hpp"

#include <stdexcept>
#include <utility>

namespace glint::test {

template <class T>
T must(Result<T> result) {
    if (!result)
        throw std::runtime_error(result.error().message);
    return std::move(result).value();
}
inline void must(Result<void> result) {
    if (!result)
        throw std::runtime_error(result.error().message);
}

} // namespace glint::test
