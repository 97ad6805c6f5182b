// Chooses positions and volumes of reflection probes: in free space, near and in sight of the reflective surfaces that
// cameras see. Works on points and needs no GPU.
#pragma once

#include "glint/probes.hpp"
#include "lab/sources/free_space.hpp"

#include <span>
#include <vector>

namespace glint::render {

/// A patch of a reflective surface that a camera sees.
struct ReflectiveNeed {
    glm::vec3 positionWS = glm::vec3(0);
    glm::vec3 normalWS = glm::vec3(0, 1, 0);
    glm::vec3 reflectedWS = glm::vec3(0, 1, 0); ///< unit: the reflected direction
    float weight = 0;                           ///< pixels times reflectance
};

/// Returns the part of the scene in which probes may be placed: around most of the needs, within the scene. Empty
/// without needs.
scene::Bounds probeDomain(std::span<const ReflectiveNeed> needs, const scene::Bounds& sceneWS);

/// Merges needs to one per occupied grid cell; returns at most `most`, those with the largest weight.
std::vector<ReflectiveNeed> gatherNeeds(std::span<const ReflectiveNeed> needs, float cellSize, size_t most);

struct PlacedProbe {
    glm::vec3 positionWS = glm::vec3(0);
    scene::Bounds needsWS;             ///< bounds of `needs`
    std::vector<ReflectiveNeed> needs; ///< the needs for which this probe is the best
    float gain = 0;                    ///< fraction of all needs that this probe serves better than the earlier probes
};

/// Places probes greedily: each next probe is placed where it best serves the needs that earlier probes serve badly.
/// Stops at `most` probes, or when another probe would improve less than a fiftieth of the needs. Empty if no free cell
/// sees a need.
std::vector<PlacedProbe> placeProbes(const FreeSpace& space, std::span<const ReflectiveNeed> needs, size_t most);

/// What a probe sees in one direction: the distance in metres, infinite for the sky.
struct SeenDistance {
    glm::vec3 directionWS = glm::vec3(0, 0, -1); ///< unit
    float distance = 0;
    float weight = 0; ///< solid angle times the weight of the probe's needs that reflect in this direction
};

/// Weights solid angles by the needs that reflect towards them, with lobes about 35 degrees wide; a tenth of the weight
/// is uniform over all directions.
void weighByNeeds(std::span<SeenDistance> seen, std::span<const ReflectiveNeed> needs);

/// Returns the axis-aligned box around `positionWS` that minimizes parallax errors for surfaces away from the capture
/// position. To first order, that error is the difference of inverse distances (docs/techniques/probes.md). `farthest`:
/// metres, distance of a side without walls.
scene::Bounds fitProxyBox(const glm::vec3& positionWS, std::span<const SeenDistance> seen, float farthest);

} // namespace glint::render
