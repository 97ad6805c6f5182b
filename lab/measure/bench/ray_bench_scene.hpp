// A procedural scene with any number of triangles, for timing rays: a terrain, and a heap of dented balls on it.
#pragma once

#include "glint/ray_scene.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace glint::measure {

class RayBenchScene {
public:
    static constexpr uint32_t kBallMeshes = 4;
    static constexpr uint32_t kBalls = 24;       ///< ball instances; the terrain is one more instance
    static constexpr uint32_t kDeformedMesh = 1; ///< the first ball mesh

    /// The meshes have about `triangles` triangles: half in the terrain, an eighth in each ball mesh. `triangles` must
    /// be at least 100.
    explicit RayBenchScene(uint64_t triangles);

    uint64_t triangles() const; ///< of the meshes, as built
    uint64_t placed() const;    ///< of the instances, as seen by rays
    uint64_t deformedTriangles() const { return meshes_[kDeformedMesh].indices.size() / 3; }

    std::vector<RayMesh> meshes() const; ///< refer to data owned by the scene
    /// Returns the instances with the balls moved and rotated by `phase`, any number; 0: initial positions.
    std::vector<RayInstance> instances(float phase) const;
    /// Returns the vertices of kDeformedMesh with its dents moved by `phase`; 0: as in meshes().
    std::vector<glm::vec3> deformed(float phase) const;

    /// Returns the world-space vertices of a triangle in the initial scene.
    std::array<glm::vec3, 3> triangleWS(uint32_t instance, uint32_t primitive) const;

private:
    struct Mesh {
        std::vector<glm::vec3> positions;
        std::vector<uint32_t> indices;
    };

    static glm::mat4 localToWorld(uint32_t instance, float phase);
    glm::vec3 ballVertex(uint32_t mesh, uint32_t column, uint32_t row, float phase) const;
    static uint32_t meshOf(uint32_t instance);

    uint32_t ballRows_ = 0; ///< columns are twice as many
    std::vector<Mesh> meshes_;
};

} // namespace glint::measure
