#include "reflect/frame.hpp"

#include "reflect/conventions.hpp"
#include "shared/outcome.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstring>

namespace glint::reflect {
namespace {

constexpr uint32_t kDfgSize = 64;

/// A host's images are read texel by texel, and many of their formats (depth, 16-bit normals) need not be filterable.
constexpr gpu::SamplerKind kTexels = gpu::SamplerKind::NearestClamp;

size_t indexOf(March march) {
    const std::span<const Technique> all = techniques();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Technique& technique) { return technique.march == march; });
    return found == all.end() ? 0 : static_cast<size_t>(found - all.begin());
}

} // namespace

// ---------------------------------------------------------------- the frame, top to bottom

void FrameState::record(gpu::Frame& frame, const View& view) {
    makeTables(frame);
    prepare(frame, view);
    if (desc.settings.screen.enabled)
        trace(frame);
    else
        forgetTrace(frame);
    combine(frame);
    compose(frame);
    if (desc.statistics && desc.settings.screen.enabled)
        countOutcomes(frame);
}

bool FrameState::anySource() const {
    const bool sky = desc.settings.sky.enabled && inputs.environment;
    return desc.settings.reflect.strength > 0 && (desc.settings.screen.enabled || sky);
}

void FrameState::makeTables(gpu::Frame& frame) {
    if (tablesMade && !frame.rehearsing())
        return;
    frame.pass(pipelines.dfg).write("dfg", dfg).dispatch(kDfgSize, kDfgSize);
    frame.clear(black, {});
    frame.clear(blackCube, {});
    tablesMade = !frame.rehearsing();
}

void FrameState::prepare(gpu::Frame& frame, const View& view) {
    shared::FrameConstants constants = makeFrameConstants(view, conventions, desc.width, desc.height);
    constants.flags |= (inputs.environment ? shared::kInputEnvironment : 0) |
                       (inputs.fallbackSpecular ? shared::kInputFallback : 0) |
                       (inputs.material ? shared::kInputMaterial : 0) |
                       (desc.settings.gbuffer.depthFormat == DepthFormat::Half ? shared::kInputHalfDepth : 0);
    constants.environmentStrength = environmentStrength;
    constants.environmentMips = static_cast<float>(environmentMips);
    constants.worldToEnvironment = glm::rotate(glm::scale(glm::mat4(1), glm::vec3(1, environmentFlipY ? -1 : 1, 1)),
                                               -environmentRotation, glm::vec3(0, 1, 0));
    frame.update(frameConstants, &constants, sizeof(constants));
    prepareSurface(frame, inputs.depth.desc().samples > 1);
    if (frame.rehearsing())
        prepareSurface(frame, true);
    prepareBackFaces(frame);
}

void FrameState::prepareSurface(gpu::Frame& frame, bool manySamples) {
    // What this kind of host does not have is not looked at: any image stands in that has as many samples.
    gpu::Image& material = inputs.material ? inputs.material : inputs.normal;
    gpu::Pass pass = frame.pass(manySamples ? pipelines.surfaceSamples : pipelines.surface);
    pass.read("frame", frameConstants)
        .read("depth", inputs.depth, kTexels)
        .read("normal", inputs.normal, kTexels)
        .read("material", material, kTexels)
        .read("baseColor", inputs.baseColor ? inputs.baseColor : material, kTexels)
        .write("viewZ", prepared.viewZ)
        .write("surface", prepared.surface)
        .write("resolvedMaterial", prepared.material);
    if (manySamples)
        pass.write("edge", prepared.edge);
    pass.dispatch(desc.width, desc.height);
}

void FrameState::prepareBackFaces(gpu::Frame& frame) {
    if (hasBackFaces || frame.rehearsing())
        frame.pass(pipelines.backFaces)
            .read("frame", frameConstants)
            .read("backDepth", inputs.backDepth, kTexels)
            .write("backViewZ", prepared.backViewZ)
            .dispatch(prepared.backViewZ.width(), prepared.backViewZ.height());
    else if (!noBackFaces)
        frame.clear(prepared.backViewZ, {.float32 = {shared::kBackgroundZ}});
    noBackFaces = !hasBackFaces && !frame.rehearsing();
}

void FrameState::trace(gpu::Frame& frame) {
    const size_t index = indexOf(desc.settings.screen.march);
    techniques()[index].record(frame, pipelines.trace[index], desc.settings, {frameConstants, inputs, prepared},
                               traced);
    untraced = false;
}

/// While the screen source is off, its images say that no ray was traced.
void FrameState::forgetTrace(gpu::Frame& frame) {
    if (untraced)
        return;
    frame.clear(traced.radianceWeight, {});
    frame.clear(traced.rayRecord, {});
    untraced = !frame.rehearsing();
}

void FrameState::combine(gpu::Frame& frame) {
    const shared::HierarchyConstants constants = {desc.settings.screen.enabled, desc.settings.sky.enabled};
    frame.pass(pipelines.combine)
        .read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("radianceWeight", traced.radianceWeight)
        .read("environment", inputs.environment ? inputs.environment : blackCube)
        .write("reflected", reflected.reflected)
        .write("weights", reflected.weights)
        .push(constants)
        .dispatch(desc.width, desc.height);
}

void FrameState::compose(gpu::Frame& frame) {
    const Settings& settings = desc.settings;
    const shared::CompositeConstants constants = {static_cast<uint32_t>(settings.composite.model),
                                                  settings.reflect.fresnel,
                                                  settings.debug.outcome,
                                                  settings.reflect.strength,
                                                  settings.reflect.falloffExponent,
                                                  static_cast<uint32_t>(settings.screen.maxSteps)};
    frame.pass(pipelines.composite)
        .read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", prepared.material, kTexels)
        .read("edge", prepared.edge)
        .read("litRadiance", inputs.litRadiance, kTexels)
        .read("fallbackSpecular", inputs.fallbackSpecular ? inputs.fallbackSpecular : black, kTexels)
        .read("reflected", reflected.reflected)
        .read("rayRecord", traced.rayRecord)
        .read("dfg", dfg)
        .write("composite", composite)
        .push(constants)
        .dispatch(desc.width, desc.height);
}

void FrameState::countOutcomes(gpu::Frame& frame) {
    frame.fill(statistics, 0);
    frame.pass(pipelines.statistics)
        .read("rayRecord", traced.rayRecord)
        .readWrite("statistics", statistics)
        .dispatch(desc.width, desc.height);
    frame.copyBuffer(statistics, statisticsReadback);
}

void FrameState::recordView(gpu::Frame& frame, uint32_t which) {
    if (!upToDate) {
        makeTables(frame);
        prepare(frame, lastView);
        forgetTrace(frame);
        combine(frame);
        upToDate = !frame.rehearsing();
    }
    const shared::ViewConstants constants = {which, static_cast<uint32_t>(desc.settings.screen.maxSteps)};
    frame.pass(pipelines.view)
        .read("frame", frameConstants)
        .read("viewZ", prepared.viewZ)
        .read("surface", prepared.surface)
        .read("material", prepared.material, kTexels)
        .read("radianceWeight", traced.radianceWeight)
        .read("rayRecord", traced.rayRecord)
        .read("reflected", reflected.reflected)
        .read("weights", reflected.weights)
        .write("view", viewImage)
        .push(constants)
        .dispatch(desc.width, desc.height);
}

// ---------------------------------------------------------------- creation

Result<Pipelines> Pipelines::create(gpu::Context& context) {
    using gpu::Pipeline;
    GLINT_TRY(surface, Pipeline::compute(context, {"prepare/surface", 0, {}}));
    GLINT_TRY(surfaceSamples, Pipeline::compute(context, {"prepare/surface_samples", 0, {}}));
    GLINT_TRY(backFaces, Pipeline::compute(context, {"prepare/back_faces", 0, {}}));
    GLINT_TRY(dfg, Pipeline::compute(context, {"prepare/dfg", 0, {}}));
    std::vector<Pipeline> trace;
    for (const Technique& technique : techniques()) {
        GLINT_TRY(pipeline, Pipeline::compute(context, {technique.shader, technique.pushSize, {}}));
        trace.push_back(std::move(pipeline));
    }
    GLINT_TRY(combine, Pipeline::compute(context, {"hierarchy/combine", sizeof(shared::HierarchyConstants), {}}));
    GLINT_TRY(composite, Pipeline::compute(context, {"composite/composite", sizeof(shared::CompositeConstants), {}}));
    GLINT_TRY(view, Pipeline::compute(context, {"composite/view", sizeof(shared::ViewConstants), {}}));
    GLINT_TRY(statistics, Pipeline::compute(context, {"composite/statistics", 0, {}}));
    return Pipelines{std::move(surface),   std::move(surfaceSamples), std::move(backFaces),
                     std::move(dfg),       std::move(trace),          std::move(combine),
                     std::move(composite), std::move(view),           std::move(statistics)};
}

Result<std::unique_ptr<FrameState>> FrameState::create(gpu::Context& context, const ReflectionsDesc& desc) {
    auto state = std::make_unique<FrameState>();
    state->context = &context;
    state->desc = desc;
    GLINT_TRY(pipelines, Pipelines::create(context));
    state->pipelines = std::move(pipelines);
    GLINT_CHECK(state->createImages());
    GLINT_CHECK(state->expectBackFaces(0, 0));
    GLINT_CHECK(state->expectSamples(1));
    GLINT_TRY(timers, gpu::Timers::create(context));
    state->timers = std::move(timers);
    GLINT_CHECK(state->rehearse());
    return state;
}

Result<void> FrameState::createImages() {
    struct Wanted {
        gpu::Image* image;
        const char* name;
        VkFormat format;
        uint32_t width;
        uint32_t height;
        VkImageUsageFlags more; ///< besides being sampled and stored
        gpu::ImageShape shape = gpu::ImageShape::Flat;
    };
    const uint32_t w = desc.width;
    const uint32_t h = desc.height;
    constexpr VkImageUsageFlags kCleared = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    std::vector<Wanted> images = {
        {&prepared.viewZ, "glint/viewZ", VK_FORMAT_R32_SFLOAT, w, h, 0},
        {&prepared.surface, "glint/surface", VK_FORMAT_R32G32_UINT, w, h, 0},
        {&prepared.material, "glint/material", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, 0},
        {&traced.radianceWeight, "glint/radianceWeight", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, kCleared},
        {&traced.rayRecord, "glint/rayRecord", VK_FORMAT_R32G32_UINT, w, h, kCleared},
        {&reflected.reflected, "glint/reflected", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, 0},
        {&reflected.weights, "glint/weights", VK_FORMAT_R8G8B8A8_UNORM, w, h, 0},
        {&composite, "glint/composite", VK_FORMAT_R16G16B16A16_SFLOAT, w, h,
         VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT}, // hosts blend over it
        {&dfg, "glint/dfg", VK_FORMAT_R16G16_SFLOAT, kDfgSize, kDfgSize, 0},
        {&black, "glint/black", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, kCleared},
        {&blackCube, "glint/blackCube", VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1, kCleared, gpu::ImageShape::Cube},
    };
    if (desc.views)
        images.push_back({&viewImage, "glint/view", VK_FORMAT_R32G32B32A32_SFLOAT, w, h,
                          VK_IMAGE_USAGE_TRANSFER_SRC_BIT | kCleared});
    for (const Wanted& wanted : images) {
        GLINT_TRY(image, gpu::Image::create(*context,
                                            {wanted.name, wanted.format, wanted.width, wanted.height, 1,
                                             wanted.shape == gpu::ImageShape::Cube ? 6u : 1u, wanted.shape,
                                             VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | wanted.more}));
        *wanted.image = std::move(image);
    }

    GLINT_TRY(constants,
              gpu::Buffer::create(*context, {"glint/frame", sizeof(shared::FrameConstants),
                                             VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                             gpu::BufferHome::Device}));
    frameConstants = std::move(constants);
    if (!desc.statistics)
        return {};
    GLINT_TRY(counts,
              gpu::Buffer::create(*context, {"glint/statistics", sizeof(shared::RayStatistics),
                                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                                 VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                             gpu::BufferHome::Device}));
    statistics = std::move(counts);
    GLINT_TRY(readback, gpu::Buffer::create(*context, {"glint/statisticsReadback", sizeof(shared::RayStatistics),
                                                       VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
    statisticsReadback = std::move(readback);
    std::memset(statisticsReadback.mapped(), 0, statisticsReadback.size()); // nothing is counted yet
    return {};
}

Result<void> FrameState::expectBackFaces(uint32_t width, uint32_t height) {
    hasBackFaces = width > 0 && height > 0;
    if (prepared.backViewZ && !hasBackFaces)
        return {};
    width = std::max(width, 1u);
    height = std::max(height, 1u);
    if (prepared.backViewZ && prepared.backViewZ.width() == width && prepared.backViewZ.height() == height)
        return {};
    GLINT_TRY(image, gpu::Image::create(
                         *context, {"glint/backViewZ", VK_FORMAT_R32_SFLOAT, width, height, 1, 1, gpu::ImageShape::Flat,
                                    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                        VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    lastBackViewZ = std::move(prepared.backViewZ);
    prepared.backViewZ = std::move(image);
    noBackFaces = false;
    return {};
}

Result<void> FrameState::expectSamples(uint32_t samples) {
    const uint32_t width = samples > 1 ? desc.width : 1;
    const uint32_t height = samples > 1 ? desc.height : 1;
    if (prepared.edge && prepared.edge.width() >= width && prepared.edge.height() >= height)
        return {};
    GLINT_TRY(image, gpu::Image::create(*context, {"glint/edge", VK_FORMAT_R32G32B32A32_UINT, width, height, 1, 1,
                                                   gpu::ImageShape::Flat,
                                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
    lastEdge = std::move(prepared.edge);
    prepared.edge = std::move(image);
    return {};
}

Result<void> FrameState::rehearse() {
    gpu::Frame frame = gpu::Frame::rehearsal(*context);
    makeTables(frame);
    prepare(frame, {});
    for (size_t i = 0; i < techniques().size(); ++i)
        techniques()[i].record(frame, pipelines.trace[i], desc.settings, {frameConstants, inputs, prepared}, traced);
    combine(frame);
    compose(frame);
    if (desc.statistics)
        countOutcomes(frame);
    if (desc.views)
        recordView(frame, 0);
    return frame.firstError();
}

} // namespace glint::reflect
