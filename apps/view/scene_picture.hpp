// One scene with one set of settings, rendered when something has changed and otherwise left alone. The viewer has one,
// and a second one where two sets of settings stand side by side.
#pragma once

#include "render/run_job.hpp"

#include <memory>

namespace glint::view {

class ScenePicture {
public:
    /// Reads the scene. Errors: as the scene's readers and the device give them.
    static Result<std::unique_ptr<ScenePicture>> create(gpu::Context& context, const render::RenderJob& job);

    // Each starts the picture anew if it changes something.
    /// After an error the session has some of them: settings have to be set that it takes, be they those of before.
    Result<void> setSettings(const render::ProgramSettings& settings);
    void setCamera(const scene::Camera& camera);
    Result<void> setTime(double seconds);
    Result<void> resize(uint32_t width, uint32_t height);

    /// Everything on the device anew (JobSession::remake). After an error the picture is as it was.
    Result<void> remake();
    /// Starts anew although nothing has changed.
    void restart() { changed(); }

    /// Renders one frame more: as `glint render --frames` with frames() + 1. Errors: DeviceLost, OutOfMemory.
    Result<void> render();
    /// Frames since something changed; the picture is that of the last one.
    uint32_t frames() const { return frames_; }
    /// More frames would not change it, or there are enough of them: RenderJob::frames, or kAccumulatedFrames for 1.
    bool complete() const { return frames_ >= wanted(); }
    uint64_t version() const { return version_; } ///< another one for every frame

    /// Shows a view of the last frame in `image()`, and one in `secondImage()`; both are ready for sampling then.
    /// Errors: as JobSession::showView.
    Result<void> show(const std::string& view);
    Result<void> showSecond(const std::string& view);
    const gpu::Image& image() const { return image_; }
    const gpu::Image& secondImage() const { return second_; }
    uint64_t images() const { return imagesMade_; } ///< another number when the images are others
    /// The bytes of `image()` as displayed: RGB, rows from the top.
    Result<std::vector<uint8_t>> bytes();

    render::JobSession& session() { return session_; }
    const render::RenderJob& job() const { return job_; }
    const render::FrameTimes& times() const { return times_; } ///< of the last frame
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }

    static constexpr uint32_t kAccumulatedFrames = 1024;

private:
    ScenePicture(gpu::Context& context, const render::RenderJob& job, render::JobSession&& session)
        : context_(context), job_(job), session_(std::move(session)) {}
    Result<gpu::Image> makeImage() const;
    Result<void> makeImages();
    uint32_t wanted() const;
    void changed() { frames_ = 0; }

    gpu::Context& context_;
    render::RenderJob job_;
    bool settingsRefused_ = false; ///< the session's are not those of job_
    render::JobSession session_;
    scene::Camera camera_;
    gpu::Image image_;
    gpu::Image second_;
    uint64_t imagesMade_ = 0;
    render::FrameTimes times_;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
    uint32_t frames_ = 0;
    uint64_t version_ = 0;
};

} // namespace glint::view
