// The mean of a still view's frames, each drawn with the camera shifted within the pixel: an antialiased image of
// everything that a frame shows, reflections too.
#pragma once

#include "gpu/pass.hpp"
#include "lab/job/render_job.hpp"

#include <glm/glm.hpp>

namespace glint::render {

/// Frames of a still that is antialiased, if its settings take fewer to settle.
constexpr uint32_t kSmoothFrames = 16;

/// True if the job's image is a mean (display.antialias accumulate, or auto for a RenderJob::smoothStill).
bool accumulates(const RenderJob& job);

/// What a frame of an antialiased still does.
struct MeanStep {
    bool adds = false;                 ///< it is drawn and added to the mean
    bool restarts = false;             ///< the mean begins with it
    glm::vec2 jitterPX = glm::vec2(0); ///< pixels, [-0.5, 0.5): of the camera
};

/// Returns what frame `frame` of `frames` does. With a history, whose first frames are noisier than the later ones, the
/// last kSmoothFrames frames are averaged; without one, all frames. The camera's shifts are Halton's points in bases 2
/// and 3 (Halton 1960). The first frame of the mean, which a viewer in motion shows alone, has none, nor has the last
/// one: its other images are those of the camera itself.
MeanStep meanStep(const RenderJob& job, uint32_t frame, uint32_t frames);

/// How many frames are added to a mean after a picture has settled in `frames` (RenderJob::settle): as many again, from
/// 4 to kSmoothFrames.
uint32_t smoothFramesAfter(uint32_t frames);

class FrameMean {
public:
    void clear() { frames_ = 0; }
    uint32_t frames() const { return frames_; } ///< 0: there is no mean
    /// Creates what `add` needs for frames of this size, at the first call also its passes; a new size clears the mean.
    /// Errors: OutOfMemory.
    Result<void> prepare(gpu::Context& context, uint32_t width, uint32_t height);
    /// `opacity`    its alpha is the frame's
    /// `displayed`  the frame as displayed, RGBA8 in sRGB
    void add(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& opacity, gpu::Image& displayed);
    gpu::Image& radiance() { return radiance_; } ///< RGBA32F; a: opacity
    /// `target`: RGBA8_UNORM with STORAGE usage; receives sRGB-encoded colours and alpha 1.
    void display(gpu::Frame& frame, gpu::Image& target);

private:
    gpu::Pipeline add_;
    gpu::Pipeline encode_;
    gpu::Image radiance_;
    gpu::Image displayed_; ///< RGBA32F, linear
    uint32_t frames_ = 0;
};

} // namespace glint::render
