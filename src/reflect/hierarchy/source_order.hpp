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
    /// Takes the user's order (settings order.*).
    explicit SourceOrder(const Settings& settings);

    const uint32_t* begin() const { return sources_.data(); }
    const uint32_t* end() const { return sources_.data() + sources_.size(); }
    /// Returns the order packed as in HierarchyConstants::order.
    uint32_t packed() const;
    /// Returns a mask in which bit s is set if source s comes before `source`.
    uint32_t before(uint32_t source) const;

private:
    std::array<uint32_t, shared::kSourceCount> sources_ = {};
};

} // namespace glint::reflect
