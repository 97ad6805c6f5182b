// The cost of a frame as the help panel shows it: compute_ssr's four figures and their loads.
#pragma once

#include "lab/session/run_job.hpp"

#include <deque>

namespace glint::view {

struct FrameFigures {
    double computeMs = 0;  ///< GPU: ray marching only (passes trace/...)
    double renderMs = 0;   ///< GPU: the host's draws, G-buffer and lighting
    double totalMs = 0;    ///< GPU: all passes of the frame, without the copy into the window
    double cpuMs = 0;      ///< from the start of the frame to its end, without waits for the GPU
    double intervalMs = 0; ///< from the start of this frame to the start of the next

    double load(double milliseconds) const { return intervalMs > 0 ? milliseconds / intervalMs : 0; }
};

/// `intervalMs`  from the start of the frame to the start of the next
FrameFigures frameFigures(const render::FrameTimes& times, double intervalMs);

/// The times of the last frames with the same size and settings. Times of single frames fluctuate; medians are
/// readable, and --stats reports them too.
class RecentTimes {
public:
    static constexpr size_t kFrames = 31;

    void clear() { frames_.clear(); }
    void add(const render::FrameTimes& times, double intervalMs);
    /// Returns figures from the medians of each pass and of the interval.
    FrameFigures figures() const;

private:
    struct Frame {
        render::FrameTimes times;
        double intervalMs = 0;
    };
    std::deque<Frame> frames_;
};

/// {"gpuComputeMs", "gpuRenderMs", "gpuMs", "cpuMs", "intervalMs"}, as in the help panel; "deviceBytes"; "passes" as in
/// --stats, but only those of `lastFrame`: work done once, in the first frame, is not a cost per frame.
std::string figuresJson(const FrameFigures& figures, const render::RenderStats& stats,
                        const std::vector<std::string>& lastFrame, size_t deviceBytes);

} // namespace glint::view
