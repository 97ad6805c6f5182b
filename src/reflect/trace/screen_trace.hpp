// `trace`: the screen source. Lists the pixels that need a ray and traces them with the marcher that the settings
// select.
#pragma once

#include "reflect/prepare/depth_pyramid.hpp"
#include "reflect/prepare/prepare.hpp"
#include "reflect/trace/ray_list.hpp"
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

class ScreenTrace {
public:
    static Result<std::unique_ptr<ScreenTrace>> create(StageContext& stages);

    /// Compiles the passes and creates the images that the plan needs for the first time. Errors: OutOfMemory,
    /// Unsupported.
    Result<void> make();

    void clear(gpu::Frame& frame);
    /// Sets the size and format of this frame's images. `whole`: the frame's size, whatever the settings.
    void begin(bool whole);
    void rehearse(gpu::Frame& frame, const TraceInputs& inputs, glm::uvec2 backFaceGroups);
    /// Call before the pass that classifies.
    void beginClasses(gpu::Frame& frame);
    /// Binds what trace/starts_ray.glsl and trace/ray_list.glsl write.
    gpu::Pass& bindClasses(gpu::Pass& pass) { return lister_.bind(writeTraced(pass, target())); }
    /// Finds the pixels that need a ray.
    void classify(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared);
    /// Lists them. `backFaceGroups`: Prepare::backFaceGroups. `always`: what rays march through is made also without
    /// any.
    void list(gpu::Frame& frame, glm::uvec2 backFaceGroups, bool always);
    /// Marches the listed rays.
    Traced record(gpu::Frame& frame, const TraceInputs& inputs);
    /// Clears the images while the screen source is off: no ray was traced.
    Traced recordNothing(gpu::Frame& frame);

    Traced traced();
    TraceTarget target();
    Rays& rays() { return rays_; }
    gpu::Buffer& rayTiles() { return lister_.tiles(); }

private:
    explicit ScreenTrace(StageContext& stages) : stages_(stages) {}
    gpu::Pipeline& marcherOf(const Settings& settings);

    StageContext& stages_;
    gpu::Pipeline classify_;
    std::vector<gpu::Pipeline> marchers_; ///< in the order of techniques()
    RayLister lister_;
    Rays rays_;
    glm::uvec2 listed_ = glm::uvec2(0); ///< pixels that rays_ has room for
    gpu::Image radianceWeight_;         ///< absent unless settings have needed it
    gpu::Image radianceWeight8_;        ///< as radianceWeight_, with screen.targetFormat rgba8
    gpu::Image unused_;                 ///< one texel, bound for whichever of the two a frame does not write
    gpu::Image unused8_;
    gpu::Image rayRecord_;
    gpu::Standing blank_;    ///< the unused texels are initialized
    gpu::Standing untraced_; ///< the images say that no ray was traced
    bool eightBits_ = false; ///< this frame writes radianceWeight8_
    uint32_t width_ = 1;     ///< pixels that this frame traces
    uint32_t height_ = 1;
};

} // namespace glint::reflect
