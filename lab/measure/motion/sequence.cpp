#include "lab/measure/motion/sequence.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "lab/measure/motion/surface_motion.hpp"
#include "lab/measure/truth/radiance_film.hpp"
#include "lab/scene/animation_sampling.hpp"
#include "lab/session/run_job.hpp"

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

Result<scene::CameraPath> makePath(const SequencePlan& plan, const render::JobInputs& inputs) {
    const SequencePath& path = plan.path;
    if (!path.keys.empty())
        return scene::CameraPath::through(path.keys, inputs.camera);
    const double focus = scene::focusDistance(inputs.camera, inputs.pose.boundsWS);
    const double speed = scene::focusSpeed(inputs.camera, focus, inputs.height, path.pixelsPerFrame, plan.fps);
    const double middle = std::min(plan.frames - 1, path.stop) / plan.fps / 2;
    return scene::CameraPath::move(path.move, inputs.camera, speed, focus, middle);
}

/// The first frames that show a stepped animation changing.
std::vector<uint32_t> stepFrames(const SequencePlan& plan, const scene::Scene& scene) {
    std::vector<uint32_t> frames;
    for (const double seconds : scene::stepTimes(scene)) {
        const double frame = std::ceil((seconds - plan.configs.front().job.time) * plan.fps - 1e-6);
        if (frame >= 1 && frame < plan.frames && (frames.empty() || frames.back() != frame))
            frames.push_back(static_cast<uint32_t>(frame));
    }
    return frames;
}

Result<void> checkMemory(const SequencePlan& plan, const render::JobInputs& inputs) {
    constexpr double kMost = 16e9, kFilms = 3 * kSignals, kBytesPerPixel = 3 * sizeof(uint16_t);
    const double bytes = kFilms * kBytesPerPixel * inputs.width * inputs.height * plan.frames;
    if (plan.measure && bytes > kMost)
        return invalidArgument("{} frames of {}x{} take {:.0f} GB to measure; the most is {:.0f}: lower --frames or "
                               "--size",
                               plan.frames, inputs.width, inputs.height, bytes / 1e9, kMost / 1e9);
    return {};
}

Result<void> checkStored(const SequencePlan& plan, const render::JobInputs& inputs) {
    for (const auto& [config, stored] : plan.stored) {
        GLINT_ASSERT(config < plan.configs.size() && plan.measure && stored.frames() >= plan.frames,
                     "config {}: {} stored frames of {}", config, stored.frames(), plan.frames);
        if (stored.width() != inputs.width || stored.height() != inputs.height)
            return invalidInput("{}: frames of {}x{}, but the sequence has {}x{}: state --size {}x{}, or other frames",
                                printable(plan.configs[config].name), stored.width(), stored.height(), inputs.width,
                                inputs.height, stored.width(), stored.height());
        for (size_t seed = 0; seed < stored.seeds(); ++seed) // takes seconds, and the reference minutes
            for (uint32_t frame = 0; frame < plan.frames; ++frame)
                GLINT_CHECK(stored.read(seed, frame));
    }
    return {};
}

/// The settings with no source of reflections: enough for the surfaces of a frame.
render::ProgramSettings surfacesAlone(render::ProgramSettings settings) {
    Settings& reflections = settings.reflections;
    reflections.screen.enabled = reflections.rays.enabled = reflections.planar.enabled = false;
    reflections.probes.enabled = reflections.sky.enabled = reflections.denoise.enabled = false;
    return settings;
}

/// Implements renderSequence: the reference, then config by config, on one session.
class Sequencer {
public:
    Sequencer(render::ReflectionSession session, scene::CameraPath path, const SequencePlan& plan,
              const SequenceCallbacks& callbacks)
        : session_(std::move(session)), path_(std::move(path)), plan_(plan), callbacks_(callbacks),
          tracker_(*session_.inputs().scene), surfaces_(plan.frames) {}

    Result<Sequence> run(const gpu::Context& context) {
        describe(context);
        if (plan_.reference)
            GLINT_CHECK(renderReference());
        for (size_t i = 0; i < plan_.configs.size(); ++i)
            GLINT_CHECK(plan_.stored.contains(i) ? readConfig(i) : renderConfig(i));
        return std::move(result_);
    }

private:
    /// What the frames show, whatever the config.
    struct Surfaces {
        PixelBands bands;
        SurfaceMotion motion; ///< since the frame before
    };
    using Films = std::array<RadianceFilm, kSignals>;
    using Views = std::array<render::RenderedView, kSignals>;

    void describe(const gpu::Context& context) {
        result_.scene = plan_.configs.front().job.scene;
        result_.width = session_.inputs().width;
        result_.height = session_.inputs().height;
        result_.frames = plan_.frames;
        result_.fps = plan_.fps;
        result_.device = context.info().name;
        result_.driver = context.info().driver;
        result_.software = context.info().software;
        result_.warmUp = plan_.warmUp;
        result_.steps = stepFrames(plan_, *session_.inputs().scene);
    }

    Result<void> renderReference() {
        const ComparedConfig& reference = *plan_.reference;
        result_.reference = reference.name;
        result_.referenceFrames = reference.job.frames;
        const uint32_t seed = plan_.configs.front().job.seed;
        reference_.emplace(std::array{seed + 2, seed + 3}, reference.job.frames); // configs have the two before
        GLINT_CHECK(session_.setSettings(reference.job.settings));
        GLINT_CHECK(standAtStart());
        for (uint32_t frame = 0; frame < plan_.frames; ++frame) {
            GLINT_CHECK(moveTo(frame));
            GLINT_CHECK(reference_->add(session_));
            showProgress("reference " + reference.name, frame);
        }
        return {};
    }

    Result<void> renderConfig(size_t index) {
        const ComparedConfig& config = plan_.configs[index];
        SequenceConfig done;
        done.name = config.name;
        done.settings = config.job.settings;
        GLINT_CHECK(session_.setSettings(config.job.settings));
        Films films;
        GLINT_CHECK(renderFrames(index, config.job.seed, [&](uint32_t frame, Views& views) {
            return keepFrame(index, frame, views, films, done);
        }));
        done.raysPerPixel /= double(plan_.frames) * result_.width * result_.height;
        done.notes = session_.notes();
        if (plan_.measure) {
            std::vector<MotionMeter> meters(kSignals, MotionMeter(plan_.warmUp, result_.steps));
            GLINT_CHECK(renderFrames(index, config.job.seed + 1, [&](uint32_t frame, Views& views) -> Result<void> {
                for (size_t signal = 0; signal < kSignals; ++signal)
                    meters[signal].add(
                        motionFrame(frame, signal, {films[signal].frame(frame), radianceOf(views[signal].rgba)}),
                        surfaces_[frame].motion);
                return {};
            }));
            for (const MotionMeter& meter : meters)
                done.figures.push_back(meter.figures());
        }
        result_.configs.push_back(std::move(done));
        return {};
    }

    /// Measures stored frames. A signal that the files lack has no figures.
    Result<void> readConfig(size_t index) {
        const ComparedConfig& config = plan_.configs[index];
        const StoredFrames& stored = plan_.stored.at(index);
        GLINT_CHECK(seeSurfaces(config));
        SequenceConfig done;
        done.name = config.name;
        done.settings = config.job.settings;
        done.storedSeeds = stored.seeds();
        std::vector<MotionMeter> meters(kSignals, MotionMeter(plan_.warmUp, result_.steps));
        for (uint32_t frame = 0; frame < plan_.frames; ++frame) {
            std::array<std::array<Radiance, 2>, kSignals> test;
            for (size_t seed = 0; seed < 2; ++seed) {
                if (seed >= stored.seeds()) {
                    for (auto& signal : test)
                        signal[seed] = signal[0];
                    continue;
                }
                GLINT_TRY(picture, stored.read(seed, frame));
                test[static_cast<size_t>(Signal::Reflection)][seed] = radianceOf(picture.reflection);
                test[static_cast<size_t>(Signal::Composite)][seed] = radianceOf(picture.composite);
            }
            for (size_t signal = 0; signal < kSignals; ++signal)
                if (!test[signal][0]->empty())
                    meters[signal].add(motionFrame(frame, signal, test[signal]), surfaces_[frame].motion);
            showProgress(config.name, frame);
        }
        for (const MotionMeter& meter : meters)
            done.figures.push_back(stored.seeds() == 1 ? ofOneSeed(meter.figures()) : meter.figures());
        if (stored.seeds() == 1)
            done.notes.emplace_back("frames of one seed: bias, noise, flicker, swim and sharp are unknown");
        result_.configs.push_back(std::move(done));
        return {};
    }

    /// Draws what the frames show, unless an earlier config has.
    Result<void> seeSurfaces(const ComparedConfig& config) {
        if (surfaces_.front().bands)
            return {};
        GLINT_CHECK(session_.setSettings(surfacesAlone(config.job.settings)));
        GLINT_CHECK(session_.restart(config.job.seed));
        GLINT_CHECK(standAtStart());
        for (uint32_t frame = 0; frame < plan_.frames; ++frame) {
            GLINT_CHECK(moveTo(frame));
            GLINT_TRY(times, session_.renderFrame(frame));
            GLINT_CHECK(readSurfaces(frame));
            showProgress("surfaces", frame);
        }
        return {};
    }

    /// A frame of the first seed.
    Result<void> keepFrame(size_t index, uint32_t frame, const Views& views, Films& films, SequenceConfig& done) {
        done.times.add(times_);
        done.times.addDrawn(times_);
        const render::RenderStats stats = session_.stats();
        done.raysPerPixel += static_cast<double>(stats.rays + stats.scene.rays);
        if (callbacks_.frame)
            GLINT_CHECK(callbacks_.frame({index, frame, result_.width, result_.height,
                                          views[static_cast<size_t>(Signal::Composite)],
                                          views[static_cast<size_t>(Signal::Reflection)]}));
        if (!plan_.measure)
            return {};
        for (size_t signal = 0; signal < kSignals; ++signal)
            films[signal].add(radianceOf(views[signal].rgba));
        return surfaces_[frame].bands ? Result<void>() : readSurfaces(frame);
    }

    Result<void> readSurfaces(uint32_t frame) {
        GLINT_TRY(roughness, session_.readView("roughness"));
        GLINT_TRY(reflectivity, session_.readView("reflectivity"));
        surfaces_[frame].bands = pixelBands(roughness.rgba, reflectivity.rgba);
        if (!plan_.reference) // no figure needs the motion
            return {};
        GLINT_TRY(motion, tracker_.advance(secondsOf(frame), session_.view()));
        surfaces_[frame].motion = std::move(motion);
        return {};
    }

    MotionFrame motionFrame(uint32_t frame, size_t signal, std::array<Radiance, 2> test) const {
        MotionFrame made{result_.width, result_.height, std::move(test), {}, surfaces_[frame].bands};
        if (reference_)
            made.reference = reference_->frame(static_cast<Signal>(signal), frame);
        return made;
    }

    /// Renders every frame from the start, without history before the first.
    Result<void> renderFrames(size_t index, uint32_t seed,
                              const std::function<Result<void>(uint32_t frame, Views& views)>& use) {
        const std::string& name = plan_.configs[index].name;
        GLINT_CHECK(session_.restart(seed));
        GLINT_CHECK(standAtStart());
        SequenceMoment previous = {secondsOf(0), session_.view()};
        for (uint32_t frame = 0; frame < plan_.frames; ++frame) {
            GLINT_CHECK(moveTo(frame));
            GLINT_TRY(times, session_.renderFrame(frame));
            times_ = std::move(times);
            Views views;
            for (size_t signal = 0; signal < kSignals; ++signal) {
                GLINT_TRY(view, session_.readView(kSignalViews[signal]));
                views[signal] = std::move(view);
            }
            GLINT_CHECK(use(frame, views));
            SequenceMoment now = {secondsOf(frame), session_.view()};
            GLINT_CHECK(giveViews(index, seed, frame, now, previous));
            previous = std::move(now);
            showProgress(plan_.measure ? fmt::format("{}, seed {}", name, seed) : name, frame);
        }
        return {};
    }

    /// Reads the plan's further views of the frame.
    Result<void> giveViews(size_t index, uint32_t seed, uint32_t frame, const SequenceMoment& now,
                           const SequenceMoment& previous) {
        if (plan_.views.empty() || !callbacks_.views)
            return {};
        std::vector<render::RenderedView> views;
        for (const std::string& name : plan_.views) {
            GLINT_TRY(view, session_.readView(name));
            views.push_back(std::move(view));
        }
        return callbacks_.views({index, seed, frame, now, previous, views});
    }

    /// Draws the first frame's view once without reflections, so that the first frame shows no motion.
    Result<void> standAtStart() {
        GLINT_CHECK(moveTo(0));
        render::FrameRequest draw;
        draw.reflect = false;
        GLINT_TRY(times, session_.renderFrame(0, draw));
        return {};
    }

    double secondsOf(uint32_t frame) const { return plan_.configs.front().job.time + frame / plan_.fps; }

    Result<void> moveTo(uint32_t frame) {
        if (!session_.inputs().scene->animations.empty())
            GLINT_CHECK(session_.setTime(secondsOf(frame)));
        return session_.setCamera(path_.at(std::min(frame, plan_.path.stop) / plan_.fps));
    }

    void showProgress(const std::string& what, uint32_t frame) const {
        if (callbacks_.progress)
            callbacks_.progress(what, frame + 1, plan_.frames);
    }

    render::ReflectionSession session_;
    scene::CameraPath path_;
    const SequencePlan& plan_;
    const SequenceCallbacks& callbacks_;
    SurfaceTracker tracker_;
    std::vector<Surfaces> surfaces_; ///< by frame, from the first config
    std::optional<SequenceReference> reference_;
    render::FrameTimes times_; ///< of the last frame
    Sequence result_;
};

} // namespace

Result<Sequence> renderSequence(gpu::Context& context, const SequencePlan& plan, const SequenceCallbacks& callbacks) {
    render::RenderJob first = plan.configs.front().job;
    first.statistics = true;
    if (plan.stored.contains(0)) // programs that it does not need take seconds to compile
        first.settings = surfacesAlone(first.settings);
    GLINT_TRY(session, render::openJob(context, first));
    GLINT_CHECK(checkMemory(plan, session.inputs()));
    GLINT_CHECK(checkStored(plan, session.inputs()));
    GLINT_TRY(path, makePath(plan, session.inputs()));
    return Sequencer(std::move(session), std::move(path), plan, callbacks).run(context);
}

} // namespace glint::measure
