#include "lab/measure/bench/effect_times.hpp"

#include "lab/measure/bench/floor_pass.hpp"

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

using Times = std::vector<std::pair<std::string, double>>;
using PassSamples = std::vector<std::pair<std::string, std::vector<double>>>;

/// Adds one sample per name and frame: a pass may run several times in a frame.
void addSums(PassSamples& samples, const Times& passes) {
    Times sums;
    for (const auto& [name, milliseconds] : passes) {
        const auto found = std::ranges::find(sums, name, &Times::value_type::first);
        if (found == sums.end())
            sums.emplace_back(name, milliseconds);
        else
            found->second += milliseconds;
    }
    for (const auto& [name, milliseconds] : sums) {
        auto found = std::ranges::find(samples, name, &PassSamples::value_type::first);
        if (found == samples.end())
            found = samples.insert(samples.end(), {name, {}});
        found->second.push_back(milliseconds);
    }
}

} // namespace

Spread Spread::of(std::vector<double> values) {
    if (values.empty())
        return {};
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[static_cast<size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
    };
    return {at(0.5), at(0.95)};
}

double effectSum(const std::vector<std::pair<std::string, double>>& passes) {
    double sum = 0;
    for (const auto& [name, milliseconds] : passes)
        if (name != "composite/statistics" && name != "prepare/dfg")
            sum += milliseconds;
    return sum;
}

void EffectTimes::add(const render::FrameTimes& times) {
    addSums(passes_, times.effectPasses);
    totals_.push_back(effectSum(times.effectPasses));
    addFloor(times);
}

void EffectTimes::addFloor(const render::FrameTimes& times) {
    for (const auto& [name, milliseconds] : times.hostPasses)
        if (name == FloorPass::kName)
            floors_.push_back(milliseconds);
}

void EffectTimes::addDrawn(const render::FrameTimes& times) {
    Times drawn;
    for (const auto& pass : times.hostPasses)
        if (pass.first.starts_with("render/back_faces"))
            drawn.push_back(pass);
    addSums(hostPasses_, drawn);
}

std::vector<PassSpread> EffectTimes::passes() const {
    std::vector<PassSpread> result;
    for (const auto* samples : {&hostPasses_, &passes_})
        for (const auto& [name, milliseconds] : *samples)
            result.push_back({name, Spread::of(milliseconds)});
    return result;
}

double EffectTimes::hostMs() const {
    double sum = 0;
    for (const auto& [name, milliseconds] : hostPasses_)
        sum += Spread::of(milliseconds).median;
    return sum;
}

Spread EffectTimes::total() const {
    const Spread traced = Spread::of(totals_);
    return {traced.median + hostMs(), traced.p95 + hostMs()};
}

double EffectTimes::floorMultiple() const {
    return floor().median > 0 ? total().median / floor().median : 0;
}

} // namespace glint::measure
