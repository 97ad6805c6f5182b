#include "lab/cli/sweep/sweep_figures.hpp"

#include <array>
#include <cmath>

namespace glint::cli {
namespace {

constexpr std::array<const char*, measure::kBands + 1> kBandEnds = {"mirror", "glossy", "rough", "all"};

void addHitFigures(const measure::HitFigures& hits, const char* band, SweepJson& figures) {
    if (hits.rays == 0)
        return;
    if (hits.reported > 0)
        addFigure(figures, fmt::format("hits.precision.{}", band), hits.precision());
    if (hits.visibleTruths > 0)
        addFigure(figures, fmt::format("hits.recall.{}", band), hits.recall());
}

} // namespace

void addFigure(SweepJson& figures, std::string_view name, double value) {
    if (std::isfinite(value))
        figures[std::string(name)] = value;
}

void addStillFigures(const measure::ConfigFigures& config, bool hits, SweepJson& figures) {
    if (config.reference) {
        for (size_t band = 0; band < kBandEnds.size(); ++band)
            if (config.reference->bands[band].pixels > 0)
                addFigure(figures, fmt::format("error.relativeMse.{}", kBandEnds[band]),
                          config.reference->bands[band].relativeMse);
        addFigure(figures, "error.psnr", config.reference->psnr);
        addFigure(figures, "error.psnrMirrors", config.reference->psnrMirrors);
    }
    if (config.exact)
        addFigure(figures, "exact.oneBounceWrong", config.exact->oneBounceShare());
    if (hits) {
        for (size_t band = 0; band < config.hits.bands.size(); ++band)
            addHitFigures(config.hits.bands[band], kBandEnds[band], figures);
        addHitFigures(config.hits.all, "all", figures);
        if (config.hits.all.rays > 0)
            addFigure(figures, "hits.lookupsPerRay", config.hits.all.lookupsMean);
    }
    addFigure(figures, "work.rays", static_cast<double>(config.stats.rays));
    addFigure(figures, "work.lookupsPerRay", config.stats.lookupsPerRay);
    addFigure(figures, "work.sceneRays", static_cast<double>(config.stats.scene.rays));
}

void addMotionFigures(const measure::SequenceConfig& config, SweepJson& figures) {
    addFigure(figures, "motion.raysPerPixel", config.raysPerPixel);
    if (config.figures.empty())
        return;
    const measure::MotionBandFigures& all =
        config.figures[static_cast<size_t>(measure::Signal::Reflection)][measure::kBands];
    addFigure(figures, "motion.relMse", all.error.relativeMse.mean);
    addFigure(figures, "motion.bias", all.error.bias.mean);
    addFigure(figures, "motion.noise", all.error.noise.mean);
    addFigure(figures, "motion.flicker", all.flicker.flicker.mean);
    addFigure(figures, "motion.swim", all.flicker.swim.mean);
    addFigure(figures, "motion.trail4", all.trail[3].value);
    addFigure(figures, "motion.sharp", all.error.sharp.mean);
}

SweepJson timesJson(const measure::EffectTimes& times) {
    SweepJson json = {{"effectMs", times.total().median},
                      {"effectMs95", times.total().p95},
                      {"floorMs", times.floor().median},
                      {"floors", times.floorMultiple()},
                      {"passes", SweepJson::object()}};
    for (const measure::PassSpread& pass : times.passes())
        json["passes"][pass.name] = pass.ms.median;
    return json;
}

} // namespace glint::cli
