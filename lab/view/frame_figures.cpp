#include "lab/view/frame_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

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

namespace {

/// Of an even count the upper middle, as in --stats.
double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

void RecentTimes::add(const render::FrameTimes& times, double intervalMs) {
    frames_.push_back({times, intervalMs});
    if (frames_.size() > kFrames)
        frames_.pop_front();
}

FrameFigures RecentTimes::figures() const {
    if (frames_.empty())
        return {};
    using Passes = std::vector<std::pair<std::string, double>>;
    const auto over = [&](const std::function<double(const Frame&)>& value) {
        std::vector<double> values;
        for (const Frame& frame : frames_)
            if (const double one = value(frame); one >= 0)
                values.push_back(one);
        return median(std::move(values));
    };
    const auto passes = [&](Passes render::FrameTimes::*list) {
        Passes result = frames_.back().times.*list;
        for (size_t i = 0; i < result.size(); ++i)
            result[i].second = over([&, name = result[i].first](const Frame& frame) {
                const Passes& other = frame.times.*list;
                if (i < other.size() && other[i].first == name) // several passes may share a name
                    return other[i].second;
                const auto same = std::ranges::find(other, name, &Passes::value_type::first);
                return same == other.end() ? -1.0 : same->second;
            });
        return result;
    };
    render::FrameTimes medians;
    medians.wallMs = over([](const Frame& frame) { return frame.times.wallMs; });
    medians.hostPasses = passes(&render::FrameTimes::hostPasses);
    medians.effectPasses = passes(&render::FrameTimes::effectPasses);
    return frameFigures(medians, over([](const Frame& frame) { return frame.intervalMs; }));
}

std::string figuresJson(const FrameFigures& figures, const render::RenderStats& stats,
                        const std::vector<std::string>& lastFrame, size_t deviceBytes) {
    std::string passes;
    for (const auto& [name, milliseconds] : stats.passes)
        if (std::ranges::find(lastFrame, name) != lastFrame.end())
            passes +=
                fmt::format("{}\n    {{\"name\": \"{}\", \"ms\": {}}}", passes.empty() ? "" : ",", name, milliseconds);
    std::string text = "{\n";
    for (const auto& [name, value] : {std::pair("gpuComputeMs", figures.computeMs),
                                      std::pair("gpuRenderMs", figures.renderMs), std::pair("gpuMs", figures.totalMs),
                                      std::pair("cpuMs", figures.cpuMs), std::pair("intervalMs", figures.intervalMs)})
        text += fmt::format("  \"{}\": {},\n", name, value);
    return text + fmt::format("  \"deviceBytes\": {},\n  \"passes\": [{}\n  ]\n}}\n", deviceBytes, passes);
}

} // namespace glint::view
