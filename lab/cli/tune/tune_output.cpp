#include "lab/cli/tune/tune_output.hpp"

#include "base/text.hpp"
#include "glint/version.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glint::cli {
namespace {

using TuneJson = nlohmann::ordered_json;

const char* unitOf(const tune::TuneResult& result) {
    return result.counted ? "floors" : "ms";
}

/// JSON has no infinity.
TuneJson finite(double value) {
    return std::isfinite(value) ? TuneJson(value) : TuneJson();
}

TuneJson valueJson(const SettingInfo& info, double value) {
    const std::string text = settingText(info, value);
    return info.type == SettingType::Enum ? TuneJson(text) : TuneJson::parse(text);
}

TuneJson differencesJson(const Settings& from, const Settings& settings) {
    TuneJson json = TuneJson::object();
    for (const SettingInfo& info : settingsTable())
        if (const double value = settingValue(info, &settings); value != settingValue(info, &from))
            json[info.key] = valueJson(info, value);
    return json;
}

/// What of the start its preset does not say: the renderer's settings too.
TuneJson startJson(const TuneNames& names) {
    TuneJson json = differencesJson(names.preset.reflections, names.settings.reflections);
    for (const SettingInfo& info : render::renderSettingsTable())
        if (const double value = settingValue(info, &names.settings.render);
            value != settingValue(info, &names.preset.render))
            json[info.key] = valueJson(info, value);
    return json;
}

TuneJson figuresJson(const tune::Figures& figures) {
    return {{"cost", finite(figures.cost)}, {"error", finite(figures.error)}};
}

TuneJson pointJson(const tune::TunePoint& point, const Settings& start) {
    TuneJson json = {{"settings", differencesJson(start, point.settings)},
                     {"cost", finite(point.search.figures.cost)},
                     {"error", finite(point.search.figures.error)}};
    json["held"] = figuresJson(point.held.figures);
    json["preset"] = point.preset.empty() ? TuneJson() : TuneJson(point.preset);
    json["chosen"] = point.chosen;
    json["measured"] = {{"floors", finite(point.timing.floors)}, {"ms", finite(point.timing.ms)}};
    for (const auto* views : {&point.search.views, &point.held.views})
        for (const tune::ViewFigures& view : *views)
            json["views"].push_back(
                {{"view", view.view}, {"cost", finite(view.figures.cost)}, {"error", finite(view.figures.error)}});
    return json;
}

std::string pointLine(const tune::TunePoint& point, const std::string& mark) {
    return fmt::format("  {:<12} {:>9.2f} {:>10.5f} {:>11.2f} {:>11.5f} {:>9.1f} {:>9.2f}\n", mark,
                       point.search.figures.cost, point.search.figures.error, point.held.figures.cost,
                       point.held.figures.error, point.timing.floors, point.timing.ms);
}

std::string pointMark(const tune::TunePoint& point) {
    return point.chosen ? "chosen" : point.preset;
}

std::string targetText(const tune::TuneResult& result) {
    return result.target.mostCost ? fmt::format("cost at most {:.2f} {}", *result.target.mostCost, unitOf(result))
                                  : fmt::format("error at most {:.5f}", *result.target.mostError);
}

std::string verdict(const tune::TuneResult& result) {
    if (!result.met)
        return "nothing meets the target; this comes nearest without being worse than the start";
    return result.held ? "it meets the target and holds up on the views held back"
                       : "it meets the target, but on the views held back it shows more error than the start";
}

} // namespace

std::string tuneText(const tune::TuneResult& result, const TuneNames& names) {
    std::string text = fmt::format("{}; {} x {}; {} settings tried in {} generations, from {}\n", result.device,
                                   result.width, result.height, result.tried, result.generations, names.start);
    text += fmt::format("\n  {:<12} {:>9} {:>10} {:>11} {:>11} {:>9} {:>9}\n", "curve", unitOf(result), "error",
                        fmt::format("held {}", unitOf(result)), "held error", "floors", "ms");
    for (const tune::TunePoint& point : result.points)
        text += pointLine(point, pointMark(point));
    text += "\n  presets\n";
    for (const tune::TunePoint& point : result.presets)
        text += pointLine(point, point.preset);
    text += fmt::format("\nasked: {}; {}\n", targetText(result), verdict(result));
    text += pointLine(result.choice, "chosen");
    if (!result.sensitivities.empty())
        text += fmt::format("\nwhat the start's value would change: {:>10} {:>10}\n", unitOf(result), "error");
    for (const tune::Sensitivity& each : result.sensitivities)
        text += fmt::format("  {:<34} {:>+10.2f} {:>+10.5f}\n", fmt::format("{}={}", each.key, each.value),
                            each.change.cost, each.change.error);
    return text;
}

Error missedTarget(const tune::TuneResult& result) {
    return makeError(ErrorCode::Unsupported,
                     "nothing that was tried meets the target, {}; the best that was found has "
                     "cost {:.2f} and error {:.5f}; relax the target, or give more --generations",
                     targetText(result), result.choice.search.figures.cost, result.choice.search.figures.error);
}

std::string tuneJson(const tune::TuneResult& result, const TuneNames& names) {
    const Settings& start = result.presets.front().settings;
    TuneJson json = {
        {"glint", fmt::format("{}.{}.{}", GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH)},
        {"device", result.device},
        {"driver", result.driver},
        {"scenes", names.scenes},
        {"size", {result.width, result.height}},
        {"seed", names.seed},
        {"generations", result.generations},
        {"tried", result.tried},
        {"start", names.start},
        {"startPreset", names.settings.preset},
        {"startSettings", startJson(names)},
        {"cost", {{"unit", unitOf(result)}, {"counted", result.counted}}},
        {"metric", result.metric == tune::ErrorMetric::Flip ? "flip" : "relativeMSE"},
    };
    if (result.target.mostCost)
        json["target"] = {{"cost", *result.target.mostCost}};
    else
        json["target"] = {{"error", *result.target.mostError}};
    json["met"] = result.met;
    json["heldUp"] = result.held;
    json["points"] = TuneJson::array();
    for (const tune::TunePoint& point : result.points)
        json["points"].push_back(pointJson(point, start));
    json["choice"] = pointJson(result.choice, start);
    for (const tune::TunePoint& point : result.presets)
        json["presets"].push_back({{"name", point.preset},
                                   {"cost", finite(point.search.figures.cost)},
                                   {"error", finite(point.search.figures.error)},
                                   {"held", figuresJson(point.held.figures)},
                                   {"measured", {{"floors", point.timing.floors}, {"ms", point.timing.ms}}}});
    json["sensitivities"] = TuneJson::array();
    for (const tune::Sensitivity& each : result.sensitivities)
        json["sensitivities"].push_back({{"setting", each.key},
                                         {"value", each.value},
                                         {"start", each.start},
                                         {"error", finite(each.change.error)},
                                         {"cost", finite(each.change.cost)}});
    json["withoutEffect"] = result.withoutEffect;
    return json.dump(2) + "\n";
}

std::string tunedSettings(const tune::TuneResult& result, const TuneNames& names) {
    TuneJson json;
    json["description"] =
        fmt::format("glint tune {}: {}, from {}", joinText(names.scenes, " "), targetText(result), names.start);
    const TuneJson differences = differencesJson(Settings(), result.choice.settings);
    for (const auto& [key, value] : differences.items()) {
        const size_t dot = key.find('.');
        json[key.substr(0, dot)][key.substr(dot + 1)] = value;
    }
    return json.dump(2) + "\n";
}

} // namespace glint::cli
