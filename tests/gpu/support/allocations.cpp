#include "gpu/support/allocations.hpp"

#include <cstdlib>
#include <new>

#ifdef __SANITIZE_ADDRESS__

namespace glint::test {
uint64_t allocations() {
    return 0;
}
bool countsAllocations() {
    return false;
}
} // namespace glint::test

#else

namespace {
thread_local uint64_t allocated = 0;
} // namespace

namespace glint::test {
uint64_t allocations() {
    return allocated;
}
bool countsAllocations() {
    return true;
}
} // namespace glint::test

// The other forms of new and delete call these.
void* operator new(std::size_t size) {
    ++allocated;
    if (void* memory = std::malloc(size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif
