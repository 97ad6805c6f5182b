#include "lab/cli/sweep/sweep_jobs.hpp"

#include "base/hash.hpp"
#include "base/settings/settings_json.hpp"
#include "base/text.hpp"
#include "lab/cli/compare/reference_bounces.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/input_files.hpp"
#include "lab/cli/sequence/motion_option.hpp"

#include <algorithm>
#include <charconv>

namespace glint::cli {
namespace {

constexpr uint32_t kMostShards = 1000000;

/// Names of files need not be UTF-8.
std::string dumped(const SweepJson& json) {
    return json.dump(-1, ' ', false, SweepJson::error_handler_t::replace);
}

std::string hashText(std::string_view text) {
    return fmt::format("{:016x}", Hash().text(text).result());
}

/// The renderer's settings, which probes and environments are made with.
std::string renderSettingsText(render::RenderSettings settings) {
    const SettingsTarget target = {render::renderSettingsTable(), &settings};
    return writeSettingsJson({&target, 1});
}

/// Makes the jobs of one scene at one size.
class SceneJobs {
public:
    SceneJobs(const SweepPlan& plan, const SweepScene& scene, const std::string& size, const std::string& program,
              InputFiles& files)
        : plan_(plan), scene_(scene), size_(size), program_(program), files_(files) {}

    Result<void> add(std::vector<SweepJob>& jobs) {
        std::vector<Prepared> configs;
        for (const SweepConfig& config : plan_.configs) {
            GLINT_TRY(job, renderJob(config));
            bounces_ = std::max(bounces_, bouncesOf(job.settings.reflections));
            GLINT_TRY(view, viewOf(job));
            const std::string settings = hashText(render::settingsJson(job.settings));
            configs.push_back({config.name, std::move(job), dumped(view), settings});
        }
        if (plan_.reference)
            GLINT_CHECK(makeReference());
        if (plan_.motion)
            GLINT_CHECK(makeMotion());
        if (plan_.stills)
            for (const Prepared& config : configs)
                for (const uint32_t seed : plan_.seeds)
                    jobs.push_back(still(config, seed));
        if (plan_.motion)
            for (const Prepared& config : configs)
                jobs.push_back(moving(config));
        return {};
    }

private:
    /// A config on this scene.
    struct Prepared {
        std::string name;
        render::RenderJob job;
        std::string view;
        std::string settings; ///< hash of all that are in force
    };

    /// With the settings of a config on this scene.
    Result<render::RenderJob> renderJob(const SweepConfig& config) {
        RenderOptions options = scene_.options;
        options.size = size_;
        options.frames = 1;
        render::SettingsRequest request = config.settings;
        request.assignments.insert(request.assignments.begin(), options.settings.assignments.begin(),
                                   options.settings.assignments.end());
        options.settings = std::move(request);
        auto job = makePictureJob(options);
        if (!job)
            return makeError(job.error().code, "{} on {}: {}", printable(config.name), printable(scene_.name),
                             job.error().message);
        return job;
    }

    Result<void> makeReference() {
        const SweepReference& planned = *plan_.reference;
        GLINT_TRY(job, renderJob(planned.config));
        followAsManyBounces(job.settings.reflections, bounces_);
        job.frames = planned.frames.value_or(defaultReferenceFrames(job.settings));
        job.seed = planned.seed;
        GLINT_TRY(view, viewOf(job));
        auto made = std::make_shared<SweepReferenceJob>();
        made->view = dumped(view);
        made->name = hashText(dumped({{"program", program_},
                                      {"kind", "reference"},
                                      {"view", made->view},
                                      {"settings", render::settingsJson(job.settings)},
                                      {"frames", job.frames},
                                      {"seed", job.seed}}));
        made->config = {planned.config.name, std::move(job)};
        reference_ = std::move(made);
        return {};
    }

    Result<void> makeMotion() {
        const SweepMotion& planned = *plan_.motion;
        auto made = std::make_shared<measure::SequencePlan>();
        GLINT_TRY(path, readPath(planned.path));
        made->path = std::move(path);
        made->path.pixelsPerFrame = planned.speed;
        if (planned.stop)
            made->path.stop = *planned.stop;
        made->frames = planned.frames;
        made->fps = planned.fps;
        made->measure = true;
        made->warmUp = std::min(planned.frames / 4, 32u); // as `glint sequence`
        motionJson_ = {{"path", planned.path},     {"speed", planned.speed}, {"stop", made->path.stop},
                       {"frames", planned.frames}, {"fps", planned.fps},     {"samples", planned.samples}};
        if (!made->path.keys.empty()) {
            GLINT_TRY(hashes, files_.of(planned.path));
            motionJson_["files"] = hashes;
        }
        if (planned.samples > 0) {
            GLINT_TRY(job, renderJob(plan_.reference->config));
            followAsManyBounces(job.settings.reflections, bounces_);
            GLINT_TRY(frames, motionReferenceFrames(job.settings, plan_.reference->config.name, planned.samples));
            job.frames = frames;
            motionJson_["reference"] = render::settingsJson(job.settings);
            made->reference = measure::ComparedConfig{plan_.reference->config.name, std::move(job)};
        }
        motion_ = std::move(made);
        return {};
    }

    /// All that a session is opened with; what the scene's files contain is part of it.
    Result<SweepJson> viewOf(const render::RenderJob& job) {
        GLINT_TRY(files, files_.of(job));
        return SweepJson{{"scene", job.scene},
                         {"camera", job.camera},
                         {"environment", job.environment},
                         {"materials", job.materials},
                         {"probes", job.probes},
                         {"planar", static_cast<int>(job.planar)},
                         {"time", job.time},
                         {"size", {job.width, job.height}},
                         {"files", files},
                         {"render", hashText(renderSettingsText(job.settings.render))}};
    }

    SweepJson describe(const char* kind, const std::string& config, uint32_t seed) const {
        return {{"name", ""},    {"kind", kind},     {"scene", scene_.name},
                {"size", size_}, {"config", config}, {"seed", seed}};
    }

    /// Gives the job a name made of `whole`, all that its figures depend on.
    void finish(SweepJob& job, SweepJson whole) const {
        whole["program"] = program_;
        whole["job"] = job.description;
        job.name = hashText(dumped(whole));
        job.description["name"] = job.name;
    }

    SweepJob still(const Prepared& config, uint32_t seed) const {
        SweepJob job;
        job.description = describe("still", config.name, seed);
        job.config = {config.name, config.job};
        job.config.job.seed = seed;
        job.view = config.view;
        job.frames = plan_.frames;
        job.hits = plan_.hits;
        job.reference = reference_;
        finish(job, {{"view", config.view},
                     {"settings", config.settings},
                     {"frames", job.frames},
                     {"hits", job.hits},
                     {"reference", reference_ ? reference_->name : ""}});
        return job;
    }

    /// With the plan's first seed and the next one: moving pictures are measured with two.
    SweepJob moving(const Prepared& config) const {
        SweepJob job;
        job.description = describe("motion", config.name, plan_.seeds.front());
        job.config = {config.name, config.job};
        job.config.job.seed = plan_.seeds.front();
        job.view = config.view;
        job.motion = motion_;
        finish(job, {{"view", config.view}, {"settings", config.settings}, {"motion", motionJson_}});
        return job;
    }

    const SweepPlan& plan_;
    const SweepScene& scene_;
    const std::string& size_;
    const std::string& program_;
    InputFiles& files_;
    int bounces_ = 0; ///< the most that a config follows
    std::shared_ptr<const SweepReferenceJob> reference_;
    std::shared_ptr<const measure::SequencePlan> motion_;
    SweepJson motionJson_;
};

} // namespace

std::string SweepJob::title() const {
    const std::string size = description["size"].get<std::string>();
    return fmt::format("{}{}{}, {}, {}", description["scene"].get<std::string>(), size.empty() ? "" : ", ", size,
                       description["config"].get<std::string>(),
                       motion ? std::string("in motion") : fmt::format("seed {}", config.job.seed));
}

Result<std::vector<SweepJob>> makeSweepJobs(const SweepPlan& plan, const std::string& program,
                                            const std::string& planName) {
    std::vector<SweepJob> jobs;
    InputFiles files;
    for (const SweepScene& scene : plan.scenes)
        for (const std::string& size : plan.sizes)
            if (auto done = SceneJobs(plan, scene, size, program, files).add(jobs); !done)
                return makeError(done.error().code, "{}: {}", printable(planName), done.error().message);
    return jobs;
}

Result<Shard> readShard(const std::string& text) {
    const auto wrong = [&] {
        return invalidArgument("--shard {}: expected I/N, as in 0/4, with I from 0 to N - 1 and N up to {}",
                               printable(text), kMostShards);
    };
    const char* const end = text.data() + text.size();
    Shard shard;
    const auto [slash, indexError] = std::from_chars(text.data(), end, shard.index);
    if (indexError != std::errc() || slash == end || *slash != '/')
        return wrong();
    const auto [rest, countError] = std::from_chars(slash + 1, end, shard.count);
    if (countError != std::errc() || rest != end || shard.count < 1 || shard.count > kMostShards ||
        shard.index >= shard.count)
        return wrong();
    return shard;
}

} // namespace glint::cli
