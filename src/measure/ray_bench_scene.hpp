// A scene by code for timing rays, with as many triangles as one likes: a terrain, and a heap of dented balls on it.
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
    static constexpr uint32_t kBalls = 24;       ///< instances of them; one more is the terrain
    static constexpr uint32_t kDeformedMesh = 1; ///< the first ball mesh

    /// About `triangles` of them in its meshes: half in the terrain, an eighth in each ball mesh. At least 100.
    explicit RayBenchScene(uint64_t triangles);

    uint64_t triangles() const; ///< of the meshes: what is built
    uint64_t placed() const;    ///< of the instances: what rays see
    uint64_t deformedTriangles() const { return meshes_[kDeformedMesh].indices.size() / 3; }

    std::vector<RayMesh> meshes() const; ///< views of what the scene owns
    /// With the balls moved and turned by `phase`, a number of any size; 0: where they are at first.
    std::vector<RayInstance> instances(float phase) const;
    /// Vertices of kDeformedMesh with its dents moved by `phase`; 0: as in meshes().
    std::vector<glm::vec3> deformed(float phase) const;

    /// Vertices of a triangle in the world, as the scene is at first.
    std::array<glm::vec3, 3> triangleWS(uint32_t instance, uint32_t primitive) const;

private:
    struct Mesh {
        std::vector<glm::vec3> positions;
        std::vector<uint32_t> indices;
    };

    static glm::mat4 localToWorld(uint32_t instance, float phase);
    glm::vec3 ballVertex(uint32_t mesh, uint32_t column, uint32_t row, float phase) const;
    static uint32_t meshOf(uint32_t instance);

    uint32_t ballRows_ = 0; ///< twice as many columns
    std::vector<Mesh> meshes_;
};

} // namespace glint::measure
