// What settings cost and how wrong their pictures are: renders every view and compares it with its reference.
#pragma once

#include "gpu/context.hpp"
#include "lab/measure/bench/effect_times.hpp"
#include "lab/session/run_job.hpp"
#include "lab/tune/pareto.hpp"
#include "lab/tune/tune_views.hpp"

#include <functional>
#include <memory>

namespace glint::tune {

/// How wrong a picture is, against its reference.
enum class ErrorMetric {
    Flip,        ///< mean of FLIP on the displayed picture: what a person sees; too bright and too dark count alike
    RelativeMse, ///< on radiance, relative to the reference: light in dark places counts most
};

struct EvaluationPlan {
    /// A job for each scene and camera; all with the same settings, those of the start. They differ in nothing that
    /// `cost` depends on.
    std::vector<render::RenderJob> jobs;
    std::vector<scene::CameraMove> paths = {scene::CameraMove::Still};
    render::ProgramSettings reference; ///< its jobs' own settings of the renderer are used
    uint32_t referenceFrames = 8;      ///< averaged for each reference, >= 1
    ErrorMetric metric = ErrorMetric::Flip;
    bool counted = false; ///< cost is counted (WorkCost), in floors; false: measured, in milliseconds
};

struct ViewFigures {
    std::string view;
    Figures figures;
};

/// `figures.cost` is the mean over the views, `figures.error` the geometric mean: each view counts by its own relative
/// changes, however hard it is.
struct Evaluation {
    Figures figures;
    std::vector<ViewFigures> views; ///< empty if the candidate was given up: figures are infinite then
    double limit = 0;               ///< of a candidate that was given up: the cost that it exceeds
};

/// Times of the effect, for tables: they have the machine's noise.
struct Timing {
    double floors = 0;
    double ms = 0;
};

class Evaluator {
public:
    using Progress = std::function<void(const std::string& what)>;

    /// Reads the scenes. `progress`  is called before long work; may be empty.
    /// Errors: those of the scenes' readers and the device.
    static Result<Evaluator> create(gpu::Context& context, EvaluationPlan plan, Progress progress = {});
    Evaluator(Evaluator&&) noexcept;
    Evaluator& operator=(Evaluator&&) noexcept;
    ~Evaluator();

    /// Renders the references of `set` first, once.
    /// `mostCost`  a candidate is given up once the views so far cost more than all of them may
    Result<Evaluation> evaluate(const Settings& settings, ViewSet set, double mostCost);
    /// Median of `frames` frames of each view at rest of the search, then the mean over views.
    Result<Timing> time(const Settings& settings, uint32_t frames);

    std::array<uint32_t, 2> size() const; ///< of the first view, pixels

private:
    struct State;
    explicit Evaluator(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Mean cost and geometric mean error of views.
Figures combine(const std::vector<ViewFigures>& views);

} // namespace glint::tune
