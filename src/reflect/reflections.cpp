#include "glint/reflections.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reflect/frame.hpp"
#include "reflect/host_image.hpp"
#include "reflect/outcomes.hpp"
#include "reflect/views.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace glint {
namespace {

using reflect::borrow;
using reflect::giveBack;
using reflect::handOut;
using reflect::isInNoLayout;
using reflect::kHandedOut;

constexpr uint32_t kMaxSize = 16384; ///< pixels a side: what every Vulkan 1.3 desktop device can hold

Result<void> checkLayout(const HostImage& image, const char* name) {
    if (isInNoLayout(image))
        return invalidArgument(
            "`{}` is in no layout (VkImageLayout {}), so it shows nothing: state the one that it is in", name,
            static_cast<int>(image.layout));
    return {};
}

Result<void> checkImage(const HostImage& image, const char* name, const ReflectionsDesc& desc) {
    if (!image.image || !image.view)
        return invalidArgument("the G-buffer's `{}` is missing: hand over an image and its view", name);
    if (image.width != desc.width || image.height != desc.height)
        return invalidArgument("the G-buffer's `{}` is {}x{}, but these reflections were made for {}x{}", name,
                               image.width, image.height, desc.width, desc.height);
    return checkLayout(image, name);
}

/// Images of surfaces keep all of a host's samples, and all of them as many; images of light have their mean.
Result<void> checkSamples(const HostImage& image, const char* name, uint32_t wanted) {
    if (image && image.samples != wanted)
        return invalidArgument(
            "the G-buffer's `{}` has {} samples a pixel, but must have {}: depth, normal, material and "
            "baseColor have the same number, all others 1",
            name, image.samples, wanted);
    return {};
}

/// What describes surfaces: depth, normal and whatever the kind of material asks for.
Result<void> checkSurface(const GBuffer& gbuffer, const ReflectionsDesc& desc) {
    const Conventions& conventions = gbuffer.conventions;
    GLINT_CHECK(checkImage(gbuffer.depth, "depth", desc));
    GLINT_CHECK(checkImage(gbuffer.normal, "normal", desc));
    if (gbuffer.material || conventions.material != MaterialKind::Standard)
        GLINT_CHECK(checkImage(gbuffer.material, "material", desc));
    if (gbuffer.baseColor || conventions.material == MaterialKind::MetallicRoughness)
        GLINT_CHECK(checkImage(gbuffer.baseColor, "baseColor", desc));
    const uint32_t samples = gbuffer.depth.samples;
    if (samples < 1 || samples > 16 || !std::has_single_bit(samples))
        return invalidArgument("the G-buffer's `depth` has {} samples a pixel: 1, 2, 4, 8 or 16", samples);
    GLINT_CHECK(checkSamples(gbuffer.normal, "normal", samples));
    GLINT_CHECK(checkSamples(gbuffer.material, "material", samples));
    GLINT_CHECK(checkSamples(gbuffer.baseColor, "baseColor", samples));
    if (conventions.roughnessChannel > 3)
        return invalidArgument("roughnessChannel is {}: an image has channels 0 to 3", conventions.roughnessChannel);
    if (conventions.metallicChannel > 3)
        return invalidArgument("metallicChannel is {}: an image has channels 0 to 3", conventions.metallicChannel);
    return {};
}

/// Back faces may have a size of their own.
Result<void> checkBackDepth(const HostImage& image) {
    if (!image)
        return {};
    if (!image.view || image.width < 1 || image.height < 1 || image.width > kMaxSize || image.height > kMaxSize)
        return invalidArgument("the G-buffer's `backDepth` is {}x{}: it needs a view, and each side must be 1 to {}",
                               image.width, image.height, kMaxSize);
    return checkLayout(image, "backDepth");
}

Result<void> checkEnvironment(const EnvironmentMap& environment) {
    if (!environment.cube)
        return {};
    const bool numbers =
        std::isfinite(environment.strength) && environment.strength >= 0 && std::isfinite(environment.rotation);
    if (environment.mips < 1 || !environment.cube.view || !numbers)
        return invalidArgument(
            "the environment needs a cube view, at least one mip, a strength that is not negative and "
            "a finite rotation");
    if (environment.diffuse) {
        if (!environment.diffuse.view)
            return invalidArgument("the environment's diffuse cube needs a view");
        GLINT_CHECK(checkLayout(environment.diffuse, "environment.diffuse"));
    }
    return checkLayout(environment.cube, "environment");
}

/// Of a layer: one sample a pixel, and for most there is no stand-in.
struct LayerImage {
    const char* name;
    HostImage TransparentLayer::*host;
    gpu::Image reflect::LayerImages::*borrowed;
    bool optional;
};

constexpr std::array<LayerImage, 10> kLayerImages = {{
    {"depth", &TransparentLayer::depth, &reflect::LayerImages::depth, false},
    {"normal", &TransparentLayer::normal, &reflect::LayerImages::normal, false},
    {"material", &TransparentLayer::material, &reflect::LayerImages::material, false},
    {"radiance", &TransparentLayer::radiance, &reflect::LayerImages::radiance, false},
    {"fallbackSpecular", &TransparentLayer::fallbackSpecular, &reflect::LayerImages::fallbackSpecular, true},
    {"transmittance", &TransparentLayer::transmittance, &reflect::LayerImages::transmittance, false},
    {"absorption", &TransparentLayer::absorption, &reflect::LayerImages::absorption, false},
    {"body", &TransparentLayer::body, &reflect::LayerImages::body, false},
    {"objectCenter", &TransparentLayer::objectCenter, &reflect::LayerImages::objectCenter, true},
    {"coverage", &TransparentLayer::coverage, &reflect::LayerImages::coverage, true},
}};

Result<void> checkLayer(const TransparentLayer& layer, const ReflectionsDesc& desc) {
    for (const auto& [name, host, borrowed, optional] : kLayerImages) {
        const HostImage& image = layer.*host;
        if (optional && !image)
            continue;
        if (!image.image || !image.view)
            return invalidArgument("the layer's `{}` is missing: hand over an image and its view", name);
        if (image.width != desc.width || image.height != desc.height)
            return invalidArgument("the layer's `{}` is {}x{}, but these reflections were made for {}x{}", name,
                                   image.width, image.height, desc.width, desc.height);
        if (image.samples != 1)
            return invalidArgument("the layer's `{}` has {} samples a pixel, but must have 1", name, image.samples);
        GLINT_CHECK(checkLayout(image, name));
    }
    return {};
}

/// The scene is made before it is handed over, so the setting can only ask.
Result<void> checkBackend(const Settings& settings, RayBackend backend) {
    const RayBackend wanted = settings.rays.backend;
    if (settings.rays.enabled && wanted != RayBackend::Auto && wanted != backend)
        return invalidArgument("rays.backend is {}, but the RayScene was made for {}",
                               wanted == RayBackend::Query ? "query" : "bvh",
                               backend == RayBackend::Query ? "query" : "bvh");
    return {};
}

} // namespace

struct Reflections::State {
    std::unique_ptr<reflect::FrameState> frame;
    GBuffer gbuffer;
    EnvironmentMap environment;
    std::vector<std::string> notes;

    void lendInputs();
    void giveBackInputs(gpu::Frame& recording);
    bool wantsBackFaces() const { return frame->desc.settings.screen.thicknessMode == ThicknessMode::Backface; }
    Result<void> expectBackFaces() {
        const HostImage& image = gbuffer.backDepth;
        return wantsBackFaces() && image ? frame->expectBackFaces(image.width, image.height)
                                         : frame->expectBackFaces(0, 0);
    }
    void note();
};

/// As the host states them; other passes of its own may have read them since.
void Reflections::State::lendInputs() {
    frame->inputs = {borrow(gbuffer.depth, "depth"),
                     borrow(gbuffer.normal, "normal"),
                     borrow(gbuffer.material, "material"),
                     borrow(gbuffer.baseColor, "baseColor"),
                     borrow(gbuffer.litRadiance, "litRadiance"),
                     borrow(gbuffer.fallbackSpecular, "fallbackSpecular"),
                     borrow(gbuffer.backDepth, "backDepth"),
                     borrow(gbuffer.motion, "motion"),
                     borrow(environment.cube, "environment", environment.mips, 6),
                     borrow(environment.diffuse, "environmentDiffuse", 1, 6)};
}

/// The host finds its images in the layouts in which it gave them.
void Reflections::State::giveBackInputs(gpu::Frame& recording) {
    reflect::Inputs& inputs = frame->inputs;
    giveBack(recording, inputs.depth, gbuffer.depth);
    giveBack(recording, inputs.normal, gbuffer.normal);
    giveBack(recording, inputs.material, gbuffer.material);
    giveBack(recording, inputs.baseColor, gbuffer.baseColor);
    giveBack(recording, inputs.litRadiance, gbuffer.litRadiance);
    giveBack(recording, inputs.fallbackSpecular, gbuffer.fallbackSpecular);
    giveBack(recording, inputs.backDepth, gbuffer.backDepth);
    giveBack(recording, inputs.motion, gbuffer.motion);
    giveBack(recording, inputs.environment, environment.cube);
    giveBack(recording, inputs.environmentDiffuse, environment.diffuse);
}

/// What settings and inputs together leave undone.
void Reflections::State::note() {
    notes.clear();
    if (frame->desc.settings.rays.enabled && !frame->rayScene)
        notes.emplace_back("rays.enabled without a scene: the host has not called Reflections::setRays");
    const ScreenSettings& screen = frame->desc.settings.screen;
    if (screen.enabled && screen.march == March::Proxy && !(frame->probesSource && frame->probesSource->hasProbes()))
        notes.emplace_back("screen.march proxy without probes: every ray is taken to end infinitely far away");
    if (!frame->inputsSet)
        return;
    if (!gbuffer.fallbackSpecular)
        notes.emplace_back(
            "no fallbackSpecular: reflections are added to litRadiance, as nothing says which part of it "
            "they replace");
    if (frame->desc.settings.screen.enabled && wantsBackFaces() && !gbuffer.backDepth)
        notes.emplace_back("no backDepth: screen.thicknessMode backface takes every surface to be as thick as "
                           "screen.thickness says");
}

Reflections::Reflections(std::unique_ptr<State> state) : state_(std::move(state)) {}
Reflections::~Reflections() = default;
Reflections::Reflections(Reflections&&) noexcept = default;
Reflections& Reflections::operator=(Reflections&&) noexcept = default;

Result<Reflections> Reflections::create(Context& context, const ReflectionsDesc& desc) {
    if (desc.width < 1 || desc.height < 1 || desc.width > kMaxSize || desc.height > kMaxSize)
        return invalidArgument("reflections of {}x{} pixels: each side must be 1 to {}", desc.width, desc.height,
                               kMaxSize);
    GLINT_CHECK(validate(desc.settings));
    auto state = std::make_unique<State>();
    GLINT_TRY(frame, reflect::FrameState::create(context.gpu(), desc));
    state->frame = std::move(frame);
    return Reflections(std::move(state));
}

Result<void> Reflections::setSettings(const Settings& settings) {
    GLINT_CHECK(validate(settings));
    if (state_->frame->rayScene)
        GLINT_CHECK(checkBackend(settings, state_->frame->rayScene->backend()));
    GLINT_CHECK(state_->frame->setSettings(settings));
    state_->frame->recorded = false;
    state_->note();
    return state_->expectBackFaces();
}

Result<void> Reflections::setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment) {
    const ReflectionsDesc& desc = state_->frame->desc;
    GLINT_CHECK(checkSurface(gbuffer, desc));
    GLINT_CHECK(checkImage(gbuffer.litRadiance, "litRadiance", desc));
    if (gbuffer.fallbackSpecular)
        GLINT_CHECK(checkImage(gbuffer.fallbackSpecular, "fallbackSpecular", desc));
    GLINT_CHECK(checkBackDepth(gbuffer.backDepth));
    if (gbuffer.motion)
        GLINT_CHECK(checkImage(gbuffer.motion, "motion", desc));
    if (!std::isfinite(gbuffer.conventions.motionScale[0]) || !std::isfinite(gbuffer.conventions.motionScale[1]))
        return invalidArgument("motionScale must be finite");
    GLINT_CHECK(checkSamples(gbuffer.litRadiance, "litRadiance", 1));
    GLINT_CHECK(checkSamples(gbuffer.fallbackSpecular, "fallbackSpecular", 1));
    GLINT_CHECK(checkSamples(gbuffer.backDepth, "backDepth", 1));
    GLINT_CHECK(checkSamples(gbuffer.motion, "motion", 1));
    GLINT_CHECK(checkEnvironment(environment));

    state_->gbuffer = gbuffer;
    state_->environment = environment;
    reflect::FrameState& frame = *state_->frame;
    frame.conventions = gbuffer.conventions;
    frame.environmentStrength = environment.strength;
    frame.environmentRotation = environment.rotation;
    frame.environmentFlipY = environment.flipY;
    frame.environmentMips = std::max(environment.mips, 1u);
    frame.inputsSet = true;
    state_->note();
    GLINT_CHECK(frame.expectSamples(gbuffer.depth.samples));
    return state_->expectBackFaces();
}

Result<void> Reflections::setRays(RayScene& scene, SurfaceTable& surfaces) {
    GLINT_CHECK(checkBackend(state_->frame->desc.settings, scene.backend()));
    GLINT_CHECK(state_->frame->setRays(scene.scene(), surfaces.state()));
    state_->note();
    return {};
}

Result<void> Reflections::setRays(RayScene& scene, ShadeHits shade) {
    if (!shade)
        return invalidArgument("setRays needs something that shades hits");
    GLINT_CHECK(checkBackend(state_->frame->desc.settings, scene.backend()));
    GLINT_CHECK(state_->frame->setRays(scene.scene(), std::move(shade)));
    state_->note();
    return {};
}

Result<void> Reflections::setPlanar(PlanarMirrors& mirrors) {
    return state_->frame->setPlanar(mirrors.state());
}

Result<void> Reflections::setProbes(Probes& probes) {
    GLINT_CHECK(state_->frame->setProbes(probes.state()));
    state_->note();
    return {};
}

void Reflections::restartAccumulation() {
    state_->frame->restartAccumulation();
}

HostImage Reflections::record(VkCommandBuffer commands, const View& view) {
    reflect::FrameState& state = *state_->frame;
    GLINT_ASSERT(state.inputsSet, "call setInputs before record");
    state_->lendInputs();
    state.lastView = view;
    state.recorded = true;
    state.ranPasses = state.anySource() || state.desc.settings.debug.outcome || state.expectsLayers();
    state.upToDate = state.ranPasses;
    if (!state.ranPasses) {
        state.historyHeld = false;
        return state_->gbuffer.litRadiance;
    }

    gpu::Frame frame(*state.context, commands, state.timers.get());
    state.record(frame, view);
    frame.hand(state.composite, kHandedOut);
    state_->giveBackInputs(frame);
    return handOut(state.composite);
}

Result<HostImage> Reflections::recordLayer(VkCommandBuffer commands, const TransparentLayer& layer,
                                           const HostImage& picture) {
    reflect::FrameState& state = *state_->frame;
    if (!state.refraction)
        return invalidArgument(
            "these reflections were made without transparent layers: set ReflectionsDesc::transparentLayers");
    if (!state.recorded)
        return invalidArgument("nothing was recorded with these settings: record a frame, then its layers");
    GLINT_CHECK(checkLayer(layer, state.desc));
    if (!state.expectsLayers())
        return picture;
    if (picture.image != state.composite.handle())
        return invalidArgument("a layer's picture is not the one that record returned");
    state.inputs.environment = borrow(state_->environment.cube, "environment", state_->environment.mips, 6);
    state.composite.states()[0] = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, 0, 0,
                                   picture.layout}; // the host may have drawn over it since
    reflect::LayerImages images;
    for (const LayerImage& image : kLayerImages)
        images.*image.borrowed = borrow(layer.*image.host, image.name);
    gpu::Frame frame = gpu::Frame::more(*state.context, commands, *state.timers);
    state.recordLayer(frame, images);
    frame.hand(state.composite, kHandedOut);
    for (const LayerImage& image : kLayerImages)
        giveBack(frame, images.*image.borrowed, layer.*image.host);
    giveBack(frame, state.inputs.environment, state_->environment.cube);
    return handOut(state.composite);
}

Result<HostImage> Reflections::recordView(VkCommandBuffer commands, std::string_view name) {
    reflect::FrameState& state = *state_->frame;
    if (!state.desc.views)
        return invalidArgument("these reflections were made without views: set ReflectionsDesc::views");
    const auto found = std::find(reflect::kViewNames.begin(), reflect::kViewNames.end(), name);
    if (found == reflect::kViewNames.end())
        return invalidArgument("no view '{}'; did you mean '{}'?", name, nearestText(name, reflect::kViewNames));
    state_->lendInputs();
    gpu::Frame frame(*state.context, commands);
    state.recordView(frame, static_cast<uint32_t>(found - reflect::kViewNames.begin()));
    frame.hand(state.viewImage, kHandedOut);
    state_->giveBackInputs(frame);
    return handOut(state.viewImage);
}

Result<void> Reflections::recordInspection(VkCommandBuffer commands, uint32_t x, uint32_t y) {
    reflect::FrameState& state = *state_->frame;
    if (!state.desc.inspection)
        return invalidArgument("these reflections were made without inspection: set ReflectionsDesc::inspection");
    if (!state.recorded)
        return invalidArgument("nothing was recorded with these settings: record a frame, then inspect it");
    if (x >= state.desc.width || y >= state.desc.height)
        return invalidArgument("pixel {},{} lies outside the picture of {}x{}", x, y, state.desc.width,
                               state.desc.height);
    state_->lendInputs();
    if (state.ranPasses) // the host may have drawn over it since
        state.composite.states()[0] = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, 0, 0,
                                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    gpu::Frame frame(*state.context, commands);
    state.recordInspection(frame, x, y);
    if (state.ranPasses)
        frame.hand(state.composite, kHandedOut);
    state_->giveBackInputs(frame);
    return {};
}

RayInspection Reflections::inspection() const {
    const reflect::FrameState& state = *state_->frame;
    GLINT_ASSERT(state.desc.inspection, "these reflections were made without inspection");
    return state.inspector->read(state.desc.settings.screen.enabled);
}

std::vector<std::string_view> Reflections::viewNames() {
    return {reflect::kViewNames.begin(), reflect::kViewNames.end()};
}

std::vector<PassTime> Reflections::passTimes() {
    std::vector<PassTime> times;
    if (!state_->frame->ranPasses)
        return times;
    for (const gpu::PassTime& time : state_->frame->timers->latest())
        times.push_back({time.name, time.milliseconds});
    return times;
}

Statistics Reflections::statistics() {
    const reflect::FrameState& state = *state_->frame;
    Statistics result;
    if (!state.desc.statistics || !state.tracesRays())
        return result;
    shared::RayStatistics counts;
    std::memcpy(&counts, state.statisticsReadback.mapped(), sizeof(counts));
    for (uint32_t outcome = 0; outcome < shared::kOutcomeCount; ++outcome) {
        result.outcomes.push_back({reflect::kOutcomeNames[outcome], counts.outcomes[outcome]});
        if (reflect::isTraced(outcome))
            result.rays += counts.outcomes[outcome];
    }
    uint64_t sum = 0;
    for (uint64_t bin = 0; bin <= shared::kMaxLookups; ++bin)
        sum += bin * counts.lookups[bin];
    result.lookupsMean = result.rays ? static_cast<double>(sum) / static_cast<double>(result.rays) : 0;
    uint64_t below = 0;
    for (uint32_t bin = 0; bin <= shared::kMaxLookups && below * 100 < result.rays * 95; ++bin) {
        below += counts.lookups[bin];
        result.lookups95 = bin;
    }
    const auto wide = [](const uint32_t words[2]) { return words[0] | uint64_t{words[1]} << 32; };
    result.scene = {counts.scenePixels, wide(counts.sceneRays), counts.fromScreen, counts.replaced,
                    wide(counts.reusedLight)};
    return result;
}

const std::vector<std::string>& Reflections::notes() const {
    return state_->notes;
}

} // namespace glint
