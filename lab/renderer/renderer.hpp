// The renderer of our own programs: draws a posed scene and an environment into a lit G-buffer, then draws transparent
// surfaces over the lit image and converts it for display.
#pragma once

#include "lab/renderer/back_face_pass.hpp"
#include "lab/renderer/background_pass.hpp"
#include "lab/renderer/display_pass.hpp"
#include "lab/renderer/shadow_maps.hpp"
#include "lab/renderer/transparent_layers.hpp"
#include "lab/renderer/transparent_pass.hpp"

#include <optional>

namespace glint::render {

/// The viewpoint of a frame.
struct ViewParameters {
    scene::Camera camera;
    /// Camera of the previous frame, for motion; none: the camera does not move.
    std::optional<scene::Camera> prevCamera;
    glm::vec2 jitterPX = glm::vec2(0); ///< pixels, [-0.5, 0.5]
    glm::vec2 prevJitterPX = glm::vec2(0);
    /// Draw the sun's disc, and the lights' highlights on smooth surfaces. Images that other surfaces fetch their
    /// reflections from leave them out: lights have their own highlights on those surfaces, and highlights depend on
    /// the viewer.
    bool highlights = true;
    bool sunDisc = true; ///< draw the sun's disc where highlights are drawn
    /// (n, d): surfaces are drawn where dot(n, positionWS) + d > 0, for mirrored views.
    glm::vec4 clipPlaneWS = glm::vec4(0, 0, 0, 1);
};

/// Render targets besides the renderer's own, for an additional view in the same frame.
struct RenderTarget {
    GBuffer gbuffer;
    gpu::Image behind; ///< the image that transmissive surfaces fetch from
};

/// A frame:
///     GBuffer& g = renderer.drawOpaque(frame, parameters);
///     ... reflections: g -> hdr
///     renderer.drawTransparent(frame, hdr);
///     renderer.display(frame, hdr, ldr);
/// Recording does not wait and allocates nothing on the GPU. The same input gives the same bits.
class Renderer {
public:
    /// Uploads the scene. `context` must have gpu::shaders::render() registered (Context::addShaders) and must outlive
    /// the renderer; `scene` and `pose` are only read. Errors: OutOfMemory, DeviceLost, Unsupported.
    static Result<Renderer> create(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose,
                                   Environment&& environment, const RenderSettings& settings);

    /// Creates the G-buffer. Call before the first frame and when the size or the options change. Errors:
    /// InvalidArgument for a size that the device does not support; Unsupported for an unsupported sample count;
    /// OutOfMemory.
    Result<void> resize(uint32_t width, uint32_t height, const GBufferOptions& options = {});
    /// Creates a target of another size with the renderer's current options; valid until a resize changes the options.
    /// Errors: as resize.
    Result<RenderTarget> makeTarget(uint32_t width, uint32_t height) const;
    /// Sets new settings; enlarges the shadow maps if necessary. `analyticSky` is not applied here: see
    /// Environment::createSky and setEnvironment. Nor are samples per pixel: see resize. Errors: OutOfMemory.
    Result<void> setSettings(const RenderSettings& settings);
    /// Sets what traces shadows with lights.shadows rays. Call before the first resize or setSettings with that
    /// setting. The renderer keeps the pointer; `rayWorld` must show this renderer's scene. Errors: OutOfMemory.
    Result<void> setRayWorld(RayWorld* rayWorld);
    Result<void> setEnvironment(Environment&& environment);
    /// Poses the same scene at another time (GpuScene::setPose).
    Result<void> setPose(const scene::Scene& scene, const scene::Pose& pose);
    /// Call after the scene's materials have changed. Returns false if a new Renderer is needed
    /// (GpuScene::setMaterials).
    Result<bool> setMaterials(const scene::Scene& scene, const scene::Pose& pose);

    /// Returns the G-buffer with every opaque surface and the background. Valid until the next call or resize.
    GBuffer& drawOpaque(gpu::Frame& frame, const ViewParameters& parameters);
    GBuffer& drawOpaque(gpu::Frame& frame, const ViewParameters& parameters, RenderTarget& target);
    /// Draws blended and transmissive surfaces over `hdr` (RGBA16F with COLOR_ATTACHMENT and TRANSFER_SRC usage, of the
    /// G-buffer's size), with the view of the last drawOpaque. Records nothing if the scene has no such surface.
    void drawTransparent(gpu::Frame& frame, gpu::Image& hdr);
    void drawTransparent(gpu::Frame& frame, gpu::Image& hdr, RenderTarget& target);
    /// Allocates up to `most` layers of transparent surfaces in the G-buffer's size; 0: none. Call after resize, and
    /// again when the size or options change. Errors: OutOfMemory.
    Result<void> makeLayers(uint32_t most);
    /// Finds the depths of all layers with the view of the last drawOpaque. After that, draw each layer, starting with
    /// the farthest.
    void peelLayers(gpu::Frame& frame);
    LayerImages& drawLayer(gpu::Frame& frame, uint32_t layer);
    TransparentLayers* layers() { return layers_ ? &*layers_ : nullptr; }
    /// Applies exposure, tone map and sRGB encoding, and writes `ldr` (RGBA8_UNORM with STORAGE usage, of the same
    /// size).
    void display(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr);

    /// Returns the view of the last drawOpaque, or of the next one with these parameters.
    View view(const ViewParameters& parameters) const;
    GBuffer& gbuffer() { return target_.gbuffer; }
    Environment& environment() { return environment_; }
    const scene::Bounds& boundsWS() const { return scene_.boundsWS(); }
    GpuScene& scene() { return scene_; }
    const std::vector<shared::Light>& lights() const { return lights_; } ///< the scene's lights, then the suns

private:
    explicit Renderer(gpu::Context& context) : context_(&context) {}
    Result<void> placeLights();
    Result<void> makePasses(const GBufferOptions& options);
    Result<void> remakePasses();
    Result<void> rehearse();
    void updateView(gpu::Frame& frame, const ViewParameters& parameters, const RenderTarget& target);
    LightingInputs lightingInputs();
    RayWorld* shadowRays() const;

    gpu::Context* context_;
    RenderSettings settings_;
    GpuScene scene_;
    Environment environment_;
    gpu::Image dfg_;
    gpu::Buffer viewBuffer_;
    gpu::Buffer lightBuffer_;
    std::vector<shared::Light> sceneLights_;
    std::vector<shared::Light> lights_; ///< of the frame: the scene's lights, then the suns
    ShadowMaps shadows_;
    RayWorld* rayWorld_ = nullptr;
    std::optional<RayBackend> shadowBackend_; ///< the ray back end that the passes were created for; none: shadow maps
    bool lightsChanged_ = true;
    SurfacePass surfaces_;
    BackgroundPass background_;
    BackFacePass backFaces_;
    TransparentPass transparent_;
    std::optional<TransparentLayers> layers_;
    bool layersFit_ = false; ///< the layers were created for the current G-buffer and passes
    DisplayPass display_;
    RenderTarget target_;
    GBufferOptions gbufferOptions_;
    View view_;
};

} // namespace glint::render
