// First hits of rays on a posed scene, by Embree: independent of everything that Glint draws and traces, so that both
// can be measured against it (docs/truth.md).
#pragma once

#include "base/result.hpp"
#include "scene/pose.hpp"

#include <glm/glm.hpp>

#include <memory>
#include <optional>

namespace glint::measure {

struct OracleHit {
    double distance = 0; ///< metres along the ray
    int material = -1;   ///< glTF material, -1: the default one
    glm::dvec3 positionWS = glm::dvec3(0);
    glm::dvec3 normalWS = glm::dvec3(0);          ///< interpolated as the raster pass does, unit
    glm::dvec3 geometricNormalWS = glm::dvec3(0); ///< the triangle's own, unit, towards where the ray came from
    bool frontFace = true;
};

/// Triangles of opaque and masked surfaces; blended and light-transmitting ones, lines and points are left out. Back
/// faces of single-sided materials and the holes of masked ones (alpha_test.hpp) are passed through, as the raster pass
/// leaves them out.
class RayOracle {
public:
    /// Refers to `pose` and `scene`, which must outlive it. Errors: Unsupported if Embree has no device.
    static Result<RayOracle> create(const scene::Scene& scene, const scene::Pose& pose);
    ~RayOracle();
    RayOracle(RayOracle&&) noexcept;
    RayOracle& operator=(RayOracle&&) noexcept;

    /// Nearest hit farther than `minDistance` metres; the distance is refined in double precision. Any thread may ask.
    std::optional<OracleHit> trace(const glm::dvec3& originWS, const glm::dvec3& directionWS, double minDistance) const;

private:
    struct State;
    explicit RayOracle(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace glint::measure
