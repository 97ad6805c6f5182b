#include "lab/session/scene_host.hpp"

#include "lab/job/job_environment.hpp"
#include "lab/renderer/lending.hpp"
#include "lab/renderer/lobes.hpp"

#include <algorithm>

namespace glint::render {
namespace {

/// True if both need the same environment, which is created once and then kept.
bool sameEnvironment(const RenderSettings& a, const RenderSettings& b) {
    return a.environment.isProbe == b.environment.isProbe && a.analyticSky.elevation == b.analyticSky.elevation &&
           a.analyticSky.azimuth == b.analyticSky.azimuth && a.analyticSky.turbidity == b.analyticSky.turbidity;
}

} // namespace

Result<std::unique_ptr<HostFrame>> SceneHost::create(gpu::Context& context, Context& library,
                                                     std::shared_ptr<JobInputs> inputs, const RenderJob& job) {
    std::unique_ptr<SceneHost> host(new SceneHost(context, library, std::move(inputs), job));
    GLINT_CHECK(host->make());
    return std::unique_ptr<HostFrame>(std::move(host));
}

Result<Renderer> SceneHost::makeRenderer() {
    const RenderSettings& settings = job_.settings.render;
    GLINT_TRY(environment, makeEnvironment(context_, *inputs_, settings, StrongLights::Taken));
    return Renderer::create(context_, *inputs_->scene, inputs_->pose, std::move(environment), settings);
}

Result<void> SceneHost::make() {
    context_.addShaders(gpu::shaders::render());
    GLINT_TRY(renderer, makeRenderer());
    renderer_ = std::make_unique<Renderer>(std::move(renderer));
    GLINT_CHECK(makeRayWorld());
    GLINT_CHECK(makeProbes());
    findMirrors();
    return resizeGBuffer();
}

Result<std::unique_ptr<HostFrame>> SceneHost::remade(Context& library) {
    std::unique_ptr<SceneHost> host(new SceneHost(context_, library, inputs_, job_));
    host->parameters_.camera = parameters_.camera;
    GLINT_CHECK(host->make());
    return std::unique_ptr<HostFrame>(std::move(host));
}

Result<void> SceneHost::setSettings(const ProgramSettings& settings) {
    const ProgramSettings before = std::exchange(job_.settings, settings);
    Result<void> done = applySettings(before.render);
    if (!done)
        job_.settings = before;
    return done;
}

Result<void> SceneHost::applySettings(const RenderSettings& before) {
    const RenderSettings& now = job_.settings.render;
    GLINT_CHECK(makeRayWorld());
    GLINT_CHECK(renderer_->setSettings(now));
    if (!sameEnvironment(before, now)) {
        GLINT_TRY(environment, makeEnvironment(context_, *inputs_, now, StrongLights::Taken));
        GLINT_CHECK(renderer_->setEnvironment(std::move(environment)));
    }
    return resizeGBuffer();
}

Result<void> SceneHost::resize(uint32_t width, uint32_t height) {
    inputs_->width = width;
    inputs_->height = height;
    return resizeGBuffer();
}

Result<void> SceneHost::resizeGBuffer() {
    const GBufferOptions options = gbufferOptions(job_.settings.reflections, job_.settings.render.display.antialias);
    GLINT_CHECK(renderer_->resize(inputs_->width, inputs_->height, withLobes(options, *inputs_->scene)));
    const int most = job_.settings.render.transparent.layers;
    return renderer_->makeLayers(hasLayers() ? static_cast<uint32_t>(most) : 0);
}

Result<void> SceneHost::setCamera(const scene::Camera& camera) {
    if (!parameters_.prevCamera)
        parameters_.prevCamera = parameters_.camera;
    parameters_.camera = camera;
    return {};
}

void SceneHost::setJitter(glm::vec2 jitterPX) {
    if (jitterPX == parameters_.jitterPX)
        return;
    if (!parameters_.prevCamera) // at rest, which is the frame before with its own shift
        parameters_.prevCamera = parameters_.camera;
    parameters_.prevJitterPX = parameters_.jitterPX;
    parameters_.jitterPX = jitterPX;
}

Result<bool> SceneHost::setTime(double seconds, Reflections& reflections) {
    GLINT_TRY(pose, scene::pose(*inputs_->scene, seconds));
    inputs_->pose = std::move(pose);
    job_.time = seconds;
    GLINT_CHECK(renderer_->setPose(*inputs_->scene, inputs_->pose));
    GLINT_TRY(mirrorsFit, moveMirrors());
    if (rayWorld_)
        GLINT_CHECK(moveRays(reflections));
    return mirrorsFit;
}

Result<bool> SceneHost::setMaterials(const scene::MaterialOverrides& overrides, Reflections&) {
    render::setMaterials(*inputs_, overrides);
    GLINT_TRY(kept, renderer_->setMaterials(*inputs_->scene, inputs_->pose));
    if (!kept) {
        GLINT_CHECK(remakeRenderer());
        return false;
    }
    if (rayWorld_) {
        GLINT_CHECK(rayWorld_->setMaterials(renderer_->scene(), *inputs_->scene, inputs_->pose));
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) { rayWorld_->record(commands); }));
    }
    const bool hadLobes = bool(renderer_->gbuffer().lobes);
    GLINT_CHECK(resizeGBuffer()); // the first clear coat needs images of its own
    GLINT_TRY(mirrorsFit, moveMirrors());
    return mirrorsFit && hadLobes == bool(renderer_->gbuffer().lobes);
}

/// Keeps the renderer's address, which mirrors refer to until giveSources replaces them.
Result<void> SceneHost::remakeRenderer() {
    GLINT_TRY(renderer, makeRenderer());
    *renderer_ = std::move(renderer);
    if (rayWorld_)
        retiredRayWorld_ = std::move(rayWorld_); // refers to the previous renderer's buffers
    GLINT_CHECK(makeRayWorld());
    findMirrors();
    return resizeGBuffer();
}

/// Called once per pose and change of materials, as it visits every triangle.
void SceneHost::findMirrors() {
    mirrors_ = render::findMirrors(*inputs_->scene, inputs_->pose, job_.planar, kMaxPlanarMirrors);
}

/// Returns the best of the mirrors found.
std::vector<PlanarMirror> SceneHost::wantedMirrors() const {
    const auto most = static_cast<size_t>(job_.settings.render.mirrors.most);
    const size_t count = job_.settings.reflections.planar.enabled ? std::min(mirrors_.size(), most) : 0;
    return {mirrors_.begin(), mirrors_.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// The mirrored views have the size and settings of the frame. The previous mirrors are destroyed once nothing refers
/// to them.
Result<void> SceneHost::makeMirrors(Reflections& reflections) {
    const auto old = std::move(mirrorWorld_);
    const std::vector<PlanarMirror> mirrors = wantedMirrors();
    if (mirrors.empty())
        return {};
    GLINT_TRY(world, MirrorWorld::create(context_, library_, *renderer_, mirrors,
                                         probeWorld_ ? &probeWorld_->probes() : nullptr, job_.settings, inputs_->width,
                                         inputs_->height));
    mirrorWorld_ = std::make_unique<MirrorWorld>(std::move(world));
    return reflections.setPlanar(mirrorWorld_->mirrors());
}

/// Call after objects have moved. Returns false if the number of mirrors has changed.
Result<bool> SceneHost::moveMirrors() {
    findMirrors();
    const std::vector<PlanarMirror> mirrors = wantedMirrors();
    return mirrorWorld_ ? mirrorWorld_->setMirrors(mirrors) : Result<bool>(mirrors.empty());
}

/// Reads or bakes the probes of the job; called once, as baking draws with the renderer.
Result<void> SceneHost::makeProbes() {
    if (job_.probes.empty())
        return {};
    GLINT_TRY(world, ProbeWorld::create(context_, library_, *renderer_, *inputs_, job_));
    probeWorld_ = std::make_unique<ProbeWorld>(std::move(world));
    return {};
}

/// Called when the settings enable rays, for reflections or shadows, and again for another back end.
Result<void> SceneHost::makeRayWorld() {
    const RaysSettings& settings = job_.settings.reflections.rays;
    if (!settings.enabled && job_.settings.render.lights.shadows != ShadowMode::Rays)
        return {};
    if (!rayWorld_ || settings.backend != rayBackend_) {
        GLINT_TRY(world, RayWorld::create(context_, library_, renderer_->scene(), *inputs_->scene, inputs_->pose,
                                          renderer_->lights(), settings.backend));
        if (rayWorld_)
            retiredRayWorld_ = std::move(rayWorld_);
        rayWorld_ = std::make_unique<RayWorld>(std::move(world));
        rayBackend_ = settings.backend;
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) { rayWorld_->record(commands); }));
        rayWorld_->releaseStaging();
    }
    return renderer_->setRayWorld(rayWorld_.get());
}

/// Call after objects have moved.
Result<void> SceneHost::moveRays(Reflections& reflections) {
    GLINT_TRY(kept, rayWorld_->setPose(renderer_->scene(), *inputs_->scene, inputs_->pose));
    if (kept) { // ray-traced shadows are drawn before the frame records the ray scene
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) { rayWorld_->record(commands); }));
        reflections.restartAccumulation();
        return rayWorld_->setLights(renderer_->lights());
    }
    retiredRayWorld_ = std::move(rayWorld_);
    GLINT_CHECK(makeRayWorld());
    if (!rayWorld_) // rays are no longer enabled
        GLINT_CHECK(renderer_->setRayWorld(nullptr));
    return giveRays(reflections);
}

Result<void> SceneHost::giveRays(Reflections& reflections) {
    if (job_.settings.reflections.rays.enabled) {
        GLINT_CHECK(rayWorld_->setLights(renderer_->lights()));
        GLINT_CHECK(reflections.setRays(rayWorld_->rays(), rayWorld_->surfaces()));
    }
    retiredRayWorld_.reset();
    return {};
}

Result<void> SceneHost::giveSources(Reflections& reflections) {
    if (probeWorld_)
        GLINT_CHECK(reflections.setProbes(probeWorld_->probes()));
    GLINT_CHECK(makeMirrors(reflections));
    return giveRays(reflections);
}

/// True if the library refracts through transparent surfaces.
bool SceneHost::hasLayers() const {
    const Settings& settings = job_.settings.reflections;
    return settings.refraction.enabled && !settings.debug.outcome && renderer_->scene().transmitsLight();
}

/// True if the library needs the depth of the nearest layer before it reflects.
bool SceneHost::showsLayerDepth() const {
    return job_.settings.reflections.screen.transparents && renderer_->layers() != nullptr;
}

Result<void> SceneHost::draw(gpu::Frame& frame, VkCommandBuffer commands, uint32_t frameIndex) {
    if (mirrorWorld_)
        GLINT_CHECK(mirrorWorld_->record(commands, parameters_, inputs_->environment != EnvironmentKind::None,
                                         frameIndex, job_.seed));
    renderer_->drawOpaque(frame, parameters_);
    if (showsLayerDepth())
        renderer_->peelLayers(frame);
    parameters_.prevCamera.reset();
    return {};
}

glint::GBuffer SceneHost::lend(gpu::Frame& frame) {
    glint::GBuffer lent = lendGBuffer(frame, renderer_->gbuffer());
    if (showsLayerDepth())
        lent.transparentDepth = render::lend(frame, renderer_->layers()->depth(0));
    return lent;
}

EnvironmentMap SceneHost::lendEnvironment(gpu::Frame& frame) {
    if (inputs_->environment == EnvironmentKind::None)
        return {};
    return lendEnvironmentMap(frame, renderer_->environment(), job_.settings.render.environment);
}

void SceneHost::recordSources(VkCommandBuffer commands) {
    if (rayWorld_)
        rayWorld_->record(commands);
}

/// Draws the farthest layer first.
Result<HostImage> SceneHost::drawLayers(gpu::Frame& frame, VkCommandBuffer commands, Reflections& reflections,
                                        HostImage lit) {
    if (!renderer_->layers())
        return lit;
    TransparentLayers& layers = *renderer_->layers();
    if (!showsLayerDepth())
        renderer_->peelLayers(frame);
    for (uint32_t i = layers.count(); i-- > 0;) {
        LayerImages& images = renderer_->drawLayer(frame, i);
        const TransparentLayer layer = lendLayer(frame, layers.depth(i), images, layers.coverage());
        lendEnvironment(frame);
        GLINT_TRY(over, reflections.recordLayer(commands, layer, lit));
        lit = over;
    }
    return lit;
}

void SceneHost::drawTransparent(gpu::Frame& frame, gpu::Image& picture, bool overLayers) {
    if (!overLayers || !renderer_->layers())
        renderer_->drawTransparent(frame, picture);
}

void SceneHost::display(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& target) {
    renderer_->display(frame, radiance, target);
}

std::vector<std::pair<std::string, double>> SceneHost::passTimes() {
    if (!mirrorWorld_)
        return {};
    return {{"mirrors", mirrorWorld_->milliseconds()}};
}

} // namespace glint::render
