// One point of a benchmark: times several settings at one image size, in turn, so that a slowdown of the machine
// affects all of them alike.
#pragma once

#include "lab/measure/bench/effect_times.hpp"
#include "lab/session/run_job.hpp"

#include <optional>

namespace glint::measure {

constexpr uint32_t kLeastFrames = 3;

struct SeriesPlan {
    uint32_t width = 0; ///< pixels
    uint32_t height = 0;
    /// Fraction of the surfaces that become mirrors (SharePass); none: the scene's own materials.
    std::optional<float> share;
    uint32_t warmUp = 10;     ///< frames per settings that are not counted
    uint32_t frames = 30;     ///< frames per settings that are counted; >= 1
    double budgetSeconds = 0; ///< reduces the frames (to kLeastFrames at least) if they take longer; 0: no limit
    bool redraw = false;      ///< draw the whole frame each time; false: draw the G-buffer once, then only the effect
};

struct SeriesFigures {
    EffectTimes times; ///< from timestamps
    /// Time with the effect minus time without it, by submitting and waiting.
    Spread wallMs;
    render::RenderStats stats; ///< counted in other frames than those that were timed
};

/// Times the settings of each session, frame by frame in turn, with and without the effect. Resizes the sessions.
/// `sessions`  of the same scene, one for each settings, without RenderJob::statistics
/// Errors: OutOfMemory, DeviceLost.
Result<std::vector<SeriesFigures>> runSeries(gpu::Context& context, std::vector<render::ReflectionSession>& sessions,
                                             const SeriesPlan& plan);

} // namespace glint::measure
