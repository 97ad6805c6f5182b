// What a frame costs, as the help panel says it: compute_ssr's four figures and their loads.
#pragma once

#include "render/run_job.hpp"

#include <deque>

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

/// The last frames of one size and one set of settings. A single frame's times jump about; medians can be read, and are
/// what --stats says.
class RecentTimes {
public:
    static constexpr size_t kFrames = 31;

    void clear() { frames_.clear(); }
    void add(const render::FrameTimes& times, double intervalMs);
    /// Of the medians of each pass and of the interval.
    FrameFigures figures() const;

private:
    struct Frame {
        render::FrameTimes times;
        double intervalMs = 0;
    };
    std::deque<Frame> frames_;
};

/// {"gpuComputeMs", "gpuRenderMs", "gpuMs", "cpuMs", "intervalMs"}: what the help panel shows; "deviceBytes"; "passes"
/// as --stats has them, but only those of `lastFrame`: what was done once, for the first frame, is no frame's cost.
std::string figuresJson(const FrameFigures& figures, const render::RenderStats& stats,
                        const std::vector<std::string>& lastFrame, size_t deviceBytes);

} // namespace glint::view
