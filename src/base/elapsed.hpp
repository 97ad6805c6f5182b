// Time that has passed, by the wall clock.
#pragma once

#include <chrono>

namespace glint {

inline double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace glint
