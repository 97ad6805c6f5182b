// The search for good settings: what is tried, generation by generation. It knows no pictures: whoever calls it says
// what settings cost and how wrong they are.
#pragma once

#include "lab/tune/evaluator.hpp"
#include "lab/tune/search_space.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace glint::tune {

struct NamedSettings {
    std::string name;
    Settings settings;
};

struct SearchPlan {
    Settings start;
    std::vector<NamedSettings> presets; ///< tried too, as they are; the search also starts from them
    std::vector<std::string> vary;      ///< as SearchSpace::create
    bool motion = false;                ///< as SearchSpace::create
    bool probes = true;                 ///< as SearchSpace::create
    uint32_t population = 24;           ///< at least kLeastPopulation, a multiple of kPopulationStep
    uint32_t generations = 20;
    uint32_t seed = 0;
    /// Candidates that cost more are given up; presets are not. Infinite: those that cost more than every preset.
    double mostCost = std::numeric_limits<double>::infinity();
    double costNoise = 0; ///< costs that differ by a smaller fraction count as equal when effects are looked for
};

struct SearchProgress {
    uint32_t generation = 0; ///< 0: before the first
    uint32_t tried = 0;      ///< in this generation
    uint32_t toTry = 0;
};

struct SearchHooks {
    /// A candidate that costs more than `mostCost` may be given up: infinite figures. An error ends the search.
    std::function<Result<Evaluation>(const Settings& settings, double mostCost)> evaluate;
    /// Asked between generations; may be empty: then all are made.
    std::function<bool()> mayGoOn;
    std::function<void(const SearchProgress&)> progress; ///< may be empty
};

struct Tried {
    Settings settings;
    Evaluation evaluation;
};

struct SearchOutcome {
    std::vector<Tried> tried;               ///< all different ones, the start first, then the presets
    uint32_t generations = 0;               ///< made
    double mostCost = 0;                    ///< beyond which candidates were given up
    std::vector<std::string> withoutEffect; ///< keys that changed nothing in these scenes
};

/// The same plan and the same evaluations give the same outcome; a search with more generations begins like one with
/// fewer. Errors: those of the hooks and of SearchSpace::create.
Result<SearchOutcome> searchSettings(const SearchPlan& plan, const SearchHooks& hooks);

} // namespace glint::tune
