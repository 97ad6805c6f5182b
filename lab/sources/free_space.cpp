#include "lab/sources/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::render {

FreeSpace FreeSpace::build(const scene::Pose& pose, const scene::Bounds& bounds, uint32_t cells) {
    FreeSpace space;
    const glm::vec3 extent = glm::max(bounds.max - bounds.min, glm::vec3(1e-6f));
    space.cellSize_ = std::max({extent.x, extent.y, extent.z}) / static_cast<float>(cells);
    space.size_ = glm::max(glm::ivec3(glm::ceil(extent / space.cellSize_ - 1e-3f)), 1);
    space.originWS_ = bounds.min;
    const size_t count = space.index(space.size_ - 1) + 1;
    space.solid_.assign(count, false);
    for (const scene::DrawItem& item : pose.items) {
        const scene::Geometry& g = *item.geometry;
        if (g.topology != scene::Topology::Triangles)
            continue;
        const auto at = [&](size_t i) {
            return glm::vec3(item.localToWorld * glm::vec4(g.positions[g.indices[i]], 1));
        };
        for (size_t i = 0; i + 2 < g.indices.size(); i += 3)
            space.addTriangle(at(i), at(i + 1), at(i + 2));
    }
    space.measureClearance();
    return space;
}

bool FreeSpace::inside(const glm::ivec3& cell) const {
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, size_));
}

/// Marks cells that the triangle's plane intersects within its box: slightly too many at slanted edges, never too few.
void FreeSpace::addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 low = (glm::min(glm::min(a, b), c) - originWS_) / cellSize_;
    const glm::vec3 high = (glm::max(glm::max(a, b), c) - originWS_) / cellSize_;
    if (!glm::all(glm::lessThan(low, glm::vec3(size_))) || !glm::all(glm::greaterThanEqual(high, glm::vec3(0))))
        return; // outside, or NaN
    const glm::ivec3 first(glm::clamp(low, glm::vec3(0), glm::vec3(size_ - 1)));
    const glm::ivec3 last(glm::clamp(high, glm::vec3(0), glm::vec3(size_ - 1)));
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const glm::vec3 size = glm::abs(normal);
    const float reach = (size.x + size.y + size.z) * cellSize_ * 0.5f; // of a cell along the normal
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                if (std::abs(glm::dot(normal, center({x, y, z}) - a)) <= reach)
                    solid_[index({x, y, z})] = true;
}

/// Two sweeps over the grid, each taking the minimum over neighbours already processed: Borgefors 1986, "Distance
/// Transformations in Digital Images", with true lengths to the 26 neighbours. The result is a few per cent too long at
/// most angles.
void FreeSpace::measureClearance() {
    clearance_.assign(solid_.size(), std::numeric_limits<float>::infinity());
    for (size_t i = 0; i < solid_.size(); ++i)
        if (solid_[i])
            clearance_[i] = 0;
    const auto relax = [&](const glm::ivec3& cell, int direction) {
        float& here = clearance_[index(cell)];
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x) {
                    const int order = (z * 3 + y) * 3 + x; // negative: processed earlier
                    const glm::ivec3 neighbour = cell + glm::ivec3(x, y, z);
                    if (order * direction < 0 && inside(neighbour))
                        here = std::min(here, clearance_[index(neighbour)] +
                                                  cellSize_ * std::sqrt(static_cast<float>(x * x + y * y + z * z)));
                }
    };
    for (int z = 0; z < size_.z; ++z)
        for (int y = 0; y < size_.y; ++y)
            for (int x = 0; x < size_.x; ++x)
                relax({x, y, z}, 1);
    for (int z = size_.z; z-- > 0;)
        for (int y = size_.y; y-- > 0;)
            for (int x = size_.x; x-- > 0;)
                relax({x, y, z}, -1);
}

bool FreeSpace::sees(const glm::vec3& fromWS, const glm::vec3& toWS, float margin) const {
    const glm::vec3 way = toWS - fromWS;
    const float length = glm::length(way);
    for (float t = margin; t < length - margin; t += cellSize_ * 0.5f) {
        const glm::ivec3 cell(glm::floor((fromWS + way * (t / length) - originWS_) / cellSize_));
        if (inside(cell) && solid(cell))
            return false;
    }
    return true;
}

} // namespace glint::render
