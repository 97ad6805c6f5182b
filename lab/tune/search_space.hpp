// The settings that a search varies, read from the settings table, and the vectors of numbers that an optimiser sees in
// their place.
#pragma once

#include "base/settings/settings_target.hpp"
#include "glint/settings.hpp"

#include <span>
#include <string>
#include <vector>

namespace glint::tune {

/// One value per dimension of a SearchSpace, as in SettingInfo::defaultValue.
using Candidate = std::vector<double>;
/// One number per dimension: [0, 1] for settings with a scale, the index of the choice for others.
using Genes = std::vector<double>;

struct Dimension {
    const SettingInfo* info = nullptr;
    double min = 0; ///< of the value; includes the start's
    double max = 0;
    double start = 0;

    bool isWhole() const; ///< a choice or a switch
    int choices() const;  ///< of a choice or a switch
};

/// Settings without effect keep the start's value: candidates that draw the same picture are one candidate.
class SearchSpace {
public:
    /// `start`  the settings that the search starts from
    /// `vary`   keys ("hiz.minLevel") and groups ("hiz") to vary; empty: all that the table can vary
    /// `motion` whether something moves in what is measured: others leave out settings that matter only then
    /// `probes` whether the scenes have probes: without them, choices that need probes are left out
    /// Errors: InvalidArgument names the entry of `vary` that is no key or group, or that no search varies.
    static Result<SearchSpace> create(const Settings& start, std::span<const std::string> vary, bool motion,
                                      bool probes = true);

    size_t size() const { return dimensions_.size(); }
    const Dimension& operator[](size_t i) const { return dimensions_[i]; }
    const Settings& startSettings() const { return start_; }
    Candidate start() const;
    /// True if a value of a dimension is never tried: the scenes lack what it needs, and the start has another.
    bool isLeftOut(size_t dimension, double value) const;

    /// The number of trailing genes that are whole numbers: choices and switches come last.
    size_t wholeGenes() const;
    std::vector<double> lowest() const;
    std::vector<double> highest() const;

    /// Values are rounded to three digits, whole ones to whole numbers.
    Candidate decode(const Genes& genes) const;
    /// The nearest genes; of the start: those that decode to it.
    Genes encode(const Candidate& candidate) const;
    /// The candidate nearest to other settings.
    Candidate nearest(const Settings& settings) const;

    Settings settings(const Candidate& candidate) const;
    /// True if the setting of this dimension has an effect.
    bool acts(size_t dimension, const Candidate& candidate) const;
    /// Gives the start's value to settings without effect and to values that are left out.
    Candidate canonical(const Candidate& candidate) const;
    /// No longer varies these dimensions.
    void drop(const std::vector<size_t>& dimensions);

private:
    Settings start_;
    bool probes_ = true;
    std::vector<Dimension> dimensions_; ///< with a scale first, then choices and switches
};

/// What differs from `start`, as "key=value" in the table's order: equal settings have equal texts.
std::vector<std::string> differences(const Settings& start, const Settings& settings);

/// True if the setting has an effect under these settings: its conditions hold, and so do those of the settings that
/// they name.
bool hasEffect(const SettingInfo& info, const Settings& settings);

} // namespace glint::tune
