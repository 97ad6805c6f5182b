#include "glint/reflections.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "gpu/pipeline.hpp"
#include "reflect/composite/view_names.hpp"
#include "reflect/frame.hpp"
#include "reflect/input_checks.hpp"

#include <algorithm>
#include <utility>

namespace glint {

using reflect::handOut;

namespace {

std::string nameOf(const gpu::WrittenImage& image) {
    return formatText("{}:{}", *image.pass, image.binding);
}

Result<void> checkFrameSize(uint32_t width, uint32_t height) {
    if (width < 1 || height < 1 || width > reflect::kMaxSize || height > reflect::kMaxSize)
        return invalidArgument("reflections of {}x{} pixels: each side must be 1 to {}", width, height,
                               reflect::kMaxSize);
    return {};
}

/// A recording that follows `record`: what it needs, and its words for what is missing.
struct Addition {
    std::string_view call;
    bool ReflectionsDesc::*enabled;
    std::string_view member; ///< its name
    std::string_view made;   ///< "these reflections were made without ..."
    std::string_view next;   ///< "record a frame, then ..."
};
constexpr Addition kLayer = {"recordLayer", &ReflectionsDesc::transparentLayers, "transparentLayers",
                             "transparent layers", "its layers"};
constexpr Addition kView = {"recordView", &ReflectionsDesc::views, "views", "views", "its views"};
constexpr Addition kInspection = {"recordInspection", &ReflectionsDesc::inspection, "inspection", "inspection",
                                  "inspect it"};
constexpr Addition kInputCheck = {"recordInputCheck", &ReflectionsDesc::inputCheck, "inputCheck", "a check",
                                  "check its inputs"};

} // namespace

struct Reflections::State : gpu::KeepsContext {
    explicit State(gpu::Context& context) : KeepsContext(context) {}

    std::unique_ptr<reflect::FrameStages> frame;
    /// Of other sizes; frames in flight may still use them.
    std::vector<std::unique_ptr<reflect::FrameStages>> outgoing;
    std::vector<std::string> notes;
    bool refused = false; ///< `notes` says why record did nothing
    InputCheck check;     ///< the newest

    void note();
    void collectNotes();
    void readCheck();
    Result<void> checkRecord(VkCommandBuffer commands, const View& view) const;
    Result<void> checkAddition(const Addition& addition, VkCommandBuffer commands) const;
    void refuse(const Error& why);
};

/// Notes which inputs the settings lack; those that are new go to the host's log too.
void Reflections::State::note() {
    const std::vector<std::string> before = std::move(notes);
    collectNotes();
    for (const std::string& text : notes)
        if (std::ranges::find(before, text) == before.end())
            frame->context().message(text);
}

void Reflections::State::collectNotes() {
    notes.clear();
    refused = false;
    const Settings& settings = frame->desc().settings;
    if (settings.rays.enabled && !frame->rayScene())
        notes.emplace_back("rays.enabled without a scene: the host has not called Reflections::setRays");
    if (settings.screen.enabled && settings.screen.march == March::Proxy && !frame->hasProbes())
        notes.emplace_back("screen.march proxy without probes: every ray is taken to end infinitely far away");
    if (reflect::denoises(settings) && settings.screen.enabled)
        for (const auto& [wanted, name] : {std::pair(settings.screen.resolutionScale != 1, "screen.resolutionScale"),
                                           std::pair(settings.blur.strength > 0, "blur.strength"),
                                           std::pair(settings.rough.factor > 0, "rough.factor")})
            if (wanted)
                notes.push_back(formatText("{} has no effect with denoise.enabled", name));
    notes.insert(notes.end(), check.findings.begin(), check.findings.end());
    if (!frame->host().isSet())
        return;
    const GBuffer& gbuffer = frame->host().gbuffer;
    if (!gbuffer.fallbackSpecular)
        notes.emplace_back(
            "no fallbackSpecular: reflections are added to litRadiance, as nothing says which part of it "
            "they replace");
    if (settings.screen.enabled && settings.screen.thicknessMode == ThicknessMode::Backface && !gbuffer.backDepth)
        notes.emplace_back("no backDepth: screen.thicknessMode backface takes every surface to be as thick as "
                           "screen.thickness says");
    if (settings.screen.enabled && settings.screen.transparents) {
        if (settings.screen.colorSource != ColorSource::Previous)
            notes.emplace_back("screen.transparents has no effect with screen.colorSource current: only the previous "
                               "frame shows transparent surfaces");
        else if (!gbuffer.transparentDepth)
            notes.emplace_back("no transparentDepth: screen.transparents has no effect");
    }
}

/// Keeps the reason for which record did nothing.
void Reflections::State::readCheck() {
    reflect::InputChecker* const checker = frame->inputChecker();
    if (!checker || !checker->evaluate())
        return;
    std::erase_if(notes, [&](const std::string& text) { return std::ranges::count(check.findings, text) > 0; });
    const std::vector<std::string> before = std::exchange(check, checker->result()).findings;
    for (const std::string& text : check.findings) {
        notes.push_back(text);
        if (std::ranges::find(before, text) == before.end())
            frame->context().message(text);
    }
}

Result<void> Reflections::State::checkRecord(VkCommandBuffer commands, const View& view) const {
    if (!frame->host().isSet())
        return invalidArgument("record before setInputs: nothing is recorded, and no image returned");
    if (!commands)
        return invalidArgument(
            "record without a command buffer: nothing is recorded, litRadiance is returned as it is");
    if (const Result<void> checked = reflect::checkView(view); !checked)
        return invalidArgument("{}: nothing is recorded, litRadiance is returned as it is", checked.error().message);
    const ReflectionsDesc& desc = frame->desc();
    if (view.width > desc.width || view.height > desc.height)
        return invalidArgument(
            "View uses {}x{} pixels of images of {}x{}: nothing is recorded, litRadiance is returned "
            "as it is",
            view.width, view.height, desc.width, desc.height);
    return {};
}

Result<void> Reflections::State::checkAddition(const Addition& addition, VkCommandBuffer commands) const {
    if (!(frame->desc().*addition.enabled))
        return invalidArgument("these reflections were made without {}: set ReflectionsDesc::{}", addition.made,
                               addition.member);
    if (!frame->recorded())
        return invalidArgument("nothing was recorded with these settings: record a frame, then {}", addition.next);
    if (!commands)
        return invalidArgument("{} without a command buffer", addition.call);
    return {};
}

void Reflections::State::refuse(const Error& why) {
    frame->forget();
    if (!refused) {
        notes.push_back(why.message);
        frame->context().message(why.message);
    }
    refused = true;
}

Reflections::Reflections(std::unique_ptr<State> state) : state_(std::move(state)) {}
Reflections::~Reflections() = default;
Reflections::Reflections(Reflections&&) noexcept = default;
Reflections& Reflections::operator=(Reflections&&) noexcept = default;

Result<Reflections> Reflections::create(Context& context, const ReflectionsDesc& desc) {
    if (desc.framesInFlight < 1 || desc.framesInFlight > 16)
        return invalidArgument("framesInFlight is {}: 1 to 16", desc.framesInFlight);
    GLINT_CHECK(checkFrameSize(desc.width, desc.height));
    GLINT_CHECK(validate(desc.settings));
    auto state = std::make_unique<State>(context.gpu());
    gpu::CompileBatch batch(context.gpu());
    GLINT_CHECK(reflect::FrameStages::askForLongest(context.gpu(), desc.settings));
    batch.start(); // while images are made, which takes a software driver nearly as long
    GLINT_TRY(frame, reflect::FrameStages::create(context.gpu(), desc));
    GLINT_CHECK(batch.finish());
    state->frame = std::move(frame);
    return Reflections(std::move(state));
}

Result<void> Reflections::resize(uint32_t width, uint32_t height) {
    GLINT_CHECK(checkFrameSize(width, height));
    ReflectionsDesc desc = state_->frame->desc();
    desc.width = width;
    desc.height = height;
    gpu::CompileBatch batch(state_->frame->context());
    GLINT_TRY(frame, reflect::FrameStages::create(state_->frame->context(), desc));
    GLINT_CHECK(frame->takeSources(*state_->frame));
    GLINT_CHECK(batch.finish());
    state_->outgoing.push_back(std::move(state_->frame));
    state_->frame = std::move(frame);
    state_->note();
    return {};
}

Result<void> Reflections::setSettings(const Settings& settings) {
    GLINT_CHECK(validate(settings));
    if (const rays::Scene* scene = state_->frame->rayScene())
        GLINT_CHECK(reflect::checkBackend(settings, scene->backend()));
    GLINT_CHECK(reflect::checkOutputSettings(state_->frame->outputs(), settings));
    gpu::CompileBatch batch(state_->frame->context());
    GLINT_CHECK(state_->frame->setSettings(settings));
    GLINT_CHECK(batch.finish());
    state_->note();
    return {};
}

Result<void> Reflections::setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment) {
    reflect::FrameStages& frame = *state_->frame;
    GLINT_CHECK(reflect::checkInputs(frame.context(), gbuffer, environment, frame.desc()));
    GLINT_CHECK(reflect::checkApart(frame.outputs(), gbuffer));
    const bool others = gbuffer.conventions != frame.host().conventions();
    GLINT_CHECK(frame.setInputs(gbuffer, environment));
    if (others)
        state_->check = {};
    state_->note();
    return {};
}

Result<void> Reflections::setOutputs(const Outputs& outputs) {
    reflect::FrameStages& frame = *state_->frame;
    GLINT_CHECK(reflect::checkOutputs(frame.context(), outputs, frame.host().gbuffer, frame.desc()));
    return frame.setOutputs(outputs);
}

Result<void> Reflections::setRays(RayScene& scene, SurfaceTable& surfaces) {
    GLINT_CHECK(reflect::checkBackend(state_->frame->desc().settings, scene.backend()));
    gpu::CompileBatch batch(state_->frame->context());
    GLINT_CHECK(state_->frame->setRays({&scene.scene(), &surfaces.state(), {}}));
    GLINT_CHECK(batch.finish());
    state_->note();
    return {};
}

Result<void> Reflections::setRays(RayScene& scene, ShadeHits shade) {
    if (!shade)
        return invalidArgument("setRays needs something that shades hits");
    GLINT_CHECK(reflect::checkBackend(state_->frame->desc().settings, scene.backend()));
    GLINT_CHECK(state_->frame->setRays({&scene.scene(), nullptr, std::move(shade)}));
    state_->note();
    return {};
}

Result<void> Reflections::setPlanar(PlanarMirrors& mirrors) {
    return state_->frame->setPlanar(mirrors.state());
}

Result<void> Reflections::setProbes(Probes& probes) {
    GLINT_CHECK(state_->frame->setProbes(probes.state()));
    state_->note();
    return {};
}

void Reflections::restartAccumulation() {
    state_->frame->restartAccumulation();
}

HostImage Reflections::record(VkCommandBuffer commands, const View& view) {
    reflect::FrameStages& frame = *state_->frame;
    if (const Result<void> possible = state_->checkRecord(commands, view); !possible) {
        state_->refuse(possible.error());
        return frame.host().gbuffer.litRadiance;
    }
    const HostImage result = frame.record(commands, view);
    std::erase_if(state_->outgoing, [&](const auto& old) {
        return old->frameNumber() + frame.desc().framesInFlight <= frame.frameNumber();
    });
    return result;
}

Result<HostImage> Reflections::recordLayer(VkCommandBuffer commands, const TransparentLayer& layer,
                                           const HostImage& picture) {
    reflect::FrameStages& frame = *state_->frame;
    GLINT_CHECK(state_->checkAddition(kLayer, commands));
    if (frame.extent() != glm::uvec2(frame.desc().width, frame.desc().height))
        return invalidArgument("the frame used {}x{} pixels of its images: layers need all {}x{}, View::width and "
                               "height 0",
                               frame.extent().x, frame.extent().y, frame.desc().width, frame.desc().height);
    GLINT_CHECK(reflect::checkLayer(frame.context(), layer, frame.desc()));
    if (!frame.plan().layers)
        return picture;
    if (!frame.plan().composites)
        return invalidArgument("the outputs have `reflection` alone: a layer needs the image with reflections");
    if (picture.image != frame.composite().handle())
        return invalidArgument("a layer's picture is not the one that record returned");
    if (reflect::isInNoLayout(picture))
        return invalidArgument("a layer's picture is in no layout (VkImageLayout {}): state the one that it is in",
                               static_cast<int>(picture.layout));
    return frame.recordLayer(commands, layer, picture.layout);
}

Result<HostImage> Reflections::recordView(VkCommandBuffer commands, std::string_view name) {
    reflect::FrameStages& frame = *state_->frame;
    GLINT_CHECK(state_->checkAddition(kView, commands));
    const auto found = std::ranges::find(reflect::kViewNames, name);
    const bool ofPass = name.find(':') != std::string_view::npos;
    if (found == reflect::kViewNames.end() && !ofPass)
        return invalidArgument("no view '{}'; did you mean '{}'?", name, nearestText(name, reflect::kViewNames));
    if (!ofPass)
        return handOut(frame.recordView(commands, static_cast<uint32_t>(found - reflect::kViewNames.begin())));
    for (size_t i = frame.written().size(); i-- > 0;) // the last one with this name
        if (nameOf(frame.written()[i]) == name)
            return handOut(frame.recordWritten(commands, i));
    return invalidArgument("no pass of this frame wrote '{}'; there are {}", name, joinText(passImages(), ", "));
}

Result<void> Reflections::recordInspection(VkCommandBuffer commands, uint32_t x, uint32_t y) {
    reflect::FrameStages& frame = *state_->frame;
    GLINT_CHECK(state_->checkAddition(kInspection, commands));
    if (x >= frame.extent().x || y >= frame.extent().y)
        return invalidArgument("pixel {},{} lies outside the picture of {}x{}", x, y, frame.extent().x,
                               frame.extent().y);
    frame.recordInspection(commands, x, y);
    return {};
}

RayInspection Reflections::inspection() const {
    GLINT_ASSERT(state_->frame->desc().inspection, "these reflections were made without inspection");
    return state_->frame->inspection();
}

Result<void> Reflections::recordInputCheck(VkCommandBuffer commands, const KnownPlane* plane) {
    reflect::FrameStages& frame = *state_->frame;
    GLINT_CHECK(state_->checkAddition(kInputCheck, commands));
    if (plane)
        GLINT_CHECK(reflect::checkPlane(*plane));
    frame.recordInputCheck(commands, plane ? std::optional(*plane) : std::nullopt);
    return {};
}

const InputCheck& Reflections::inputCheck() {
    state_->readCheck();
    return state_->check;
}

std::vector<std::string_view> Reflections::viewNames() {
    return {reflect::kViewNames.begin(), reflect::kViewNames.end()};
}

std::vector<std::string> Reflections::passImages() const {
    std::vector<std::string> names;
    for (const gpu::WrittenImage& image : state_->frame->written())
        if (std::string name = nameOf(image); std::ranges::find(names, name) == names.end())
            names.push_back(std::move(name));
    return names;
}

std::vector<PassTime> Reflections::passTimes() {
    std::vector<PassTime> times;
    for (const gpu::PassTime& time : state_->frame->passTimes())
        times.push_back({time.name, time.milliseconds});
    return times;
}

std::vector<FrameDecision> Reflections::plan() const {
    return state_->frame->decisions();
}

Statistics Reflections::statistics() {
    return state_->frame->statistics();
}

const std::vector<std::string>& Reflections::notes() const {
    state_->readCheck();
    return state_->notes;
}

} // namespace glint
