// `denoise`: from what the rays found to an answer for every pixel of the picture. Blurs by roughness and hit distance,
// then brings the traced image up to the picture's size; where neither is asked for, no pass runs.
#pragma once

#include "glint/settings.hpp"
#include "reflect/stages.hpp"
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

struct DenoisePipelines {
    gpu::Pipeline blur;
    gpu::Pipeline upsample;

    static Result<DenoisePipelines> create(gpu::Context& context);
};

struct DenoiseInputs {
    TraceInputs trace; ///< what the rays were traced with
    Traced& traced;
};

/// The part of the traced images that a picture of this size needs: screen.resolutionScale, at least one pixel.
uint32_t tracedPixels(const Settings& settings, uint32_t pixels);

/// Makes what these settings need and is not there yet; nothing is taken away, as frames in flight may still read it.
/// Errors: OutOfMemory.
Result<void> makeDenoiseImages(gpu::Context& context, const Settings& settings, uint32_t width, uint32_t height,
                               Denoised& images);

void recordDenoise(gpu::Frame& frame, const DenoisePipelines& pipelines, const Settings& settings, DenoiseInputs inputs,
                   Denoised& out);
/// Every pass that any settings may ask for.
void rehearseDenoise(gpu::Frame& frame, const DenoisePipelines& pipelines, const Settings& settings,
                     DenoiseInputs inputs, Denoised& out);

} // namespace glint::reflect
