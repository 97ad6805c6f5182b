#include "lab/view/settings_model.hpp"

#include "base/assert.hpp"
#include "base/file.hpp"
#include "lab/view/fuzzy_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace glint::view {
namespace {

bool isIn(std::span<const SettingInfo> table, const SettingInfo& info) {
    return !table.empty() && &info >= table.data() && &info < table.data() + table.size();
}

/// Clamps to the setting's range; at an open end to the nearest float inside.
double clamped(const SettingInfo& info, double value) {
    if (info.type == SettingType::Boolean)
        return value != 0 ? 1 : 0;
    if (info.type == SettingType::Enum)
        return std::clamp(value, 0.0, static_cast<double>(info.choices.size() - 1));
    if (info.type == SettingType::Int)
        value = std::round(value);
    const SettingRange& range = info.range;
    if (range.minOpen && value <= range.min)
        return info.type == SettingType::Int
                   ? range.min + 1
                   : static_cast<double>(std::nextafter(static_cast<float>(range.min), static_cast<float>(range.max)));
    if (range.maxOpen && value >= range.max)
        return info.type == SettingType::Int
                   ? range.max - 1
                   : static_cast<double>(std::nextafter(static_cast<float>(range.max), static_cast<float>(range.min)));
    return std::clamp(value, range.min, range.max);
}

bool contains(std::string_view text, std::string_view part) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return !std::ranges::search(text, part, {}, lower, lower).empty();
}

/// Returns how well a setting matches `text`; no value if it does not.
std::optional<int> answer(const SettingInfo& info, std::string_view text) {
    std::optional<int> best = fuzzyScore(text, info.key);
    for (const SettingAlias& alias : info.aliases)
        best = std::max(best, fuzzyScore(text, alias.system + ":" + alias.name));
    if (text.size() >= 3 && contains(info.meaning, text))
        best = std::max(best, std::optional<int>(0));
    return best;
}

} // namespace

const SettingInfo& settingOf(std::string_view key) {
    for (const std::span<const SettingInfo> table : render::allSettings())
        for (const SettingInfo& info : table)
            if (info.key == key)
                return info;
    GLINT_ASSERT(false, "no setting '{}'", key);
    std::abort();
}

SettingsModel::SettingsModel(render::SettingsRequest request, const render::ProgramSettings& settings)
    : state_{std::move(request), settings, settings} {
    state_.request.file.clear();
    state_.request.assignments.clear();
    state_.request.preset = settings.preset;
    if (auto base = render::loadSettings(state_.request))
        state_.baseline = *base;
}

void* SettingsModel::object(const SettingInfo& info, render::ProgramSettings& settings) {
    for (const SettingsTarget& target : settings.targets())
        if (isIn(target.table, info))
            return target.object;
    GLINT_ASSERT(false, "'{}' is in no table", info.key);
    std::abort();
}

double SettingsModel::value(const SettingInfo& info) const {
    render::ProgramSettings copy = state_.now;
    return settingValue(info, object(info, copy));
}

double SettingsModel::baseline(const SettingInfo& info) const {
    render::ProgramSettings copy = state_.baseline;
    return settingValue(info, object(info, copy));
}

size_t SettingsModel::changedCount() const {
    size_t count = 0;
    for (const std::span<const SettingInfo> table : render::allSettings())
        count += static_cast<size_t>(std::ranges::count_if(table, [&](const SettingInfo& i) { return changed(i); }));
    return count;
}

void SettingsModel::change(bool continues) {
    if (!continues || !stack_.canUndo())
        stack_.push(state_);
    ++version_;
}

void SettingsModel::set(const SettingInfo& info, double value, bool continues) {
    const double in = clamped(info, value);
    if (!std::isfinite(in) || in == this->value(info))
        return;
    change(continues);
    const SettingAssignment assignment = {&info, object(info, state_.now), in, false, std::nullopt};
    assignSettings({&assignment, 1});
}

Result<void> SettingsModel::assign(std::string_view key, std::string_view value) {
    render::ProgramSettings next = state_.now;
    GLINT_CHECK(setSetting(next.targets(), key, value, next.preset));
    change(false);
    state_.now = next;
    return {};
}

void SettingsModel::reset(const SettingInfo& info) {
    set(info, baseline(info));
}

void SettingsModel::resetAll() {
    if (changedCount() == 0)
        return;
    change(false);
    state_.now = state_.baseline;
}

bool SettingsModel::undo() {
    const bool done = stack_.undo(state_);
    version_ += done;
    return done;
}

bool SettingsModel::redo() {
    const bool done = stack_.redo(state_);
    version_ += done;
    return done;
}

Result<void> SettingsModel::suit(State& state, const std::vector<std::string>& defaults) {
    state.request.defaults = defaults;
    GLINT_TRY(baseline, render::loadSettings(state.request));
    for (const std::span<const SettingInfo> table : render::allSettings())
        for (const SettingInfo& info : table) {
            const double before = settingValue(info, object(info, state.baseline));
            const double after = settingValue(info, object(info, baseline));
            void* const now = object(info, state.now);
            if (after == before || settingValue(info, now) != before)
                continue;
            const SettingAssignment assignment = {&info, now, after, false, std::nullopt};
            assignSettings({&assignment, 1});
        }
    state.baseline = baseline;
    return {};
}

Result<void> SettingsModel::suitScene(const std::vector<std::string>& defaults) {
    SettingsModel next = *this;
    Result<void> suited = suit(next.state_, defaults);
    next.stack_.forEach([&](State& state) {
        if (suited)
            suited = suit(state, defaults);
    });
    GLINT_CHECK(suited);
    *this = std::move(next);
    ++version_;
    return {};
}

Result<void> SettingsModel::usePreset(std::string_view name) {
    render::SettingsRequest request = state_.request;
    request.preset = name;
    GLINT_TRY(settings, render::loadSettings(request));
    change(false);
    state_.request = request;
    state_.now = state_.baseline = settings;
    return {};
}

Result<void> SettingsModel::load(const std::string& path) {
    render::SettingsRequest request = state_.request;
    request.file = path;
    GLINT_TRY(settings, render::loadSettings(request));
    change(false);
    state_.now = settings;
    return {};
}

Result<void> SettingsModel::save(const std::string& path) const {
    return writeFile(path, render::settingsJson(state_.now));
}

std::string SettingsModel::options() const {
    std::string text = fmt::format("--preset {}", state_.request.preset);
    for (const std::span<const SettingInfo> table : render::allSettings())
        for (const SettingInfo& info : table)
            if (changed(info))
                text += fmt::format(" --set {}={}", info.key, settingText(info, value(info)));
    return text;
}

std::vector<const SettingInfo*> SettingsModel::search(std::string_view text) const {
    std::vector<std::pair<int, const SettingInfo*>> found;
    for (const std::span<const SettingInfo> table : render::allSettings())
        for (const SettingInfo& info : table)
            if (const std::optional<int> score = answer(info, text))
                found.emplace_back(*score, &info);
    if (!text.empty())
        std::ranges::stable_sort(found, std::ranges::greater(), [](const auto& one) { return one.first; });
    std::vector<const SettingInfo*> result;
    for (const auto& [score, info] : found)
        result.push_back(info);
    return result;
}

} // namespace glint::view
