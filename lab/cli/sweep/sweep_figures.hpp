// The figures of a job that are the same on every run, by the names that reports give them, and the times, which are
// not.
#pragma once

#include "lab/cli/sweep/sweep_jobs.hpp"

#include <string_view>

namespace glint::cli {

/// Adds the figures of a still: errors against the reference, hits against exact rays, the exact picture, rays and
/// lookups. A figure that is unknown, or infinite as the PSNR of equal images, is absent.
/// `hits`  ConfigFigures::hits has been measured
void addStillFigures(const measure::ConfigFigures& config, bool hits, SweepJson& figures);
void addMotionFigures(const measure::SequenceConfig& config, SweepJson& figures);

/// {"effectMs", "effectMs95", "floorMs", "floors", "passes": {name: ms}}
SweepJson timesJson(const measure::EffectTimes& times);

/// Adds one figure, if it is finite.
void addFigure(SweepJson& figures, std::string_view name, double value);

} // namespace glint::cli
