#include "reflect/inspect/inspector.hpp"

#include "reflect/trace/outcomes.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/frame_constants.h"
#include "shared/probes.h"
#include "shared/ray_log.h"

#include <array>
#include <cstring>
#include <limits>

namespace glint::reflect {
namespace {

static_assert(kMaxRaySamples == shared::kMaxLoggedSamples);

constexpr std::array<std::string_view, shared::kSampleDecisionCount> kDecisionNames = {
    "front",    "behind", "empty",  "lookInto", "passes",   "hit",   "side",
    "backFace", "grazes", "nearly", "places",   "inferred", "beside"};
constexpr std::array<std::string_view, shared::kLoggedFadeCount> kFadeNames = {
    "roughness",    "borderSmooth", "borderLinear", "distance", "iterations",
    "facingCamera", "backface",     "inferred",     "uncertain"};

constexpr std::array<std::string_view, shared::kProbeNoProxy + 1> kProxyNames = {"box", "sphere", "none"};

Float2 toArray(const glm::vec2& v) {
    return {v.x, v.y};
}

Float3 toArray(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

float depthOf(float viewZ) {
    return viewZ >= shared::kBackgroundZ ? std::numeric_limits<float>::infinity() : viewZ;
}

std::string_view whyNoRay(uint32_t outcome, bool background, bool screenEnabled) {
    if (background)
        return "the pixel shows no surface";
    switch (outcome) {
    case shared::kOutcomeBelowThreshold: return "its F0 is not above reflect.threshold";
    case shared::kOutcomeTooRough: return "it is rougher than reflect.maxRoughness";
    case shared::kOutcomeFacingCamera: return "fade.facingCamera leaves nothing of it";
    default: break;
    }
    return screenEnabled ? "the traced pixel that covers it shows no surface" : "screen.enabled is off";
}

RaySample toSample(const shared::LoggedSample& logged) {
    RaySample sample;
    sample.positionPX = toArray(logged.px);
    sample.level = logged.level;
    sample.rayDepth = logged.rayZ;
    sample.sceneDepth = depthOf(logged.sceneZ);
    if (logged.slabZ > 0)
        sample.slabEndDepth = depthOf(logged.slabZ);
    sample.distance = logged.distance;
    sample.decision = kDecisionNames[std::min(logged.decision, shared::kSampleDecisionCount - 1)];
    return sample;
}

void readPixel(const shared::LoggedPixel& logged, RayInspection& out) {
    out.pixel = {logged.px.x, logged.px.y};
    out.rayPixel = {logged.rayPX.x, logged.rayPX.y};
    out.background = logged.viewZ >= shared::kBackgroundZ;
    out.depth = out.background ? 0 : logged.viewZ;
    out.positionWS = toArray(logged.positionWS);
    out.normalWS = toArray(logged.normalWS);
    out.f0 = toArray(logged.f0);
    out.perceptualRoughness = logged.perceptualRoughness;
    out.totalWeight = logged.reflected.w;
    out.reflected = toArray(glm::vec3(logged.reflected));
    out.composite = {logged.composite.x, logged.composite.y, logged.composite.z, logged.composite.w};
}

void readRay(const shared::LoggedRay& logged, RayInspection& out) {
    out.start = {toArray(logged.startPX), toArray(logged.startVS), toArray(logged.startWS), logged.startZ};
    out.end = {toArray(logged.endPX), toArray(logged.endVS), toArray(logged.endWS), logged.endZ};
    out.directionVS = toArray(logged.directionVS);
    out.directionWS = toArray(logged.directionWS);
    out.maxLength = logged.lengthVS;
    out.length = logged.endDistance;
    out.lookups = logged.lookups;
    out.iterations = logged.iterations;
    if (logged.projected != 0)
        out.projection = {logged.probe == shared::kNoProbe ? std::nullopt : std::optional(logged.probe),
                          kProxyNames[std::min(logged.proxyShape, shared::kProbeNoProxy)],
                          depthOf(logged.projectionDistance)};
    if (!out.answered)
        return;
    out.hitPixel = {static_cast<uint32_t>(logged.endPX.x), static_cast<uint32_t>(logged.endPX.y)};
    out.hitDepth = depthOf(logged.hitZ);
    out.radiance = toArray(logged.radiance);
    out.weight = logged.weight;
    for (uint32_t i = 0; i < shared::kLoggedFadeCount; ++i)
        if ((logged.fadesUsed >> i & 1) != 0)
            out.fades.push_back({kFadeNames[i], logged.fades[i]});
}

} // namespace

const size_t kRayLogSize = sizeof(shared::RayLogHeader) + shared::kMaxLoggedSamples * sizeof(shared::LoggedSample);

Result<std::unique_ptr<Inspector>> Inspector::create(StageContext& stages) {
    using gpu::Buffer, gpu::Pipeline;
    std::unique_ptr<Inspector> inspector(new Inspector(stages));
    gpu::Context& context = stages.gpu;
    GLINT_TRY(pixel, Pipeline::compute(context, {"trace/log/pixel", sizeof(shared::InspectConstants), {}}));
    inspector->pixel_ = std::move(pixel);
    for (const Technique& technique : techniques()) {
        GLINT_TRY(pipeline, Pipeline::compute(context, {logShader(technique), 0, {}}));
        inspector->marchers_.push_back(std::move(pipeline));
    }
    GLINT_TRY(combine, Pipeline::compute(context, {"hierarchy/log/combine", 0, {}}));
    inspector->combine_ = std::move(combine);
    GLINT_TRY(list, Buffer::create(context, {"glint/inspectedRay", sizeof(shared::RayListHeader) + 4,
                                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                                             gpu::BufferHome::Device}));
    inspector->rays_.list = std::move(list);
    GLINT_TRY(log, Buffer::create(context, {"glint/rayLog", kRayLogSize,
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                                VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                            gpu::BufferHome::Device}));
    inspector->log_ = std::move(log);
    GLINT_TRY(readback, Buffer::create(context, {"glint/rayLogReadback", kRayLogSize, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                 gpu::BufferHome::Readback}));
    inspector->readback_ = std::move(readback);
    std::memset(inspector->readback_.mapped(), 0, kRayLogSize); // nothing is inspected yet
    return inspector;
}

void Inspector::rehearse(gpu::Frame& frame, const InspectorInputs& inputs) {
    for (const Technique& technique : techniques())
        record(frame, inputs, 0, 0, technique);
}

void Inspector::record(gpu::Frame& frame, const InspectorInputs& inputs, uint32_t x, uint32_t y,
                       const Technique& technique) {
    const shared::InspectConstants constants = {{x, y}};
    frame.fill(log_, 0);
    frame.pass(pixel_)
        .read("frame", inputs.trace.frame.constants)
        .read("viewZ", inputs.trace.prepared.viewZ)
        .read("surface", inputs.trace.prepared.surface)
        .read("material", inputs.trace.prepared.material, kTexels)
        .read("rayRecord", inputs.rayRecord)
        .read("reflected", inputs.sources.reflected().reflected)
        .read("composite", inputs.composite, kTexels)
        .write("rays", rays_.list)
        .write("rayLog", log_)
        .push(constants)
        .dispatch(1);
    const TraceInputs& frames = inputs.trace; // of all its rays
    const TraceInputs one = {.frame = frames.frame,
                             .prepared = frames.prepared,
                             .met = frames.met,
                             .rays = rays_,
                             .pyramid = frames.pyramid,
                             .previous = frames.previous,
                             .probes = frames.probes,
                             .conePicture = frames.conePicture,
                             .log = &log_};
    recordMarch(frame, technique, marchers_[indexOf(technique)], one, inputs.target);
    inputs.sources.combinePass(frame, combine_, inputs.hierarchy)
        .readWrite("rayLog", log_)
        .dispatch(stages_.extent.x, stages_.extent.y);
    frame.copyBuffer(log_, readback_);
}

RayInspection Inspector::read(const Hierarchy& sources) const {
    return readRayLog(static_cast<const std::byte*>(readback_.mapped()), stages_.settings().screen.enabled,
                      [&](uint32_t source) { return sources.nameOf(source); });
}

RayInspection readRayLog(const std::byte* bytes, bool screenEnabled,
                         const std::function<std::string_view(uint32_t)>& nameOfSource) {
    shared::RayLogHeader header;
    std::memcpy(&header, bytes, sizeof(header));
    RayInspection out;
    readPixel(header.pixel, out);
    const uint32_t outcome = std::min(header.pixel.outcome, shared::kOutcomeCount - 1);
    out.outcome = kOutcomeNames[outcome];
    out.traced = header.ray.traced != 0;
    if (out.traced) {
        const uint32_t ended = header.ray.record.y >> 28; // lib/ray_record.glsl
        out.outcome = kOutcomeNames[std::min(ended, shared::kOutcomeCount - 1)];
        out.hit = ended == shared::kOutcomeHit;
        out.answered = header.ray.answered != 0;
        out.sameAsFrame = header.ray.record == header.pixel.record;
        readRay(header.ray, out);
    } else {
        out.whyNoRay = whyNoRay(outcome, out.background, screenEnabled);
    }
    const uint32_t written = std::min(header.sampleCount, shared::kMaxLoggedSamples);
    out.truncated = header.sampleCount > written;
    for (uint32_t i = 0; i < written; ++i) {
        shared::LoggedSample logged;
        std::memcpy(&logged, bytes + sizeof(header) + i * sizeof(logged), sizeof(logged));
        out.samples.push_back(toSample(logged));
    }
    for (uint32_t i = 0; i < shared::kMaxSources; ++i) {
        const shared::LoggedSource& source = header.sources[i];
        if (source.answered != 0 && source.weight > 0)
            out.sources.push_back({nameOfSource(source.source), source.weight, toArray(source.radiance)});
    }
    return out;
}

} // namespace glint::reflect
