// Stages that only some frames have, in one list: each is created when the plan first wants it, makes what its settings
// need, and is recorded at its moment of the frame. A stage in the list has
//
//   wanted(settings) or wanted(PlanInputs)   static and pure: whether frames have it
//   create(StageContext&)                    static; then its pipelines and images belong to it
//   make(settings)                           optional: what new settings need
//   clear(frame)                             optional: initializes images that may be read before they are written
//   kMoment, kName, record(frame, inputs)    optional: one that the frame records without naming it
#pragma once

#include "reflect/stage.hpp"
#include "reflect/trace/technique.hpp"

#include <array>
#include <memory>
#include <tuple>

namespace glint::reflect {

/// When in a frame a stage is recorded (FrameStages::recordFrame).
enum class Moment : uint8_t {
    BeforeMarch, ///< the pixels that need a ray are listed; only where the screen is traced
    AfterMarch,  ///< the screen's rays have their answers; only where the screen is traced
    AfterAll,    ///< the image with reflections is complete
};

/// What the frame offers to a stage at its moment.
struct StageInputs {
    TraceInputs trace; ///< with the frame's constants, the host's images and what `prepare` made of them
    TraceTarget target;
    gpu::Image& rayRecord; ///< outcomes of the pixels' rays
    gpu::Image* composite; ///< the image with reflections; null: the host composites
};

template <class... Stages>
class StageList {
public:
    /// Null until it is created.
    template <class Stage>
    Stage* find() const {
        return std::get<std::unique_ptr<Stage>>(stages_).get();
    }
    /// Null if frames do not have it.
    template <class Stage>
    Stage* findWanted() const {
        return wants<Stage>() ? find<Stage>() : nullptr;
    }

    /// Decides which stages frames have.
    void plan(const PlanInputs& inputs) { wanted_ = {wanted<Stages>(inputs)...}; }

    /// Creates the wanted stages that do not exist, and makes what the settings need. `made` is called with each; it
    /// returns a Result. Errors: those of the stages.
    template <class Made>
    Result<void> make(StageContext& context, const Made& made) {
        Result<void> result;
        forEachWanted([&]<class Stage>(std::unique_ptr<Stage>& stage) {
            if (result)
                result = makeOne(context, stage, made);
        });
        return result;
    }

    /// Calls `visit` with each wanted stage that exists.
    template <class Visit>
    void forEach(const Visit& visit) {
        forEachWanted([&](auto& stage) {
            if (stage)
                visit(*stage);
        });
    }

    /// Initializes the images of all stages that exist.
    void clear(gpu::Frame& frame) {
        const auto clearOne = [&](auto* stage) {
            if constexpr (requires { stage->clear(frame); })
                if (stage)
                    stage->clear(frame);
        };
        (clearOne(find<Stages>()), ...);
    }

    /// Records the wanted stages of this moment, in the order of the list.
    void record(gpu::Frame& frame, Moment moment, const StageInputs& inputs) {
        forEach([&]<class Stage>(Stage& stage) {
            if constexpr (requires { Stage::kMoment; })
                if (Stage::kMoment == moment)
                    stage.record(frame, inputs);
        });
    }

    /// Adds a row for each stage that has a name: whether frames have it.
    void describe(std::vector<FrameDecision>& rows) const {
        const auto add = [&]<class Stage>(const std::unique_ptr<Stage>&) {
            if constexpr (requires { Stage::kName; })
                rows.push_back({Stage::kName, wants<Stage>()});
        };
        (add(std::get<std::unique_ptr<Stages>>(stages_)), ...);
    }

private:
    template <class Stage>
    static bool wanted(const PlanInputs& inputs) {
        if constexpr (requires { Stage::wanted(inputs); })
            return Stage::wanted(inputs);
        else
            return Stage::wanted(inputs.settings);
    }

    template <class Stage>
    bool wants() const {
        size_t place = 0;
        size_t found = 0;
        ((std::is_same_v<Stage, Stages> ? found = place++ : place++), ...);
        return wanted_[found];
    }

    template <class Visit>
    void forEachWanted(const Visit& visit) {
        size_t place = 0;
        ((wanted_[place++] ? visit(std::get<std::unique_ptr<Stages>>(stages_)) : void()), ...);
    }

    template <class Stage, class Made>
    static Result<void> makeOne(StageContext& context, std::unique_ptr<Stage>& stage, const Made& made) {
        if (!stage) {
            GLINT_TRY(created, Stage::create(context));
            stage = std::move(created);
        }
        if constexpr (requires { stage->make(context.settings()); })
            GLINT_CHECK(stage->make(context.settings()));
        return made(*stage);
    }

    std::tuple<std::unique_ptr<Stages>...> stages_;
    std::array<bool, sizeof...(Stages)> wanted_ = {};
};

} // namespace glint::reflect
