// What the calling thread has computed, for tests of the host's cost.
#pragma once

#include <ctime>

namespace glint::test {

/// Processor time of the calling thread, in milliseconds: what other processes do does not count, and neither does the
/// driver's own work on its threads.
inline double threadMilliseconds() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

} // namespace glint::test
