#include "lab/renderer/renderer.hpp"

#include "base/assert.hpp"
#include "lab/renderer/dfg_table.hpp"
#include "shared/render_view.h"

#include <glm/gtc/matrix_access.hpp>

#include <cmath>

namespace glint::render {
namespace {

static_assert(scene::kMostStrongLights == shared::kMaxSuns);

/// A disc of radiance L gives the irradiance pi L sin^2(radius).
shared::SunDisc sunDisc(const Sun& sun, const EnvironmentSettings& settings) {
    const float sinRadius = std::sin(sun.angularRadius);
    return {rotateFromEnvironment(sun.direction, settings.rotation), std::cos(sun.angularRadius),
            sun.irradiance * (settings.strength / (glm::pi<float>() * sinRadius * sinRadius))};
}

} // namespace

Result<Renderer> Renderer::create(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose,
                                  Environment&& environment, const RenderSettings& settings) {
    Renderer result(context);
    GLINT_TRY(gpuScene, GpuScene::create(context, scene, pose));
    GLINT_TRY(dfg, makeDfgTable(context));
    GLINT_TRY(backFaces, BackFacePass::create(context, gpuScene));
    GLINT_TRY(display, DisplayPass::create(context));
    GLINT_TRY(shadows, ShadowMaps::create(context, gpuScene));
    GLINT_TRY(viewBuffer,
              gpu::Buffer::create(context, {"render/view", sizeof(shared::RenderView),
                                            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT}));
    GLINT_TRY(lightBuffer,
              gpu::Buffer::create(context, {"render/lights", shared::kMaxLights * sizeof(shared::Light),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT}));
    result.scene_ = std::move(gpuScene);
    result.dfg_ = std::move(dfg);
    result.backFaces_ = std::move(backFaces);
    result.display_ = std::move(display);
    result.shadows_ = std::move(shadows);
    result.viewBuffer_ = std::move(viewBuffer);
    result.lightBuffer_ = std::move(lightBuffer);
    result.environment_ = std::move(environment);
    result.settings_ = settings;
    result.sceneLights_ = gpuLights(pose);
    GLINT_CHECK(result.placeLights());
    return result;
}

Result<void> Renderer::resize(uint32_t width, uint32_t height, const GBufferOptions& options) {
    if (target_.gbuffer.litRadiance && target_.gbuffer.litRadiance.width() == width &&
        target_.gbuffer.litRadiance.height() == height && gbufferOptions_ == options)
        return {};
    GLINT_TRY(gbuffer, GBuffer::create(*context_, width, height, options));
    if (!target_.gbuffer.litRadiance || options.mode != gbufferOptions_.mode ||
        options.samples != gbufferOptions_.samples || options.lobes != gbufferOptions_.lobes)
        GLINT_CHECK(makePasses(options));
    GLINT_TRY(behind, TransparentPass::makeBehind(*context_, scene_, width, height));
    GLINT_CHECK(display_.resize(*context_, width, height, settings_.display));
    target_ = {std::move(gbuffer), std::move(behind)};
    layersFit_ = false;
    gbufferOptions_ = options;
    return rehearse();
}

Result<RenderTarget> Renderer::makeTarget(uint32_t width, uint32_t height) const {
    GLINT_TRY(gbuffer, GBuffer::create(*context_, width, height, gbufferOptions_));
    GLINT_TRY(behind, TransparentPass::makeBehind(*context_, scene_, width, height));
    return RenderTarget{std::move(gbuffer), std::move(behind)};
}

Result<void> Renderer::makePasses(const GBufferOptions& options) {
    GLINT_TRY(surfaces, SurfacePass::create(*context_, scene_, options, shadowRays()));
    GLINT_TRY(transparent, TransparentPass::create(*context_, scene_, options, shadowRays()));
    GLINT_TRY(background, BackgroundPass::create(*context_, options));
    surfaces_ = std::move(surfaces);
    transparent_ = std::move(transparent);
    background_ = std::move(background);
    shadowBackend_ = shadowRays() ? std::optional(shadowRays()->backend()) : std::nullopt;
    return {};
}

/// Call after the shadow technique has changed.
Result<void> Renderer::remakePasses() {
    layersFit_ = false;
    GLINT_CHECK(makePasses(gbufferOptions_));
    return rehearse();
}

Result<void> Renderer::rehearse() {
    gpu::Frame frame = gpu::Frame::rehearsal(*context_);
    drawOpaque(frame, ViewParameters());
    drawTransparent(frame, target_.gbuffer.litRadiance);
    display(frame, target_.gbuffer.litRadiance, target_.gbuffer.albedo);
    return frame.firstError();
}

Result<void> Renderer::setSettings(const RenderSettings& settings) {
    const RayWorld* before = shadowRays();
    settings_ = settings;
    if (target_.gbuffer.litRadiance && shadowRays() != before)
        GLINT_CHECK(remakePasses());
    if (target_.gbuffer.litRadiance)
        GLINT_CHECK(display_.resize(*context_, target_.gbuffer.litRadiance.width(),
                                    target_.gbuffer.litRadiance.height(), settings_.display));
    return placeLights();
}

Result<void> Renderer::setEnvironment(Environment&& environment) {
    environment_ = std::move(environment);
    return placeLights();
}

Result<void> Renderer::setPose(const scene::Scene& scene, const scene::Pose& pose) {
    GLINT_CHECK(scene_.setPose(*context_, scene, pose));
    sceneLights_ = gpuLights(pose);
    return placeLights();
}

Result<bool> Renderer::setMaterials(const scene::Scene& scene, const scene::Pose& pose) {
    lightsChanged_ = true; // a material decides if its surfaces cast shadows
    return scene_.setMaterials(*context_, scene, pose);
}

Result<void> Renderer::placeLights() {
    lights_ = sceneLights_;
    for (const Sun& sun : environment_.suns())
        lights_.push_back(sunLight(sun, settings_.environment));
    const bool maps = settings_.lights.shadows == ShadowMode::Maps;
    GLINT_CHECK(shadows_.resize(*context_, maps ? ShadowMaps::casters(lights_) : 0,
                                static_cast<uint32_t>(settings_.shadows.resolution)));
    shadows_.place(lights_, scene_.boundsWS());
    for (shared::Light& light : lights_)
        light.castsShadow |= settings_.lights.shadows == ShadowMode::Rays;
    lightsChanged_ = true;
    return {};
}

/// Null if shadows are not ray-traced.
RayWorld* Renderer::shadowRays() const {
    GLINT_ASSERT(settings_.lights.shadows != ShadowMode::Rays || rayWorld_, "lights.shadows rays need a RayWorld");
    return settings_.lights.shadows == ShadowMode::Rays ? rayWorld_ : nullptr;
}

Result<void> Renderer::setRayWorld(RayWorld* rayWorld) {
    rayWorld_ = rayWorld;
    const bool fits = !shadowRays() || shadowBackend_ == shadowRays()->backend();
    return target_.gbuffer.litRadiance && !fits ? remakePasses() : Result<void>();
}

View Renderer::view(const ViewParameters& parameters) const {
    return makeView(parameters.camera, target_.gbuffer.litRadiance.width(), target_.gbuffer.litRadiance.height(),
                    parameters.jitterPX);
}

void Renderer::updateView(gpu::Frame& frame, const ViewParameters& parameters, const RenderTarget& target) {
    view_ = makeView(parameters.camera, target.gbuffer.litRadiance.width(), target.gbuffer.litRadiance.height(),
                     parameters.jitterPX);
    const View previous = makeView(parameters.prevCamera.value_or(parameters.camera), view_.width, view_.height,
                                   parameters.prevCamera ? parameters.prevJitterPX : parameters.jitterPX);
    const EnvironmentSettings& environment = settings_.environment;
    const float rotation = glm::radians(environment.rotation);
    shared::RenderView constants = {};
    constants.worldToClip = view_.worldToClip;
    constants.clipToWorld = view_.clipToWorld;
    constants.prevWorldToClip = previous.worldToClip;
    constants.worldToViewZ = -glm::row(view_.worldToView, 2);
    constants.prevWorldToViewZ = -glm::row(previous.worldToView, 2);
    constants.jitterUV = view_.jitterUV;
    constants.prevJitterUV = previous.jitterUV;
    constants.cameraPositionWS = view_.positionWS();
    constants.orthographic = view_.orthographic ? 1 : 0;
    constants.cameraForwardWS = view_.forwardWS();
    constants.lightCount = static_cast<uint32_t>(lights_.size());
    constants.environmentRotation = {std::cos(rotation), std::sin(rotation)};
    constants.environmentStrength = environment.strength * environment_.unit();
    constants.environmentVisible = environment.visible ? 1 : 0;
    constants.clipPlaneWS = parameters.clipPlaneWS;
    constants.highlights = parameters.highlights ? 1 : 0;
    const bool drawsSuns = parameters.highlights && parameters.sunDisc;
    for (size_t i = 0; i < std::size(constants.suns); ++i)
        constants.suns[i] = drawsSuns && i < environment_.suns().size() ? sunDisc(environment_.suns()[i], environment)
                                                                        : shared::SunDisc{{}, 2, {}};
    frame.update(viewBuffer_, &constants, sizeof(constants));
}

LightingInputs Renderer::lightingInputs() {
    return {viewBuffer_, lightBuffer_, environment_, dfg_, shadows_.atlas(), shadowRays()};
}

GBuffer& Renderer::drawOpaque(gpu::Frame& frame, const ViewParameters& parameters) {
    return drawOpaque(frame, parameters, target_);
}

GBuffer& Renderer::drawOpaque(gpu::Frame& frame, const ViewParameters& parameters, RenderTarget& target) {
    GBuffer& gbuffer = target.gbuffer;
    updateView(frame, parameters, target);
    if (lightsChanged_ || frame.rehearsing()) { // shadow maps do not depend on the camera
        if (!lights_.empty())
            frame.update(lightBuffer_, lights_.data(), lights_.size() * sizeof(shared::Light));
        shadows_.draw(frame, scene_, lights_, lightBuffer_);
        lightsChanged_ = frame.rehearsing();
    }
    surfaces_.draw(frame, view_, scene_, lightingInputs(), gbuffer);
    background_.draw(frame, viewBuffer_, environment_, gbuffer);
    gbuffer.resolve(frame);
    if (gbuffer.backDepth || frame.rehearsing())
        backFaces_.draw(frame, view_, viewBuffer_, scene_, gbufferOptions_.backFaceTransparents, gbuffer.backDepth);
    return gbuffer;
}

void Renderer::drawTransparent(gpu::Frame& frame, gpu::Image& hdr) {
    drawTransparent(frame, hdr, target_);
}

void Renderer::drawTransparent(gpu::Frame& frame, gpu::Image& hdr, RenderTarget& target) {
    transparent_.draw(frame, view_, scene_, lightingInputs(), target.gbuffer, target.behind, hdr);
}

Result<void> Renderer::makeLayers(uint32_t most) {
    if (layers_ && layersFit_ && layers_->count() == most)
        return {};
    layers_.reset();
    if (most == 0)
        return {};
    const gpu::Image& picture = target_.gbuffer.litRadiance;
    GLINT_TRY(layers, TransparentLayers::create(*context_, scene_, gbufferOptions_, shadowRays(), picture.width(),
                                                picture.height(), most));
    layers_ = std::move(layers);
    gpu::Frame frame = gpu::Frame::rehearsal(*context_);
    peelLayers(frame);
    drawLayer(frame, 0);
    layersFit_ = true;
    return frame.firstError();
}

void Renderer::peelLayers(gpu::Frame& frame) {
    layers_->peel(frame, scene_, viewBuffer_, target_.gbuffer);
}

LayerImages& Renderer::drawLayer(gpu::Frame& frame, uint32_t layer) {
    layers_->cover(frame, scene_, viewBuffer_, target_.gbuffer, layer);
    return layers_->draw(frame, scene_, lightingInputs(), layer);
}

void Renderer::display(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr) {
    display_.draw(frame, hdr, ldr, settings_.display);
}

} // namespace glint::render
