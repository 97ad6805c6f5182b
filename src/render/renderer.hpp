// The renderer of our own programs: a posed scene and an environment in, a lit G-buffer out; then what is drawn over
// it, and the picture for the screen.
#pragma once

#include "render/back_face_pass.hpp"
#include "render/background_pass.hpp"
#include "render/display_pass.hpp"
#include "render/shadow_maps.hpp"
#include "render/transparent_layers.hpp"
#include "render/transparent_pass.hpp"

#include <optional>

namespace glint::render {

/// Where a frame is seen from.
struct ViewParameters {
    scene::Camera camera;
    std::optional<scene::Camera> prevCamera; ///< of the frame before, for motion; none: the camera stands still
    glm::vec2 jitterPX = glm::vec2(0);       ///< pixels, [-0.5, 0.5]
    glm::vec2 prevJitterPX = glm::vec2(0);
    /// Draw the sun's disc, and lights' highlights on what is smooth. Pictures that are looked up from elsewhere leave
    /// them out: lights have highlights of their own there, and these belong to one viewer.
    bool highlights = true;
    bool sunDisc = true; ///< draw it where the highlights are
    /// (n, d): surfaces are drawn where dot(n, positionWS) + d > 0, for pictures from behind a mirror.
    glm::vec4 clipPlaneWS = glm::vec4(0, 0, 0, 1);
};

/// Images that a frame is drawn into, beside the renderer's own: for a view more in the same frame.
struct RenderTarget {
    GBuffer gbuffer;
    gpu::Image behind; ///< what light-transmitting surfaces see
};

/// A frame:
///     GBuffer& g = renderer.drawOpaque(frame, parameters);
///     ... reflections: g -> hdr
///     renderer.drawTransparent(frame, hdr);
///     renderer.display(frame, hdr, ldr);
/// Recording does not wait and allocates nothing on the GPU. The same input gives the same bits.
class Renderer {
public:
    /// Uploads the scene. `context` must know gpu::shaders::render() (Context::addShaders) and outlive the renderer;
    /// `scene` and `pose` are only read.
    /// Errors: OutOfMemory, DeviceLost, Unsupported.
    static Result<Renderer> create(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose,
                                   Environment&& environment, const RenderSettings& settings);

    /// Makes the G-buffer; call before the first frame and when its size or how it is drawn changes.
    /// Errors: InvalidArgument for a size outside what the device can make; Unsupported for a number of samples that it
    /// cannot draw; OutOfMemory.
    Result<void> resize(uint32_t width, uint32_t height, const GBufferOptions& options = {});
    /// Of another size, drawn as the renderer's own is, until the next resize that changes how.
    /// Errors: as resize.
    Result<RenderTarget> makeTarget(uint32_t width, uint32_t height) const;
    /// Takes new settings; makes larger shadow maps if they ask for some. `analyticSky` is the environment's matter:
    /// see Environment::createSky and setEnvironment; samples a pixel are the G-buffer's: see resize.
    /// Errors: OutOfMemory.
    Result<void> setSettings(const RenderSettings& settings);
    /// What traces shadows with lights.shadows rays: set it before the first resize or setSettings that finds it so. It
    /// is kept, and shows this renderer's scene. Errors: OutOfMemory.
    Result<void> setRayWorld(RayWorld* rayWorld);
    Result<void> setEnvironment(Environment&& environment);
    /// Another moment of the same scene (GpuScene::setPose).
    Result<void> setPose(const scene::Scene& scene, const scene::Pose& pose);

    /// The G-buffer with every opaque surface and the background. Valid until the next call or resize.
    GBuffer& drawOpaque(gpu::Frame& frame, const ViewParameters& parameters);
    GBuffer& drawOpaque(gpu::Frame& frame, const ViewParameters& parameters, RenderTarget& target);
    /// Blended and light-transmitting surfaces over `hdr` (RGBA16F with COLOR_ATTACHMENT and TRANSFER_SRC usage, of the
    /// G-buffer's size), seen as in the last drawOpaque. Records nothing if the scene has none.
    void drawTransparent(gpu::Frame& frame, gpu::Image& hdr);
    void drawTransparent(gpu::Frame& frame, gpu::Image& hdr, RenderTarget& target);
    /// Makes room for up to `most` layers of transparent surfaces in the G-buffer's size; 0: none. Call after resize,
    /// and again when that or how it is drawn changes. Errors: OutOfMemory.
    Result<void> makeLayers(uint32_t most);
    /// The depths of all layers, seen as in the last drawOpaque; then each of them is drawn, from the farthest on.
    void peelLayers(gpu::Frame& frame);
    LayerImages& drawLayer(gpu::Frame& frame, uint32_t layer);
    TransparentLayers* layers() { return layers_ ? &*layers_ : nullptr; }
    /// Exposure, tone map and sRGB into `ldr` (RGBA8_UNORM with STORAGE usage, of the same size).
    void display(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr);

    /// The view of the last drawOpaque, or of the next one with these parameters.
    View view(const ViewParameters& parameters) const;
    GBuffer& gbuffer() { return target_.gbuffer; }
    Environment& environment() { return environment_; }
    const scene::Bounds& boundsWS() const { return scene_.boundsWS(); }
    GpuScene& scene() { return scene_; }
    const std::vector<shared::Light>& lights() const { return lights_; } ///< the scene's, then the sun's

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
    std::vector<shared::Light> lights_; ///< of the frame: the scene's, then the sun's
    ShadowMaps shadows_;
    RayWorld* rayWorld_ = nullptr;
    std::optional<RayBackend> shadowBackend_; ///< that the passes were made for; none: shadow maps
    bool lightsChanged_ = true;
    SurfacePass surfaces_;
    BackgroundPass background_;
    BackFacePass backFaces_;
    TransparentPass transparent_;
    std::optional<TransparentLayers> layers_;
    bool layersFit_ = false; ///< they were made for the G-buffer and the passes that there are
    DisplayPass display_;
    RenderTarget target_;
    GBufferOptions gbufferOptions_;
    View view_;
};

} // namespace glint::render
