#include "frame_figures.hpp"

#include <algorithm>

namespace glint::view {

FrameFigures frameFigures(const render::FrameTimes& times, double intervalMs) {
    FrameFigures figures;
    for (const auto& [name, milliseconds] : times.hostPasses)
        figures.renderMs += milliseconds;
    double effect = 0;
    for (const auto& [name, milliseconds] : times.effectPasses) {
        effect += milliseconds;
        if (name.starts_with("trace/"))
            figures.computeMs += milliseconds;
    }
    figures.totalMs = figures.renderMs + effect;
    figures.intervalMs = std::max(intervalMs, times.wallMs);
    figures.cpuMs = std::max(figures.intervalMs - figures.totalMs, 0.0);
    return figures;
}

} // namespace glint::view
