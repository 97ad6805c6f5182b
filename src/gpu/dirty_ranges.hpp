// The bytes of a list that the GPU's copy lacks: a host that changes a few of many items uploads those alone.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace glint::gpu {

struct ByteRange {
    size_t first = 0;
    size_t size = 0;
};

class DirtyRanges {
public:
    void add(size_t first, size_t size);
    void clear() { ranges_.clear(); }
    /// All ranges in ascending order. Those less than 1 KiB apart are one, which costs less than another command.
    std::span<const ByteRange> merged();

private:
    std::vector<ByteRange> ranges_;
    size_t tidy_ = 0; ///< the number of ranges that are in order and apart
};

} // namespace glint::gpu
