#include "lab/cli/report/gallery_run.hpp"

#include "base/log.hpp"
#include "base/text.hpp"
#include "lab/cli/command_text.hpp"
#include "lab/session/run_job.hpp"
#include "lab/cli/render/render_output.hpp"

#include <atomic>
#include <mutex>
#include <thread>

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

/// As runJob, without the frames that it adds for their times.
Result<render::RenderResult> withoutTimes(const render::RenderJob& job) {
    auto result = render::onOwnDevice(job, [&](gpu::Context& context) -> Result<render::RenderResult> {
        GLINT_TRY(session, render::openJob(context, job));
        return render::renderFrames(session, job);
    });
    if (result)
        result->stats.passes.clear();
    return result;
}

Result<RenderedPicture> renderPicture(const render::RenderJob& job, const std::string& file, bool timed) {
    GLINT_TRY(result, timed ? render::runJob(job) : withoutTimes(job));
    for (const std::string& note : result.notes)
        log::warning("{}: {}", printable(file), note);
    GLINT_CHECK(writePictures(file, result));
    RenderedPicture picture;
    picture.width = result.width;
    picture.height = result.height;
    if (result.settled)
        picture.frames = result.settled->frames;
    picture.stats = std::move(result.stats);
    return picture;
}

/// The threads' common state.
class GalleryRun {
public:
    GalleryRun(GalleryWork& work, const std::string& folder, const std::function<Result<void>(const Gallery&)>& show)
        : work_(work), folder_(folder), show_(show) {}

    void takeJobs() {
        for (size_t i = next_++; i < work_.jobs.size() && !failed_; i = next_++)
            if (Result<void> done = render(i); !done)
                fail(done);
    }
    Result<void> result() { return result_; }

private:
    Result<void> render(size_t index) {
        const std::string file = fmt::format("{}/{}.png", folder_, work_.gallery.pictures[index].name);
        GLINT_TRY(picture, renderPicture(work_.jobs[index], file, !work_.gallery.software));
        const std::lock_guard lock(mutex_);
        work_.gallery.pictures[index].rendered = std::move(picture);
        return show_(work_.gallery);
    }
    void fail(const Result<void>& result) {
        const std::lock_guard lock(mutex_);
        if (!failed_.exchange(true))
            result_ = result;
    }

    GalleryWork& work_;
    const std::string& folder_;
    const std::function<Result<void>(const Gallery&)>& show_;
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
        job->statistics = true;
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
            threads.emplace_back([&] { run.takeJobs(); });
    run.takeJobs();
    for (std::thread& thread : threads)
        thread.join();
    return run.result();
}

} // namespace glint::cli
