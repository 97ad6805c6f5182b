// What a frame costs, as the help panel says it: compute_ssr's four figures and their loads.
#pragma once

#include "render/run_job.hpp"

namespace glint::view {

struct FrameFigures {
    double computeMs = 0;  ///< GPU: the marching of rays alone (passes trace/...)
    double renderMs = 0;   ///< GPU: what the host draws, G-buffer and light
    double totalMs = 0;    ///< GPU: all passes of the frame; the copy into the window is none of them
    double cpuMs = 0;      ///< from the frame's begin to its end, less what was waited for the GPU
    double intervalMs = 0; ///< from this frame to the next

    double load(double milliseconds) const { return intervalMs > 0 ? milliseconds / intervalMs : 0; }
};

/// `intervalMs`  from the begin of the frame to the begin of the next
FrameFigures frameFigures(const render::FrameTimes& times, double intervalMs);

} // namespace glint::view
