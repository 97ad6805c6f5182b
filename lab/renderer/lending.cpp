#include "lab/renderer/lending.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace glint::render {
namespace {

Matrix4 toMatrix4(const glm::mat4& matrix) {
    Matrix4 out;
    std::copy_n(glm::value_ptr(matrix), 16, out.begin());
    return out;
}

} // namespace

Result<std::shared_ptr<Context>> adoptDevice(gpu::Context& context) {
    if (context.companion().use_count() == 1)
        return std::static_pointer_cast<Context>(context.companion());
    const gpu::AdoptedDevice handles = context.handles();
    GLINT_TRY(library, Context::adopt({handles.instance, handles.physicalDevice, handles.device, handles.queueFamily,
                                       handles.getInstanceProcAddr, handles.rayQuery}));
    library.gpu().replaceShaders(context.replacedShaders());
    auto adopted = std::make_shared<Context>(std::move(library));
    context.companion() = adopted;
    return adopted;
}

HostImage lend(gpu::Frame& frame, gpu::Image& image) {
    frame.hand(image, kSampled);
    HostImage host = {image.handle(), image.view(), image.desc().format, image.width(), image.height()};
    host.samples = image.desc().samples;
    host.usage = image.desc().usage;
    host.mips = image.desc().mips;
    host.viewType = image.desc().shape == gpu::ImageShape::Cube ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
    return host;
}

gpu::Image borrow(const HostImage& image, const char* name, uint32_t mips, uint32_t layers) {
    gpu::ResourceState state;
    state.writeStages = image.stages;
    state.writeAccess = image.access;
    state.layout = image.layout;
    return gpu::Image::borrow(image.image, image.view,
                              {name, image.format, image.width, image.height, mips, layers, gpu::ImageShape::Flat, 0},
                              state);
}

glint::GBuffer lendGBuffer(gpu::Frame& frame, GBuffer& g) {
    glint::GBuffer inputs; // our conventions are Glint's own
    inputs.conventions.highlightsInAlpha = true;
    inputs.conventions.motionDepthScale = g.multisampled.motion ? 0.0f : 1.0f; // a mean over samples is of no surface
    inputs.depth = lend(frame, g.deviceDepth);
    inputs.normal = lend(frame, g.normal);
    inputs.material = lend(frame, g.material);
    inputs.litRadiance = lend(frame, g.litRadiance);
    inputs.fallbackSpecular = lend(frame, g.fallbackSpecular);
    if (g.lobes) {
        const HostImage lobes = lend(frame, g.lobes);
        inputs.f90 = {lobes, 0};
        if (g.coat) {
            inputs.coat = {lobes, 1};
            inputs.coatRoughness = {lobes, 2};
            inputs.coatNormal = lend(frame, g.coatNormal);
        }
    }
    if (g.backDepth)
        inputs.backDepth = lend(frame, g.backDepth);
    inputs.motion = lend(frame, g.motion);
    return inputs;
}

TransparentLayer lendLayer(gpu::Frame& frame, gpu::Image& depth, LayerImages& layer, gpu::Image& coverage) {
    TransparentLayer inputs;
    inputs.depth = lend(frame, depth);
    inputs.normal = lend(frame, layer.normal);
    inputs.material = lend(frame, layer.material);
    inputs.radiance = lend(frame, layer.radiance);
    inputs.fallbackSpecular = lend(frame, layer.fallbackSpecular);
    inputs.transmittance = lend(frame, layer.transmittance);
    inputs.absorption = lend(frame, layer.absorption);
    inputs.body = lend(frame, layer.body);
    inputs.objectCenter = lend(frame, layer.objectCenter);
    if (coverage)
        inputs.coverage = lend(frame, coverage);
    return inputs;
}

EnvironmentMap lendEnvironmentMap(gpu::Frame& frame, Environment& environment, const EnvironmentSettings& settings) {
    gpu::Image& cube = environment.radiance();
    EnvironmentMap map = {lend(frame, cube), cube.desc().mips, settings.strength * environment.unit(),
                          glm::radians(settings.rotation)};
    map.diffuse = lend(frame, environment.diffuse());
    return map;
}

glint::View libraryView(const View& view, uint32_t frameIndex, uint32_t seed) {
    return {toMatrix4(view.worldToView), toMatrix4(view.viewToClip), frameIndex, seed};
}

} // namespace glint::render
