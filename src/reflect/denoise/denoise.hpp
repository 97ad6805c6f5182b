// `denoise`: converts the rays' hits to an answer for every pixel of the frame. It is a list of filters in order, each
// with one input and one output image. Filters that the settings do not enable record no pass.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/denoise_constants.h"

#include <functional>
#include <vector>

namespace glint::reflect {

/// Returns the traced size for an image side of `pixels`: scaled by screen.resolutionScale, at least one pixel.
uint32_t tracedPixels(const Settings& settings, uint32_t pixels);

/// An intermediate answer, RGBA16F or RGBA8: radiance and weight, in the top left `width` x `height` pixels of an
/// image.
struct Signal {
    gpu::Image* image;
    uint32_t width;
    uint32_t height;
    glm::vec2 size() const { return {width, height}; }
};

struct DenoiseInputs {
    TraceInputs trace; ///< inputs that the rays were traced with
    Traced traced;
};

/// One filter of the list.
struct Denoiser {
    std::string_view name;
    /// True if this frame needs the filter. `signal`: the output of the earlier filters.
    std::function<bool(const Settings& settings, const Signal& signal)> needs;
    /// Records the filter's passes and returns their output. In a rehearsal: every pass that it may record.
    std::function<Signal(gpu::Frame& frame, const DenoiseInputs& inputs, Signal signal)> record;
};

/// Settings blur.*.
shared::BlurConstants blurConstants(const Settings& settings);

class Denoise {
public:
    static Result<std::unique_ptr<Denoise>> create(StageContext& stages);

    /// Creates missing images that these settings need. Nothing is released, as frames in flight may still read it.
    /// Errors: OutOfMemory.
    Result<void> make(const Settings& settings);
    /// Adds a filter before the one that upscales the signal to the frame's size.
    void add(Denoiser denoiser);

    void rehearse(gpu::Frame& frame, const DenoiseInputs& inputs);
    /// Returns the answer for every pixel of the frame; if no filter runs, that of the rays (Traced::target).
    gpu::Image& record(gpu::Frame& frame, const DenoiseInputs& inputs);
    /// True if any filter runs on this frame's rays.
    bool filters(const Traced& traced) const;
    /// Uses the traced image as the answer if no ray was traced; its weights are then 0.
    gpu::Image& recordNothing(const Traced& traced) { return *(answer_ = &traced.target); }
    gpu::Image& answer() { return *answer_; }

private:
    explicit Denoise(StageContext& stages) : stages_(stages) {}
    Signal blur(gpu::Frame& frame, const DenoiseInputs& inputs, Signal source);
    Signal upsample(gpu::Frame& frame, const DenoiseInputs& inputs, Signal source);
    void recordBlur(gpu::Frame& frame, const DenoiseInputs& inputs, bool vertical, Signal source, Signal target);

    StageContext& stages_;
    gpu::Pipeline blurPass_;
    gpu::Pipeline upsamplePass_;
    std::vector<Denoiser> denoisers_;
    gpu::Image whole_;      ///< RGBA16F, of the frame's size; absent until settings need it
    gpu::Image blurred_[2]; ///< RGBA16F: blurred along x, then along both axes; absent until settings need it
    gpu::Image* answer_ = nullptr;
};

} // namespace glint::reflect
