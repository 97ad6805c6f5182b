// The host's part of a frame, as ReflectionSession uses it: the host makes the G-buffer, lends it to the library and
// draws over the returned image. SceneHost implements it with our renderer; another host may read its G-buffer from
// files.
#pragma once

#include "glint/reflections.hpp"
#include "gpu/pass.hpp"
#include "lab/job/job_inputs.hpp"
#include "lab/job/program_settings.hpp"
#include "lab/renderer/gbuffer.hpp"
#include "lab/renderer/view.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glint::render {

/// Every failing call states its reason. A call that a host does not support (such as another camera for a G-buffer
/// from files) fails with Unsupported.
class HostFrame {
public:
    virtual ~HostFrame() = default;

    // The scene and the view.
    /// Scene, size, camera and environment; `scene` is null if only the G-buffer is known.
    virtual const JobInputs& inputs() const = 0;
    /// The view of the frame drawn last, or of the next frame.
    virtual View view() const = 0;

    // Changes. After each of them except setCamera, the G-buffer must be drawn again. After an error, a change may be
    // partly applied.
    virtual Result<void> setSettings(const ProgramSettings& settings) = 0;
    virtual Result<void> resize(uint32_t width, uint32_t height) = 0;
    virtual Result<void> setCamera(const scene::Camera& camera) = 0;
    /// Shifts the next frames to the right and down, pixels in [-0.5, 0.5]. A host that cannot be jittered ignores it.
    virtual void setJitter(glm::vec2 /*jitterPX*/) {}
    /// Seed of the noise in images that the host draws with reflections of their own; most hosts draw none.
    virtual void setSeed(uint32_t /*seed*/) {}
    /// Returns true if `reflections` has been updated. Returns false if the sources were replaced: new Reflections must
    /// receive them through giveSources.
    virtual Result<bool> setTime(double seconds, Reflections& reflections) = 0;
    /// Replaces the overrides of the scene's materials. Returns as setTime.
    virtual Result<bool> setMaterials(const scene::MaterialOverrides& overrides, Reflections& reflections) = 0;
    /// Returns the same host with all device objects recreated for `library`. On success, this object is not drawn with
    /// again.
    virtual Result<std::unique_ptr<HostFrame>> remade(Context& library) = 0;

    // Drawing a frame, in this order. All calls except `draw` may repeat for a frame that is already drawn.
    /// Draws the G-buffer, and before it the images that sources need. `frame` records into `commands`.
    virtual Result<void> draw(gpu::Frame& frame, VkCommandBuffer commands, uint32_t frameIndex) = 0;
    /// True if `draw` gives the same bits in every frame of a still view, also after surfaces were blended over it.
    virtual bool drawsAlike() const = 0;
    virtual GBuffer& gbuffer() = 0;
    /// The G-buffer and environment, as Reflections::setInputs requires them, in the host's conventions.
    virtual glint::GBuffer lend(gpu::Frame& frame) = 0;
    virtual EnvironmentMap lendEnvironment(gpu::Frame& frame) = 0;
    /// Records the changes of the sources since the last frame.
    virtual void recordSources(VkCommandBuffer commands) = 0;
    /// Draws layers over `lit`, which the library returned for this frame. Returns the image that the library returned
    /// for the last layer.
    virtual Result<HostImage> drawLayers(gpu::Frame& frame, VkCommandBuffer commands, Reflections& reflections,
                                         HostImage lit) = 0;
    /// Draws transparent surfaces over an image. `overLayers`: the image is the result of drawLayers, which already
    /// shows some of those surfaces.
    virtual void drawTransparent(gpu::Frame& frame, gpu::Image& picture, bool overLayers) = 0;
    /// Displays radiance in `target`: RGBA8_UNORM with STORAGE usage, of the frame's size.
    virtual void display(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& target) = 0;

    // What the host provides to the library besides the G-buffer.
    /// True if there are layers to draw with Reflections::recordLayer.
    virtual bool hasLayers() const = 0;
    /// Sets probes, planar mirrors and rays on newly created Reflections; the host may then destroy earlier sources.
    virtual Result<void> giveSources(Reflections& reflections) = 0;
    /// GPU milliseconds, by name, of the work for the last frame that is in no pass of its `frame`.
    virtual std::vector<std::pair<std::string, double>> passTimes() = 0;
};

} // namespace glint::render
