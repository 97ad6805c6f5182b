#include "lab/session/frame_mean.hpp"

#include "lab/session/settled_frames.hpp"
#include "shared/display.h"

#include <algorithm>

namespace glint::render {
namespace {

float radicalInverse(uint32_t index, uint32_t base) {
    float result = 0, digit = 1;
    for (; index > 0; index /= base) {
        digit /= static_cast<float>(base);
        result += digit * static_cast<float>(index % base);
    }
    return result;
}

} // namespace

bool accumulates(const RenderJob& job) {
    const Antialias kind = job.settings.render.display.antialias;
    return kind == Antialias::Accumulate ||
           (kind == Antialias::Auto && job.smoothStill && !job.settings.reflections.rays.accumulate);
}

MeanStep meanStep(const RenderJob& job, uint32_t frame, uint32_t frames) {
    const bool hasHistory = settledFrames(job.settings.reflections) > 1;
    const uint32_t first = hasHistory ? frames - std::min(frames, kSmoothFrames) : 0;
    MeanStep step;
    if (frame < first)
        return step;
    step.adds = true;
    step.restarts = frame == first;
    if (frame > first && frame + 1 < frames)
        step.jitterPX = glm::vec2(radicalInverse(frame - first, 2), radicalInverse(frame - first, 3)) - 0.5f;
    return step;
}

uint32_t smoothFramesAfter(uint32_t frames) {
    return std::clamp(frames, 4u, kSmoothFrames);
}

Result<void> FrameMean::prepare(gpu::Context& context, uint32_t width, uint32_t height) {
    if (radiance_ && radiance_.width() == width && radiance_.height() == height)
        return {};
    GLINT_TRY(add, gpu::Pipeline::compute(context, {"display/add_to_mean", sizeof(shared::MeanConstants), {}}));
    GLINT_TRY(encode, gpu::Pipeline::compute(context, {"display/encode_mean", sizeof(shared::MeanConstants), {}}));
    const auto make = [&](const char* name) {
        return gpu::Image::create(
            context, {name, VK_FORMAT_R32G32B32A32_SFLOAT, width, height, 1, 1, gpu::ImageShape::Flat,
                      VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    };
    GLINT_TRY(radiance, make("job/mean"));
    GLINT_TRY(displayed, make("job/mean displayed"));
    add_ = std::move(add);
    encode_ = std::move(encode);
    radiance_ = std::move(radiance);
    displayed_ = std::move(displayed);
    clear();
    return {};
}

void FrameMean::add(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& opacity, gpu::Image& displayed) {
    ++frames_;
    frame.pass(add_)
        .read("radiance", radiance, gpu::SamplerKind::NearestClamp)
        .read("opacity", opacity, gpu::SamplerKind::NearestClamp)
        .read("displayed", displayed, gpu::SamplerKind::NearestClamp)
        .readWrite("meanRadiance", radiance_)
        .readWrite("meanDisplayed", displayed_)
        .push(shared::MeanConstants{{radiance_.width(), radiance_.height()}, frames_})
        .dispatch(radiance_.width(), radiance_.height());
}

void FrameMean::display(gpu::Frame& frame, gpu::Image& target) {
    frame.pass(encode_)
        .read("mean", displayed_, gpu::SamplerKind::NearestClamp)
        .write("display", target)
        .push(shared::MeanConstants{{target.width(), target.height()}, frames_})
        .dispatch(target.width(), target.height());
}

} // namespace glint::render
