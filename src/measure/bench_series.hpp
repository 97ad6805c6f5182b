// One point of a benchmark: several settings on one picture size, timed in turn so that what slows the machine down
// meets all of them alike.
#pragma once

#include "measure/effect_times.hpp"
#include "render/run_job.hpp"

#include <optional>

namespace glint::measure {

constexpr uint32_t kLeastFrames = 3;

struct SeriesPlan {
    uint32_t width = 0; ///< pixels
    uint32_t height = 0;
    std::optional<float> share; ///< of the surfaces that become mirrors (SharePass); none: the scene's own materials
    uint32_t warmUp = 10;       ///< frames of each settings that are not counted
    uint32_t frames = 30;       ///< that are; >= 1
    double budgetSeconds = 0;   ///< fewer frames (kLeastFrames at least) when they take longer; 0: no limit
    bool redraw = false;        ///< draw the whole frame each time; false: the G-buffer once, then the effect alone
};

struct SeriesFigures {
    EffectTimes times; ///< by timestamps
    Spread wallMs;     ///< effect on minus off, by submitting and waiting; what counting took is left out
    render::RenderStats stats;
};

/// Times each session's settings, frame by frame in turn: with the effect, without it. Resizes the sessions.
/// `sessions`  of the same scene, one for each settings, with RenderJob::statistics
/// Errors: OutOfMemory, DeviceLost.
Result<std::vector<SeriesFigures>> runSeries(gpu::Context& context, std::vector<render::JobSession>& sessions,
                                             const SeriesPlan& plan);

} // namespace glint::measure
