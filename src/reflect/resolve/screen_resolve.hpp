// `resolve`: the screen's answer for every pixel of the frame, from rays that fewer pixels may have traced: a blur by
// roughness, then upsampling to the frame's size. Passes that the settings do not need are not recorded.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/resolve_constants.h"

namespace glint::reflect {

struct ResolveInputs {
    TraceInputs trace; ///< inputs that the rays were traced with
    Traced traced;
};

/// Settings blur.*.
shared::BlurConstants blurConstants(const Settings& settings);

class ScreenResolve {
public:
    static Result<std::unique_ptr<ScreenResolve>> create(StageContext& stages);

    /// Creates missing images that the plan needs. Nothing is released, as frames in flight may still read it.
    /// Errors: OutOfMemory.
    Result<void> make();

    /// Records both passes, whatever the settings.
    void rehearse(gpu::Frame& frame, const ResolveInputs& inputs);
    /// Returns the answer for every pixel of the frame; if no pass runs, that of the rays (Traced::target).
    gpu::Image& record(gpu::Frame& frame, const ResolveInputs& inputs);
    /// Uses the traced image as the answer if no ray was traced; its weights are then 0.
    gpu::Image& recordNothing(const Traced& traced) { return *(answer_ = &traced.target); }
    gpu::Image& answer() { return *answer_; }

private:
    /// An intermediate answer, RGBA16F or RGBA8: radiance and weight, in the top left `width` x `height` pixels of an
    /// image.
    struct Signal {
        gpu::Image* image;
        uint32_t width;
        uint32_t height;
        glm::vec2 size() const { return {width, height}; }
    };

    explicit ScreenResolve(StageContext& stages) : stages_(stages) {}
    Signal blur(gpu::Frame& frame, const ResolveInputs& inputs, Signal source);
    Signal upsample(gpu::Frame& frame, const ResolveInputs& inputs, Signal source);
    void recordBlur(gpu::Frame& frame, const ResolveInputs& inputs, bool vertical, Signal source, Signal target);

    StageContext& stages_;
    gpu::Pipeline blurPass_;
    gpu::Pipeline upsamplePass_;
    gpu::Image whole_;      ///< RGBA16F, of the frame's size; absent until settings need it
    gpu::Image blurred_[2]; ///< RGBA16F: blurred along x, then along both axes; absent until settings need it
    gpu::Image* answer_ = nullptr;
};

} // namespace glint::reflect
