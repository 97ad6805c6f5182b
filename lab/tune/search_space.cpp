#include "lab/tune/search_space.hpp"

#include "base/settings/setting_suggestion.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <cmath>

namespace glint::tune {
namespace {

using Scale = SettingSearch::Scale;

const SettingInfo* findSetting(std::string_view key) {
    const std::span<const SettingInfo> table = settingsTable();
    const auto found = std::ranges::find(table, key, &SettingInfo::key);
    return found == table.end() ? nullptr : &*found;
}

bool holds(const SettingSearch::Condition& condition, const Settings& settings) {
    const SettingInfo* const other = findSetting(condition.key);
    if (!other || !hasEffect(*other, settings))
        return false;
    const double value = settingValue(*other, &settings);
    if (condition.values.empty())
        return value > condition.above;
    return std::ranges::find(condition.values, settingText(*other, value)) != condition.values.end();
}

/// A proxy is the volume of a probe: without probes every ray of this march ends infinitely far away.
bool needsProbes(const SettingInfo& info, double value) {
    return info.key == "screen.march" && settingText(info, value) == "proxy";
}

void assign(Settings& settings, const SettingInfo& info, double value) {
    const SettingAssignment assignment{&info, &settings, value, false, std::nullopt};
    assignSettings({&assignment, 1});
}

bool isNamed(const SettingInfo& info, const std::string& name) {
    return info.key == name || info.key.starts_with(name + ".");
}

Result<void> checkNames(std::span<const std::string> vary) {
    for (const std::string& name : vary) {
        bool known = false, searched = false;
        for (const SettingInfo& info : settingsTable()) {
            known |= isNamed(info, name);
            searched |= isNamed(info, name) && info.search.scale != Scale::Never;
        }
        if (!known) {
            const SettingsTarget target{settingsTable(), nullptr};
            const std::vector<std::string> meant = likelySettings({&target, 1}, name);
            const std::string question =
                meant.empty() ? "" : fmt::format(" (did you mean {}?)", listText(meant, " or "));
            return invalidArgument("--vary {}: no setting and no group of this name{}; `glint settings` lists them",
                                   printable(name), question);
        }
        if (!searched)
            return invalidArgument("--vary {}: the search never varies this; docs/settings.md lists what it does",
                                   printable(name));
    }
    return {};
}

/// Three significant digits: files that people read, and candidates that meet again.
double rounded(double value) {
    if (value == 0 || !std::isfinite(value))
        return value;
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
    return std::round(value / step) * step;
}

double fromUnit(const Dimension& dimension, double unit) {
    const double t = std::clamp(unit, 0.0, 1.0);
    if (dimension.info->search.scale == Scale::Log)
        return dimension.min * std::pow(dimension.max / dimension.min, t);
    return dimension.min + t * (dimension.max - dimension.min);
}

double toUnit(const Dimension& dimension, double value) {
    const double clamped = std::clamp(value, dimension.min, dimension.max);
    if (dimension.info->search.scale == Scale::Log)
        return std::log(clamped / dimension.min) / std::log(dimension.max / dimension.min);
    return (clamped - dimension.min) / (dimension.max - dimension.min);
}

/// The value of a gene as the setting holds it.
double valueOf(const Dimension& dimension, double gene) {
    if (dimension.isWhole())
        return std::clamp(std::round(gene), 0.0, double(dimension.choices() - 1));
    double value = fromUnit(dimension, gene);
    // The start is met exactly, whatever its digits: genes that round to it mean it.
    const auto shown = [&](double v) { return dimension.info->type == SettingType::Int ? std::round(v) : rounded(v); };
    if (shown(value) == shown(dimension.start))
        return dimension.start;
    value = std::clamp(shown(value), dimension.min, dimension.max);
    return dimension.info->type == SettingType::Float ? static_cast<double>(static_cast<float>(value)) : value;
}

Dimension makeDimension(const SettingInfo& info, const Settings& start) {
    Dimension dimension;
    dimension.info = &info;
    dimension.start = settingValue(info, &start);
    if (!dimension.isWhole()) {
        const bool scaled = info.search.scale == Scale::Linear || dimension.start > 0;
        dimension.min = scaled ? std::min(info.search.min, dimension.start) : info.search.min;
        dimension.max = std::max(info.search.max, dimension.start);
    }
    return dimension;
}

} // namespace

bool Dimension::isWhole() const {
    return info->search.scale == Scale::Choice || info->search.scale == Scale::Switch;
}

int Dimension::choices() const {
    return info->search.scale == Scale::Switch ? 2 : static_cast<int>(info->choices.size());
}

bool hasEffect(const SettingInfo& info, const Settings& settings) {
    return std::ranges::all_of(info.search.conditions, [&](const auto& each) { return holds(each, settings); });
}

std::vector<std::string> differences(const Settings& start, const Settings& settings) {
    std::vector<std::string> result;
    for (const SettingInfo& info : settingsTable()) {
        const double value = settingValue(info, &settings);
        if (value != settingValue(info, &start))
            result.push_back(info.key + "=" + settingText(info, value));
    }
    return result;
}

Result<SearchSpace> SearchSpace::create(const Settings& start, std::span<const std::string> vary, bool motion,
                                        bool probes) {
    GLINT_CHECK(checkNames(vary));
    SearchSpace space;
    space.start_ = start;
    space.probes_ = probes;
    for (const bool whole : {false, true}) {
        for (const SettingInfo& info : settingsTable()) {
            const bool wanted =
                vary.empty() || std::ranges::any_of(vary, [&](const std::string& name) { return isNamed(info, name); });
            if (info.search.scale == Scale::Never || !wanted || (info.search.motionOnly && !motion))
                continue;
            const Dimension dimension = makeDimension(info, start);
            if (dimension.isWhole() == whole)
                space.dimensions_.push_back(dimension);
        }
    }
    if (space.dimensions_.empty())
        return invalidArgument("--vary: these settings matter only where something moves; add --paths pan, or others");
    return space;
}

Candidate SearchSpace::start() const {
    Candidate candidate;
    for (const Dimension& dimension : dimensions_)
        candidate.push_back(dimension.start);
    return candidate;
}

bool SearchSpace::isLeftOut(size_t dimension, double value) const {
    const Dimension& d = dimensions_[dimension];
    return !probes_ && value != d.start && needsProbes(*d.info, value);
}

size_t SearchSpace::wholeGenes() const {
    return static_cast<size_t>(std::ranges::count_if(dimensions_, &Dimension::isWhole));
}

std::vector<double> SearchSpace::lowest() const {
    return std::vector<double>(size(), 0.0);
}

std::vector<double> SearchSpace::highest() const {
    std::vector<double> result;
    for (const Dimension& dimension : dimensions_)
        result.push_back(dimension.isWhole() ? dimension.choices() - 1 : 1.0);
    return result;
}

Candidate SearchSpace::decode(const Genes& genes) const {
    Candidate candidate;
    for (size_t i = 0; i < size(); ++i)
        candidate.push_back(valueOf(dimensions_[i], genes[i]));
    return canonical(candidate);
}

Genes SearchSpace::encode(const Candidate& candidate) const {
    Genes genes;
    for (size_t i = 0; i < size(); ++i)
        genes.push_back(dimensions_[i].isWhole() ? candidate[i] : toUnit(dimensions_[i], candidate[i]));
    return genes;
}

Candidate SearchSpace::nearest(const Settings& settings) const {
    Candidate candidate;
    for (const Dimension& dimension : dimensions_)
        candidate.push_back(settingValue(*dimension.info, &settings));
    return decode(encode(candidate));
}

Settings SearchSpace::settings(const Candidate& candidate) const {
    Settings settings = start_;
    for (size_t i = 0; i < size(); ++i)
        assign(settings, *dimensions_[i].info, candidate[i]);
    return settings;
}

bool SearchSpace::acts(size_t dimension, const Candidate& candidate) const {
    return hasEffect(*dimensions_[dimension].info, settings(candidate));
}

Candidate SearchSpace::canonical(const Candidate& candidate) const {
    const Settings asked = settings(candidate);
    Candidate result = candidate;
    for (size_t i = 0; i < size(); ++i)
        if (isLeftOut(i, candidate[i]) || !hasEffect(*dimensions_[i].info, asked))
            result[i] = dimensions_[i].start;
    return result;
}

void SearchSpace::drop(const std::vector<size_t>& dimensions) {
    std::vector<Dimension> kept;
    for (size_t i = 0; i < size(); ++i)
        if (std::ranges::find(dimensions, i) == dimensions.end())
            kept.push_back(dimensions_[i]);
    dimensions_ = std::move(kept);
}

} // namespace glint::tune
