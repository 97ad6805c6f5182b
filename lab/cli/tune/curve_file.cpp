#include "lab/cli/tune/curve_file.hpp"

#include "base/file.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <cmath>

namespace glint::cli {
namespace {

using CurveJson = nlohmann::ordered_json;

constexpr size_t kLongestCurve = size_t(16) << 20;
constexpr size_t kMostPoints = 10000;
constexpr int kDeepestSettings = 4;

/// A value of the file with its place in it, for messages.
struct Place {
    const CurveJson& json;
    std::string name; ///< "points[3].cost"; empty: the file itself

    Place at(const char* key) const {
        static const CurveJson missing;
        const auto found = json.is_object() ? json.find(key) : json.end();
        return {found == json.end() ? missing : *found, name.empty() ? key : fmt::format("{}.{}", name, key)};
    }
    Place at(size_t index) const { return {json[index], fmt::format("{}[{}]", name, index)}; }
};

Result<double> number(const Place& place) {
    if (!place.json.is_number() || !std::isfinite(place.json.get<double>()))
        return invalidInput("{} is no number", place.name);
    return place.json.get<double>();
}

/// A cost or an error.
Result<double> positive(const Place& place) {
    GLINT_TRY(value, number(place));
    return value >= 0 ? Result<double>(value) : invalidInput("{} is below 0", place.name);
}

Result<std::string> text(const Place& place) {
    if (!place.json.is_string())
        return invalidInput("{} is no text", place.name);
    return place.json.get<std::string>();
}

Result<size_t> listSize(const Place& place, size_t least) {
    if (!place.json.is_array() || place.json.size() < least || place.json.size() > kMostPoints)
        return invalidInput("{} is no list of {} to {}", place.name, least, kMostPoints);
    return place.json.size();
}

/// {"screen": {"step": 4}} and {"screen.step": 4} become "screen.step=4".
Result<void> addAssignments(const Place& place, const std::string& prefix, int depth, CurveJson& assignments) {
    if (!place.json.is_object() || depth > kDeepestSettings)
        return invalidInput("{} is no object of settings", place.name);
    for (const auto& [key, value] : place.json.items()) {
        const std::string name = prefix.empty() ? key : fmt::format("{}.{}", prefix, key);
        if (value.is_object())
            GLINT_CHECK(addAssignments({value, fmt::format("{}.{}", place.name, key)}, name, depth + 1, assignments));
        else if (value.is_string())
            assignments.push_back(fmt::format("{}={}", name, value.get<std::string>()));
        else if (value.is_number() || value.is_boolean())
            assignments.push_back(fmt::format("{}={}", name, value.dump()));
        else
            return invalidInput("{}.{} is no number, text, true or false", place.name, printable(key));
    }
    return {};
}

/// Those of the start that the point's do not replace, then the point's.
CurveJson joined(const CurveJson& start, const CurveJson& own) {
    const auto keyOf = [](const CurveJson& assignment) {
        const auto& text = assignment.get_ref<const std::string&>();
        return text.substr(0, text.find('='));
    };
    CurveJson all = CurveJson::array();
    for (const CurveJson& assignment : start)
        if (std::ranges::none_of(own, [&](const CurveJson& other) { return keyOf(other) == keyOf(assignment); }))
            all.push_back(assignment);
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

/// `start`  assignments that make the start of its preset
Result<CurveJson> readPoint(const Place& place, const CurveJson& start) {
    CurveJson point;
    CurveJson own = CurveJson::array();
    GLINT_CHECK(addAssignments(place.at("settings"), "", 1, own));
    point["assignments"] = joined(start, own);
    GLINT_TRY(cost, positive(place.at("cost")));
    GLINT_TRY(error, positive(place.at("error")));
    point["cost"] = cost;
    point["error"] = error;
    point["heldError"] = nullptr;
    if (!place.at("held").json.is_null()) {
        GLINT_TRY(held, positive(place.at("held").at("error")));
        point["heldError"] = held;
    }
    point["preset"] = nullptr;
    if (!place.at("preset").json.is_null()) {
        GLINT_TRY(preset, text(place.at("preset")));
        point["preset"] = preset;
    }
    const Place chosen = place.at("chosen");
    if (!chosen.json.is_null() && !chosen.json.is_boolean())
        return invalidInput("{} is neither true nor false", chosen.name);
    point["chosen"] = chosen.json.is_boolean() && chosen.json.get<bool>();
    return point;
}

Result<CurveJson> readSize(const Place& place) {
    GLINT_TRY(count, listSize(place, 2));
    CurveJson size = CurveJson::array();
    for (size_t i = 0; i < count; ++i) {
        GLINT_TRY(side, positive(place.at(i)));
        size.push_back(side);
    }
    return count == 2 ? Result<CurveJson>(std::move(size)) : invalidInput("{} is no [width, height]", place.name);
}

Result<CurveJson> checkedCurve(const Place& file) {
    if (!file.json.is_object())
        return invalidInput("this is no JSON object: give the file that `glint tune --json` wrote");
    CurveJson curve;
    const Place named = file.at("device"); // its name, or an object with the driver too
    GLINT_TRY(device, text(named.json.is_object() ? named.at("name") : named));
    curve["device"] = device;
    curve["scenes"] = CurveJson::array();
    GLINT_TRY(scenes, listSize(file.at("scenes"), 1));
    for (size_t i = 0; i < scenes; ++i) {
        GLINT_TRY(scene, text(file.at("scenes").at(i)));
        curve["scenes"].push_back(scene);
    }
    GLINT_TRY(size, readSize(file.at("size")));
    curve["size"] = std::move(size);
    GLINT_TRY(start, text(file.at("start")));
    curve["start"] = start;
    const Place preset = file.at("startPreset");
    GLINT_TRY(presetName, preset.json.is_null() ? Result<std::string>(start) : text(preset));
    curve["preset"] = presetName;
    CurveJson startAssignments = CurveJson::array();
    if (const Place settings = file.at("startSettings"); !settings.json.is_null())
        GLINT_CHECK(addAssignments(settings, "", 1, startAssignments));
    GLINT_TRY(unit, text(file.at("cost").at("unit")));
    curve["unit"] = unit;
    curve["points"] = CurveJson::array();
    GLINT_TRY(points, listSize(file.at("points"), 1));
    for (size_t i = 0; i < points; ++i) {
        GLINT_TRY(point, readPoint(file.at("points").at(i), startAssignments));
        if (i > 0 && point["cost"].get<double>() < curve["points"].back()["cost"].get<double>())
            return invalidInput("points[{}].cost is below the one before: points are ordered by cost", i);
        curve["points"].push_back(std::move(point));
    }
    curve["presets"] = CurveJson::array();
    if (const Place presets = file.at("presets"); !presets.json.is_null()) {
        GLINT_TRY(count, listSize(presets, 0));
        for (size_t i = 0; i < count; ++i) {
            GLINT_TRY(name, text(presets.at(i).at("name")));
            GLINT_TRY(cost, positive(presets.at(i).at("cost")));
            GLINT_TRY(error, positive(presets.at(i).at("error")));
            curve["presets"].push_back({{"name", name}, {"cost", cost}, {"error", error}});
        }
    }
    curve["sensitivities"] = CurveJson::array();
    if (const Place list = file.at("sensitivities"); !list.json.is_null()) {
        GLINT_TRY(count, listSize(list, 0));
        for (size_t i = 0; i < count; ++i) {
            GLINT_TRY(setting, text(list.at(i).at("setting")));
            GLINT_TRY(error, number(list.at(i).at("error")));
            GLINT_TRY(cost, number(list.at(i).at("cost")));
            curve["sensitivities"].push_back({{"setting", setting}, {"error", error}, {"cost", cost}});
        }
    }
    return curve;
}

} // namespace

Result<CurveJson> readCurve(const std::string& file) {
    auto bytes = readFile(file, kLongestCurve);
    if (!bytes)
        return makeError(bytes.error().code, "--curve {}", bytes.error().message);
    const CurveJson json = CurveJson::parse(*bytes, nullptr, false);
    auto curve = checkedCurve({json, ""});
    if (!curve)
        return makeError(curve.error().code, "--curve {}: {}", printable(file), printable(curve.error().message, 300));
    CurveJson named;
    named["file"] = file;
    named.update(*curve);
    return named;
}

} // namespace glint::cli
