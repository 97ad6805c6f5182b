// Distributes the rows of an image over the machine's cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace glint::scene {

/// Calls `work(row)` for each row in [0, rows), from several threads at once, and returns when all are done. Work on
/// different rows must not touch the same data, and must not throw.
template <class Work>
void forEachRow(uint32_t rows, const Work& work) {
    std::atomic<uint32_t> next = 0;
    const auto run = [&] {
        for (uint32_t row = next++; row < rows; row = next++)
            work(row);
    };
    const uint32_t helpers = std::min(std::max(std::thread::hardware_concurrency(), 1u), rows) - (rows > 0 ? 1 : 0);
    std::vector<std::jthread> threads;
    for (uint32_t i = 0; i < helpers; ++i)
        threads.emplace_back(run);
    run();
}

} // namespace glint::scene
