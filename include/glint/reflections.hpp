// SPDX-License-Identifier: MIT
// The main class of the library: it takes the host's G-buffer and returns the lit image with reflections.
#pragma once

#include "glint/api.h"
#include "glint/context.hpp"
#include "glint/gbuffer.hpp"
#include "glint/input_check.hpp"
#include "glint/inspection.hpp"
#include "glint/outputs.hpp"
#include "glint/planar.hpp"
#include "glint/probes.hpp"
#include "glint/ray_hits.hpp"
#include "glint/ray_scene.hpp"
#include "glint/settings.hpp"
#include "glint/surface_table.hpp"
#include "glint/transparent_layer.hpp"
#include "glint/view.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// The environment, a GGX-prefiltered cube map. Mip 0 has perceptual roughness 0, the last mip has 1, and perceptual
/// roughness increases linearly with the mip. Faces and axes follow Vulkan's cube maps.
struct EnvironmentMap {
    HostImage cube;     ///< requires a view of type CUBE; width and height: size of a face
    uint32_t mips = 1;  ///< mips of the view; at most a full mip chain of a face
    float strength = 1; ///< factor on the environment's radiance
    float rotation = 0; ///< radians about world +Y, counter-clockwise as seen from above
    bool flipY = false; ///< true if the cube is upside down, like probes rendered by Babylon.js
    /// Optional: a cube of irradiance / pi, for diffuse light at ray hits. Absent: the last mip of `cube` is the
    /// fallback.
    HostImage diffuse;
};

/// Size, settings and optional features of a Reflections object.
struct ReflectionsDesc {
    uint32_t width = 0; ///< pixels, size of every image of the G-buffer except backDepth
    uint32_t height = 0;
    Settings settings;
    bool statistics = false;        ///< count outcomes and lookups each frame; adds a small pass
    bool views = false;             ///< allocate an image for debug views (recordView)
    bool inspection = false;        ///< enable recordInspection: one more pipeline per marcher, and 256 KiB
    bool transparentLayers = false; ///< enable recordLayer: two more images of the frame's size, with mips
    /// Check the host's declarations in the first frames (InputCheck): a small pass in one frame, later in ever rarer
    /// ones until a frame has shown enough surfaces and motion. 250 KiB twice. Also enables recordInputCheck.
    bool inputCheck = false;
    bool timers = true; ///< time each pass (passTimes): two timestamps per pass
    /// Maximum frames in flight, at least 1. When frame n is recorded, the GPU has finished, or will never run, all
    /// frames up to n - framesInFlight. Objects that new settings or inputs replace are kept for this number of frames,
    /// and a history starts this number of frames later (screen.colorSource previous, rays.accumulate). 1: the host
    /// waits for each frame before it records the next.
    uint32_t framesInFlight = 3;
};

/// GPU time of one pass.
struct PassTime {
    std::string name; ///< for example "trace/linear"
    double milliseconds = 0;
};

/// A decision on which passes frames have.
struct FrameDecision {
    std::string_view name; ///< for example "denoise", or the name of a pass
    bool value = false;
};

/// Ray outcomes and costs of one frame.
struct Statistics {
    struct Outcome {
        std::string_view name; ///< "hit", "offScreen", ...
        uint64_t count = 0;    ///< pixels
    };
    std::vector<Outcome> outcomes;
    uint64_t rays = 0;
    double lookupsMean = 0; ///< depth lookups per traced ray, mean
    uint32_t lookups95 = 0; ///< depth lookups per traced ray, 95th percentile

    /// Counters of the source `rays`; 0 without it.
    struct SceneRays {
        uint64_t pixels = 0;      ///< pixels that the source traced for
        uint64_t rays = 0;        ///< rays through the host's triangles, without shadow rays
        uint64_t fromScreen = 0;  ///< pixels whose first hit came from the screen source, not from a ray
        uint64_t replaced = 0;    ///< pixels whose screen result was replaced by the rays' result
        uint64_t reusedLight = 0; ///< hits that reused light from the frame
    } scene;
};

/// Records reflections into the host's command buffers. One object has one image size, one set of settings and one
/// history: the previous frame of a recording is the recording before it, whatever its view. Several views may share an
/// object, in turn, while no setting keeps data from frame to frame: each gets the same bits as from an object of its
/// own. With screen.colorSource previous, denoise.enabled or rays.accumulate each view needs its own object: a shared
/// one looks up the other view's image where both show the same surface, with the light that the other eye sees;
/// GBuffer::motion does not lead there; and rays.accumulate starts again with every recording. View::cut in every
/// recording also keeps views apart: no frame then has a history. Not thread-safe.
///
/// Frames in flight: objects that a call replaces (images, pipelines) are freed by the first `record` of a frame that
/// is framesInFlight after the newest frame that may use them. The host needs no other wait, except that the GPU must
/// be done before this object is destroyed. The host submits command buffers to one queue, in any order, or not at all:
/// a command buffer that is never submitted loses only the history of its frame.
class GLINT_API Reflections {
public:
    /// Creates the pipelines and images that the settings need and validates the frame in advance, so that `record`
    /// cannot fail. Compiles on all cores, for the duration of the call; pipelines that the context has are shared.
    /// Errors: InvalidArgument (size, settings), OutOfMemory, Unsupported.
    static Result<Reflections> create(Context& context, const ReflectionsDesc& desc);
    ~Reflections();
    Reflections(Reflections&&) noexcept;
    Reflections& operator=(Reflections&&) noexcept;

    /// Replaces all images by images of this size. Pipelines, settings and what setRays, setPlanar and setProbes set
    /// are kept. Call setInputs, and setOutputs for images of the host, before the next `record`, which has no history.
    /// For a size that changes often use View::width and height instead. Replaced images are freed as the class states.
    /// Errors: InvalidArgument (size), OutOfMemory; then the old size stays in force.
    Result<void> resize(uint32_t width, uint32_t height);

    /// Applies new settings, and creates the images that they need for the first time.
    /// Errors: InvalidArgument names the setting; OutOfMemory. After an error the old settings stay in force.
    Result<void> setSettings(const Settings& settings);

    /// Sets the host's images. Call it again when any of them changes. The environment is optional.
    /// Errors: InvalidArgument names the image that is missing, has a wrong size, has no layout, or has a format, usage
    /// or view type that cannot be read; OutOfMemory.
    Result<void> setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment = {});

    /// Sets the host's images that `record` writes to; without an image in `outputs`, it writes to an image of Glint's.
    /// Call it again when any of them changes. The next frame has no previous image to take colours from.
    /// Errors: InvalidArgument names the image that is missing, has a wrong size, format or usage, has no layout, or is
    /// an image of the G-buffer; or says that screen.colorSource previous needs `composite`.
    Result<void> setOutputs(const Outputs& outputs);

    /// Sets the geometry and the surfaces of the source `rays`, and creates its pipelines. Both objects must outlive
    /// the frames that use them. When objects move, the host records both (RayScene::record, SurfaceTable::record)
    /// before the frame that shows the change.
    /// Errors: InvalidArgument if the scene's back end does not match rays.backend; OutOfMemory; Unsupported.
    Result<void> setRays(RayScene& scene, SurfaceTable& surfaces);

    /// Sets the geometry of the source `rays` for a host that shades hits itself. Each record() calls `shade` after the
    /// commands that trace the rays. Glint traces one ray per pixel in the direction of rays.lobe, and every triangle
    /// is solid; rays.samples, bounces, alphaTest and accumulate have no effect. The host shades misses too, including
    /// the environment.
    Result<void> setRays(RayScene& scene, ShadeHits shade);

    /// Sets the mirrors of the source `planar`, which must outlive the frames that use them. Record the mirror images
    /// of a frame (PlanarMirrors::record) before the frame. Without mirrors the source costs nothing.
    /// Errors: OutOfMemory.
    Result<void> setPlanar(PlanarMirrors& mirrors);

    /// Sets the probes of the source `probes`, which must outlive the frames that use them. Record the probes
    /// (Probes::record) before the first of these frames. Without probes the source costs nothing.
    /// Errors: OutOfMemory.
    Result<void> setProbes(Probes& probes);

    /// Restarts rays.accumulate with the next frame. Call it after changes that Glint cannot detect, as of lights,
    /// materials or objects. Accumulation restarts automatically if the view, the settings or the scene given to
    /// setRays change.
    void restartAccumulation();

    /// Records the frame's passes. Never submits or waits, allocates no memory of any kind and creates no Vulkan
    /// object. Call it outside a render pass, after setInputs.
    ///
    /// Returns the image with reflections (RGBA16F). It is the same image and view in every frame, so descriptors of it
    /// may be written once, and its content is valid until the next call. With screen.colorSource previous the next
    /// frame reads it again, so its reflections show what the host draws over the image. Leave the image in its layout.
    ///
    /// With images of setOutputs, the results are in these, in their layouts; returned is `composite`, or `reflection`
    /// if that is alone. Without them the image is Glint's and ready for sampling; with every source off no pass runs
    /// then, and the returned image is litRadiance itself, bit for bit.
    ///
    /// With View::width and height smaller than the images, only that part of them is read, and only that part of the
    /// results is written. Histories continue when it changes: the previous frame's extent is known. Motion is in UV of
    /// the extent in use, before and now.
    ///
    /// Invalid calls are: no inputs, no command buffer, a view with a non-finite number, a matrix without an inverse,
    /// or an extent larger than the images. An invalid call records nothing, adds one note (notes()) and returns
    /// litRadiance, or no image before setInputs.
    HostImage record(VkCommandBuffer commands, const View& view);

    /// Records a transparent layer over the image of the last recorded frame, in place. Requires
    /// ReflectionsDesc::transparentLayers. Call it for each layer, farthest first, in the command buffer of that frame.
    ///
    /// `picture` is the image that record, or recordLayer of the previous layer, returned, with its current layout.
    /// Geometry that the host draws between two layers is visible through the later layer. Layers refract and reflect
    /// from their own sources, in this order: screen (by the depth pyramid), probes, sky. The environment must be in
    /// the layout that setInputs declared; no other input is read. With refraction.enabled off, or with debug colours,
    /// Glint draws no layers and returns `picture`: the host then draws transparent surfaces itself.
    ///
    /// Cost: up to three marches and 34 fetches from the image per layer pixel, and the mips of the image.
    /// Errors: InvalidArgument names the image that is missing or has a wrong size, or says that no frame was recorded,
    /// or that the frame used only a part of its images.
    Result<HostImage> recordLayer(VkCommandBuffer commands, const TransparentLayer& layer, const HostImage& picture);

    /// Records a debug view of the last recorded frame into an RGBA32F image. Requires ReflectionsDesc::views. Values
    /// are raw, in metres and unit vectors, not scaled for display.
    /// Errors: InvalidArgument for an unknown view, with the nearest name, or if no frame was recorded.
    Result<HostImage> recordView(VkCommandBuffer commands, std::string_view name);
    /// Returns the names of the views. recordView accepts the names of passImages too.
    static std::vector<std::string_view> viewNames();
    /// Returns the images that the passes of the last recorded frame wrote, as "trace/hiz:radianceWeight". As a view,
    /// an image has the content of the frame's end, and the nearest texel where its size is another. Requires
    /// ReflectionsDesc::views.
    std::vector<std::string> passImages() const;

    /// Records a trace of the ray of pixel (x, y), from the top left, of the last recorded frame, and logs every step
    /// of the ray. Requires ReflectionsDesc::inspection. The host's images must still hold that frame, in the layouts
    /// that the host declared. The trace uses the frame's own settings and images, whose contents stay bit-identical.
    /// Errors: InvalidArgument if no frame was recorded, or if the pixel is outside the image.
    Result<void> recordInspection(VkCommandBuffer commands, uint32_t x, uint32_t y);
    /// Returns the inspection of the last inspected pixel. Call it after the GPU has finished that inspection.
    RayInspection inspection() const;

    /// Records a check of the host's declarations (Conventions, View, motion) against the images of the last recorded
    /// frame: copies samples of them. Requires ReflectionsDesc::inputCheck. The host's images must still hold that
    /// frame, in the layouts that the host declared. `plane`: null, or a flat surface of known place that at least a
    /// tenth of the pixels shows; the check then finds wrong distances too.
    /// Errors: InvalidArgument if no frame was recorded, or for a plane without a unit normal.
    Result<void> recordInputCheck(VkCommandBuffer commands, const KnownPlane* plane = nullptr);
    /// Evaluates the newest check that the GPU has finished and returns it; `tested` is 0 until there is one. Never
    /// waits. Findings become notes. Cost: none without a new check, otherwise up to about 50 ms of the CPU if
    /// declarations are wrong or normals are bent by maps.
    const InputCheck& inputCheck();

    /// Returns the GPU time of each pass of the newest frame that the GPU has finished. Never waits. Empty without
    /// ReflectionsDesc::timers.
    std::vector<PassTime> passTimes();

    /// Returns the decisions on which passes frames have with the settings, inputs and sources in force.
    std::vector<FrameDecision> plan() const;

    /// Returns the statistics of the last recorded frame. Call it after the GPU has finished that frame. Empty without
    /// ReflectionsDesc::statistics.
    Statistics statistics();

    /// Returns notes for the host, each given once: for example, that reflections are added because the host did not
    /// provide fallbackSpecular, or why record() recorded nothing. With ReflectionsDesc::inputCheck, evaluates a
    /// finished check, as inputCheck does.
    const std::vector<std::string>& notes() const;

private:
    struct State;
    explicit Reflections(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace glint
