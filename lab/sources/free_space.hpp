// The free space of a scene: a grid over a part of the scene with solid and free cells, and the distance of each cell
// to the nearest solid cell.
#pragma once

#include "lab/scene/pose.hpp"

#include <vector>

namespace glint::render {

class FreeSpace {
public:
    /// `cells`: number of cells along the longest side of `bounds`, which must not be empty. Only triangles are solid.
    /// Cost: proportional to the cells that triangles cover.
    static FreeSpace build(const scene::Pose& pose, const scene::Bounds& bounds, uint32_t cells);

    const glm::ivec3& size() const { return size_; }
    float cellSize() const { return cellSize_; } ///< metres
    glm::vec3 center(const glm::ivec3& cell) const { return originWS_ + (glm::vec3(cell) + 0.5f) * cellSize_; }
    bool inside(const glm::ivec3& cell) const;
    bool solid(const glm::ivec3& cell) const { return solid_[index(cell)]; }
    /// Approximate distance in metres to the centre of the nearest solid cell; infinite in an empty grid.
    float clearance(const glm::ivec3& cell) const { return clearance_[index(cell)]; }
    /// True if no solid cell lies between the two points, except within `margin` metres of each end.
    bool sees(const glm::vec3& fromWS, const glm::vec3& toWS, float margin) const;

private:
    size_t index(const glm::ivec3& cell) const {
        return (static_cast<size_t>(cell.z) * static_cast<size_t>(size_.y) + static_cast<size_t>(cell.y)) *
                   static_cast<size_t>(size_.x) +
               static_cast<size_t>(cell.x);
    }
    void addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
    void measureClearance();

    glm::vec3 originWS_ = glm::vec3(0);
    float cellSize_ = 1;
    glm::ivec3 size_ = glm::ivec3(1);
    std::vector<bool> solid_;
    std::vector<float> clearance_;
};

} // namespace glint::render
