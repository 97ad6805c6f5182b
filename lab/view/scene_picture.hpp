// One scene with one set of settings, rendered only when something has changed. The viewer has one, and a second one if
// two sets of settings are shown side by side.
#pragma once

#include "lab/session/run_job.hpp"

#include <memory>

namespace glint::view {

class ScenePicture {
public:
    /// Reads the scene. Errors: those of the scene's readers and the device.
    static Result<std::unique_ptr<ScenePicture>> create(gpu::Context& context, const render::RenderJob& job);

    // Each setter restarts the picture if it changes something.
    /// On error, settings may be partly applied: set settings that the session accepts next, for example the previous
    /// ones.
    Result<void> setSettings(const render::ProgramSettings& settings);
    Result<void> setCamera(const scene::Camera& camera);
    Result<void> setTime(double seconds);
    /// `version`  of the overrides; 0: those of the job, which a new picture has. Differs if they differ.
    Result<void> setMaterials(const scene::MaterialOverrides& overrides, uint64_t version);
    Result<void> resize(uint32_t width, uint32_t height);

    /// Recreates all device objects (ReflectionSession::remake). On error the picture does not change.
    Result<void> remake();
    /// Restarts although nothing has changed.
    void restart() { changed(); }

    /// Renders one more frame, as `glint render --frames` with frames() + 1. Errors: DeviceLost, OutOfMemory.
    Result<void> render();
    /// Returns the number of frames since the last change; the picture is the last of them.
    uint32_t frames() const { return frames_; }
    /// More frames would not change it, or there are enough of them: RenderJob::stillFrames, or kAccumulatedFrames.
    bool complete() const { return frames_ >= wanted(); }
    uint64_t version() const { return version_; } ///< differs for every frame

    /// Shows a view of the last frame in `image()`, and another in `secondImage()`; both are then ready for sampling.
    /// Errors: as ReflectionSession::showView.
    Result<void> show(const std::string& view);
    Result<void> showSecond(const std::string& view);
    const gpu::Image& image() const { return image_; }
    const gpu::Image& secondImage() const { return second_; }
    uint64_t images() const { return imagesMade_; } ///< changes when the images are replaced
    /// Returns the bytes of `image()` as displayed: RGB, rows from the top.
    Result<std::vector<uint8_t>> bytes();

    render::ReflectionSession& session() { return session_; }
    const render::RenderJob& job() const { return job_; }
    const render::FrameTimes& times() const { return times_; } ///< of the last frame
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }

    static constexpr uint32_t kAccumulatedFrames = 1024;

private:
    ScenePicture(gpu::Context& context, const render::RenderJob& job, render::ReflectionSession&& session)
        : context_(context), job_(job), session_(std::move(session)) {}
    Result<gpu::Image> makeImage() const;
    Result<void> makeImages();
    uint32_t wanted() const;
    void changed() { frames_ = index_ = 0; }
    void moved();

    gpu::Context& context_;
    render::RenderJob job_;
    bool settingsRefused_ = false; ///< the session's settings differ from those of job_
    render::ReflectionSession session_;
    scene::Camera camera_;
    gpu::Image image_;
    gpu::Image second_;
    uint64_t imagesMade_ = 0;
    render::FrameTimes times_;
    uint64_t materialsVersion_ = 0;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
    uint32_t frames_ = 0;
    uint32_t index_ = 0; ///< of the next frame: selects its noise
    uint64_t version_ = 0;
};

} // namespace glint::view
