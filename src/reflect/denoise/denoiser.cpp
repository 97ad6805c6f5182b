#include "reflect/denoise/denoiser.hpp"

#include <algorithm>
#include <array>
#include <ranges>

namespace glint::reflect {
namespace {

constexpr VkFormat kHalf = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat kWords = VK_FORMAT_R32G32B32A32_UINT;

/// The images of the history: a line here and, if settings decide, in `isNeeded`.
constexpr HistoryImage kMean = {0, "glint/mean", kHalf};
constexpr HistoryImage kMeta = {1, "glint/meanMeta", kHalf};
constexpr HistoryImage kFast = {2, "glint/fastMean", VK_FORMAT_R16_SFLOAT};
constexpr HistoryImage kPlace = {3, "glint/meanPlace", VK_FORMAT_R32G32_UINT};
constexpr HistoryImage kSentinelRay = {4, "glint/sentinelRay", kWords, shared::kSentinelTile, 2};
constexpr HistoryImage kSentinelPath = {5, "glint/sentinelPath", kWords, shared::kSentinelTile, 2};
constexpr HistoryImage kRates = {6, "glint/rayRates", VK_FORMAT_R8_UNORM, shared::kRateTile};
constexpr HistoryImage kSpeed = {7, "glint/meanSpeed", VK_FORMAT_R16_SFLOAT};
constexpr HistoryImage kSentinelPlace = {8, "glint/sentinelPlace", kWords, shared::kSentinelTile, 2};
constexpr HistoryImage kStable = {9, "glint/stableBrightness", VK_FORMAT_R16G16_SFLOAT};
constexpr std::array kImages = {kMean,         kMeta,  kFast,  kPlace,         kSentinelRay,
                                kSentinelPath, kRates, kSpeed, kSentinelPlace, kStable};
static_assert(std::ranges::equal(kImages, std::views::iota(size_t{0}, kImages.size()), {}, &HistoryImage::index));

bool isNeeded(const HistoryImage& image, const DenoiserKept& kept) {
    switch (image.index) {
    case kFast.index: return kept.fastMean;
    case kSentinelRay.index:
    case kSentinelPath.index: return kept.paths;
    case kSentinelPlace.index: return kept.places;
    case kStable.index: return kept.stable;
    default: return true;
    }
}

uint32_t tiles(uint32_t pixels, uint32_t across) {
    return (pixels + across - 1) / across;
}

uint32_t rateOf(const Settings& settings) {
    if (settings.reuse.samples == 0)
        return shared::kRateFull; // there are no neighbours to take rays from
    switch (settings.reuse.rate) {
    case RayRate::Checkerboard: return shared::kRateCheckerboard;
    case RayRate::Quarter: return shared::kRateQuarter;
    case RayRate::Adaptive: return shared::kRateAdaptive;
    default: return shared::kRateFull;
    }
}

} // namespace

Result<std::unique_ptr<Denoiser>> Denoiser::create(StageContext& stages) {
    std::unique_ptr<Denoiser> denoise(new Denoiser(stages));
    const auto pass = [&](gpu::Pipeline& pipeline, const char* name, uint32_t pushSize) -> Result<void> {
        GLINT_TRY(made, gpu::Pipeline::compute(stages.gpu, {name, pushSize, {}}));
        pipeline = std::move(made);
        return {};
    };
    GLINT_CHECK(pass(denoise->gather_, "denoise/gather", sizeof(uint32_t)));
    GLINT_CHECK(pass(denoise->reuse_, "denoise/reuse", 0));
    GLINT_CHECK(pass(denoise->sentinels_, "denoise/sentinels", 0));
    GLINT_CHECK(pass(denoise->change_, "denoise/change", 0));
    GLINT_CHECK(pass(denoise->accumulate_, "denoise/accumulate", 0));
    GLINT_CHECK(pass(denoise->filter_, "denoise/filter", 0));
    GLINT_CHECK(pass(denoise->rate_, "denoise/rate", 0));
    const uint32_t w = stages.width();
    const uint32_t h = stages.height();
    GLINT_CHECK(makeImage(stages.gpu, denoise->noisy_, {"glint/noisy", kHalf, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->sentRay_, {"glint/sentRay", VK_FORMAT_R32G32_UINT, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->reusedMeta_, {"glint/reusedMeta", VK_FORMAT_R16G16_SFLOAT, w, h}));
    const uint32_t tilesX = tiles(w, shared::kSentinelTile);
    const uint32_t tilesY = tiles(h, shared::kSentinelTile);
    GLINT_CHECK(makeImage(stages.gpu, denoise->sentinelChange_, {"glint/change", kHalf, tilesX, tilesY}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->changed_, {"glint/changed", kHalf, tilesX, tilesY}));
    GLINT_CHECK(
        makeImage(stages.gpu, denoise->noMirroredSurface_, {"glint/noMirroredSurface", kWords, 1, 1, kCleared}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->noMirroredLight_, {"glint/noMirroredLight", kWords, 1, 1, kCleared}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->hitMotion_, {"glint/hitMotion", VK_FORMAT_R32_UINT, w, h}));
    GLINT_CHECK(makeImage(stages.gpu, denoise->reusedMotion_, {"glint/reusedMotion", kHalf, w, h}));
    return denoise;
}

Result<void> Denoiser::makeHistory(const DenoiserKept& kept) {
    std::array<StageImage, kImages.size()> images;
    for (const HistoryImage& image : kImages)
        images[image.index] = image.sized(stages_.width(), stages_.height(), isNeeded(image, kept));
    GLINT_CHECK(history_.make(images, true));
    kept_ = kept;
    return {};
}

Result<void> Denoiser::make(const Settings& settings) {
    const uint32_t w = stages_.width();
    const uint32_t h = stages_.height();
    if (!reusesTarget(settings))
        GLINT_CHECK(makeImage(stages_.gpu, reused_, {"glint/reused", kHalf, w, h}));
    if (stages_.desc.views)
        GLINT_CHECK(makeImage(stages_.gpu, answer_, {"glint/denoisedAnswer", kHalf, w, h}));
    const Antilag antilag = settings.denoise.antilag;
    const bool screen = settings.screen.enabled;
    DenoiserKept kept = kept_.value_or(DenoiserKept());
    kept.fastMean |= antilag == Antilag::Mean || (antilag == Antilag::Gradient && !screen);
    kept.places |= antilag == Antilag::Gradient && screen;
    kept.paths |= settings.rays.enabled;
    if (settings.denoise.stabilizeSeconds > 0 && !kept.stable) {
        GLINT_TRY(made, gpu::Pipeline::compute(stages_.gpu, {"denoise/stabilize", 0, {}}));
        stabilize_ = std::move(made);
        GLINT_CHECK(makeImage(stages_.gpu, takenFrom_, {"glint/takenFrom", VK_FORMAT_R16G16_SFLOAT, w, h}));
        if (stages_.desc.views)
            GLINT_CHECK(makeImage(stages_.gpu, stabilized_, {"glint/stabilized", kHalf, w, h}));
        kept.stable = true;
    }
    history_.reset(HistoryReset::Settings);
    return kept_ != kept ? makeHistory(kept) : Result<void>();
}

/// True if the neighbours' rays are gathered in the image of the screen's answer, which only gather reads. Views show
/// that answer.
bool Denoiser::reusesTarget(const Settings& settings) const {
    return !stages_.desc.views && !stages_.desc.inspection && settings.screen.enabled &&
           settings.screen.targetFormat != TargetFormat::Rgba8;
}

void Denoiser::begin(gpu::Frame& frame) {
    const FramePlan& plan = stages_.plan;
    const Sentinels followed = plan.followsPaths    ? Sentinels::Paths
                               : plan.followsPlaces ? Sentinels::Places
                                                    : Sentinels::None;
    if (followed != followed_)
        history_.reset(HistoryReset::Asked); // a history without sentinels holds what older frames left there
    followed_ = followed;
    history_.begin(frame, plan.denoise);
    if (blank_.isNeeded(stages_.progress)) {
        frame.clear(noMirroredSurface_, {});
        frame.clear(noMirroredLight_, {});
        blank_.recorded(stages_.progress);
    }
    recorded_ = false;
}

/// True if the means tell of changed light. With sentinels they add nothing: those are never later.
bool Denoiser::comparesMeans() const {
    const Antilag antilag = stages_.settings().denoise.antilag;
    return antilag == Antilag::Mean || (antilag == Antilag::Gradient && followed_ == Sentinels::None);
}

shared::DenoiseConstants Denoiser::constants(double seconds, bool mirrored) const {
    const Settings& settings = stages_.settings();
    const double frames = settings.denoise.historySeconds / seconds;
    return {static_cast<uint32_t>(settings.reuse.samples),
            settings.reuse.radius,
            static_cast<float>(std::clamp(frames, 1.0, 1024.0)),
            settings.denoise.disocclusion,
            settings.denoise.lobeTrail,
            settings.denoise.maxRadius,
            settings.denoise.noiseTarget,
            static_cast<float>(settings.denoise.fastFrames),
            settings.denoise.firefly,
            rateOf(settings),
            comparesMeans() ? 1u : 0u,
            settings.denoise.hitMotion ? 1u : 0u,
            static_cast<uint32_t>(settings.denoise.virtualMotion),
            static_cast<float>(std::min(settings.denoise.stabilizeSeconds / seconds, 1024.0)),
            mirrored ? 1u : 0u,
            history_.valid() ? history_.expectedTag() : 0,
            0};
}

void Denoiser::copyTag(gpu::Frame& frame, gpu::Buffer& target, size_t offset) {
    if (history_.valid())
        history_.copyTag(frame, target, offset);
}

std::optional<DenoiserHistory> Denoiser::history() {
    if (!recorded_)
        return std::nullopt;
    return DenoiserHistory{sentRay_, history_.now(kMeta), history_.before(kMeta), *shownChange_};
}

gpu::Image& Denoiser::rayRates() {
    return history_.before(kRates);
}

gpu::Image& Denoiser::metaBefore() {
    return history_.before(kMeta);
}

MirroredImages Denoiser::mirroredOf(const DenoiserInputs& inputs) {
    return inputs.mirrored.value_or(MirroredImages{noMirroredSurface_, noMirroredLight_});
}

void Denoiser::gather(gpu::Frame& frame, const DenoiserInputs& inputs) {
    gpu::Image& black = inputs.frame.standIns.black;
    const MirroredImages mirrored = mirroredOf(inputs);
    const uint32_t sources = (inputs.screenAnswer ? shared::kJoinScreen : 0) |
                             (inputs.raysAnswer ? shared::kJoinRays : 0) |
                             (inputs.raysFirst ? shared::kJoinRaysFirst : 0);
    frame.pass(gather_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("blueNoise", inputs.frame.standIns.blueNoise)
        .read("screenAnswer", inputs.screenAnswer ? *inputs.screenAnswer : black)
        .read("screenRecord", inputs.screenRecord)
        .read("raysAnswer", inputs.raysAnswer ? *inputs.raysAnswer : black)
        .read("raysRecord", inputs.raysRecord)
        .read("motion", inputs.frame.host.motion ? inputs.frame.host.motion : black, kTexels)
        .write("noisy", noisy_)
        .write("sentRay", sentRay_)
        .write("hitMotion", hitMotion_)
        .readWrite("mirroredSurface", mirrored.surface)
        .readWrite("mirroredLight", mirrored.light)
        .push(sources)
        .dispatch(stages_.extent.x, stages_.extent.y);
}

void Denoiser::lookAtPlaces(gpu::Frame& frame, const DenoiserInputs& inputs) {
    gpu::Image& black = inputs.frame.standIns.black;
    Inputs& host = inputs.frame.host;
    frame.pass(sentinels_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("litRadiance", host.litRadiance, kTexels)
        .read("motion", host.motion ? host.motion : black, kTexels)
        .read("screenAnswer", inputs.screenAnswer ? *inputs.screenAnswer : black)
        .read("screenRecord", inputs.screenRecord)
        .read("sentinelBefore", history_.before(kSentinelPlace))
        .write("sentinel", history_.now(kSentinelPlace))
        .write("change", sentinelChange_)
        .dispatch(sentinelChange_.width(), sentinelChange_.height());
}

/// Returns what has changed since the previous frame, by tiles; black where nothing is to be found.
gpu::Image& Denoiser::findChange(gpu::Frame& frame, const DenoiserInputs& inputs) {
    gpu::Image& black = inputs.frame.standIns.black;
    if (!stages_.plan.findsChange)
        return black;
    const bool places = followed_ == Sentinels::Places || frame.rehearsing();
    if (inputs.followPaths)
        inputs.followPaths(frame, {history_.before(kSentinelRay), history_.before(kSentinelPath),
                                   history_.now(kSentinelRay), history_.now(kSentinelPath), sentinelChange_});
    if (places)
        lookAtPlaces(frame, inputs);
    frame.pass(change_)
        .read("frame", inputs.frame.constants)
        .read("change", inputs.followPaths || places ? sentinelChange_ : black, kTexels)
        .read("metaBefore", history_.before(kMeta), kTexels)
        .read("fastBefore", history_.before(kFast), kTexels)
        .write("changed", changed_)
        .dispatch(changed_.width(), changed_.height());
    return changed_;
}

/// Returns the image of what it was given or, without views, of `spare`, which nothing reads any more.
gpu::Image& Denoiser::stabilize(gpu::Frame& frame, const DenoiserInputs& inputs, gpu::Image& filtered,
                                gpu::Image& spare) {
    gpu::Image& answer = stages_.desc.views ? stabilized_ : spare;
    frame.pass(stabilize_)
        .read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("filtered", filtered)
        .read("meta", history_.now(kMeta))
        .read("takenFrom", takenFrom_)
        .read("stableBefore", history_.before(kStable))
        .write("stable", history_.now(kStable))
        .write("answer", answer)
        .dispatch(stages_.extent.x, stages_.extent.y);
    return answer;
}

gpu::Image& Denoiser::record(gpu::Frame& frame, const DenoiserInputs& inputs) {
    recorded_ = true;
    gpu::Image& reused = inputs.screenAnswer && reusesTarget(stages_.settings()) ? *inputs.screenAnswer : reused_;
    gpu::Image& answer = stages_.desc.views ? answer_ : noisy_; // what gather wrote is read no more then
    const MirroredImages mirrored = mirroredOf(inputs);
    gather(frame, inputs);
    gpu::Image& changed = findChange(frame, inputs);
    shownChange_ = &changed;
    const auto begin = [&](const gpu::Pipeline& pipeline) {
        gpu::Pass pass = frame.pass(pipeline);
        pass.read("frame", inputs.frame.constants)
            .read("viewZ", inputs.prepared.viewZ)
            .read("surface", inputs.prepared.surface);
        return pass;
    };
    const uint32_t w = stages_.extent.x;
    const uint32_t h = stages_.extent.y;
    begin(reuse_)
        .read("noisy", noisy_)
        .read("sentRay", sentRay_)
        .read("rayRates", rayRates(), kTexels)
        .read("dfg", inputs.frame.standIns.dfg)
        .write("reused", reused)
        .read("hitMotion", hitMotion_)
        .read("mirroredSurface", mirrored.surface)
        .write("reusedMeta", reusedMeta_)
        .write("reusedMotion", reusedMotion_)
        .dispatch(w, h);
    Inputs& host = inputs.frame.host;
    begin(accumulate_)
        .read("reused", reused)
        .read("reusedMeta", reusedMeta_)
        .read("reusedMotion", reusedMotion_)
        .read("motion", host.motion ? host.motion : inputs.frame.standIns.black, kTexels)
        .read("meanBefore", history_.before(kMean))
        .read("metaBefore", history_.before(kMeta))
        .read("fastBefore", history_.before(kFast))
        .read("placeBefore", history_.before(kPlace))
        .read("changed", changed)
        .read("speedBefore", history_.before(kSpeed))
        .read("mirroredSurface", mirrored.surface)
        .read("hitMotion", hitMotion_)
        .write("mean", history_.now(kMean))
        .write("meta", history_.now(kMeta))
        .write("fast", history_.now(kFast))
        .write("speed", history_.now(kSpeed))
        .write("place", history_.now(kPlace))
        .write("takenFrom",
               stages_.plan.stabilizes ? takenFrom_ : history_.now(kStable)) // written only where it is kept
        .dispatch(w, h);
    if (stages_.plan.ratesRays)
        begin(rate_)
            .read("meta", history_.now(kMeta))
            .write("rates", history_.now(kRates))
            .dispatch(tiles(w, shared::kRateTile), tiles(h, shared::kRateTile));
    begin(filter_)
        .read("mean", history_.now(kMean))
        .read("meta", history_.now(kMeta))
        .read("mirroredSurface", mirrored.surface)
        .read("mirroredLight", mirrored.light)
        .write("answer", answer)
        .dispatch(w, h);
    return stages_.plan.stabilizes ? stabilize(frame, inputs, answer, reused) : answer;
}

} // namespace glint::reflect
