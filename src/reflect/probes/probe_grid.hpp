// Which probes may influence a point: a grid over all influence volumes whose cells list the probes that reach into
// them, so that a pixel looks at those of its cell and no others.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace glint::reflect {

/// Axis-aligned, around one influence volume.
struct ProbeBounds {
    glm::vec3 min = glm::vec3(0);
    glm::vec3 max = glm::vec3(0);
    double volume = 0; ///< of the influence itself, cubic metres
};

constexpr uint32_t kMaxProbeCells = 16384;
constexpr uint32_t kMaxProbeListed = 65536;

struct ProbeGrid {
    glm::vec3 originWS = glm::vec3(0);
    glm::vec3 cellsPerMetre = glm::vec3(1);
    glm::uvec3 size = glm::uvec3(1);
    std::vector<uint32_t> first;  ///< a cell's first place in `listed`; one more at the end. At most kMaxProbeCells + 1
    std::vector<uint32_t> listed; ///< probes, smallest volume first, else in their own order. At most kMaxProbeListed

    /// `probes`: at most kMaxProbeListed. As fine as the limits allow, and no finer than 64 cells a probe.
    static ProbeGrid build(std::span<const ProbeBounds> probes);
};

} // namespace glint::reflect
