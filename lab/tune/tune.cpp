#include "lab/tune/tune.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>

namespace glint::tune {
namespace {

using Clock = std::chrono::steady_clock;

/// More points than these say no more: the curve is thinned to them.
constexpr size_t kMostPoints = 16;

/// With a target of cost, the curve reaches this far beyond it and the start.
constexpr double kBeyondTarget = 1.25;

/// A setting whose start value makes neither figure worse by more than this fraction is left out of the choice.
constexpr double kNoGain = 0.003;

/// Implements tuneSettings.
class Tuner {
public:
    Tuner(const TunePlan& plan, const TuneHooks& hooks, Evaluator evaluator, EvaluationStore store)
        : plan_(plan), hooks_(hooks), evaluator_(std::move(evaluator)), store_(std::move(store)) {}

    Result<TuneResult> run(const gpu::Context& context) {
        result_.device = context.info().name;
        result_.driver = context.info().driver;
        result_.metric = plan_.evaluation.metric;
        result_.counted = plan_.evaluation.counted;
        result_.width = evaluator_.size()[0];
        result_.height = evaluator_.size()[1];
        GLINT_CHECK(findTarget());
        GLINT_CHECK(search());
        GLINT_CHECK(choose());
        GLINT_CHECK(simplify());
        GLINT_CHECK(explain());
        GLINT_CHECK(makeCurve());
        GLINT_CHECK(save());
        return std::move(result_);
    }

private:
    Result<void> search() {
        const auto started = Clock::now();
        SearchHooks hooks;
        hooks.evaluate = [this](const Settings& settings, double mostCost) {
            return evaluate(settings, ViewSet::Search, mostCost);
        };
        if (plan_.seconds)
            hooks.mayGoOn = [this, started] {
                const std::chrono::duration<double> passed = Clock::now() - started;
                return passed.count() < *plan_.seconds;
            };
        hooks.progress = hooks_.progress;
        SearchPlan plan = plan_.search;
        if (result_.target.mostCost)
            plan.mostCost = kBeyondTarget * std::max(*result_.target.mostCost, start_.cost);
        GLINT_TRY(outcome, searchSettings(plan, hooks));
        tried_ = std::move(outcome.tried);
        result_.generations = outcome.generations;
        result_.tried = tried_.size();
        result_.withoutEffect = std::move(outcome.withoutEffect);
        return {};
    }

    /// Brings the target to the unit of cost. Milliseconds and counted floors are only related by a measurement, which
    /// the state file keeps.
    Result<void> findTarget() {
        GLINT_TRY(start, evaluate(plan_.search.start, ViewSet::Search, kInfinite));
        start_ = start.figures;
        const TuneTarget& asked = plan_.target;
        if (asked.mostError) {
            result_.target.mostError = asked.mostError;
        } else if (asked.mostShare) {
            result_.target.mostCost = *asked.mostShare * start_.cost;
        } else {
            GLINT_TRY(timing, time(plan_.search.start));
            const double msPerFloor = timing.ms / timing.floors;
            const bool ms = asked.mostMs.has_value();
            const double most = ms ? *asked.mostMs : *asked.mostFloors;
            if (ms == !plan_.evaluation.counted)
                result_.target.mostCost = most;
            else
                result_.target.mostCost = ms ? most / msPerFloor : most * msPerFloor;
        }
        return {};
    }

    /// Goes down the curve from the best point for the target to the first that holds up on the views held back.
    Result<void> choose() {
        working("checking on views held back");
        GLINT_TRY(heldStart, evaluate(plan_.search.start, ViewSet::Held, kInfinite));
        heldStart_ = heldStart.figures;
        const std::vector<Figures> figures = figuresOf(tried_);
        const std::vector<size_t> front = paretoFront(figures);
        std::vector<Figures> onFront;
        for (const size_t i : front)
            onFront.push_back(figures[i]);
        for (const size_t i : byPreference(onFront, result_.target)) {
            if (!meets(onFront[i], result_.target))
                break;
            GLINT_TRY(held, evaluate(tried_[front[i]].settings, ViewSet::Held, kInfinite));
            if (!holdsUp(held.figures, heldStart_, result_.target))
                continue;
            choice_ = tried_[front[i]].settings;
            result_.met = result_.held = true;
            return {};
        }
        // Nothing does both: what comes nearest to the target without being worse than the start anywhere.
        for (const size_t i : byPreference(onFront, result_.target)) {
            GLINT_TRY(held, evaluate(tried_[front[i]].settings, ViewSet::Held, kInfinite));
            if (dominates(heldStart_, held.figures) || dominates(start_, onFront[i]))
                continue;
            choice_ = tried_[front[i]].settings;
            result_.met = meets(onFront[i], result_.target);
            return {};
        }
        choice_ = plan_.search.start;
        result_.met = meets(start_, result_.target);
        return {};
    }

    /// Gives back the start's value to every setting of the choice that gains nothing, on either kind of views.
    Result<void> simplify() {
        working("leaving out what gains nothing");
        GLINT_TRY(search, evaluate(choice_, ViewSet::Search, kInfinite));
        GLINT_TRY(held, evaluate(choice_, ViewSet::Held, kInfinite));
        // Again after each change: a setting may gain nothing only once another one is back.
        for (bool simplified = true; simplified;) {
            simplified = false;
            for (const SettingInfo* info : changed(choice_)) {
                if (settingValue(*info, &choice_) == settingValue(*info, &plan_.search.start))
                    continue; // went with one before
                const Settings simpler = reverted(choice_, *info);
                GLINT_TRY(without, tryOne(simpler));
                if (!gainsNothing(search.figures, without.figures) || isBeaten(without.figures))
                    continue;
                GLINT_TRY(heldWithout, evaluate(simpler, ViewSet::Held, kInfinite));
                if (!gainsNothing(held.figures, heldWithout.figures) ||
                    (result_.met && !meets(without.figures, result_.target)) ||
                    (result_.held && !holdsUp(heldWithout.figures, heldStart_, result_.target)))
                    continue;
                choice_ = simpler;
                simplified = true;
            }
        }
        return {};
    }

    /// True if something that was tried is better by more than next to nothing.
    bool isBeaten(const Figures& figures) const {
        return std::ranges::any_of(tried_, [&](const Tried& each) {
            return dominates(each.evaluation.figures, figures) && !gainsNothing(each.evaluation.figures, figures);
        });
    }

    static bool gainsNothing(const Figures& with, const Figures& without) {
        return without.cost <= with.cost * (1 + kNoGain) && without.error <= with.error * (1 + kNoGain);
    }

    Result<void> explain() {
        working("asking which settings matter");
        GLINT_TRY(search, evaluate(choice_, ViewSet::Search, kInfinite));
        for (const SettingInfo* info : changed(choice_)) {
            GLINT_TRY(without, tryOne(reverted(choice_, *info)));
            result_.sensitivities.push_back(
                {info->key,
                 settingText(*info, settingValue(*info, &choice_)),
                 settingText(*info, settingValue(*info, &plan_.search.start)),
                 {without.figures.cost - search.figures.cost, without.figures.error - search.figures.error}});
        }
        std::ranges::stable_sort(result_.sensitivities, std::ranges::greater(),
                                 [](const Sensitivity& each) { return std::abs(each.change.error); });
        return {};
    }

    /// The curve of all that was tried, with the figures that only its points get. The choice is one of them: what
    /// beats it does so by next to nothing and differs in more, or did not hold up on the views held back.
    Result<void> makeCurve() {
        const std::vector<Figures> figures = figuresOf(tried_);
        const auto found =
            std::ranges::find_if(tried_, [this](const Tried& each) { return isSame(each.settings, choice_); });
        const auto chosen = static_cast<size_t>(found - tried_.begin());
        const std::vector<size_t> front = thinned(paretoFrontThrough(figures, chosen), figures);
        for (const size_t i : front) {
            working(fmt::format("measuring the curve, {} of {}", result_.points.size() + 1, front.size()));
            GLINT_TRY(point, makePoint(tried_[i].settings));
            result_.points.push_back(std::move(point));
        }
        working("measuring the presets");
        GLINT_TRY(start, makePoint(plan_.search.start));
        start.preset = plan_.startName;
        result_.presets.push_back(std::move(start));
        for (const NamedSettings& preset : plan_.search.presets) {
            GLINT_TRY(point, makePoint(preset.settings));
            point.preset = preset.name;
            result_.presets.push_back(std::move(point));
        }
        GLINT_TRY(choice, makePoint(choice_));
        result_.choice = std::move(choice);
        return {};
    }

    Result<TunePoint> makePoint(const Settings& settings) {
        TunePoint point;
        point.settings = settings;
        GLINT_TRY(search, evaluate(settings, ViewSet::Search, kInfinite));
        GLINT_TRY(held, evaluate(settings, ViewSet::Held, kInfinite));
        GLINT_TRY(timing, time(settings));
        point.search = std::move(search);
        point.held = std::move(held);
        point.timing = timing;
        point.chosen = isSame(settings, choice_);
        if (isSame(settings, plan_.search.start))
            point.preset = plan_.startName;
        for (const NamedSettings& preset : plan_.search.presets)
            if (isSame(settings, preset.settings))
                point.preset = preset.name;
        return point;
    }

    /// Keeps the ends, the choice and the presets, and of the others those that lie farthest from their neighbours.
    std::vector<size_t> thinned(std::vector<size_t> front, const std::vector<Figures>& figures) const {
        const auto gap = [&](size_t at) {
            return std::log(figures[front[at + 1]].cost / figures[front[at - 1]].cost) +
                   std::log(figures[front[at - 1]].error / figures[front[at + 1]].error);
        };
        while (front.size() > kMostPoints) {
            size_t worst = 0;
            for (size_t at = 1; at + 1 < front.size(); ++at)
                if (!isNamed(tried_[front[at]].settings) && (worst == 0 || gap(at) < gap(worst)))
                    worst = at;
            if (worst == 0)
                break;
            front.erase(front.begin() + static_cast<ptrdiff_t>(worst));
        }
        return front;
    }

    bool isNamed(const Settings& settings) const {
        return isSame(settings, choice_) || isSame(settings, plan_.search.start) ||
               std::ranges::any_of(plan_.search.presets,
                                   [&](const NamedSettings& preset) { return isSame(settings, preset.settings); });
    }

    static bool isSame(const Settings& a, const Settings& b) { return differences(a, b).empty(); }

    std::vector<const SettingInfo*> changed(const Settings& settings) const {
        std::vector<const SettingInfo*> result;
        for (const SettingInfo& info : settingsTable())
            if (settingValue(info, &settings) != settingValue(info, &plan_.search.start))
                result.push_back(&info);
        return result;
    }

    /// With the start's value of one setting, and of all that have no effect without it.
    Settings reverted(const Settings& settings, const SettingInfo& info) const {
        Settings result = settings;
        const auto revert = [&](const SettingInfo& each) {
            const SettingAssignment assignment{&each, &result, settingValue(each, &plan_.search.start), false, {}};
            assignSettings({&assignment, 1});
        };
        revert(info);
        for (const SettingInfo* other : changed(result))
            if (!hasEffect(*other, result))
                revert(*other);
        return result;
    }

    /// As a candidate of the search: it may belong to the curve.
    Result<Evaluation> tryOne(const Settings& settings) {
        GLINT_TRY(evaluation, evaluate(settings, ViewSet::Search, kInfinite));
        tried_.push_back({settings, evaluation});
        return evaluation;
    }

    static std::vector<Figures> figuresOf(const std::vector<Tried>& tried) {
        std::vector<Figures> figures;
        for (const Tried& each : tried)
            figures.push_back(each.evaluation.figures);
        return figures;
    }

    Result<Evaluation> evaluate(const Settings& settings, ViewSet set, double mostCost) {
        const Evaluation* const known = store_.find(settings, set);
        if (known && (!known->views.empty() || mostCost <= known->limit))
            return *known;
        GLINT_TRY(evaluation, evaluator_.evaluate(settings, set, mostCost));
        store_.add(settings, set, evaluation);
        GLINT_CHECK(saveNowAndThen());
        return evaluation;
    }

    Result<Timing> time(const Settings& settings) {
        if (const Timing* known = store_.findTiming(settings))
            return *known;
        GLINT_TRY(timing, evaluator_.time(settings, plan_.timedFrames));
        store_.addTiming(settings, timing);
        GLINT_CHECK(saveNowAndThen());
        return timing;
    }

    Result<void> save() {
        saved_ = Clock::now();
        return plan_.stateFile.empty() ? Result<void>() : store_.save(plan_.stateFile);
    }

    /// Before the first generation alone there are a hundred evaluations.
    Result<void> saveNowAndThen() {
        const std::chrono::duration<double> passed = Clock::now() - saved_;
        return passed.count() < plan_.secondsPerSave ? Result<void>() : save();
    }

    void working(const std::string& what) const {
        if (hooks_.working)
            hooks_.working(what);
    }

    const TunePlan& plan_;
    const TuneHooks& hooks_;
    Evaluator evaluator_;
    EvaluationStore store_;
    Clock::time_point saved_ = Clock::now();
    std::vector<Tried> tried_;
    Settings choice_;
    Figures start_;
    Figures heldStart_;
    TuneResult result_;
};

/// Everything that an evaluation depends on besides the settings of the candidate.
std::string requestText(const gpu::Context& context, const TunePlan& plan) {
    std::string text = fmt::format("{} {}\n{}\n", context.info().name, context.info().driver, plan.identity);
    for (const render::RenderJob& job : plan.evaluation.jobs)
        text += fmt::format("{} camera {} env {} materials {} probes {} planar {} size {}x{} seed {}\n", job.scene,
                            job.camera, job.environment, job.materials, job.probes, static_cast<int>(job.planar),
                            job.width, job.height, job.seed);
    for (const scene::CameraMove move : plan.evaluation.paths)
        text += fmt::format("{}\n", scene::cameraMoves()[static_cast<size_t>(move)]);
    text += fmt::format("metric {}, cost {}, reference {} frames\n{}", static_cast<int>(plan.evaluation.metric),
                        plan.evaluation.counted ? "counted" : "measured", plan.evaluation.referenceFrames,
                        render::settingsJson(plan.evaluation.reference));
    for (const render::RenderJob& job : plan.evaluation.jobs)
        text += render::settingsJson(job.settings);
    return text;
}

} // namespace

Result<TuneResult> tuneSettings(gpu::Context& context, const TunePlan& plan, const TuneHooks& hooks) {
    EvaluationStore store(requestText(context, plan), plan.search.start);
    std::error_code ignored;
    if (!plan.stateFile.empty() && std::filesystem::exists(plan.stateFile, ignored))
        GLINT_CHECK(store.load(plan.stateFile));
    GLINT_TRY(evaluator, Evaluator::create(context, plan.evaluation, hooks.working));
    return Tuner(plan, hooks, std::move(evaluator), std::move(store)).run(context);
}

} // namespace glint::tune
