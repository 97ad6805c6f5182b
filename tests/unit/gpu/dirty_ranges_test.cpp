#include "gpu/dirty_ranges.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace glint::gpu {
namespace dirty_ranges_test {

/// Bytes that the ranges hold, one flag each.
std::vector<bool> covered(DirtyRanges& ranges, size_t size) {
    std::vector<bool> bytes(size);
    for (const ByteRange& range : ranges.merged())
        for (size_t i = range.first; i < range.first + range.size; ++i)
            bytes.at(i) = true;
    return bytes;
}

TEST(DirtyRanges, neighboursAreOneAndFarOnesAreNot) {
    DirtyRanges ranges;
    EXPECT_TRUE(ranges.merged().empty());
    ranges.add(64000, 64);
    ranges.add(0, 64);
    ranges.add(128, 64);
    ranges.add(32, 64);
    ranges.add(500, 0);
    const auto merged = ranges.merged();
    ASSERT_EQ(merged.size(), 2u);
    EXPECT_EQ(merged[0].first, 0u);
    EXPECT_EQ(merged[0].size, 192u);
    EXPECT_EQ(merged[1].first, 64000u);
    EXPECT_EQ(merged[1].size, 64u);
    ranges.clear();
    EXPECT_TRUE(ranges.merged().empty());
}

/// Every byte that was added is there, however often and in whichever order; what is more costs less than a command.
TEST(DirtyRanges, holdWhatWasAdded) {
    constexpr size_t kSize = 1 << 20;
    std::mt19937 random(1);
    DirtyRanges ranges;
    std::vector<bool> added(kSize);
    for (int i = 0; i < 5000; ++i) {
        const size_t first = random() % (kSize - 256), size = random() % 256;
        ranges.add(first, size);
        for (size_t b = first; b < first + size; ++b)
            added[b] = true;
        if (i % 1000 == 500)
            (void)ranges.merged(); // more may come after
    }
    const std::vector<bool> held = covered(ranges, kSize);
    size_t gap = 0;
    for (size_t b = 0; b < kSize; ++b) {
        ASSERT_TRUE(held[b] || !added[b]) << b;
        gap = held[b] && !added[b] ? gap + 1 : 0;
        ASSERT_LT(gap, 1024u);
    }
}

} // namespace dirty_ranges_test
} // namespace glint::gpu
