// Renders successive frames with reflections: runs the library on a host's frames and provides views, statistics and
// inspections to our programs.
#pragma once

#include "gpu/timers.hpp"
#include "lab/job/render_job.hpp"
#include "lab/session/frame_views.hpp"
#include "lab/session/host_frame.hpp"
#include "lab/session/pass_times.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace glint::render {

/// The work of a session in one frame.
struct FrameRequest {
    bool draw = true;    ///< run the host's own passes; false: reuse the G-buffer of the previous frame
    bool reflect = true; ///< run the reflections
    bool blend = true;   ///< blend transparent surfaces over both images, if the frame is drawn
    /// Blend them over the reflected image of a frame that is not drawn, too. The other image has them since it was
    /// drawn. Requires drawsAlike.
    bool blendAgain = false;
    MeanStep mean; ///< the views show the mean of frames that add to it; another frame ends it
    std::optional<std::array<uint32_t, 2>> inspect;         ///< inspect this pixel; requires SessionOptions::inspect
    std::function<void(gpu::Frame&, GBuffer&)> afterOpaque; ///< additional passes before the reflections; may be empty
};

/// Times in milliseconds.
struct FrameTimes {
    double wallMs = 0;                                        ///< recording, submitting and waiting for the whole frame
    std::vector<std::pair<std::string, double>> hostPasses;   ///< GPU time, including FrameRequest::afterOpaque
    std::vector<std::pair<std::string, double>> effectPasses; ///< GPU time of the reflections
};

struct SessionOptions {
    ProgramSettings settings;
    uint32_t seed = 0;        ///< seed of the rays' noise
    bool statistics = false;  ///< count outcomes and depth fetches
    bool libraryViews = true; ///< allow views that the library makes: RenderJob::libraryViews
    bool inspect = false;     ///< allow inspection of pixels
    bool display = false;     ///< also read views as displayed: RenderedView::rgb8
};

/// Creates the host of a session; the library has adopted the session's device.
using MakeHost = std::function<Result<std::unique_ptr<HostFrame>>(Context& library)>;

class ReflectionSession {
public:
    /// `options.settings` must be those that the host was created with. Errors: those of the host, the device and the
    /// settings.
    static Result<ReflectionSession> create(gpu::Context& context, const MakeHost& makeHost,
                                            const SessionOptions& options);
    ReflectionSession(ReflectionSession&&) noexcept = default;
    ReflectionSession& operator=(ReflectionSession&&) noexcept = default;

    /// Recreates all device objects, as needed after Context::replaceShaders. On error nothing changes. Errors: as
    /// create.
    Result<void> remake();
    // The following setters, except setCamera and setTime, restart the pass times.
    Result<void> setSettings(const ProgramSettings& settings);
    Result<void> resize(uint32_t width, uint32_t height);
    /// Counts outcomes and depth fetches from the next frame on, or no longer; that frame has no history. Errors: as
    /// create.
    Result<void> setStatistics(bool statistics);
    /// Restarts with another seed: the next frame has no history.
    Result<void> restart(uint32_t seed);
    /// Makes the next frame the first that rays.accumulate averages: for frames in which only the light or the objects
    /// change, and to start with another seed at the same view.
    void restartAccumulation(uint32_t seed);
    /// Replaces the overrides of the scene's materials. Errors: as create.
    Result<void> setMaterials(const scene::MaterialOverrides& overrides);
    /// True if the frame that was drawn last holds motion: what rests then has to be drawn once more.
    bool drewMotion() const { return moving_; }
    /// Sets the camera of the next frames; motion is relative to the previous frame's camera.
    Result<void> setCamera(const scene::Camera& camera);
    /// Poses the scene at another animation time. Errors: OutOfMemory, DeviceLost.
    Result<void> setTime(double seconds);

    /// The first frame, and the first frame after a change of settings or size, must be drawn.
    Result<FrameTimes> renderFrame(uint32_t index, const FrameRequest& request = {});

    // Results of the last frame.
    /// As FrameViews::show, without read-back: for windows.
    Result<void> showView(const std::string& name, gpu::Image& target);
    /// Errors: InvalidArgument for an unknown view; DeviceLost.
    Result<RenderedView> readView(const std::string& name);
    /// Returns medians over the frames since the settings or size last changed, and counts of the last frame.
    RenderStats stats() const;
    void forgetTimes() { passTimes_.clear(); } ///< The medians are those of the frames to come.
    /// Traces one pixel again. Requires SessionOptions::inspect and a frame with reflections. Errors: InvalidArgument
    /// for a pixel outside the frame; DeviceLost.
    Result<RayInspection> inspect(uint32_t x, uint32_t y);
    /// Returns the result for the pixel inspected last.
    RayInspection inspection() const { return objects_->reflections->inspection(); }

    /// Returns the notes of the library and of the scene's inputs.
    std::vector<std::string> notes() const;
    /// Returns the bytes of device memory allocated in this session's context and in the library; other users of that
    /// context are counted too.
    size_t deviceBytes() const;
    /// True if drawing the frames of a still view again changes nothing (HostFrame::drawsAlike).
    bool drawsAlike() const { return objects_->host->drawsAlike(); }
    const JobInputs& inputs() const { return objects_->host->inputs(); }
    View view() const { return objects_->host->view(); }
    const ProgramSettings& settings() const { return options_.settings; }

private:
    /// The device objects. They have stable addresses, as they refer to each other.
    struct Objects {
        explicit Objects(FrameViews&& made) : views(std::move(made)) {}
        std::shared_ptr<Context> library;
        std::unique_ptr<HostFrame> host;
        std::unique_ptr<Reflections> reflections;
        std::unique_ptr<gpu::Timers> timers;
        FrameViews views;
    };

    ReflectionSession(gpu::Context& context, const SessionOptions& options) : context_(&context), options_(options) {}
    Result<std::unique_ptr<Objects>> makeObjects(const MakeHost& makeHost) const;
    Result<void> makeReflections(Objects& objects) const;

    gpu::Context* context_;
    SessionOptions options_;
    std::unique_ptr<Objects> objects_;
    PassTimes passTimes_;
    bool drawn_ = false;  ///< the G-buffer holds a frame
    bool moved_ = false;  ///< camera or scene did, since the frame that was drawn last
    bool moving_ = false; ///< that frame holds motion
};

} // namespace glint::render
