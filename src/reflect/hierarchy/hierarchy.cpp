#include "reflect/hierarchy/hierarchy.hpp"

#include "base/assert.hpp"

namespace glint::reflect {

Result<std::unique_ptr<Hierarchy>> Hierarchy::create(StageContext& stages, std::vector<Source> sources) {
    std::unique_ptr<Hierarchy> hierarchy(new Hierarchy(stages));
    hierarchy->sources_ = std::move(sources);
    GLINT_TRY(combine, gpu::Pipeline::compute(stages.gpu, {"hierarchy/combine", 0, {}}, gpu::Compile::Later));
    hierarchy->combine_ = std::move(combine);
    return hierarchy;
}

Result<void> Hierarchy::makeReflected(gpu::Image* target) {
    const auto make = [&](gpu::Image& image, const char* name, VkFormat format, bool whole) {
        return makeImage(stages_.gpu, image, {name, format, whole ? stages_.width() : 1, whole ? stages_.height() : 1});
    };
    GLINT_CHECK(combine_.compile());
    GLINT_CHECK(make(weights_, "glint/weights", VK_FORMAT_R32G32_UINT, keepsWeights()));
    if (!target)
        GLINT_CHECK(make(reflected_, "glint/reflected", VK_FORMAT_R16G16B16A16_SFLOAT, true));
    target_ = target;
    return {};
}

/// Bit s: source s is used.
uint32_t Hierarchy::takingPart() const {
    uint32_t bits = 0;
    if (stages_.settings().reflect.strength > 0)
        for (uint32_t source = 0; source < sources_.size(); ++source)
            bits |= isUsed(source) ? 1u << source : 0;
    return bits;
}

constexpr uint32_t kScreenAndRays = 1u << shared::kSourceScreen | 1u << shared::kSourceRays;

/// As takingPart; of joined sources only the one in whose place the joined answer stands.
uint32_t Hierarchy::answering() const {
    const uint32_t all = takingPart();
    if (!join_ || (all & kScreenAndRays) != kScreenAndRays)
        return all;
    return all & ~(1u << (raysComeFirst() ? shared::kSourceScreen : shared::kSourceRays));
}

uint32_t Hierarchy::before(uint32_t source) const {
    const bool joins = source == shared::kSourceScreen || source == shared::kSourceRays;
    return (joins ? takingPart() : answering()) & order().before(source);
}

gpu::Image& Hierarchy::answerOf(uint32_t source, const HierarchyInputs& inputs) const {
    if (joined_ && (kScreenAndRays >> source & 1) != 0)
        return *joined_;
    gpu::Image* const answer = isUsed(source) ? sources_[source].answer() : nullptr;
    return answer ? *answer : inputs.frame.standIns.black;
}

EarlierAnswers Hierarchy::noAnswersBefore(const HierarchyInputs& inputs) const {
    return answersOf(0, inputs);
}

EarlierAnswers Hierarchy::answersOf(uint32_t which, const HierarchyInputs& inputs) const {
    const bool rays = (which >> shared::kSourceRays & 1) != 0 && inputs.raysRecord;
    EarlierAnswers result = {which, {}, rays ? *inputs.raysRecord : inputs.screenRecord};
    for (uint32_t source = 0; source < shared::kMaxSources; ++source)
        result.answers[source] = (which >> source & 1) != 0 ? &answerOf(source, inputs) : &inputs.frame.standIns.black;
    return result;
}

Reflected Hierarchy::record(gpu::Frame& frame, const HierarchyInputs& inputs) {
    recordSources(frame, inputs);
    return combine(frame, inputs);
}

void Hierarchy::recordSources(gpu::Frame& frame, const HierarchyInputs& inputs) {
    const SourceOrder order = this->order();
    uint32_t unjoined = join_ ? takingPart() & kScreenAndRays : 0;
    joined_ = nullptr;
    for (const uint32_t source : order) {
        if (sources_[source].record && isUsed(source))
            sources_[source].record(frame, answersOf(before(source), inputs));
        const uint32_t left = unjoined & ~(1u << source);
        if (unjoined != 0 && left == 0)
            joined_ = join_(frame);
        unjoined = left;
    }
}

Reflected Hierarchy::combine(gpu::Frame& frame, const HierarchyInputs& inputs) {
    combinePass(frame, combine_, inputs).dispatch(stages_.extent.x, stages_.extent.y);
    return reflected();
}

void Hierarchy::bindAnswers(gpu::Pass& pass, const HierarchyInputs& inputs) const {
    Inputs& host = inputs.frame.host;
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("environment", host.environment ? host.environment : inputs.frame.standIns.blackCube)
        .read("occlusion", host.scalar(Inputs::Occlusion, inputs.frame.standIns.black), kTexels);
    answersOf(takingPart(), inputs).bind(pass);
}

gpu::Pass Hierarchy::combinePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, const HierarchyInputs& inputs) {
    gpu::Pass pass = frame.pass(pipeline);
    bindAnswers(pass, inputs);
    pass.write("reflected", reflected().reflected).write("weights", weights_);
    return pass;
}

} // namespace glint::reflect
