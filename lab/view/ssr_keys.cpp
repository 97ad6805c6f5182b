#include "lab/view/ssr_keys.hpp"

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

/// Rounds to six digits, a float's precision: a step down and up returns 20 to 20, not to 19.999998.
double rounded(double value) {
    if (value == 0)
        return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
    return std::round(value / unit) * unit;
}

} // namespace

std::string_view nextView(std::string_view view) {
    const auto found = std::ranges::find(kCycledViews, view);
    return found == kCycledViews.end() || found + 1 == kCycledViews.end() ? kCycledViews.front() : *(found + 1);
}

std::optional<std::string> pressSsrKey(char digit, SettingsModel& model) {
    for (const SsrKey& key : kSsrKeys) {
        if (digit != key.less && digit != key.more)
            continue;
        const SettingInfo& info = settingOf(key.setting);
        const bool more = digit == key.more;
        const double now = model.value(info);
        double next = now;
        if (key.step > 0) // on a grid of steps: ten times 0.1 is 1
            next = std::round((now + (more ? key.step : -key.step)) / key.step * 1e6) / 1e6 * key.step;
        else // a value at 0 must be able to grow again
            next = rounded(std::max(now, key.min) * (more ? key.factor : 1 / key.factor));
        model.set(info, std::clamp(next, key.min, key.max));
        return fmt::format("{} {}{}{}", key.name, settingText(info, model.value(info)), info.unit.empty() ? "" : " ",
                           info.unit);
    }
    return std::nullopt;
}

} // namespace glint::view
