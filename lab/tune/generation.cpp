#include "lab/tune/generation.hpp"

#include "base/assert.hpp"

#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <algorithm>
#include <cmath>

namespace glint::tune {
namespace {

/// Carries the error of an evaluation through pagmo.
struct EvaluationFailed : std::exception {
    explicit EvaluationFailed(Error failed) : error(std::move(failed)) {}
    const char* what() const noexcept override { return error.message.c_str(); }
    Error error;
};

/// Figures that are not finite say that a candidate was given up: pagmo sorts numbers only.
constexpr double kGivenUp = 1e30;

double sortable(double figure) {
    return std::isfinite(figure) ? figure : kGivenUp;
}

/// The problem as pagmo wants it; pagmo copies it.
struct Problem {
    const SearchSpace* space = nullptr;
    const EvaluateGenes* evaluate = nullptr;

    pagmo::vector_double fitness(const pagmo::vector_double& genes) const {
        const Result<Figures> figures = (*evaluate)(genes);
        if (!figures)
            throw EvaluationFailed(figures.error());
        return {sortable(figures->cost), sortable(figures->error)};
    }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        return {space->lowest(), space->highest()};
    }
    pagmo::vector_double::size_type get_nobj() const { return 2; }
    pagmo::vector_double::size_type get_nix() const { return space->wholeGenes(); }
};

/// Deb et al. 2002, "A Fast and Elitist Multiobjective Genetic Algorithm: NSGA-II". Few individuals over few
/// generations: crossover and mutation spread wider than the paper's 20, and two genes of an individual mutate.
pagmo::algorithm makeAlgorithm(size_t genes, uint32_t seed) {
    constexpr double kCrossover = 0.9, kCrossoverIndex = 10, kMutationIndex = 10, kMutations = 2;
    const double mutation = std::min(1.0, kMutations / static_cast<double>(genes));
    return pagmo::algorithm(pagmo::nsga2(1, kCrossover, kCrossoverIndex, mutation, kMutationIndex, seed));
}

} // namespace

Result<std::vector<Individual>> nextGeneration(const SearchSpace& space, const std::vector<Individual>& population,
                                               uint32_t seed, const EvaluateGenes& evaluate) {
    GLINT_ASSERT(population.size() >= kLeastPopulation && population.size() % kPopulationStep == 0, "{} individuals",
                 population.size());
    try {
        pagmo::population evolving(pagmo::problem(Problem{&space, &evaluate}), 0, seed);
        for (const Individual& individual : population)
            evolving.push_back(individual.genes,
                               {sortable(individual.figures.cost), sortable(individual.figures.error)});
        evolving = makeAlgorithm(space.size(), seed).evolve(evolving);
        std::vector<Individual> result;
        for (size_t i = 0; i < evolving.size(); ++i)
            result.push_back({evolving.get_x()[i], {evolving.get_f()[i][0], evolving.get_f()[i][1]}});
        return result;
    } catch (const EvaluationFailed& failed) {
        return failed.error;
    }
}

} // namespace glint::tune
