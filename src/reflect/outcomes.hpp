// The words for shared/outcome.h's numbers.
#pragma once

#include "shared/outcome.h"

#include <array>
#include <string_view>

namespace glint::reflect {

inline constexpr std::array<std::string_view, shared::kOutcomeCount> kOutcomeNames = {
    "none",   "hit",      "sky",      "offScreen", "behindCamera",   "maxDistance", "outOfSteps",
    "hidden", "tooThick", "backFace", "side",      "belowThreshold", "tooRough",    "facingCamera"};

/// Was a ray marched at all?
constexpr bool isTraced(uint32_t outcome) {
    return outcome != shared::kOutcomeNone && outcome < shared::kOutcomeBelowThreshold;
}

} // namespace glint::reflect
