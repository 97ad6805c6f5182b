#include "lab/cli/report/gallery_run.hpp"

#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/command_text.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/session/run_job.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <tuple>

namespace glint::cli {
namespace {

constexpr size_t kSoftwareThreads = 2;

std::string commandOf(const GalleryEntry& entry, const render::RenderJob& job) {
    RenderOptions options = entry.options;
    std::string text = renderCommand(options, options.scene, entry.config, job.width, job.height);
    for (const std::string& view : options.views)
        text += " --view " + shellWord(view);
    if (job.settle > 0)
        text += fmt::format(" --settle {}", job.settle);
    return fmt::format("{} -o {}.png", text, entry.name);
}

/// True if both show one scene in one way, but for their settings and views: a session serves both.
bool sameScene(const render::RenderJob& a, const render::RenderJob& b) {
    const auto key = [](const render::RenderJob& job) {
        return std::tie(job.scene, job.camera, job.environment, job.materials, job.width, job.height, job.probes,
                        job.planar);
    };
    return key(a) == key(b);
}

/// The jobs of each session, by their index.
std::vector<std::vector<size_t>> jobsOfSessions(const std::vector<render::RenderJob>& jobs) {
    std::vector<std::vector<size_t>> sessions;
    for (size_t i = 0; i < jobs.size(); ++i) {
        const auto found = std::ranges::find_if(
            sessions, [&](const std::vector<size_t>& session) { return sameScene(jobs[session.front()], jobs[i]); });
        (found == sessions.end() ? sessions.emplace_back() : *found).push_back(i);
    }
    return sessions;
}

Result<RenderedPicture> renderPicture(render::ReflectionSession& session, const render::RenderJob& job,
                                      const std::string& file) {
    GLINT_TRY(result, render::runJob(session, job));
    for (const std::string& note : result.notes)
        log::warning("{}: {}", printable(file), note);
    GLINT_CHECK(writePictures(file, result));
    RenderedPicture picture;
    picture.width = result.width;
    picture.height = result.height;
    if (result.settled)
        picture.frames = result.settled->frames;
    picture.stats = std::move(result.stats);
    if (!job.passTimes)
        picture.stats.passes.clear();
    return picture;
}

/// The threads' common state.
class GalleryRun {
public:
    GalleryRun(GalleryWork& work, const std::string& folder, const std::function<Result<void>(const Gallery&)>& show)
        : work_(work), folder_(folder), show_(show), sessions_(jobsOfSessions(work.jobs)) {}

    /// On a device of its own.
    void takeSessions() {
        for (size_t i = next_++; i < sessions_.size() && !failed_; i = next_++)
            if (Result<void> done = render(sessions_[i]); !done)
                fail(done);
    }
    Result<void> result() { return result_; }

private:
    Result<void> render(const std::vector<size_t>& indices) {
        const render::RenderJob& first = work_.jobs[indices.front()];
        GLINT_TRY(context, gpu::Context::create({first.device, first.validate}));
        GLINT_TRY(session, render::openJob(*context, first));
        for (const size_t index : indices) {
            if (failed_)
                return {};
            if (index != indices.front())
                GLINT_CHECK(session.setSettings(work_.jobs[index].settings));
            const std::string file = fmt::format("{}/{}.png", folder_, work_.gallery.pictures[index].name);
            GLINT_TRY(picture, renderPicture(session, work_.jobs[index], file));
            const std::lock_guard lock(mutex_);
            work_.gallery.pictures[index].rendered = std::move(picture);
            GLINT_CHECK(show_(work_.gallery));
        }
        return render::checkMessages(*context);
    }
    void fail(const Result<void>& result) {
        const std::lock_guard lock(mutex_);
        if (!failed_.exchange(true))
            result_ = result;
    }

    GalleryWork& work_;
    const std::string& folder_;
    const std::function<Result<void>(const Gallery&)>& show_;
    const std::vector<std::vector<size_t>> sessions_;
    std::atomic<size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    Result<void> result_;
};

} // namespace

Result<GalleryWork> planGallery(const GalleryPlan& plan, const gpu::DeviceInfo& device, const std::string& size,
                                const RenderOptions& common) {
    GalleryWork work;
    work.gallery.device = device.name;
    work.gallery.driver = device.driver;
    work.gallery.software = device.software;
    const std::string& planned = device.software && !plan.softwareSize.empty() ? plan.softwareSize : plan.size;
    for (const GalleryEntry& entry : plan.entries) {
        RenderOptions options = entry.options;
        options.size = size.empty() ? planned : size;
        options.device = common.device;
        options.validate = common.validate;
        options.seed = common.seed;
        auto job = makeRenderJob(options);
        if (!job)
            return makeError(job.error().code, "picture {}: {}", entry.name, job.error().message);
        lookAt(*job, options);
        job->statistics = true;
        job->passTimes = !device.software; // two pictures are rendered at the same time there
        work.gallery.pictures.push_back({entry.name, entry.title, options.scene, commandOf(entry, *job), {}});
        work.jobs.push_back(std::move(*job));
    }
    return work;
}

Result<void> renderGallery(GalleryWork& work, const std::string& folder,
                           const std::function<Result<void>(const Gallery&)>& show) {
    GLINT_CHECK(show(work.gallery));
    GalleryRun run(work, folder, show);
    std::vector<std::thread> threads;
    if (work.gallery.software)
        for (size_t i = 1; i < kSoftwareThreads; ++i)
            threads.emplace_back([&] { run.takeSessions(); });
    run.takeSessions();
    for (std::thread& thread : threads)
        thread.join();
    return run.result();
}

} // namespace glint::cli
