#include "reflect/denoise/lobe_denoise.hpp"

#include <algorithm>
#include <array>

namespace glint::reflect {
namespace {

/// Indices of the images in the history.
constexpr size_t kMean = 0;
constexpr size_t kMeta = 1;
constexpr size_t kPlace = 2;

} // namespace

Result<std::unique_ptr<LobeDenoise>> LobeDenoise::create(StageContext& stages) {
    std::unique_ptr<LobeDenoise> denoise(new LobeDenoise(stages));
    const auto pass = [&](gpu::Pipeline& pipeline, const char* name, uint32_t pushSize) -> Result<void> {
        GLINT_TRY(made, gpu::Pipeline::compute(stages.gpu, {name, pushSize, {}}));
        pipeline = std::move(made);
        return {};
    };
    GLINT_CHECK(pass(denoise->gather_, "denoise/gather", sizeof(uint32_t)));
    GLINT_CHECK(pass(denoise->reuse_, "denoise/reuse", 0));
    GLINT_CHECK(pass(denoise->accumulate_, "denoise/accumulate", 0));
    GLINT_CHECK(pass(denoise->filter_, "denoise/filter", 0));
    const uint32_t w = stages.width();
    const uint32_t h = stages.height();
    constexpr VkFormat kHalf = VK_FORMAT_R16G16B16A16_SFLOAT;
    GLINT_CHECK(makeImage(stages.gpu, denoise->signal_[0], {"glint/noisy", kHalf, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->signal_[1], {"glint/reused", kHalf, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->nearness_[0], {"glint/nearness", VK_FORMAT_R32_SFLOAT, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->nearness_[1], {"glint/reusedNearness", VK_FORMAT_R32_SFLOAT, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->answer_, {"glint/lobeAnswer", kHalf, w, h}));
    std::array<StageImage, 3> images;
    images[kMean] = {"glint/mean", kHalf, w, h};
    images[kMeta] = {"glint/meanMeta", kHalf, w, h};
    images[kPlace] = {"glint/meanPlace", VK_FORMAT_R32G32_UINT, w, h};
    GLINT_CHECK(denoise->history_.make(images, true));
    return denoise;
}

shared::DenoiseConstants LobeDenoise::constants(double seconds) const {
    const Settings& settings = stages_.settings();
    const double frames = settings.denoise.historySeconds / seconds;
    return {static_cast<uint32_t>(settings.reuse.samples),
            settings.reuse.radius,
            static_cast<float>(std::clamp(frames, 1.0, 1024.0)),
            settings.denoise.disocclusion,
            settings.denoise.lobeTrail,
            settings.denoise.maxRadius,
            settings.denoise.noiseTarget,
            history_.valid() ? history_.expectedTag() : 0,
            0};
}

void LobeDenoise::copyTag(gpu::Frame& frame, gpu::Buffer& target, size_t offset) {
    if (history_.valid())
        history_.copyTag(frame, target, offset);
}

void LobeDenoise::gather(gpu::Frame& frame, const LobeDenoiseInputs& inputs) {
    gpu::Image& black = inputs.frame.standIns.black;
    const uint32_t sources = (inputs.screenAnswer ? shared::kJoinScreen : 0) |
                             (inputs.raysAnswer ? shared::kJoinRays : 0) |
                             (inputs.raysFirst ? shared::kJoinRaysFirst : 0);
    frame.pass(gather_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("screenAnswer", inputs.screenAnswer ? *inputs.screenAnswer : black)
        .read("screenRecord", inputs.screenRecord)
        .read("raysAnswer", inputs.raysAnswer ? *inputs.raysAnswer : black)
        .read("raysRecord", inputs.raysRecord)
        .write("noisy", signal_[0])
        .write("nearness", nearness_[0])
        .push(sources)
        .dispatch(stages_.width(), stages_.height());
}

gpu::Image& LobeDenoise::record(gpu::Frame& frame, const LobeDenoiseInputs& inputs) {
    recorded_ = true;
    gather(frame, inputs);
    const auto begin = [&](const gpu::Pipeline& pipeline) {
        gpu::Pass pass = frame.pass(pipeline);
        pass.read("frame", inputs.frame.constants)
            .read("viewZ", inputs.prepared.viewZ)
            .read("surface", inputs.prepared.surface);
        return pass;
    };
    const uint32_t w = stages_.width();
    const uint32_t h = stages_.height();
    begin(reuse_)
        .read("blueNoise", inputs.frame.standIns.blueNoise)
        .read("noisy", signal_[0])
        .read("nearness", nearness_[0])
        .write("reused", signal_[1])
        .write("reusedNearness", nearness_[1])
        .dispatch(w, h);
    Inputs& host = inputs.frame.host;
    begin(accumulate_)
        .read("reused", signal_[1])
        .read("reusedNearness", nearness_[1])
        .read("motion", host.motion ? host.motion : inputs.frame.standIns.black, kTexels)
        .read("meanBefore", history_.before(kMean))
        .read("metaBefore", history_.before(kMeta))
        .read("placeBefore", history_.before(kPlace))
        .write("mean", history_.now(kMean))
        .write("meta", history_.now(kMeta))
        .write("place", history_.now(kPlace))
        .dispatch(w, h);
    begin(filter_)
        .read("mean", history_.now(kMean))
        .read("meta", history_.now(kMeta))
        .read("place", history_.now(kPlace))
        .write("answer", answer_)
        .dispatch(w, h);
    return answer_;
}

} // namespace glint::reflect
