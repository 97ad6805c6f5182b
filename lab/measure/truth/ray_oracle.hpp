// Traces first hits of rays on a posed scene with Embree. Independent of all that Glint draws and traces, so that both
// can be measured against it (docs/truth.md).
#pragma once

#include "base/result.hpp"
#include "lab/scene/pose.hpp"

#include <glm/glm.hpp>

#include <memory>
#include <optional>

namespace glint::measure {

struct OracleHit {
    double distance = 0; ///< metres along the ray
    int material = -1;   ///< glTF material index, -1: the default material
    glm::dvec3 positionWS = glm::dvec3(0);
    glm::dvec3 normalWS = glm::dvec3(0);          ///< interpolated as the raster pass does, unit
    glm::dvec3 geometricNormalWS = glm::dvec3(0); ///< normal of the triangle, unit, towards the ray origin
    bool frontFace = true;
    size_t item = 0;                        ///< index in Pose::items
    size_t firstIndex = 0;                  ///< of the triangle, in the item's indices
    glm::dvec2 barycentric = glm::dvec2(0); ///< weights of the triangle's second and third corner
};

/// Contains triangles of opaque and masked surfaces; blended and transmissive surfaces, lines and points are left out.
/// Rays pass through back faces of single-sided materials and the holes of masked ones (alpha_cutout.hpp), which the
/// raster pass does not draw either.
class RayOracle {
public:
    /// Refers to `pose` and `scene`, which must outlive the oracle. Errors: Unsupported if Embree has no device.
    static Result<RayOracle> create(const scene::Scene& scene, const scene::Pose& pose);
    ~RayOracle();
    RayOracle(RayOracle&&) noexcept;
    RayOracle& operator=(RayOracle&&) noexcept;

    /// Returns the nearest hit farther than `minDistance` metres; its distance is refined in double precision.
    /// Thread-safe.
    std::optional<OracleHit> trace(const glm::dvec3& originWS, const glm::dvec3& directionWS, double minDistance) const;

private:
    struct State;
    explicit RayOracle(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace glint::measure
