// The cost of a frame from what the frame counted instead of what a clock showed: the same on every run, for machines
// whose times are noise.
#pragma once

#include "render/render_job.hpp"

#include <string>
#include <vector>

namespace glint::tune {

/// What one frame did. Rays and lookups are counted by the shaders, passes by the recording.
struct FrameWork {
    const Settings* settings = nullptr;
    render::RenderStats stats;
    std::vector<std::string> passes; ///< names of the reflections' passes and of the host's back faces, in order
    double pixels = 0;               ///< of the frame
    double rough = 0;                ///< fraction of the pixels whose reflections the denoiser averages
    double triangles = 0;            ///< of the scene, which the host draws once more for back faces
};

/// Estimates the cost in floors (docs/truth.md): each pass by its pixels, rays, depth lookups and taps, with unit costs
/// that were measured on the software driver. Deterministic; on another device only a rough guess.
double countedFloors(const FrameWork& work);

} // namespace glint::tune
