#include "lab/measure/figures/figure_change.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glint::measure {
namespace {

constexpr std::array<std::string_view, 4> kKindNames = {"share", "wrong", "error", "time"};

/// The standard error of the difference, and Welch's degrees of freedom for it. Based on: Welch 1947, "The
/// generalization of Student's problem when several different population variances are involved", Biometrika 34.
Estimate difference(const Estimate& before, const Estimate& now) {
    const double a = before.standardError * before.standardError, b = now.standardError * now.standardError;
    Estimate result;
    result.value = now.value - before.value;
    result.standardError = std::sqrt(a + b);
    if (a + b > 0)
        result.freedom = (a + b) * (a + b) / ((a > 0 ? a * a / before.freedom : 0) + (b > 0 ? b * b / now.freedom : 0));
    return result;
}

/// Units of a change: percentage points, or percent of the earlier value.
double unitOf(const Figure& before) {
    switch (before.kind) {
    case FigureKind::Share:
    case FigureKind::Wrong: return 0.01;
    case FigureKind::Error:
    case FigureKind::Time: break;
    }
    return 0.01 * std::abs(before.estimate.value);
}

/// 0 / 0 is no change.
double inUnits(double change, double unit) {
    if (change == 0)
        return 0;
    return unit > 0 ? change / unit : std::copysign(std::numeric_limits<double>::infinity(), change);
}

} // namespace

std::span<const std::string_view> figureKindNames() {
    return kKindNames;
}

Estimate Estimate::of(std::span<const double> values) {
    GLINT_ASSERT(values.size() >= 2, "{} values have no spread", values.size());
    const auto count = static_cast<double>(values.size());
    double sum = 0, squares = 0;
    for (const double value : values)
        sum += value;
    const double mean = sum / count;
    if (std::ranges::all_of(values, [&](double one) { return one == values.front(); }))
        return {values.front(), 0, 0}; // not the rounded mean
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (count - 1) / count), count - 1};
}

double studentFactor(double freedom) {
    // The 97.5th percentiles of Student's distribution for 1 to 30 degrees of freedom.
    constexpr std::array kFactors = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                     2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                     2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
    const double whole = std::floor(freedom + 1e-6); // Welch's formula gives 2 as 1.9999...
    if (!(whole >= 2))
        return kFactors.front();
    if (whole <= kFactors.size())
        return kFactors[static_cast<size_t>(whole) - 1];
    constexpr double kNormal = 1.959964;
    return kNormal + (kNormal * kNormal * kNormal + kNormal) / (4 * whole); // the first terms in 1 / freedom
}

FigureChange changeOf(const Figure& before, const Figure& now) {
    const Estimate change = difference(before.estimate, now.estimate);
    const double half = change.standardError > 0 ? studentFactor(change.freedom) * change.standardError : 0;
    const double sign = now.kind == FigureKind::Share ? -1 : 1;
    const double unit = unitOf(before);
    FigureChange result;
    result.before = before;
    result.now = now;
    result.worse = inUnits(sign * change.value, unit);
    result.low = inUnits(sign * change.value - half, unit);
    result.high = inUnits(sign * change.value + half, unit);
    if (half == 0 && change.value == 0)
        result.verdict = Verdict::Same;
    else if (result.low > 0)
        result.verdict = Verdict::Worse;
    else
        result.verdict = result.high < 0 ? Verdict::Better : Verdict::Noise;
    return result;
}

FigureChanges compareFigures(std::span<const Figure> before, std::span<const Figure> now, bool sameDevice) {
    FigureChanges result;
    for (const Figure& figure : now) {
        const auto old = std::ranges::find_if(before, [&](const Figure& other) { return figure.sameAs(other); });
        if (old == before.end())
            result.added.push_back(figure);
        else if (figure.kind == FigureKind::Time && !sameDevice)
            ++result.otherDevice;
        else
            result.changes.push_back(changeOf(*old, figure));
    }
    for (const Figure& figure : before)
        if (std::ranges::none_of(now, [&](const Figure& other) { return figure.sameAs(other); }))
            result.removed.push_back(figure);
    return result;
}

} // namespace glint::measure
