// One step of the evolution: the optimiser's part of a search, by pagmo's NSGA-II.
#pragma once

#include "base/result.hpp"
#include "lab/tune/pareto.hpp"
#include "lab/tune/search_space.hpp"

#include <cstdint>
#include <functional>

namespace glint::tune {

struct Individual {
    Genes genes;
    Figures figures;
};

/// What a population must count: NSGA-II pairs individuals four by four.
constexpr size_t kLeastPopulation = 8;
constexpr size_t kPopulationStep = 4;

using EvaluateGenes = std::function<Result<Figures>(const Genes&)>;

/// Evolves `population` by one generation: as many offspring are evaluated, and the best of both remain. The result
/// depends on the arguments alone, so a search can be continued from a stored population.
/// `seed`  another one for every generation
/// Errors: those of `evaluate`.
Result<std::vector<Individual>> nextGeneration(const SearchSpace& space, const std::vector<Individual>& population,
                                               uint32_t seed, const EvaluateGenes& evaluate);

} // namespace glint::tune
