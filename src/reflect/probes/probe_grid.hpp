// A grid over all influence volumes whose cells list the probes that may influence them, so that a pixel tests only the
// probes of its cell.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace glint::reflect {

/// Axis-aligned bounds of one influence volume.
struct ProbeBounds {
    glm::vec3 min = glm::vec3(0);
    glm::vec3 max = glm::vec3(0);
    double volume = 0; ///< of the influence volume itself, cubic metres
};

constexpr uint32_t kMaxProbeCells = 16384;
constexpr uint32_t kMaxProbeListed = 65536;

struct ProbeGrid {
    glm::vec3 originWS = glm::vec3(0);
    glm::vec3 cellsPerMetre = glm::vec3(1);
    glm::uvec3 size = glm::uvec3(1);
    std::vector<uint32_t> first; ///< a cell's first index in `listed`; one more at the end. At most kMaxProbeCells + 1
    /// Probes of each cell, smallest volume first, ties in their own order. At most kMaxProbeListed.
    std::vector<uint32_t> listed;

    /// `probes`: at most kMaxProbeListed. The grid is as fine as the limits allow, with at most 64 cells per probe.
    static ProbeGrid build(std::span<const ProbeBounds> probes);
};

} // namespace glint::reflect
