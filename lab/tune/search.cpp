#include "lab/tune/search.hpp"

#include "base/hash.hpp"
#include "base/text.hpp"
#include "lab/tune/generation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <unordered_map>

namespace glint::tune {
namespace {

/// Candidates dearer than this multiple of the dearest preset belong to no curve.
constexpr double kDearest = 1.25;

/// How far a setting with a scale is moved, as a fraction of it, to see what it does.
constexpr double kProbe = 0.35;

uint32_t seedOf(uint32_t seed, uint32_t generation) {
    return static_cast<uint32_t>(Hash().value(seed).value(generation).result());
}

class Searcher {
public:
    Searcher(const SearchPlan& plan, const SearchHooks& hooks, SearchSpace space)
        : plan_(plan), hooks_(hooks), space_(std::move(space)), random_(seedOf(plan.seed, 0)) {
        outcome_.mostCost = std::numeric_limits<double>::infinity();
    }

    Result<SearchOutcome> run() {
        GLINT_CHECK(tryPresets());
        GLINT_CHECK(probeSettings());
        GLINT_CHECK(climbs());
        GLINT_CHECK(probeBest());
        GLINT_TRY(population, firstPopulation());
        while (outcome_.generations < plan_.generations && (!hooks_.mayGoOn || hooks_.mayGoOn())) {
            const uint32_t generation = outcome_.generations + 1;
            begin(generation, plan_.population);
            GLINT_TRY(next, nextGeneration(space_, population, seedOf(plan_.seed, generation),
                                           [this](const Genes& genes) { return tryGenes(genes); }));
            population = std::move(next);
            outcome_.generations = generation;
        }
        return std::move(outcome_);
    }

private:
    Result<void> tryPresets() {
        begin(0, static_cast<uint32_t>(plan_.presets.size()) + 1 + probeCount());
        GLINT_TRY(start, trySettings(plan_.start));
        double dearest = start.cost;
        for (const NamedSettings& preset : plan_.presets) {
            GLINT_TRY(figures, trySettings(preset.settings));
            dearest = std::max(dearest, figures.cost);
        }
        outcome_.mostCost = std::min(dearest * kDearest, plan_.mostCost);
        return {};
    }

    /// The values to which a setting is moved, alone, from this one.
    std::vector<double> probes(size_t dimension, double from) const {
        const Dimension& d = space_[dimension];
        std::vector<double> values;
        if (d.isWhole()) {
            for (int choice = 0; choice < d.choices(); ++choice)
                if (choice != std::lround(from) && !space_.isLeftOut(dimension, choice))
                    values.push_back(choice);
            return values;
        }
        for (const double moved : {from - kProbe, from + kProbe})
            if (moved > -kProbe / 2 && moved < 1 + kProbe / 2)
                values.push_back(std::clamp(moved, 0.0, 1.0));
        return values;
    }

    uint32_t probeCount() const {
        const Genes start = space_.encode(space_.start());
        size_t count = 0;
        for (size_t i = 0; i < space_.size(); ++i)
            if (space_.acts(i, space_.start()))
                count += probes(i, start[i]).size();
        return static_cast<uint32_t>(count);
    }

    /// Moves each setting alone. Those that change nothing in these scenes are not varied.
    Result<void> probeSettings() {
        const Evaluation start = outcome_.tried.front().evaluation;
        std::vector<size_t> idle;
        for (size_t i = 0; i < space_.size(); ++i) {
            if (!space_.acts(i, space_.start()))
                continue; // it may have an effect elsewhere
            bool changes = false;
            for (const double gene : probes(i, space_.encode(space_.start())[i])) {
                Genes genes = space_.encode(space_.start());
                genes[i] = gene;
                GLINT_CHECK(tryGenes(genes));
                const Evaluation& moved = at(space_.settings(space_.decode(genes)));
                changes |= !same(moved, start);
                moves_.push_back({{{space_[i].info, gene}}, moved.figures});
                if (space_[i].isWhole())
                    GLINT_CHECK(probeWithLess(i, gene, Figures(moved.figures)));
            }
            if (!changes) {
                idle.push_back(i);
                outcome_.withoutEffect.push_back(space_[i].info->key);
            }
        }
        if (idle.size() < space_.size())
            space_.drop(idle);
        return {};
    }

    /// What is better but dear when it is switched on is also tried with less of it: with each setting that has an
    /// effect only then near its cheap end. Rays for mirrors alone cost little, and rays for everything are given up.
    Result<void> probeWithLess(size_t switched, double gene, const Figures& alone) {
        const Figures start = outcome_.tried.front().evaluation.figures;
        const bool isBetter = alone.error < start.error || !std::isfinite(alone.error); // given up: nobody knows
        if (alone.cost <= start.cost || !isBetter)
            return {};
        Genes on = space_.encode(space_.start());
        on[switched] = gene;
        const Candidate with = space_.decode(on);
        const Genes highest = space_.highest();
        for (size_t i = 0; i < space_.size(); ++i) {
            const int dearer = space_[i].info->search.cost;
            if (dearer == 0 || space_.acts(i, space_.start()) || !space_.acts(i, with))
                continue;
            const double cheapest = dearer > 0 ? 0 : highest[i];
            for (const double share : space_[i].isWhole() ? std::vector{0.0} : std::vector{0.3, 0.1, 0.03}) {
                Genes less = on;
                less[i] = cheapest + share * (on[i] - cheapest);
                if (less[i] == on[i])
                    continue;
                ++progress_.toTry;
                // Other settings may pay for it.
                GLINT_TRY(figures, trySettings(space_.settings(space_.decode(less)), 2 * outcome_.mostCost));
                moves_.push_back({{{space_[switched].info, gene}, {space_[i].info, less[i]}}, figures});
            }
        }
        return {};
    }

    /// Settings that were moved together from the start.
    struct Move {
        std::vector<std::pair<const SettingInfo*, double>> genes;
        Figures figures;
    };

    /// The moves that are better in one figure, by its gain for what they lose of the other. What is better in both
    /// comes first, the largest gain before.
    struct Ordered {
        std::vector<Move> free; ///< better in both
        std::vector<Move> dear; ///< better in the one alone
    };
    Ordered ordered(double Figures::*better, double Figures::*worse) const {
        const Figures start = outcome_.tried.front().evaluation.figures;
        const auto gain = [&](const Move& move) { return std::log(start.*better / move.figures.*better); };
        const auto price = [&](const Move& move) { return std::log(move.figures.*worse / start.*worse); };
        Ordered moves;
        for (const Move& move : moves_)
            if (std::isfinite(move.figures.cost) && gain(move) > 0)
                (price(move) <= 0 ? moves.free : moves.dear).push_back(move);
        std::ranges::stable_sort(moves.free, std::greater(), gain);
        std::ranges::stable_sort(moves.dear, {}, [&](const Move& move) { return price(move) / gain(move); });
        return moves;
    }

    /// Takes together what was good alone: what saves most cost for its error, then that and the second best, and so
    /// on; the same for error; and the best of what costs something, paid for by what saves it.
    Result<void> climbs() {
        const Ordered cheaper = ordered(&Figures::cost, &Figures::error);
        const Ordered truer = ordered(&Figures::error, &Figures::cost);
        GLINT_CHECK(climb({cheaper.free, cheaper.dear}));
        GLINT_CHECK(climb({truer.free, truer.dear}));
        if (!truer.dear.empty())
            GLINT_CHECK(climb({{truer.dear.front()}, cheaper.free, cheaper.dear}));
        return {};
    }

    Result<void> climb(const std::vector<std::vector<Move>>& moves) {
        constexpr size_t kLongestClimb = 12;
        Genes genes = space_.encode(space_.start());
        std::vector<const SettingInfo*> moved;
        size_t steps = 0;
        for (const std::vector<Move>& some : moves)
            for (const Move& move : some) {
                const bool again = std::ranges::any_of(
                    move.genes, [&](const auto& gene) { return std::ranges::find(moved, gene.first) != moved.end(); });
                if (again)
                    continue;
                if (steps++ == kLongestClimb)
                    return {};
                for (const auto& [setting, gene] : move.genes) {
                    moved.push_back(setting);
                    for (size_t i = 0; i < space_.size(); ++i)
                        if (space_[i].info == setting)
                            genes[i] = gene;
                }
                GLINT_CHECK(tryGenes(genes));
            }
        return {};
    }

    /// What is best at the start's cost, and what is cheapest at the start's error, may switch on what the start has
    /// not: the settings that have an effect only there are tried there.
    Result<void> probeBest() {
        const Figures start = outcome_.tried.front().evaluation.figures;
        size_t truest = 0, cheapest = 0;
        for (size_t i = 0; i < outcome_.tried.size(); ++i) {
            const Figures& figures = outcome_.tried[i].evaluation.figures;
            if (figures.cost <= start.cost && figures.error < outcome_.tried[truest].evaluation.figures.error)
                truest = i;
            if (figures.error <= start.error && figures.cost < outcome_.tried[cheapest].evaluation.figures.cost)
                cheapest = i;
        }
        GLINT_CHECK(probeFrom(truest));
        return cheapest == truest ? Result<void>() : probeFrom(cheapest);
    }

    /// Moves, one by one, the settings that have an effect with this candidate but not with the start. Those that
    /// lessen cost times error are then taken together, the best first, each as far as it helps.
    Result<void> probeFrom(size_t tried) {
        const auto product = [](const Figures& figures) { return figures.cost * figures.error; };
        double reached = product(outcome_.tried[tried].evaluation.figures);
        const Candidate with = space_.nearest(outcome_.tried[tried].settings);
        Genes genes = space_.encode(with);
        struct Better {
            size_t dimension;
            double gene;
            double product;
        };
        std::vector<Better> better;
        for (size_t i = 0; i < space_.size(); ++i) {
            if (space_.acts(i, space_.start()) || !space_.acts(i, with))
                continue;
            for (const double gene : probes(i, genes[i])) {
                Genes moved = genes;
                moved[i] = gene;
                GLINT_TRY(figures, tryOneMore(moved));
                if (product(figures) < reached)
                    better.push_back({i, gene, product(figures)});
            }
        }
        std::ranges::stable_sort(better, {}, &Better::product);
        const Genes before = genes;
        for (const Better& one : better) {
            const double from = before[one.dimension];
            if (genes[one.dimension] != from)
                continue;                   // another value of it was better
            for (int steps = 1;; ++steps) { // on in that direction while it helps
                const bool whole = space_[one.dimension].isWhole();
                const double gene = whole ? one.gene : std::clamp(from + steps * (one.gene - from), 0.0, 1.0);
                Genes moved = genes;
                moved[one.dimension] = gene;
                GLINT_TRY(figures, tryOneMore(moved));
                if (product(figures) >= reached)
                    break;
                reached = product(figures);
                genes = moved;
                if (whole || gene <= 0 || gene >= 1)
                    break;
            }
        }
        return {};
    }

    Result<Figures> tryOneMore(const Genes& genes) {
        ++progress_.toTry;
        return tryGenes(genes);
    }

    bool same(const Evaluation& a, const Evaluation& b) const {
        if (a.views.size() != b.views.size())
            return false; // one was given up
        for (size_t i = 0; i < a.views.size(); ++i) {
            const Figures& x = a.views[i].figures;
            const Figures& y = b.views[i].figures;
            if (x.error != y.error || std::abs(x.cost - y.cost) > plan_.costNoise * y.cost)
                return false;
        }
        return true;
    }

    /// The best of what was tried so far, and settings between those: each gene from one of two of them, or any value.
    Result<std::vector<Individual>> firstPopulation() {
        std::vector<Genes> parents;
        for (const size_t i : bestTried()) {
            const Genes genes = space_.encode(space_.nearest(outcome_.tried[i].settings));
            if (std::ranges::find(parents, genes) == parents.end())
                parents.push_back(genes);
        }
        // Of the presets all, of the curve as many as there is room for, evenly.
        const size_t room = std::min<size_t>(parents.size(), plan_.population / 2);
        const size_t presets = std::min(room, plan_.presets.size() + 1);
        std::vector<Genes> chosen;
        for (size_t i = 0; i < room; ++i)
            chosen.push_back(
                parents[i < presets ? i : presets + (i - presets) * (parents.size() - presets) / (room - presets)]);
        while (chosen.size() < plan_.population)
            chosen.push_back(between(parents[below(parents.size())], parents[below(parents.size())]));
        std::vector<Individual> population;
        for (const Genes& genes : chosen) {
            GLINT_TRY(figures, tryGenes(genes));
            population.push_back({genes, figures});
        }
        return population;
    }

    /// The start and the presets first, then the curve of what was tried.
    std::vector<size_t> bestTried() const {
        std::vector<size_t> best;
        for (size_t i = 0; i <= plan_.presets.size() && i < outcome_.tried.size(); ++i)
            best.push_back(i);
        std::vector<Figures> figures;
        for (const Tried& tried : outcome_.tried)
            figures.push_back(tried.evaluation.figures);
        for (const size_t i : paretoFront(figures))
            if (std::ranges::find(best, i) == best.end())
                best.push_back(i);
        return best;
    }

    Genes between(const Genes& a, const Genes& b) {
        constexpr double kAnyValue = 0.12;
        Genes genes;
        for (size_t i = 0; i < a.size(); ++i) {
            const double any = space_[i].isWhole() ? std::floor(unit() * space_[i].choices()) : unit();
            const double parent = unit() < 0.5 ? a[i] : b[i];
            genes.push_back(unit() < kAnyValue ? any : parent);
        }
        return genes;
    }

    /// [0, 1); the standard's distributions differ from library to library.
    double unit() { return static_cast<double>(random_()) * 0x1p-32; }
    size_t below(size_t count) { return static_cast<size_t>(unit() * static_cast<double>(count)); }

    Result<Figures> tryGenes(const Genes& genes) { return trySettings(space_.settings(space_.decode(genes))); }

    Result<Figures> trySettings(const Settings& settings) { return trySettings(settings, outcome_.mostCost); }

    Result<Figures> trySettings(const Settings& settings, double mostCost) {
        const std::string key = joinText(differences(plan_.start, settings), "\n");
        if (const auto known = known_.find(key); known != known_.end()) {
            count();
            return outcome_.tried[known->second].evaluation.figures;
        }
        GLINT_TRY(evaluation, hooks_.evaluate(settings, mostCost));
        known_.emplace(key, outcome_.tried.size());
        outcome_.tried.push_back({settings, std::move(evaluation)});
        count();
        return outcome_.tried.back().evaluation.figures;
    }

    const Evaluation& at(const Settings& settings) const {
        return outcome_.tried[known_.at(joinText(differences(plan_.start, settings), "\n"))].evaluation;
    }

    void begin(uint32_t generation, uint32_t toTry) {
        progress_ = {generation, 0, toTry};
        if (hooks_.progress)
            hooks_.progress(progress_);
    }

    void count() {
        progress_.tried = std::min(progress_.tried + 1, progress_.toTry);
        if (hooks_.progress)
            hooks_.progress(progress_);
    }

    const SearchPlan& plan_;
    const SearchHooks& hooks_;
    SearchSpace space_;
    std::vector<Move> moves_;
    std::mt19937 random_;
    SearchOutcome outcome_;
    std::unordered_map<std::string, size_t> known_; ///< by what differs from the start
    SearchProgress progress_;
};

} // namespace

Result<SearchOutcome> searchSettings(const SearchPlan& plan, const SearchHooks& hooks) {
    GLINT_TRY(space, SearchSpace::create(plan.start, plan.vary, plan.motion, plan.probes));
    return Searcher(plan, hooks, std::move(space)).run();
}

} // namespace glint::tune
