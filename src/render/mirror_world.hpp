// The planar mirrors of a job: pictures from behind them, drawn before each frame, and of mirrors in mirrors before
// these.
#pragma once

#include "glint/reflections.hpp"
#include "gpu/timers.hpp"
#include "render/program_settings.hpp"
#include "render/renderer.hpp"

#include <memory>
#include <vector>

namespace glint::render {

class MirrorWorld {
public:
    /// Pictures for frames of `width` x `height` pixels. `renderer` has its size by now. `probes` may be null; all must
    /// outlive the mirrors. Errors: OutOfMemory.
    static Result<MirrorWorld> create(gpu::Context& context, Context& library, Renderer& renderer,
                                      const std::vector<PlanarMirror>& mirrors, Probes* probes,
                                      const ProgramSettings& settings, uint32_t width, uint32_t height);

    /// Where they are now; false: there are more or fewer of them than there were. Errors: InvalidArgument.
    Result<bool> setMirrors(const std::vector<PlanarMirror>& mirrors);

    /// Draws the picture of each mirror that a frame seen so shows, outside of rendering, before the frame itself.
    /// `withSky`: the environment is there to be looked up. Errors: InvalidArgument.
    Result<void> record(VkCommandBuffer commands, const ViewParameters& parameters, bool withSky, uint32_t frameIndex,
                        uint32_t seed);

    PlanarMirrors& mirrors() { return levels_.front().mirrors; }
    /// GPU time of what was drawn for them, milliseconds; their own reflections are not in it.
    double milliseconds();

private:
    /// The pictures of mirrors that are seen directly, or in a mirror, or in a mirror's mirror.
    struct Level {
        PlanarMirrors mirrors;
        RenderTarget target;                      ///< one after the other, they are drawn here
        std::unique_ptr<Reflections> reflections; ///< of these pictures; absent if they are to have none
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
