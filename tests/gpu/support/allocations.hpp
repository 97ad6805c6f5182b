// Counts the heap allocations of this program's C++ code. The driver is C and the validation layer may be left out, so
// all counted allocations are ours.
#pragma once

#include <cstdint>

namespace glint::test {

/// Calls of operator new by this thread since it began; always 0 where a sanitizer replaces the heap
/// (countsAllocations).
uint64_t allocations();
bool countsAllocations();

} // namespace glint::test
