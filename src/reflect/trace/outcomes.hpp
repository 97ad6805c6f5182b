// The names of the outcomes in shared/outcome.h.
#pragma once

#include "shared/outcome.h"

#include <array>
#include <string_view>

namespace glint::reflect {

inline constexpr std::array<std::string_view, shared::kOutcomeCount> kOutcomeNames = {
    "none",     "hit",      "sky",  "offScreen", "behindCamera",   "maxDistance", "outOfSteps",   "hidden",
    "tooThick", "backFace", "side", "inferred",  "belowThreshold", "tooRough",    "facingCamera", "fromNeighbours"};

/// True if a ray was marched.
constexpr bool isTraced(uint32_t outcome) {
    return outcome != shared::kOutcomeNone && outcome < shared::kOutcomeBelowThreshold;
}

/// True if the ray has an answer, as lib/ray_record.glsl defines it.
constexpr bool isAnswered(uint32_t outcome) {
    return outcome == shared::kOutcomeHit || outcome == shared::kOutcomeSide || outcome == shared::kOutcomeBackFace ||
           outcome == shared::kOutcomeInferred;
}

} // namespace glint::reflect
