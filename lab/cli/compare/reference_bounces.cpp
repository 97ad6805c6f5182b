#include "lab/cli/compare/reference_bounces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace glint::cli {

int bouncesOf(const Settings& settings) {
    return settings.rays.enabled ? settings.rays.bounces : 0;
}

bool followAsManyBounces(Settings& reference, int bounces) {
    if (!reference.rays.enabled || reference.rays.bounces >= bounces)
        return false;
    reference.rays.bounces = bounces;
    return true;
}

void followAsManyBounces(measure::ComparedConfig& reference, std::span<const measure::ComparedConfig> configs) {
    int bounces = 0;
    for (const measure::ComparedConfig& config : configs)
        bounces = std::max(bounces, bouncesOf(config.job.settings.reflections));
    if (followAsManyBounces(reference.job.settings.reflections, bounces))
        reference.name += fmt::format(", {} bounces", bounces);
}

} // namespace glint::cli
