// The cost of a frame from what the frame counted instead of what a clock showed: the same on every run, for machines
// whose times are noise.
#pragma once

#include "lab/job/render_job.hpp"

#include <array>
#include <string>
#include <vector>

namespace glint::tune {

/// Fraction of the pixels whose reflections the denoiser averages, by perceptual roughness.
class RoughShare {
public:
    void add(float perceptualRoughness, double share);
    /// Adds `part` of the other shares.
    void add(const RoughShare& other, double part);
    double all() const { return upTo(1); }
    /// Of surfaces no rougher than this, to a hundredth.
    double upTo(float perceptualRoughness) const;

private:
    std::array<double, 101> shares_ = {}; ///< by hundredths
};

/// What one frame did. Rays and lookups are counted by the shaders, passes by the recording.
struct FrameWork {
    const Settings* settings = nullptr;
    render::RenderStats stats;
    std::vector<std::string> passes; ///< names of the reflections' passes and of the host's back faces, in order
    double pixels = 0;               ///< of the frame
    RoughShare rough;
    double triangles = 0; ///< of the scene, which the host draws once more for back faces
    double lights = 0;    ///< of the scene: each gets a shadow ray from what rays hit
};

/// Estimates the cost in floors (docs/truth.md): each pass by its pixels, rays, depth lookups and taps, with the costs
/// of cost_table.hpp, which were measured on the software driver. Deterministic; on another device only a rough guess.
double countedFloors(const FrameWork& work);

} // namespace glint::tune
