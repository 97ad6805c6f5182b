// Where a scene is empty: a grid of cells over a part of it, each solid or not, and how far from the next solid one.
#pragma once

#include "scene/pose.hpp"

#include <vector>

namespace glint::render {

class FreeSpace {
public:
    /// `cells`: along the longest side of `bounds`, which is not empty. Triangles alone are solid. Time grows with the
    /// cells that triangles cover.
    static FreeSpace build(const scene::Pose& pose, const scene::Bounds& bounds, uint32_t cells);

    const glm::ivec3& size() const { return size_; }
    float cellSize() const { return cellSize_; } ///< metres
    glm::vec3 center(const glm::ivec3& cell) const { return originWS_ + (glm::vec3(cell) + 0.5f) * cellSize_; }
    bool inside(const glm::ivec3& cell) const;
    bool solid(const glm::ivec3& cell) const { return solid_[index(cell)]; }
    /// Metres to the nearest solid cell's middle, roughly; infinite in an empty grid.
    float clearance(const glm::ivec3& cell) const { return clearance_[index(cell)]; }
    /// No solid cell lies between the two points, each end left out by `margin` metres.
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
