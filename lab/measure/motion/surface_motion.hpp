// Where the surface of each pixel was one frame earlier, by exact rays: the measure's own motion vectors and
// disocclusions, independent of the renderer's and of what a denoiser takes for them.
#pragma once

#include "lab/measure/truth/ray_oracle.hpp"
#include "lab/renderer/view.hpp"

#include <vector>

namespace glint::measure {

enum class SurfaceOrigin : uint8_t {
    Seen,    ///< the earlier frame shows it too
    Hidden,  ///< the earlier frame shows something else there: disoccluded
    Outside, ///< it was outside the earlier frame
    None,    ///< no surface, or between two others in the earlier frame
};

struct PixelOrigin {
    uint32_t pixel = 0; ///< Seen: the earlier frame's pixel of that surface; Hidden: the pixel in its place
    SurfaceOrigin origin = SurfaceOrigin::None;
};

/// One for each pixel; empty: nothing has moved.
using SurfaceMotion = std::vector<PixelOrigin>;

/// Follows a scene from frame to frame.
class SurfaceTracker {
public:
    /// Refers to `scene`, which must outlive it.
    explicit SurfaceTracker(const scene::Scene& scene) : scene_(&scene) {}

    /// Returns the motion since the last call; empty for the first one. Errors: those of scene::pose and RayOracle.
    Result<SurfaceMotion> advance(double seconds, const render::View& view);

private:
    /// What one frame shows.
    struct Moment {
        double seconds = 0;
        render::View view;
        scene::Pose pose;
        std::unique_ptr<RayOracle> oracle;
        std::vector<int> items; ///< index in the pose's items that each pixel shows; -1: none
        std::vector<OracleHit> hits;
    };
    Result<std::unique_ptr<Moment>> look(double seconds, const render::View& view) const;
    PixelOrigin originOf(const OracleHit& hit, int item) const;

    const scene::Scene* scene_;
    std::unique_ptr<Moment> prev_;
};

} // namespace glint::measure
