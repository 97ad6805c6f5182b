#include "reflect/probes/probe_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glint::reflect {
namespace {

constexpr size_t kCellsAProbe = 64;

struct CellRange {
    glm::uvec3 first;
    glm::uvec3 last; ///< inclusive
};

/// As in the shader, but widened by 1e-3 cells so that rounding on either side loses no cell.
CellRange cellsOf(const ProbeGrid& grid, const ProbeBounds& bounds) {
    const auto place = [&](const glm::vec3& at, float widen) {
        const glm::vec3 cell = (at - grid.originWS) * grid.cellsPerMetre + widen;
        return glm::uvec3(glm::clamp(cell, glm::vec3(0), glm::vec3(grid.size - 1u)));
    };
    return {place(bounds.min, -1e-3f), place(bounds.max, 1e-3f)};
}

template <class Visit>
void forCells(const ProbeGrid& grid, const CellRange& range, Visit visit) {
    for (uint32_t z = range.first.z; z <= range.last.z; ++z)
        for (uint32_t y = range.first.y; y <= range.last.y; ++y)
            for (uint32_t x = range.first.x; x <= range.last.x; ++x)
                visit((size_t{z} * grid.size.y + y) * grid.size.x + x);
}

/// Returns the size of a grid of nearly cubic cells, at most `cells`.
glm::uvec3 gridSize(const glm::vec3& extent, size_t cells) {
    const double volume = std::max(double(extent.x) * extent.y * extent.z, 1e-30);
    const double edge = std::cbrt(volume / static_cast<double>(cells));
    glm::uvec3 size = glm::uvec3(1);
    for (int axis = 0; axis < 3; ++axis)
        size[axis] = static_cast<uint32_t>(std::clamp(std::floor(extent[axis] / edge), 1.0, double(cells)));
    while (size_t{size.x} * size.y * size.z > cells) { // an axis was rounded up to 1
        uint32_t& longest = size.x >= size.y && size.x >= size.z ? size.x : size.y >= size.z ? size.y : size.z;
        longest = std::max(longest / 2, 1u);
    }
    return size;
}

} // namespace

ProbeGrid ProbeGrid::build(std::span<const ProbeBounds> probes) {
    ProbeGrid grid;
    if (probes.empty()) {
        grid.first = {0, 0};
        return grid;
    }
    glm::vec3 low = probes.front().min;
    glm::vec3 high = probes.front().max;
    for (const ProbeBounds& probe : probes) {
        low = glm::min(low, probe.min);
        high = glm::max(high, probe.max);
    }
    const glm::vec3 extent = glm::max(high - low, glm::vec3(1e-6f)) * 1.001f; // the far faces lie inside
    grid.originWS = low - extent * 0.0005f;

    std::vector<uint32_t> order(probes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](uint32_t probe) { return probes[probe].volume; });

    for (size_t cells = std::min<size_t>(kMaxProbeCells, kCellsAProbe * probes.size());; cells /= 2) {
        grid.size = gridSize(extent, std::max<size_t>(cells, 1));
        grid.cellsPerMetre = glm::vec3(grid.size) / extent;
        grid.first.assign(size_t{grid.size.x} * grid.size.y * grid.size.z + 1, 0);
        for (const ProbeBounds& probe : probes)
            forCells(grid, cellsOf(grid, probe), [&](size_t cell) { ++grid.first[cell + 1]; });
        std::partial_sum(grid.first.begin(), grid.first.end(), grid.first.begin());
        if (grid.first.back() <= kMaxProbeListed || grid.first.size() == 2)
            break;
    }
    grid.listed.resize(grid.first.back());
    std::vector<uint32_t> next(grid.first.begin(), grid.first.end() - 1);
    for (const uint32_t probe : order)
        forCells(grid, cellsOf(grid, probes[probe]), [&](size_t cell) { grid.listed[next[cell]++] = probe; });
    return grid;
}

} // namespace glint::reflect
