#include "render/run_job.hpp"

#include "base/assert.hpp"
#include "glint/glint.hpp"
#include "gpu/memory.hpp"
#include "gpu/transfer.hpp"
#include "render/find_mirrors.hpp"
#include "render/job_environment.hpp"
#include "render/job_inputs.hpp"
#include "render/lending.hpp"
#include "render/mirror_world.hpp"
#include "render/probe_world.hpp"
#include "render/ray_world.hpp"
#include "render/renderer.hpp"
#include "render/view_pass.hpp"
#include "render/views.hpp"

#include <algorithm>
#include <chrono>
#include <map>

namespace glint::render {
namespace {

/// Do both ask for the same environment, as it is made once and then kept?
bool sameEnvironment(const RenderSettings& a, const RenderSettings& b) {
    return a.environment.isProbe == b.environment.isProbe && a.analyticSky.elevation == b.analyticSky.elevation &&
           a.analyticSky.azimuth == b.analyticSky.azimuth && a.analyticSky.turbidity == b.analyticSky.turbidity;
}

/// Milliseconds of each pass over the frames, in the order in which they run.
class PassTimes {
public:
    void clear() { *this = {}; }
    void add(const std::string& name, double milliseconds) {
        if (times_.find(name) == times_.end())
            order_.push_back(name);
        std::vector<double>& all = times_[name];
        if (all.size() >= kMostFrames) // a window may stay open for days
            all.erase(all.begin(), all.begin() + kMostFrames / 2);
        all.push_back(milliseconds);
    }
    std::vector<std::pair<std::string, double>> medians() {
        std::vector<std::pair<std::string, double>> result;
        for (const std::string& name : order_) {
            std::vector<double>& all = times_[name];
            std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
            result.emplace_back(name, all[all.size() / 2]);
        }
        return result;
    }

private:
    static constexpr size_t kMostFrames = 4096;

    std::vector<std::string> order_;
    std::map<std::string, std::vector<double>> times_;
};

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

/// One job's objects, and the frame that they make.
struct JobSession::State {
    State(gpu::Context& context, RenderJob job) : context_(context), job_(std::move(job)) {}

    Result<void> load() {
        GLINT_TRY(inputs, loadJobInputs(job_));
        inputs_ = std::move(inputs);
        parameters_.camera = inputs_.camera;
        return {};
    }

    Result<void> create() {
        const RenderSettings& settings = job_.settings.render;
        context_.addShaders(gpu::shaders::render());
        GLINT_TRY(environment, makeEnvironment(context_, inputs_, settings));
        GLINT_TRY(renderer, Renderer::create(context_, *inputs_.scene, inputs_.pose, std::move(environment), settings));
        renderer_ = std::make_unique<Renderer>(std::move(renderer));
        GLINT_TRY(viewPass, ViewPass::create(context_));
        viewPass_ = std::move(viewPass);

        GLINT_TRY(library, adoptDevice(context_));
        library_ = std::make_unique<Context>(std::move(library));
        GLINT_CHECK(makeRayWorld());
        GLINT_CHECK(makeProbes());
        findMirrors();
        GLINT_CHECK(resizeGBuffer());
        GLINT_TRY(timers, gpu::Timers::create(context_));
        timers_ = std::move(timers);
        GLINT_CHECK(makeReflections());
        return makeTargets();
    }

    Result<void> setSettings(const ProgramSettings& settings) {
        const ProgramSettings before = std::exchange(job_.settings, settings);
        Result<void> done = applySettings(before.render);
        if (!done)
            job_.settings = before;
        return done;
    }

    Result<void> applySettings(const RenderSettings& before) {
        const RenderSettings& now = job_.settings.render;
        GLINT_CHECK(makeRayWorld());
        GLINT_CHECK(renderer_->setSettings(now));
        if (!sameEnvironment(before, now)) {
            GLINT_TRY(environment, makeEnvironment(context_, inputs_, now));
            GLINT_CHECK(renderer_->setEnvironment(std::move(environment)));
        }
        GLINT_CHECK(resizeGBuffer());
        passTimes_.clear();
        return makeReflections();
    }

    Result<void> resize(uint32_t width, uint32_t height) {
        inputs_.width = width;
        inputs_.height = height;
        GLINT_CHECK(resizeGBuffer());
        passTimes_.clear();
        GLINT_CHECK(makeReflections());
        return makeTargets();
    }

    Result<void> resizeGBuffer() {
        drawn_ = false;
        GLINT_CHECK(
            renderer_->resize(inputs_.width, inputs_.height,
                              gbufferOptions(job_.settings.reflections, job_.settings.render.display.antialias)));
        const int most = job_.settings.render.transparent.layers;
        return renderer_->makeLayers(refracts() ? static_cast<uint32_t>(most) : 0);
    }

    /// Is what comes through transparent surfaces the library's matter?
    bool refracts() const {
        const Settings& settings = job_.settings.reflections;
        return settings.refraction.enabled && !settings.debug.outcome && renderer_->scene().transmitsLight();
    }

    /// Made anew for other settings: some of them are decided when it is created.
    Result<void> makeReflections() {
        GLINT_TRY(reflections,
                  Reflections::create(*library_, {inputs_.width, inputs_.height, job_.settings.reflections,
                                                  job_.statistics, true, job_.inspect.has_value(), refracts()}));
        const auto old = std::exchange(reflections_, std::make_unique<Reflections>(std::move(reflections)));
        if (probeWorld_)
            GLINT_CHECK(reflections_->setProbes(probeWorld_->probes()));
        GLINT_CHECK(makeMirrors());
        return giveRays(); // and only then the old ones go, with the pipelines that both share
    }

    Result<void> giveRays() {
        if (job_.settings.reflections.rays.enabled) {
            GLINT_CHECK(rayWorld_->setLights(renderer_->lights()));
            GLINT_CHECK(reflections_->setRays(rayWorld_->rays(), rayWorld_->surfaces()));
        }
        retiredRayWorld_.reset();
        return {};
    }

    /// Once a pose: it looks at every triangle.
    void findMirrors() { mirrors_ = render::findMirrors(*inputs_.scene, inputs_.pose, job_.planar, kMaxPlanarMirrors); }
    /// The best of those that were found.
    std::vector<PlanarMirror> wantedMirrors() const {
        const auto most = static_cast<size_t>(job_.settings.render.mirrors.most);
        const size_t count = job_.settings.reflections.planar.enabled ? std::min(mirrors_.size(), most) : 0;
        return {mirrors_.begin(), mirrors_.begin() + static_cast<std::ptrdiff_t>(count)};
    }

    /// Their pictures are as large as the frame, and are drawn and reflect with its settings. Those that were there go
    /// when nothing knows them any more.
    Result<void> makeMirrors() {
        const auto old = std::move(mirrorWorld_);
        const std::vector<PlanarMirror> mirrors = wantedMirrors();
        if (mirrors.empty())
            return {};
        GLINT_TRY(world, MirrorWorld::create(context_, *library_, *renderer_, mirrors,
                                             probeWorld_ ? &probeWorld_->probes() : nullptr, job_.settings,
                                             inputs_.width, inputs_.height));
        mirrorWorld_ = std::make_unique<MirrorWorld>(std::move(world));
        return reflections_->setPlanar(mirrorWorld_->mirrors());
    }

    /// After things have moved.
    Result<void> moveMirrors() {
        findMirrors();
        const std::vector<PlanarMirror> mirrors = wantedMirrors();
        if (mirrorWorld_) {
            GLINT_TRY(fits, mirrorWorld_->setMirrors(mirrors));
            if (fits)
                return {};
        }
        return mirrors.empty() && !mirrorWorld_ ? Result<void>() : makeReflections();
    }

    /// Reads or bakes what the job asks for; once, as baking draws with the renderer.
    Result<void> makeProbes() {
        if (job_.probes.empty())
            return {};
        GLINT_TRY(world, ProbeWorld::create(context_, *library_, *renderer_, inputs_, job_));
        probeWorld_ = std::make_unique<ProbeWorld>(std::move(world));
        return {};
    }

    /// As soon as the settings ask for rays, to reflect or for shadows, and anew for another back end.
    Result<void> makeRayWorld() {
        const RaysSettings& settings = job_.settings.reflections.rays;
        if (!settings.enabled && job_.settings.render.lights.shadows != ShadowMode::Rays)
            return {};
        if (!rayWorld_ || settings.backend != rayBackend_) {
            GLINT_TRY(world, RayWorld::create(context_, *library_, renderer_->scene(), *inputs_.scene, inputs_.pose,
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

    Result<void> makeTargets() {
        const auto make = [&](const char* name, VkFormat format, VkImageUsageFlags usage) {
            return gpu::Image::create(context_, {name, format, inputs_.width, inputs_.height, 1, 1,
                                                 gpu::ImageShape::Flat, usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
        };
        GLINT_TRY(display, make("job/display", VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_STORAGE_BIT));
        display_ = std::move(display);
        GLINT_TRY(scene, make("job/scene", kRadianceFormat,
                              VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                  VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT));
        scene_ = std::move(scene);
        return {};
    }

    /// The frame of a host: its own opaque picture, the reflections, then what is blended over both.
    Result<FrameTimes> renderFrame(uint32_t index, const FramePlan& plan) {
        GLINT_ASSERT(plan.draw || drawn_, "the first frame has to be drawn");
        Result<void> inputsSet, inspected, mirrored, layered;
        const auto start = std::chrono::steady_clock::now();
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands, timers_.get());
            if (plan.draw && mirrorWorld_)
                mirrored = mirrorWorld_->record(commands, parameters_, inputs_.environment != EnvironmentKind::None,
                                                index, job_.seed);
            if (!mirrored)
                return;
            GBuffer& g = plan.draw ? renderer_->drawOpaque(frame, parameters_) : renderer_->gbuffer();
            if (plan.draw)
                frame.copy(g.litRadiance, scene_); // before anything is blended over it
            if (plan.afterOpaque)
                plan.afterOpaque(frame, g);
            if (!plan.reflect)
                return;
            inputsSet = reflections_->setInputs(lendGBuffer(frame, g), lendEnvironment(frame));
            if (!inputsSet)
                return;
            if (rayWorld_)
                rayWorld_->record(commands);
            const View view = renderer_->view(parameters_);
            HostImage lit = reflections_->record(commands, libraryView(view, index, job_.seed));
            if (plan.inspect) // before anything is blended over it
                inspected = reflections_->recordInspection(commands, (*plan.inspect)[0], (*plan.inspect)[1]);
            const bool blends = plan.draw && plan.blend;
            if (blends && renderer_->layers())
                layered = drawLayers(frame, commands, lit);
            composite_ = borrow(lit, "job/composite");
            if (blends && !renderer_->layers())
                renderer_->drawTransparent(frame, composite_);
            if (blends)
                renderer_->drawTransparent(frame, scene_);
            frame.hand(composite_, kSampled);
        }));
        FrameTimes times;
        times.wallMs = millisecondsSince(start);
        GLINT_CHECK(mirrored);
        GLINT_CHECK(inputsSet);
        GLINT_CHECK(inspected);
        GLINT_CHECK(layered);
        drawn_ = true;
        if (plan.draw)
            parameters_.prevCamera.reset();
        if (plan.draw && mirrorWorld_)
            times.hostPasses.emplace_back("mirrors", mirrorWorld_->milliseconds());
        for (const gpu::PassTime& time : timers_->latest())
            times.hostPasses.emplace_back(time.name, time.milliseconds);
        if (plan.reflect)
            for (const PassTime& time : reflections_->passTimes())
                times.effectPasses.emplace_back(time.name, time.milliseconds);
        for (const auto* passes : {&times.hostPasses, &times.effectPasses})
            for (const auto& [name, milliseconds] : *passes)
                passTimes_.add(name, milliseconds);
        return times;
    }

    /// Over `lit`, which the library returned; the farthest layer first.
    Result<void> drawLayers(gpu::Frame& frame, VkCommandBuffer commands, HostImage& lit) {
        TransparentLayers& layers = *renderer_->layers();
        renderer_->peelLayers(frame);
        for (uint32_t i = layers.count(); i-- > 0;) {
            LayerImages& images = renderer_->drawLayer(frame, i);
            const TransparentLayer layer = lendLayer(frame, layers.depth(i), images, layers.coverage());
            lendEnvironment(frame);
            GLINT_TRY(over, reflections_->recordLayer(commands, layer, lit));
            lit = over;
        }
        return {};
    }

    EnvironmentMap lendEnvironment(gpu::Frame& frame) {
        if (inputs_.environment == EnvironmentKind::None)
            return {};
        return lendEnvironmentMap(frame, renderer_->environment(), job_.settings.render.environment);
    }

    Result<RayInspection> inspect(uint32_t x, uint32_t y) {
        Result<void> inspected;
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands);
            lendGBuffer(frame, renderer_->gbuffer()); // blended surfaces may have left them in other layouts
            inspected = reflections_->recordInspection(commands, x, y);
        }));
        GLINT_CHECK(inspected);
        return reflections_->inspection();
    }

    void setCamera(const scene::Camera& camera) {
        if (!parameters_.prevCamera)
            parameters_.prevCamera = parameters_.camera;
        parameters_.camera = camera;
    }

    Result<void> setTime(double seconds) {
        GLINT_TRY(pose, scene::pose(*inputs_.scene, seconds));
        inputs_.pose = std::move(pose);
        job_.time = seconds;
        GLINT_CHECK(renderer_->setPose(*inputs_.scene, inputs_.pose));
        GLINT_CHECK(moveMirrors());
        if (!rayWorld_)
            return {};
        GLINT_TRY(kept, rayWorld_->setPose(renderer_->scene(), *inputs_.scene, inputs_.pose));
        if (kept) { // shadows by rays are drawn before the frame records what rays go through
            GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) { rayWorld_->record(commands); }));
            return giveRays();
        }
        const auto old = std::move(rayWorld_);
        GLINT_CHECK(makeRayWorld());
        if (!rayWorld_) // nobody asks for rays any more
            GLINT_CHECK(renderer_->setRayWorld(nullptr));
        return giveRays();
    }

    Result<void> showView(const std::string& name, gpu::Image& target) {
        GLINT_TRY(info, findView(name));
        Result<void> done;
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands);
            if (name == "composite" || name == "scene") {
                renderer_->display(frame, name == "composite" ? composite_ : scene_, target);
            } else if (name == "albedo") {
                viewPass_.draw(frame, renderer_->gbuffer().albedo, info->kind, target);
            } else if (const auto recorded = reflections_->recordView(commands, name); !recorded) {
                done = recorded.error();
                return;
            } else {
                gpu::Image image = borrow(*recorded, "job/view");
                if (info->kind == ViewKind::Radiance)
                    renderer_->display(frame, image, target);
                else
                    viewPass_.draw(frame, image, info->kind, target);
                frame.hand(image, kSampled);
            }
            frame.hand(composite_, kSampled); // as the library left it
            frame.hand(target, kSampled);
        }));
        return done;
    }

    Result<RenderedView> readView(const std::string& name) {
        GLINT_TRY(info, findView(name));
        RenderedView view;
        view.name = name;
        GBuffer& g = renderer_->gbuffer();
        if (name == "composite" || name == "scene") {
            gpu::Image& radiance = name == "composite" ? composite_ : scene_;
            GLINT_TRY(rgba, gpu::downloadImageAsFloats(context_, radiance));
            view.rgba = std::move(rgba);
            if (job_.display)
                GLINT_CHECK(displayInto(view, radiance));
            return view;
        }
        if (name == "albedo") {
            GLINT_TRY(rgba, gpu::downloadImageAsFloats(context_, g.albedo));
            view.rgba = std::move(rgba);
            return view;
        }
        Result<HostImage> recorded = HostImage{};
        GLINT_CHECK(context_.submitAndWait(
            [&](VkCommandBuffer commands) { recorded = reflections_->recordView(commands, name); }));
        GLINT_CHECK(recorded);
        gpu::Image image = borrow(*recorded, "job/view");
        GLINT_TRY(rgba, gpu::downloadImageAsFloats(context_, image));
        view.rgba = std::move(rgba);
        if (info->kind == ViewKind::Radiance && job_.display)
            GLINT_CHECK(displayInto(view, image));
        return context_.submitAndWait(
                   [&](VkCommandBuffer commands) { gpu::Frame(context_, commands).hand(image, kSampled); })
                   ? Result<RenderedView>(std::move(view))
                   : Result<RenderedView>(makeError(ErrorCode::DeviceLost, "view '{}' was lost with the device", name));
    }

    Result<void> displayInto(RenderedView& view, gpu::Image& radiance) {
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands);
            renderer_->display(frame, radiance, display_);
        }));
        GLINT_TRY(bytes, gpu::downloadImage(context_, display_));
        view.rgb8.reserve(bytes.size() / 4 * 3);
        for (size_t i = 0; i < bytes.size(); ++i)
            if (i % 4 != 3)
                view.rgb8.push_back(static_cast<uint8_t>(bytes[i]));
        return {};
    }

    RenderStats stats() {
        RenderStats stats;
        stats.device = context_.info().name;
        stats.driver = context_.info().driver;
        stats.software = context_.info().software;
        stats.passes = passTimes_.medians();
        const Statistics counted = reflections_->statistics();
        stats.rays = counted.rays;
        stats.lookupsPerRay = counted.lookupsMean;
        stats.lookups95 = counted.lookups95;
        stats.scene = counted.scene;
        for (const Statistics::Outcome& outcome : counted.outcomes)
            stats.outcomes.emplace_back(outcome.name, outcome.count);
        return stats;
    }

    gpu::Context& context_;
    RenderJob job_;
    JobInputs inputs_;
    ViewParameters parameters_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Context> library_;
    std::unique_ptr<ProbeWorld> probeWorld_;    ///< absent unless the job asks for probes
    std::unique_ptr<RayWorld> rayWorld_;        ///< absent until settings ask for rays
    std::unique_ptr<RayWorld> retiredRayWorld_; ///< the one before, as long as `reflections_` may know it
    RayBackend rayBackend_ = RayBackend::Auto;
    std::vector<PlanarMirror> mirrors_;        ///< that the pose has, the best first
    std::unique_ptr<MirrorWorld> mirrorWorld_; ///< absent unless the job asks for mirrors and the scene has some
    std::unique_ptr<Reflections> reflections_;
    std::unique_ptr<gpu::Timers> timers_;
    ViewPass viewPass_;
    gpu::Image composite_; ///< the library's, or our litRadiance when nothing reflects
    gpu::Image scene_;
    gpu::Image display_;
    PassTimes passTimes_;
    bool drawn_ = false; ///< the G-buffer holds a frame
};

JobSession::JobSession(std::unique_ptr<State> state) : state_(std::move(state)) {}
JobSession::~JobSession() = default;
JobSession::JobSession(JobSession&&) noexcept = default;
JobSession& JobSession::operator=(JobSession&&) noexcept = default;

Result<JobSession> JobSession::create(gpu::Context& context, const RenderJob& job) {
    auto state = std::make_unique<State>(context, job);
    GLINT_CHECK(state->load());
    GLINT_CHECK(state->create());
    return JobSession(std::move(state));
}

Result<void> JobSession::remake() {
    auto made = std::make_unique<State>(state_->context_, state_->job_);
    made->parameters_.camera = state_->parameters_.camera;
    made->inputs_ = std::move(state_->inputs_); // lent: both are never drawn from at a time
    if (auto created = made->create(); !created) {
        state_->inputs_ = std::move(made->inputs_);
        return created;
    }
    state_ = std::move(made);
    return {};
}

Result<void> JobSession::setSettings(const ProgramSettings& settings) {
    return state_->setSettings(settings);
}

Result<void> JobSession::resize(uint32_t width, uint32_t height) {
    return state_->resize(width, height);
}

void JobSession::setCamera(const scene::Camera& camera) {
    state_->setCamera(camera);
}

Result<void> JobSession::setTime(double seconds) {
    return state_->setTime(seconds);
}

Result<void> JobSession::showView(const std::string& name, gpu::Image& target) {
    return state_->showView(name, target);
}

Result<FrameTimes> JobSession::renderFrame(uint32_t index, const FramePlan& plan) {
    return state_->renderFrame(index, plan);
}

Result<RenderedView> JobSession::readView(const std::string& name) {
    return state_->readView(name);
}

RenderStats JobSession::stats() {
    return state_->stats();
}

Result<RayInspection> JobSession::inspect(uint32_t x, uint32_t y) {
    return state_->inspect(x, y);
}

RayInspection JobSession::inspection() const {
    return state_->reflections_->inspection();
}

const std::vector<std::string>& JobSession::notes() const {
    return state_->reflections_->notes();
}

size_t JobSession::deviceBytes() const {
    return gpu::allocatedBytes(state_->context_.allocator()) + gpu::allocatedBytes(state_->library_->gpu().allocator());
}

const JobInputs& JobSession::inputs() const {
    return state_->inputs_;
}

View JobSession::view() const {
    return state_->renderer_->view(state_->parameters_);
}

Result<RenderResult> runJob(gpu::Context& context, const RenderJob& job) {
    GLINT_TRY(session, JobSession::create(context, job));
    const JobInputs& inputs = session.inputs();
    if (job.inspect && ((*job.inspect)[0] >= inputs.width || (*job.inspect)[1] >= inputs.height))
        return invalidArgument("pixel {},{} lies outside the picture of {}x{}", (*job.inspect)[0], (*job.inspect)[1],
                               inputs.width, inputs.height);
    for (uint32_t i = 0; i < job.frames; ++i) {
        FramePlan plan;
        if (i + 1 == job.frames)
            plan.inspect = job.inspect;
        GLINT_CHECK(session.renderFrame(i, plan));
        if (job.progress)
            job.progress(i + 1, job.frames);
    }
    RenderResult result;
    result.width = session.inputs().width;
    result.height = session.inputs().height;
    for (const std::string& name : job.views) {
        GLINT_TRY(view, session.readView(name));
        result.views.push_back(std::move(view));
    }
    result.stats = session.stats();
    if (job.inspect)
        result.inspection = session.inspection();
    result.notes = session.notes();
    return result;
}

Result<RenderResult> runJob(const RenderJob& job) {
    GLINT_TRY(context, gpu::Context::create({job.device, job.validate}));
    Result<RenderResult> result = runJob(*context, job);
    if (result && !context->validationMessages().empty())
        return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                         context->validationMessages().size(), context->validationMessages().front());
    return result;
}

} // namespace glint::render
