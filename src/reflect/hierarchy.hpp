// The sources of reflections, and the order in which they are asked.
#pragma once

#include "glint/settings.hpp"
#include "shared/hierarchy.h"

#include <array>
#include <string_view>

namespace glint::reflect {

inline constexpr std::array<std::string_view, shared::kSourceCount> kSourceNames = {"screen", "rays", "planar",
                                                                                    "probes", "sky"};

/// Sources (kSource*), the one that is asked first at the front.
using SourceOrder = std::array<uint32_t, shared::kSourceCount>;

SourceOrder sourceOrder(const Settings& settings);
/// As HierarchyConstants::order has it.
uint32_t packOrder(const SourceOrder& order);
/// Bit s: source s is asked before `source`.
uint32_t sourcesBefore(const SourceOrder& order, uint32_t source);

} // namespace glint::reflect
