#include "lab/session/reflection_session.hpp"

#include "base/assert.hpp"
#include "base/elapsed.hpp"
#include "glint/glint.hpp"
#include "gpu/memory.hpp"
#include "lab/renderer/lending.hpp"

#include <utility>

namespace glint::render {

Result<ReflectionSession> ReflectionSession::create(gpu::Context& context, const MakeHost& makeHost,
                                                    const SessionOptions& options) {
    ReflectionSession session(context, options);
    GLINT_TRY(objects, session.makeObjects(makeHost));
    session.objects_ = std::move(objects);
    return session;
}

Result<std::unique_ptr<ReflectionSession::Objects>> ReflectionSession::makeObjects(const MakeHost& makeHost) const {
    context_->addShaders(gpu::shaders::render());
    GLINT_TRY(views, FrameViews::create(*context_));
    auto objects = std::make_unique<Objects>(std::move(views));
    GLINT_TRY(library, adoptDevice(*context_));
    objects->library = std::move(library);
    GLINT_TRY(host, makeHost(*objects->library));
    objects->host = std::move(host);
    GLINT_TRY(timers, gpu::Timers::create(*context_));
    objects->timers = std::move(timers);
    GLINT_CHECK(makeReflections(*objects));
    GLINT_CHECK(objects->views.resize(objects->host->inputs().width, objects->host->inputs().height));
    return objects;
}

/// Creates new Reflections for other settings: some settings take effect only at creation.
Result<void> ReflectionSession::makeReflections(Objects& objects) const {
    const JobInputs& inputs = objects.host->inputs();
    ReflectionsDesc desc = {inputs.width, inputs.height, options_.settings.reflections};
    desc.statistics = options_.statistics;
    desc.views = options_.libraryViews;
    desc.inspection = options_.inspect;
    desc.transparentLayers = objects.host->hasLayers();
    desc.framesInFlight = 1; // the session waits for every frame
    GLINT_TRY(reflections, Reflections::create(*objects.library, desc));
    const auto old = std::exchange(objects.reflections, std::make_unique<Reflections>(std::move(reflections)));
    // The old Reflections are destroyed only after that, with the sources that both share.
    return objects.host->giveSources(*objects.reflections);
}

Result<void> ReflectionSession::remake() {
    GLINT_TRY(objects, makeObjects([&](Context& library) { return objects_->host->remade(library); }));
    objects_ = std::move(objects);
    passTimes_.clear();
    drawn_ = false;
    return {};
}

Result<void> ReflectionSession::setSettings(const ProgramSettings& settings) {
    drawn_ = false;
    GLINT_CHECK(objects_->host->setSettings(settings));
    passTimes_.clear();
    const ProgramSettings before = std::exchange(options_.settings, settings);
    Result<void> done = makeReflections(*objects_);
    if (!done)
        options_.settings = before;
    return done;
}

Result<void> ReflectionSession::resize(uint32_t width, uint32_t height) {
    drawn_ = false;
    GLINT_CHECK(objects_->host->resize(width, height));
    passTimes_.clear();
    GLINT_CHECK(makeReflections(*objects_));
    return objects_->views.resize(width, height);
}

Result<void> ReflectionSession::setStatistics(bool statistics) {
    passTimes_.clear();
    const bool before = std::exchange(options_.statistics, statistics);
    Result<void> done = makeReflections(*objects_);
    if (!done)
        options_.statistics = before;
    return done;
}

Result<void> ReflectionSession::restart(uint32_t seed) {
    options_.seed = seed;
    objects_->host->setSeed(seed);
    passTimes_.clear();
    return makeReflections(*objects_);
}

void ReflectionSession::restartAccumulation(uint32_t seed) {
    options_.seed = seed;
    objects_->host->setSeed(seed);
    objects_->reflections->restartAccumulation();
}

Result<void> ReflectionSession::setCamera(const scene::Camera& camera) {
    moved_ = true;
    return objects_->host->setCamera(camera);
}

Result<void> ReflectionSession::setTime(double seconds) {
    moved_ = true;
    GLINT_TRY(sourcesFit, objects_->host->setTime(seconds, *objects_->reflections));
    return sourcesFit ? Result<void>() : makeReflections(*objects_);
}

Result<void> ReflectionSession::setMaterials(const scene::MaterialOverrides& overrides) {
    drawn_ = false;
    passTimes_.clear();
    GLINT_TRY(sourcesFit, objects_->host->setMaterials(overrides, *objects_->reflections));
    return sourcesFit ? Result<void>() : makeReflections(*objects_);
}

std::vector<std::string> ReflectionSession::notes() const {
    std::vector<std::string> notes = objects_->reflections->notes();
    notes.insert(notes.end(), inputs().notes.begin(), inputs().notes.end());
    return notes;
}

/// A host's frame: its opaque image, the reflections, then the surfaces blended over both.
Result<FrameTimes> ReflectionSession::renderFrame(uint32_t index, const FrameRequest& request) {
    GLINT_ASSERT(request.draw || drawn_, "the first frame has to be drawn");
    HostFrame& host = *objects_->host;
    Reflections& reflections = *objects_->reflections;
    FrameViews& views = objects_->views;
    if (request.draw)
        host.setJitter(request.mean.jitterPX);
    if (request.mean.adds)
        GLINT_CHECK(views.prepareMean(request.mean.restarts));
    else
        views.endMean();
    const auto record = [&](VkCommandBuffer commands) -> Result<void> {
        gpu::Frame frame(*context_, commands, objects_->timers.get());
        if (request.draw)
            GLINT_CHECK(host.draw(frame, commands, index));
        GBuffer& g = host.gbuffer();
        if (request.draw)
            views.keepScene(frame, g);
        if (request.afterOpaque)
            request.afterOpaque(frame, g);
        if (!request.reflect)
            return {};
        const glint::GBuffer lent = host.lend(frame);
        GLINT_CHECK(reflections.setInputs(lent, host.lendEnvironment(frame)));
        host.recordSources(commands);
        HostImage lit = reflections.record(commands, libraryView(host.view(), index, options_.seed));
        if (request.inspect) // before anything is blended over it
            GLINT_CHECK(reflections.recordInspection(commands, (*request.inspect)[0], (*request.inspect)[1]));
        const bool blends = request.draw ? request.blend : request.blendAgain;
        if (blends) {
            GLINT_TRY(over, host.drawLayers(frame, commands, reflections, lit));
            lit = over;
        }
        views.setComposite(borrow(lit, "job/composite"));
        if (blends) {
            host.drawTransparent(frame, views.composite(), true);
            if (request.draw)
                host.drawTransparent(frame, views.scene(), false);
        }
        if (request.mean.adds)
            views.addToMean(frame, host);
        frame.hand(views.composite(), kSampled);
        return {};
    };
    Result<void> recorded;
    const auto start = std::chrono::steady_clock::now();
    GLINT_CHECK(context_->submitAndWait([&](VkCommandBuffer commands) { recorded = record(commands); }));
    FrameTimes times;
    times.wallMs = millisecondsSince(start);
    GLINT_CHECK(recorded);
    drawn_ = true;
    if (request.draw)
        moving_ = std::exchange(moved_, false);
    if (request.draw)
        times.hostPasses = host.passTimes();
    for (const gpu::PassTime& time : objects_->timers->latest())
        times.hostPasses.emplace_back(time.name, time.milliseconds);
    if (request.reflect)
        for (const PassTime& time : reflections.passTimes())
            times.effectPasses.emplace_back(time.name, time.milliseconds);
    for (const auto* passes : {&times.hostPasses, &times.effectPasses})
        for (const auto& [name, milliseconds] : *passes)
            passTimes_.add(name, milliseconds);
    return times;
}

Result<void> ReflectionSession::showView(const std::string& name, gpu::Image& target) {
    return objects_->views.show(name, *objects_->host, *objects_->reflections, target);
}

Result<RenderedView> ReflectionSession::readView(const std::string& name) {
    return objects_->views.read(name, *objects_->host, *objects_->reflections, options_.display);
}

Result<RayInspection> ReflectionSession::inspect(uint32_t x, uint32_t y) {
    Result<void> inspected;
    GLINT_CHECK(context_->submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(*context_, commands);
        objects_->host->lend(frame); // blended surfaces may have left it in other layouts
        inspected = objects_->reflections->recordInspection(commands, x, y);
    }));
    GLINT_CHECK(inspected);
    return inspection();
}

RenderStats ReflectionSession::stats() const {
    RenderStats stats;
    stats.device = context_->info().name;
    stats.driver = context_->info().driver;
    stats.software = context_->info().software;
    stats.passes = passTimes_.medians();
    stats.memory = objects_->library->memory();
    stats.plan = objects_->reflections->plan();
    const Statistics counted = objects_->reflections->statistics();
    stats.rays = counted.rays;
    stats.lookupsPerRay = counted.lookupsMean;
    stats.lookups95 = counted.lookups95;
    stats.scene = counted.scene;
    for (const Statistics::Outcome& outcome : counted.outcomes)
        stats.outcomes.emplace_back(outcome.name, outcome.count);
    return stats;
}

size_t ReflectionSession::deviceBytes() const {
    return gpu::allocatedBytes(context_->allocator()) + gpu::allocatedBytes(objects_->library->gpu().allocator());
}

} // namespace glint::render
