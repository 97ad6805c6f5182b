#include "lab/session/file_host.hpp"

#include "base/assert.hpp"
#include "gpu/transfer.hpp"
#include "lab/job/job_environment.hpp"
#include "lab/renderer/lending.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace {

Error fixedError(const char* what) {
    return makeError(ErrorCode::Unsupported, "the {} of a G-buffer from a file cannot be changed", what);
}

/// Near and far planes around all surfaces, as their depth becomes device depth.
scene::Camera aroundSurfaces(const scene::Camera& camera, const scene::GBufferPixels& pixels) {
    float nearest = std::numeric_limits<float>::max(), farthest = 0;
    for (const float viewZ : pixels.viewZ)
        if (viewZ > 0) {
            nearest = std::min(nearest, viewZ);
            farthest = std::max(farthest, viewZ);
        }
    scene::Camera around = camera;
    around.near = std::min(camera.near, nearest / 2);
    around.far = camera.orthographic ? farthest * 1.01f : std::numeric_limits<float>::infinity();
    return around;
}

float deviceDepth(const scene::Camera& camera, float viewZ) {
    if (viewZ <= 0)
        return 0;
    const float depth = camera.orthographic ? (camera.far - viewZ) / (camera.far - camera.near) : camera.near / viewZ;
    return std::clamp(depth, 0.0f, 1.0f);
}

/// shaders/lib/octahedral.glsl.
glm::vec2 encodeOctahedral(const glm::vec3& direction) {
    const glm::vec2 p = glm::vec2(direction) / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    const glm::vec2 sign(p.x >= 0 ? 1 : -1, p.y >= 0 ? 1 : -1);
    return direction.z >= 0 ? p : (1.0f - glm::abs(glm::vec2(p.y, p.x))) * sign;
}

uint64_t packRgba(const glm::vec4& color) {
    return glm::packHalf4x16(color);
}

/// Converts each pixel with `texel` and uploads them.
template <class Texel>
Result<void> uploadPlane(gpu::Context& context, gpu::Image& image, size_t pixels, const Texel& texel) {
    std::vector<decltype(texel(size_t{0}))> texels(pixels);
    for (size_t i = 0; i < pixels; ++i)
        texels[i] = texel(i);
    return gpu::uploadImage(context, image, std::as_bytes(std::span(texels)));
}

} // namespace

Result<std::unique_ptr<FileHost>> FileHost::create(gpu::Context& context, Context& library,
                                                   std::shared_ptr<JobInputs> inputs,
                                                   std::shared_ptr<const scene::GBufferPixels> pixels,
                                                   std::shared_ptr<const ProbeSet> probes,
                                                   const ProgramSettings& settings) {
    std::unique_ptr<FileHost> host(
        new FileHost(context, library, std::move(inputs), std::move(pixels), std::move(probes), settings));
    GLINT_CHECK(host->make());
    return host;
}

Result<void> FileHost::make() {
    context_.addShaders(gpu::shaders::render());
    view_ = makeView(aroundSurfaces(inputs_->camera, *pixels_), inputs_->width, inputs_->height);
    GLINT_TRY(gbuffer, GBuffer::create(context_, inputs_->width, inputs_->height));
    gbuffer_ = std::move(gbuffer);
    GLINT_CHECK(upload());
    GLINT_TRY(environment, makeEnvironment(context_, *inputs_, settings_.render, StrongLights::Kept));
    environment_ = std::move(environment);
    GLINT_TRY(display, DisplayPass::create(context_));
    display_ = std::move(display);
    GLINT_CHECK(display_.resize(context_, inputs_->width, inputs_->height, settings_.render.display));
    if (probeSet_) {
        GLINT_TRY(probes, ProbeWorld::upload(context_, library_, *probeSet_));
        probes_ = std::make_unique<ProbeWorld>(std::move(probes));
    }
    return {};
}

Result<void> FileHost::setFrame(std::shared_ptr<JobInputs> inputs, std::shared_ptr<const scene::GBufferPixels> pixels) {
    GLINT_ASSERT(inputs->width == inputs_->width && inputs->height == inputs_->height, "{}x{} after {}x{}",
                 inputs->width, inputs->height, inputs_->width, inputs_->height);
    inputs_ = std::move(inputs);
    pixels_ = std::move(pixels);
    follows_ = true;
    view_ = makeView(aroundSurfaces(inputs_->camera, *pixels_), inputs_->width, inputs_->height);
    return upload();
}

Result<void> FileHost::upload() {
    const scene::GBufferPixels& p = *pixels_;
    const size_t count = p.viewZ.size();
    const scene::Camera camera = aroundSurfaces(inputs_->camera, p);
    GLINT_CHECK(
        uploadPlane(context_, gbuffer_.deviceDepth, count, [&](size_t i) { return deviceDepth(camera, p.viewZ[i]); }));
    const auto octahedral = [&](size_t i) { return p.viewZ[i] > 0 ? encodeOctahedral(p.normalWS[i]) : glm::vec2(0); };
    if (gbuffer_.normal.desc().format == VK_FORMAT_R16G16_SNORM)
        GLINT_CHECK(
            uploadPlane(context_, gbuffer_.normal, count, [&](size_t i) { return glm::packSnorm2x16(octahedral(i)); }));
    else
        GLINT_CHECK(uploadPlane(context_, gbuffer_.normal, count, octahedral));
    GLINT_CHECK(uploadPlane(context_, gbuffer_.material, count, [&](size_t i) { return packRgba(p.material[i]); }));
    GLINT_CHECK(uploadPlane(context_, gbuffer_.motion, count, [&](size_t i) {
        return packRgba(p.motionUV.empty() ? glm::vec4(0) : glm::vec4(p.motionUV[i], 0, 0));
    }));
    GLINT_CHECK(uploadPlane(context_, gbuffer_.litRadiance, count,
                            [&](size_t i) { return packRgba(glm::vec4(p.litRadiance[i], 1)); }));
    GLINT_CHECK(uploadPlane(context_, gbuffer_.fallbackSpecular, count, [&](size_t i) {
        return packRgba(p.fallbackSpecular.empty() ? glm::vec4(0) : glm::vec4(p.fallbackSpecular[i], 1));
    }));
    return uploadPlane(context_, gbuffer_.albedo, count, [&](size_t i) {
        return glm::packUnorm4x8(glm::vec4(p.baseColor[i], p.viewZ[i] > 0 ? 1.0f : 0.0f));
    });
}

Result<void> FileHost::setSettings(const ProgramSettings& settings) {
    settings_ = settings;
    GLINT_TRY(environment, makeEnvironment(context_, *inputs_, settings_.render, StrongLights::Kept));
    environment_ = std::move(environment);
    return display_.resize(context_, inputs_->width, inputs_->height, settings_.render.display);
}

Result<void> FileHost::resize(uint32_t, uint32_t) {
    return fixedError("size");
}
Result<void> FileHost::setCamera(const scene::Camera&) {
    return fixedError("camera");
}
Result<bool> FileHost::setTime(double, Reflections&) {
    return fixedError("time");
}
Result<bool> FileHost::setMaterials(const scene::MaterialOverrides&, Reflections&) {
    return fixedError("materials");
}

Result<std::unique_ptr<HostFrame>> FileHost::remade(Context& library) {
    GLINT_TRY(host, create(context_, library, inputs_, pixels_, probeSet_, settings_));
    return std::unique_ptr<HostFrame>(std::move(host));
}

/// The alpha of the file's picture is no mean without highlights, and its motion tells nothing of depth. Without motion
/// the library takes all surfaces to stand still: where the file has none, and in the first frame, which is repeated.
glint::GBuffer FileHost::lend(gpu::Frame& frame) {
    glint::GBuffer inputs = lendGBuffer(frame, gbuffer_);
    inputs.conventions.highlightsInAlpha = false;
    inputs.conventions.motionDepthScale = 0;
    if (pixels_->fallbackSpecular.empty())
        inputs.fallbackSpecular = {};
    if (!follows_ || pixels_->motionUV.empty())
        inputs.motion = {};
    return inputs;
}

EnvironmentMap FileHost::lendEnvironment(gpu::Frame& frame) {
    if (inputs_->environment == EnvironmentKind::None)
        return {};
    return lendEnvironmentMap(frame, environment_, settings_.render.environment);
}

void FileHost::display(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& target) {
    display_.draw(frame, radiance, target, settings_.render.display);
}

Result<void> FileHost::giveSources(Reflections& reflections) {
    return probes_ ? reflections.setProbes(probes_->probes()) : Result<void>();
}

} // namespace glint::render
