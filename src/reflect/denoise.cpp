#include "reflect/denoise.hpp"

#include "shared/denoise_constants.h"

#include <algorithm>
#include <cmath>

namespace glint::reflect {
namespace {

bool blurs(const Settings& settings) {
    return settings.blur.strength > 0;
}

/// Pixels of the blurred images: of the traced ones, fewer with blur.downsample.
uint32_t blurredPixels(const Settings& settings, uint32_t traced) {
    const auto divisor = static_cast<uint32_t>(settings.blur.downsample) + 1;
    return (traced + divisor - 1) / divisor;
}

uint32_t maxTaps(const Settings& settings) {
    constexpr uint32_t kTaps[] = {9, 21, 41}; // the middle one is Babylon.js' own
    return kTaps[std::clamp(settings.blur.quality, 1, 3) - 1];
}

/// The part of an image that a pass reads or writes.
struct Grid {
    gpu::Image& image;
    uint32_t width;
    uint32_t height;
    glm::vec2 size() const { return {width, height}; }
};

void recordBlur(gpu::Frame& frame, const DenoisePipelines& pipelines, const Settings& settings, DenoiseInputs inputs,
                bool vertical, Grid source, Grid target) {
    const shared::BlurConstants constants = {source.size(),     target.size(),          vertical,
                                             maxTaps(settings), settings.blur.strength, settings.rough.factor};
    frame.pass(pipelines.blur)
        .read("frame", inputs.trace.frameConstants)
        .read("viewZ", inputs.trace.prepared.viewZ)
        .read("surface", inputs.trace.prepared.surface)
        .read("rayRecord", inputs.traced.rayRecord)
        .read("source", source.image)
        .write("blurred", target.image)
        .push(constants)
        .dispatch(target.width, target.height);
}

void recordUpsample(gpu::Frame& frame, const DenoisePipelines& pipelines, const Settings& settings,
                    DenoiseInputs inputs, Grid source, gpu::Image& target) {
    const shared::TraceConstants trace = traceConstants(settings, inputs.trace.backFacesKnown);
    const shared::UpsampleConstants constants = {source.size(),
                                                 trace.threshold,
                                                 trace.roughnessFadeStart,
                                                 trace.maxRoughness,
                                                 trace.roughnessFactor <= 0,
                                                 settings.blur.strength,
                                                 settings.rough.factor};
    gpu::Pass pass = frame.pass(pipelines.upsample);
    readHitColor(pass, inputs.trace);
    pass.read("frame", inputs.trace.frameConstants)
        .read("viewZ", inputs.trace.prepared.viewZ)
        .read("surface", inputs.trace.prepared.surface)
        .read("rayRecord", inputs.traced.rayRecord)
        .read("traced", inputs.traced.target())
        .read("source", source.image)
        .write("radianceWeight", target)
        .push(constants)
        .dispatch(target.width(), target.height());
}

} // namespace

// ---------------------------------------------------------------- the stage, top to bottom

void recordDenoise(gpu::Frame& frame, const DenoisePipelines& pipelines, const Settings& settings, DenoiseInputs inputs,
                   Denoised& out) {
    Traced& traced = inputs.traced;
    const uint32_t width = inputs.trace.prepared.viewZ.width();
    const uint32_t height = inputs.trace.prepared.viewZ.height();
    Grid source = {traced.target(), traced.width, traced.height};
    out.answer = &traced.target();
    if (blurs(settings)) {
        const uint32_t w = blurredPixels(settings, traced.width);
        const uint32_t h = blurredPixels(settings, traced.height);
        const bool whole = w == width && h == height; // then the second pass writes the answer itself
        gpu::Image& last = whole ? out.radianceWeight : out.blurred[1];
        recordBlur(frame, pipelines, settings, inputs, false, source, {out.blurred[0], w, h});
        recordBlur(frame, pipelines, settings, inputs, true, {out.blurred[0], w, h}, {last, w, h});
        out.answer = &out.radianceWeight;
        if (!whole)
            recordUpsample(frame, pipelines, settings, inputs, {last, w, h}, out.radianceWeight);
    } else if (traced.width < width || traced.height < height) {
        recordUpsample(frame, pipelines, settings, inputs, source, out.radianceWeight);
        out.answer = &out.radianceWeight;
    }
}

void rehearseDenoise(gpu::Frame& frame, const DenoisePipelines& pipelines, const Settings& settings,
                     DenoiseInputs inputs, Denoised& out) {
    recordBlur(frame, pipelines, settings, inputs, false, {inputs.traced.target(), 1, 1}, {out.blurred[0], 1, 1});
    recordUpsample(frame, pipelines, settings, inputs, {out.blurred[0], 1, 1}, out.radianceWeight);
    out.answer = &inputs.traced.target();
}

// ---------------------------------------------------------------- creation

uint32_t tracedPixels(const Settings& settings, uint32_t pixels) {
    // A hair less before rounding up: 0.1f is a little above a tenth.
    const double wanted = pixels * static_cast<double>(settings.screen.resolutionScale) - 1e-3;
    return static_cast<uint32_t>(std::clamp(std::ceil(wanted), 1.0, static_cast<double>(pixels)));
}

Result<DenoisePipelines> DenoisePipelines::create(gpu::Context& context) {
    GLINT_TRY(blur, gpu::Pipeline::compute(context, {"denoise/blur", sizeof(shared::BlurConstants), {}}));
    GLINT_TRY(upsample, gpu::Pipeline::compute(context, {"denoise/upsample", sizeof(shared::UpsampleConstants), {}}));
    return DenoisePipelines{std::move(blur), std::move(upsample)};
}

Result<void> makeDenoiseImages(gpu::Context& context, const Settings& settings, uint32_t width, uint32_t height,
                               Denoised& images) {
    const auto make = [&](gpu::Image& image, const char* name) -> Result<void> {
        if (image)
            return {};
        GLINT_TRY(made, gpu::Image::create(context, {name, VK_FORMAT_R16G16B16A16_SFLOAT, width, height, 1, 1,
                                                     gpu::ImageShape::Flat,
                                                     VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
        image = std::move(made);
        return {};
    };
    const bool smaller = tracedPixels(settings, width) < width || tracedPixels(settings, height) < height;
    if (smaller || blurs(settings))
        GLINT_CHECK(make(images.radianceWeight, "glint/denoised"));
    if (!blurs(settings))
        return {};
    GLINT_CHECK(make(images.blurred[0], "glint/blurredX"));
    if (smaller || settings.blur.downsample > 0)
        GLINT_CHECK(make(images.blurred[1], "glint/blurred"));
    return {};
}

} // namespace glint::reflect
