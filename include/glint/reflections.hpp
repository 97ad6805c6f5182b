// The library's main door: a G-buffer in, the same picture with reflections out.
#pragma once

#include "glint/api.hpp"
#include "glint/context.hpp"
#include "glint/gbuffer.hpp"
#include "glint/inspection.hpp"
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

/// A cube map, GGX-prefiltered: mip 0 for mirrors, the last mip for roughness 1, even steps of perceptual roughness
/// between. Faces and axes as Vulkan's cube maps have them.
struct EnvironmentMap {
    HostImage cube;
    uint32_t mips = 1;
    float strength = 1; ///< factor on its radiance
    float rotation = 0; ///< radians about world +Y, counter-clockwise seen from above
    bool flipY = false; ///< the cube is upside down, as probes that Babylon.js renders are
    /// Optional: a cube of irradiance / pi, for what rays hit. Absent: the cube's last mip stands in.
    HostImage diffuse;
};

struct ReflectionsDesc {
    uint32_t width = 0; ///< pixels, of every image of the G-buffer
    uint32_t height = 0;
    Settings settings;
    bool statistics = false;        ///< count outcomes and lookups each frame (a small pass more)
    bool views = false;             ///< keep an image for debug views
    bool inspection = false;        ///< make what recordInspection needs: a pipeline a marcher more, and 256 KiB
    bool transparentLayers = false; ///< make what recordLayer needs: the picture twice more, with mips
};

struct PassTime {
    std::string name; ///< "trace/linear"
    double milliseconds = 0;
};

/// How the rays of one frame ended, and what they cost.
struct Statistics {
    struct Outcome {
        std::string_view name; ///< "hit", "offScreen", ...
        uint64_t count = 0;    ///< pixels
    };
    std::vector<Outcome> outcomes;
    uint64_t rays = 0;
    double lookupsMean = 0; ///< depth reads a traced ray
    uint32_t lookups95 = 0; ///< 95th percentile

    /// What the source `rays` did; zeros without it.
    struct SceneRays {
        uint64_t pixels = 0;      ///< that it was asked for
        uint64_t rays = 0;        ///< through the host's triangles, those for shadows apart
        uint64_t fromScreen = 0;  ///< of the pixels: the first hit was the screen source's, and took no ray
        uint64_t replaced = 0;    ///< of the pixels: the screen source had an answer, and rays knew better
        uint64_t reusedLight = 0; ///< hits whose light was taken from the picture
    } scene;
};

/// One picture size, one set of settings, any number of views in turn. Not thread-safe.
class GLINT_API Reflections {
public:
    /// Makes every pipeline and image and rehearses the frame, so that `record` cannot fail.
    /// Errors: InvalidArgument (size, settings), OutOfMemory, Unsupported.
    static Result<Reflections> create(Context& context, const ReflectionsDesc& desc);
    ~Reflections();
    Reflections(Reflections&&) noexcept;
    Reflections& operator=(Reflections&&) noexcept;

    /// Makes images that the new settings need for the first time.
    /// Errors: InvalidArgument names the setting; OutOfMemory; the old ones stay in force.
    Result<void> setSettings(const Settings& settings);

    /// States the host's images; call again when any of them changes. The environment may be absent.
    /// When backDepth's size changes, the GPU must have finished the frames recorded with the old one.
    /// Errors: InvalidArgument says which image is missing or of another size; OutOfMemory.
    Result<void> setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment = {});

    /// States what the source `rays` goes through and what it looks like there; both must outlive the frames that use
    /// them. Makes that source's pipelines. Whoever moves things records both (RayScene::record, SurfaceTable::record)
    /// before the frame that should see it.
    /// Errors: InvalidArgument if the scene's back end is not the one that rays.backend asks for; OutOfMemory;
    /// Unsupported.
    Result<void> setRays(RayScene& scene, SurfaceTable& surfaces);

    /// The same for a host that shades hits itself: `shade` is called within each record(), after the rays were traced.
    /// One ray a pixel in the direction of rays.lobe, every triangle solid; rays.samples, bounces, alphaTest and
    /// accumulate do not act. What lies beyond the hits is the host's matter, the environment too.
    Result<void> setRays(RayScene& scene, ShadeHits shade);

    /// States the mirrors of the source `planar`, which must outlive the frames that use them; record the pictures of
    /// each frame (PlanarMirrors::record) before it. None at all cost nothing. When these replace others, the GPU must
    /// have finished the frames recorded with those. Errors: OutOfMemory.
    Result<void> setPlanar(PlanarMirrors& mirrors);

    /// States the probes of the source `probes`, which must outlive the frames that use them; record them
    /// (Probes::record) before the first of these. None at all cost nothing. When these replace others, the GPU must
    /// have finished the frames recorded with those. Errors: OutOfMemory.
    Result<void> setProbes(Probes& probes);

    /// With rays.accumulate the next frame starts anew, as it does by itself when the view, the settings or the scene
    /// given to setRays change: for what Glint cannot see, as when lights, materials or things have changed.
    void restartAccumulation();

    /// Records the frame's passes. Never submits or waits, and makes no Vulkan object and no device memory. Call
    /// outside a render pass, after setInputs.
    /// Returns the picture with reflections (RGBA16F, ready for sampling), valid until the next call; with every
    /// source off no pass runs and that is litRadiance itself, bit for bit.
    /// What the host draws over it is seen in the next frame's reflections with screen.colorSource previous, which
    /// reads it once more: leave it in its layout.
    HostImage record(VkCommandBuffer commands, const View& view);

    /// Records a transparent layer over the picture of the frame recorded last, in place (needs
    /// ReflectionsDesc::transparentLayers): call it for each layer, the farthest first, in the command buffer of that
    /// frame. `picture` is what record, or the layer before, returned, in the layout that it is in by now; what the
    /// host draws between layers is seen through the next. Refraction and reflection have a walk of their own: screen,
    /// by the depth pyramid, probes, sky. The environment is in the layout that setInputs stated; no other input is
    /// read. With refraction.enabled off, or debug colours, layers are not drawn, and `picture` comes back: a host has
    /// its own way then. Cost: up to three marches and 34 lookups of the picture a pixel of the layer, and the
    /// picture's mips. Errors: InvalidArgument says which image is missing or of another size, or that no frame was
    /// recorded.
    Result<HostImage> recordLayer(VkCommandBuffer commands, const TransparentLayer& layer, const HostImage& picture);

    /// Records a debug view of the frame recorded last into an RGBA32F image (needs ReflectionsDesc::views): raw
    /// values, metres and unit vectors, not scaled for display.
    /// Errors: InvalidArgument lists the views.
    Result<HostImage> recordView(VkCommandBuffer commands, std::string_view name);
    static std::vector<std::string_view> viewNames();

    /// Records the trace of the one ray of pixel (x, y), counted from the top left, of the frame recorded last, and
    /// writes down all that it does (needs ReflectionsDesc::inspection). The host's images must still hold that frame,
    /// in the layouts in which it handed them over. Traces with the frame's own settings, into its own images: they
    /// keep their bits.
    /// Errors: InvalidArgument if nothing was recorded, or the pixel lies outside the picture.
    Result<void> recordInspection(VkCommandBuffer commands, uint32_t x, uint32_t y);
    /// Of the pixel inspected last; call when the GPU has finished it.
    RayInspection inspection() const;

    /// GPU time of each pass of the newest frame that the GPU has finished. Never waits.
    std::vector<PassTime> passTimes();

    /// Of the frame recorded last; call when the GPU has finished it. Empty unless ReflectionsDesc::statistics.
    Statistics statistics();

    /// What the host should know once, e.g. that reflections cannot replace what it did not hand over.
    const std::vector<std::string>& notes() const;

private:
    struct State;
    explicit Reflections(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace glint
