// The order of the sources of reflections.
#pragma once

#include "glint/settings.hpp"
#include "shared/hierarchy.h"

#include <array>
#include <span>

namespace glint::reflect {

/// Source numbers (kSource*), the first source at the front.
class SourceOrder {
public:
    /// Takes the user's order (settings order.*). Sources after Glint's own, up to `count`, come before all others.
    explicit SourceOrder(const Settings& settings, uint32_t count = shared::kSourceCount);

    const uint32_t* begin() const { return sources_.data(); }
    const uint32_t* end() const { return sources_.data() + count_; }
    /// Returns the order packed as in HierarchyConstants::order.
    uint32_t packed() const;
    /// Returns a mask in which bit s is set if source s comes before `source`.
    uint32_t before(uint32_t source) const;

private:
    std::array<uint32_t, shared::kMaxSources> sources_ = {};
    uint32_t count_;
};

} // namespace glint::reflect
