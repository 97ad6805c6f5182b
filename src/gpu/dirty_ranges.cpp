#include "gpu/dirty_ranges.hpp"

#include <algorithm>

namespace glint::gpu {

void DirtyRanges::add(size_t first, size_t size) {
    if (size == 0)
        return;
    constexpr size_t kMost = 1024; // ranges that are added before they are merged, at least
    if (ranges_.size() > 2 * tidy_ + kMost)
        merged();
    ranges_.push_back({first, size});
}

std::span<const ByteRange> DirtyRanges::merged() {
    constexpr size_t kGap = 1024;
    std::ranges::sort(ranges_, {}, &ByteRange::first);
    size_t kept = 0;
    for (const ByteRange& range : ranges_) {
        if (kept > 0) {
            ByteRange& last = ranges_[kept - 1];
            if (range.first < last.first + last.size + kGap) {
                last.size = std::max(last.size, range.first + range.size - last.first);
                continue;
            }
        }
        ranges_[kept++] = range;
    }
    ranges_.resize(kept);
    tidy_ = kept;
    return ranges_;
}

} // namespace glint::gpu
