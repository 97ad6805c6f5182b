// Where reflection probes should stand and what each should answer for: in free space, near and in sight of the
// reflective surfaces that cameras see. Works on plain points, so that it needs no GPU.
#pragma once

#include "glint/probes.hpp"
#include "render/free_space.hpp"

#include <span>
#include <vector>

namespace glint::render {

/// A patch of a reflective surface that some camera sees.
struct ReflectiveNeed {
    glm::vec3 positionWS = glm::vec3(0);
    glm::vec3 normalWS = glm::vec3(0, 1, 0);
    glm::vec3 reflectedWS = glm::vec3(0, 1, 0); ///< unit: where it looks
    float weight = 0;                           ///< pixels times their reflectance
};

/// The part of the scene in which probes may stand: around most of the needs, within the scene. Empty without needs.
scene::Bounds probeDomain(std::span<const ReflectiveNeed> needs, const scene::Bounds& sceneWS);

/// As many needs as there are cells with any, at most `most`: the heaviest.
std::vector<ReflectiveNeed> gatherNeeds(std::span<const ReflectiveNeed> needs, float cellSize, size_t most);

struct PlacedProbe {
    glm::vec3 positionWS = glm::vec3(0);
    scene::Bounds needsWS;             ///< around the needs that it serves best, which are
    std::vector<ReflectiveNeed> needs; ///< these
    float gain = 0;                    ///< share of all needs that it serves better than those before it
};

/// Greedily: each next probe stands where it serves best what those before it serve badly; ends at `most`, or when one
/// more would better less than a fiftieth of the needs. Empty if no free cell sees a need.
std::vector<PlacedProbe> placeProbes(const FreeSpace& space, std::span<const ReflectiveNeed> needs, size_t most);

/// What a probe sees in a direction: metres, infinite for the sky.
struct SeenDistance {
    glm::vec3 directionWS = glm::vec3(0, 0, -1); ///< unit
    float distance = 0;
    float weight = 0; ///< solid angle times how much the probe's needs look that way
};

/// Weighs solid angles by how many needs look there, through lobes about 35 degrees wide; a tenth is left to all
/// directions alike.
void weighByNeeds(std::span<SeenDistance> seen, std::span<const ReflectiveNeed> needs);

/// The axis-aligned box around `positionWS` on which the probe's picture is least misplaced for surfaces off the
/// capture position: that error is, to first order, the difference of inverse distances (docs/techniques/probes.md).
/// `farthest`: metres at which a side without walls is put.
scene::Bounds fitProxyBox(const glm::vec3& positionWS, std::span<const SeenDistance> seen, float farthest);

} // namespace glint::render
