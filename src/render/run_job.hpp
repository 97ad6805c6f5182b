// Does a RenderJob: scene, renderer, reflections, read-back. The frame of our own programs, as a host writes it: it
// reaches the reflections only through include/glint.
#pragma once

#include "gpu/context.hpp"
#include "gpu/pass.hpp"
#include "render/gbuffer.hpp"
#include "render/job_inputs.hpp"
#include "render/render_job.hpp"
#include "render/view.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace glint::render {

/// What one frame of a session does.
struct FramePlan {
    bool draw = true;    ///< the host's own passes; false: the G-buffer of the frame before serves again
    bool reflect = true; ///< the reflections
    bool blend = true;   ///< what is blended over both pictures, if the frame is drawn
    std::optional<std::array<uint32_t, 2>> inspect;         ///< this pixel, with RenderJob::inspect; `inspection` tells
    std::function<void(gpu::Frame&, GBuffer&)> afterOpaque; ///< more passes, before the reflections; may be empty
};

/// Milliseconds.
struct FrameTimes {
    double wallMs = 0;                                        ///< recording, submitting and waiting for the whole frame
    std::vector<std::pair<std::string, double>> hostPasses;   ///< GPU time; with those of FramePlan::afterOpaque
    std::vector<std::pair<std::string, double>> effectPasses; ///< GPU time of the reflections
};

/// A job that stays: the scene is read and uploaded once, settings, size and frames change.
class JobSession {
public:
    static Result<JobSession> create(gpu::Context& context, const RenderJob& job);
    ~JobSession();
    JobSession(JobSession&&) noexcept;
    JobSession& operator=(JobSession&&) noexcept;

    /// Makes everything on the device anew from what has been read, as after Context::replaceShaders. After an error
    /// all is as it was. Errors: as create.
    Result<void> remake();
    /// Forgets the pass times so far.
    Result<void> setSettings(const ProgramSettings& settings);
    Result<void> resize(uint32_t width, uint32_t height);
    /// Where the next frames are seen from; that of the frame before counts for motion.
    void setCamera(const scene::Camera& camera);
    /// Poses the scene at another moment of its animations. Errors: OutOfMemory, DeviceLost.
    Result<void> setTime(double seconds);
    /// Makes a view of the frame rendered last visible in `target` (RGBA8_UNORM with STORAGE and SAMPLED usage, of the
    /// session's size), as readView's bytes have it, and leaves that ready for sampling. Without a read-back: for
    /// windows. Errors: InvalidArgument for an unknown view; DeviceLost.
    Result<void> showView(const std::string& name, gpu::Image& target);
    /// The first frame, and the first after settings or size changed, has to be drawn.
    Result<FrameTimes> renderFrame(uint32_t index, const FramePlan& plan = {});
    /// Of the frame rendered last. Errors: InvalidArgument for an unknown view; DeviceLost.
    Result<RenderedView> readView(const std::string& name);
    /// Medians over the frames since the settings or the size changed; counts of the last one.
    RenderStats stats();
    /// Traces one pixel of the frame rendered last once more; with RenderJob::inspect, and after a frame that reflects.
    /// Errors: InvalidArgument for a pixel outside; DeviceLost.
    Result<RayInspection> inspect(uint32_t x, uint32_t y);
    /// Of the pixel inspected last.
    RayInspection inspection() const;
    const std::vector<std::string>& notes() const;
    /// Memory of the device that this session's context and library have, bytes; what others have in that context
    /// counts too.
    size_t deviceBytes() const;
    const JobInputs& inputs() const;
    View view() const;

private:
    struct State;
    explicit JobSession(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// On a device of its own. Errors: as the scene's readers, the device and the settings give them; with
/// RenderJob::validate also the first message of the validation layer.
Result<RenderResult> runJob(const RenderJob& job);

/// On a device that is there already (RenderJob::device and validate are the caller's matter then).
Result<RenderResult> runJob(gpu::Context& context, const RenderJob& job);

} // namespace glint::render
