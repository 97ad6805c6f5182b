// A guard against slowing down: compares a benchmark's figures with those of an earlier one, in units that other
// machines share: floors and lookups, not milliseconds.
#pragma once

#include "lab/measure/bench/bench.hpp"

namespace glint::measure {

/// One configuration at one point.
struct BenchFigure {
    std::string scene;
    glm::uvec2 size = {};       ///< pixels
    std::optional<float> share; ///< as in SeriesPlan
    std::string config;
    double floors = 0;
    double lookups = 0; ///< a traced ray
};

struct BenchBase {
    std::string device;
    uint32_t warmUp = 0;
    uint32_t frames = 0;
    std::vector<BenchFigure> figures;
};

/// How much larger than the base's a figure may be, as a fraction.
struct BenchTolerance {
    double floors = 0.5;
    double lookups = 0.01; ///< a driver's rounding may take a ray one cell farther
};

struct CheckedFigure {
    BenchFigure base;
    BenchFigure now;
    bool slower = false; ///< floors; false on another device than the base's
    bool moreLookups = false;
    bool good() const { return !slower && !moreLookups; }
};

std::vector<BenchFigure> figuresOf(const BenchResult& result);

/// Keeps the smaller floors of two measurements of the same figures: a machine's other work only ever adds time.
void keepFaster(std::vector<BenchFigure>& best, const std::vector<BenchFigure>& again);

/// Errors: NotFound for a figure of the base that was not measured.
Result<std::vector<CheckedFigure>> checkFigures(const BenchBase& base, const std::vector<BenchFigure>& now,
                                                std::string_view device, const BenchTolerance& tolerance);

} // namespace glint::measure
