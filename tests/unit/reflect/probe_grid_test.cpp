// The grid over probes: no point may miss one whose volume holds it, and no cell may list more than the limits allow.
#include "reflect/probes/probe_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace glint::reflect {
namespace probe_grid_test {

/// As shaders/probes/reflect.comp looks it up.
std::vector<uint32_t> at(const ProbeGrid& grid, const glm::vec3& p) {
    const glm::vec3 cell = (p - grid.originWS) * grid.cellsPerMetre;
    if (glm::any(glm::lessThan(cell, glm::vec3(0))) || glm::any(glm::greaterThanEqual(cell, glm::vec3(grid.size))))
        return {};
    const glm::uvec3 c = glm::min(glm::uvec3(cell), grid.size - 1u);
    const size_t index = (size_t{c.z} * grid.size.y + c.y) * grid.size.x + c.x;
    return {grid.listed.begin() + grid.first[index], grid.listed.begin() + grid.first[index + 1]};
}

std::vector<ProbeBounds> scattered(size_t count, float reach, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-50, 50), size(0.1f, reach);
    std::vector<ProbeBounds> probes;
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 center(place(random), place(random) * 0.1f, place(random));
        const glm::vec3 half(size(random), size(random), size(random));
        probes.push_back({center - half, center + half, 8.0 * half.x * half.y * half.z});
    }
    return probes;
}

TEST(ProbeGrid, noPointMissesAProbe) {
    for (const size_t count : {1, 2, 7, 300, 4096}) {
        const std::vector<ProbeBounds> probes = scattered(count, 6, 1);
        const ProbeGrid grid = ProbeGrid::build(probes);
        std::mt19937 random(2);
        std::uniform_real_distribution<float> unit(0, 1);
        for (int i = 0; i < 2000; ++i) {
            const ProbeBounds& into = probes[static_cast<size_t>(i) % count];
            const glm::vec3 u(unit(random), unit(random), unit(random));
            // Faces and corners of the boxes too.
            const glm::vec3 p = into.min + (into.max - into.min) * (i % 3 == 0 ? glm::round(u) : u);
            const std::vector<uint32_t> listed = at(grid, p);
            for (uint32_t probe = 0; probe < count; ++probe)
                if (glm::all(glm::greaterThanEqual(p, probes[probe].min)) &&
                    glm::all(glm::lessThanEqual(p, probes[probe].max))) {
                    ASSERT_TRUE(std::ranges::find(listed, probe) != listed.end()) << count << " probes";
                }
        }
    }
}

TEST(ProbeGrid, theSmallestComeFirst) {
    const std::vector<ProbeBounds> probes = scattered(300, 10, 3);
    const ProbeGrid grid = ProbeGrid::build(probes);
    for (size_t cell = 0; cell + 1 < grid.first.size(); ++cell)
        for (uint32_t i = grid.first[cell] + 1; i < grid.first[cell + 1]; ++i)
            ASSERT_LE(probes[grid.listed[i - 1]].volume, probes[grid.listed[i]].volume);
}

TEST(ProbeGrid, aPointSeesFewOfMany) {
    const std::vector<ProbeBounds> probes = scattered(4096, 2, 4);
    const ProbeGrid grid = ProbeGrid::build(probes);
    EXPECT_LT(grid.listed.size() / (grid.first.size() - 1), 40u); // of 4096, on average
}

TEST(ProbeGrid, theLimitsHold) {
    for (const auto& [count, reach] : {std::pair<size_t, float>{4096, 200.f}, {4096, 1.f}, {2, 1e8f}, {1, 1e-5f}}) {
        const ProbeGrid grid = ProbeGrid::build(scattered(count, reach, 5));
        EXPECT_LE(grid.first.size(), kMaxProbeCells + 1);
        EXPECT_LE(grid.listed.size(), kMaxProbeListed);
        EXPECT_EQ(grid.first.back(), grid.listed.size());
    }
    const ProbeGrid empty = ProbeGrid::build({});
    EXPECT_TRUE(empty.listed.empty());
    EXPECT_TRUE(at(empty, glm::vec3(0.5f)).empty());
}

} // namespace probe_grid_test
} // namespace glint::reflect
