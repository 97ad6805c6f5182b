// `hierarchy`: combines the sources of reflections by one rule. A source is an entry of a table; order, weights, names
// and the answers of earlier sources come from that table.
#pragma once

#include "reflect/hierarchy/source_order.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

#include <functional>

namespace glint::reflect {

/// An entry of the table; its index is the source's number, kSource* of shared/hierarchy.h for Glint's own sources.
struct Source {
    std::string_view name; ///< name of its settings group, views and log
    /// True if the source is used. No source is used while reflect.strength is 0.
    bool FramePlan::*takesPart;
    /// Records the passes that compute the source's answer for the weight remaining after earlier sources. Empty: the
    /// answer already exists, or is computed in the walk.
    std::function<void(gpu::Frame& frame, const EarlierAnswers& before)> record;
    /// Returns RGBA16F or RGBA8: radiance, weight; null: the walk computes it.
    std::function<gpu::Image*()> answer;
};

struct HierarchyInputs {
    FrameInputs frame;
    Prepared prepared;
    gpu::Image& screenRecord; ///< outcomes of the screen's rays
    gpu::Image* raysRecord;   ///< which of the screen's answers `rays` replaced; null without rays
};

class Hierarchy {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<Hierarchy>> create(StageContext& stages, std::vector<Source> sources);
    std::string_view nameOf(uint32_t source) const { return sources_[source].name; }

    /// Bit s: source s is used, and asked before `source`.
    uint32_t before(uint32_t source) const;
    shared::HierarchyConstants constants() const { return {answering(), order().packed(), keepsWeights() ? 1u : 0u}; }

    /// The answers of screen and rays count as one, in the place of the first of the two, as soon as both have
    /// answered. `join` records what makes one of them and returns it. Empty: they count apart.
    using Join = std::function<gpu::Image*(gpu::Frame& frame)>;
    void joinScreenAndRays(Join join) {
        join_ = std::move(join);
        joined_ = nullptr;
    }
    bool raysComeFirst() const { return (order().before(shared::kSourceScreen) >> shared::kSourceRays & 1) != 0; }

    /// Creates what `combine` needs, which then writes its answer into `target`, an image of the host's; null: into one
    /// of Glint's. Errors: OutOfMemory, Unsupported; then nothing has changed.
    Result<void> makeReflected(gpu::Image* target);

    /// Records the sources that fill the remaining weight, in the user's order, then the walk over all sources.
    Reflected record(gpu::Frame& frame, const HierarchyInputs& inputs);
    void recordSources(gpu::Frame& frame, const HierarchyInputs& inputs);
    Reflected combine(gpu::Frame& frame, const HierarchyInputs& inputs);
    /// Binds what shaders/hierarchy/combined.glsl declares, once the sources are recorded.
    void bindAnswers(gpu::Pass& pass, const HierarchyInputs& inputs) const;
    /// Begins the pass of `combine` with another pipeline; the caller dispatches it.
    gpu::Pass combinePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, const HierarchyInputs& inputs);

    /// The answers that a source is rehearsed with: no earlier source has answered.
    EarlierAnswers noAnswersBefore(const HierarchyInputs& inputs) const;
    Reflected reflected() { return {target_ ? *target_ : reflected_, weights_}; }
    /// Returns the source's answer if it exists, otherwise a black image.
    gpu::Image& answerOf(uint32_t source, const HierarchyInputs& inputs) const;

private:
    explicit Hierarchy(StageContext& stages) : stages_(stages) {}
    uint32_t takingPart() const;
    uint32_t answering() const;
    /// True if views or the inspection show which source answered.
    bool keepsWeights() const { return stages_.desc.views || stages_.desc.inspection; }
    bool isUsed(uint32_t source) const { return stages_.plan.*sources_[source].takesPart; }
    SourceOrder order() const { return SourceOrder(stages_.settings()); }
    /// Returns the answers of the sources in `which`, where bit s is source s.
    EarlierAnswers answersOf(uint32_t which, const HierarchyInputs& inputs) const;

    StageContext& stages_;
    std::vector<Source> sources_;
    Join join_;
    gpu::Image* joined_ = nullptr; ///< of this frame, once it is recorded
    gpu::Pipeline combine_;
    gpu::Image reflected_;
    gpu::Image* target_ = nullptr;
    gpu::Image weights_;
};

} // namespace glint::reflect
