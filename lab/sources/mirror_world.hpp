// The planar mirrors of a job. Their mirrored views are drawn before each frame; mirrored views of mirrors in mirrors
// are drawn before those.
#pragma once

#include "glint/reflections.hpp"
#include "gpu/timers.hpp"
#include "lab/job/program_settings.hpp"
#include "lab/renderer/renderer.hpp"

#include <memory>
#include <vector>

namespace glint::render {

class MirrorWorld {
public:
    /// Creates mirrored views for frames of `width` x `height` pixels. `renderer` must already have its size. `probes`
    /// may be null. All arguments must outlive the mirrors. Errors: OutOfMemory.
    static Result<MirrorWorld> create(gpu::Context& context, Context& library, Renderer& renderer,
                                      const std::vector<PlanarMirror>& mirrors, Probes* probes,
                                      const ProgramSettings& settings, uint32_t width, uint32_t height);

    /// Sets the current positions of the mirrors. Returns false if their number has changed. Errors: InvalidArgument.
    Result<bool> setMirrors(const std::vector<PlanarMirror>& mirrors);

    /// Draws the mirrored view of each mirror that is visible with these parameters; call outside rendering, before the
    /// frame is drawn. `withSky`: the environment is available for fetches. Errors: InvalidArgument.
    Result<void> record(VkCommandBuffer commands, const ViewParameters& parameters, bool withSky, uint32_t frameIndex,
                        uint32_t seed);

    PlanarMirrors& mirrors() { return levels_.front().mirrors; }
    /// GPU milliseconds of drawing the mirrored views, without the reflections in them.
    double milliseconds();

private:
    /// The mirrored views of one depth: mirrors seen directly, in a mirror, or in a mirror's mirror.
    struct Level {
        PlanarMirrors mirrors;
        RenderTarget target;                      ///< the mirrored views are drawn here one after the other
        std::unique_ptr<Reflections> reflections; ///< reflections in the mirrored views; absent if they have none
    };
    struct Seen;

    explicit MirrorWorld(Renderer& renderer) : renderer_(&renderer) {}
    Result<void> drawPictures(const Seen& seen, size_t level, const ViewParameters& parameters, size_t except);
    Result<void> drawPicture(const Seen& seen, size_t level, size_t mirror, const ViewParameters& parameters,
                             const View& view);

    Renderer* renderer_;
    gpu::Context* context_ = nullptr;
    ProgramSettings settings_;
    std::vector<PlanarMirror> list_;
    std::vector<Level> levels_;
    std::unique_ptr<gpu::Timers> timers_;
};

} // namespace glint::render
