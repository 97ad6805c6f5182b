// The views of a frame by name: its own images, the host's and the reflections' (views.hpp). A view is shown in an
// image or read back.
#pragma once

#include "lab/job/render_job.hpp"
#include "lab/session/frame_mean.hpp"
#include "lab/session/host_frame.hpp"
#include "lab/session/view_pass.hpp"

namespace glint::render {

class FrameViews {
public:
    /// Errors: OutOfMemory.
    static Result<FrameViews> create(gpu::Context& context);
    Result<void> resize(uint32_t width, uint32_t height);

    /// Copies the host's lit image before anything is blended over it.
    void keepScene(gpu::Frame& frame, GBuffer& gbuffer);
    /// RGBA16F: the frame without reflections; a: opacity, to which blended surfaces add theirs.
    gpu::Image& scene() { return scene_; }
    /// The frame with reflections, as the library returned it; owned by the library.
    gpu::Image& composite() { return composite_; }
    void setComposite(gpu::Image&& composite) { composite_ = std::move(composite); }

    /// Makes "composite" the mean of the frames that are added. `restart`: without the earlier ones. Errors:
    /// OutOfMemory.
    Result<void> prepareMean(bool restart);
    void addToMean(gpu::Frame& frame, HostFrame& host);
    void endMean() { mean_.clear(); }

    /// Shows a view in `target` (RGBA8_UNORM with STORAGE and SAMPLED usage, of the frame's size) with the same bytes
    /// as `read`, and leaves `target` ready for sampling. Errors: InvalidArgument for an unknown view; DeviceLost.
    Result<void> show(const std::string& name, HostFrame& host, Reflections& reflections, gpu::Image& target);
    /// Reads a view back. The alpha of "composite" and "scene" is the opacity of the frame: 1 where surfaces cover the
    /// whole pixel, 0 where only the background is visible. `display`: also fill RenderedView::rgb8. Errors: as show.
    Result<RenderedView> read(const std::string& name, HostFrame& host, Reflections& reflections, bool display);

private:
    explicit FrameViews(gpu::Context& context) : context_(&context) {}
    Result<RenderedView> readComposite(HostFrame& host, bool display);
    /// Leaves an image as the library had left it.
    Result<void> handBack(gpu::Image& image);
    Result<void> displayInto(RenderedView& view, HostFrame& host, gpu::Image& radiance);
    Result<void> displayInto(RenderedView& view, const std::function<void(gpu::Frame&)>& draw);

    gpu::Context* context_;
    FrameMean mean_;
    ViewPass viewPass_;
    gpu::Pipeline opacity_;
    gpu::Image composite_;
    gpu::Image scene_;
    gpu::Image display_;
};

} // namespace glint::render
