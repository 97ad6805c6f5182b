// A reference follows at least as many bounces as what is held against it: else the light of the further ones, which is
// right, would count as error.
#pragma once

#include "lab/measure/motion/sequence.hpp"

#include <span>

namespace glint::cli {

/// Surfaces that a path of these settings hits; 0 without rays.
int bouncesOf(const Settings& settings);

/// Raises `rays.bounces` of a reference that sends rays to `bounces`, if it has fewer. True if it had.
bool followAsManyBounces(Settings& reference, int bounces);

/// To the most that one of the configs follows. The reference's name then says how many it is: "reference, 3 bounces".
void followAsManyBounces(measure::ComparedConfig& reference, std::span<const measure::ComparedConfig> configs);

} // namespace glint::cli
