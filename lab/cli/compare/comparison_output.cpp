#include "lab/cli/compare/comparison_output.hpp"

#include "lab/cli/compare/certainty_text.hpp"
#include "lab/cli/compare/exact_report.hpp"
#include "lab/cli/compare/hits_report.hpp"
#include "lab/cli/render/render_output.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string hitsLine(std::string_view name, const measure::HitFigures& hits) {
    return fmt::format("  {:<8} precision {:6.4f}  recall {:6.4f}  error {:.2f} px, {:.2f} (95 %)  lookups {:.1f}, {} "
                       "(95 %)  {} rays, {} visible\n",
                       name, hits.precision(), hits.recall(), hits.positionErrorMedian, hits.positionError95,
                       hits.lookupsMean, hits.lookups95, hits.rays, hits.visibleTruths);
}

/// "hit 52.5 %, offScreen 36.1 %": the share of each outcome, without those that round to 0.0 %.
template <class Counts>
std::string sharesText(const Counts& counts, const render::RenderStats& stats, uint64_t whole) {
    std::string text;
    for (size_t i = 0; i < counts.size() && i < stats.outcomes.size(); ++i) {
        const double share = whole > 0 ? 100 * static_cast<double>(counts[i]) / static_cast<double>(whole) : 0;
        if (share >= 0.05)
            text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", stats.outcomes[i].first, share);
    }
    return text.empty() ? "none" : text;
}

std::string timesText(const measure::EffectTimes& times) {
    std::string text = fmt::format("  time     {:.2f} ms, {:.2f} (95 %) = {:.1f} floors:", times.total().median,
                                   times.total().p95, times.floorMultiple());
    for (const measure::PassSpread& pass : times.passes())
        text += fmt::format(" {} {:.2f}", pass.name, pass.ms.median);
    return text + "\n";
}

std::string exactText(const measure::MirrorError& exact) {
    return fmt::format("  wrong    {:.2f} % of mirror pixels that one bounce explains, {:.2f} % of all\n",
                       100 * exact.oneBounceShare(), 100 * exact.share());
}

std::string referenceText(const measure::ReferenceError& error) {
    return fmt::format(
        "  from the reference: displayed error {:.2e}, {:.0f} % of it in the worst 0.1 % of the pixels; relative "
        "MSE {:.2e}, {:.0f} % of it; {:.2e} on mirrors; PSNR {:.1f} dB, {:.1f} on mirrors\n",
        error.displayed.mean, 100 * error.displayed.share, error.relativeMse, 100 * error.radiance.share,
        error.relativeMseMirrors, error.psnr, error.psnrMirrors);
}

std::string sceneRaysText(const Statistics::SceneRays& scene) {
    return fmt::format("  scene    {} rays for {} pixels, {} of them from the screen's hit; light reused {} times\n",
                       scene.rays, scene.pixels, scene.fromScreen, scene.reusedLight);
}

/// Null for infinity, which JSON lacks: the PSNR of equal images.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

/// Bands without pixels are absent.
Json bandsJson(const measure::ByBand<measure::BandError>& bands) {
    constexpr std::array kNames = {"mirror", "glossy", "rough", "all"};
    Json json = Json::object();
    for (size_t band = 0; band < bands.size(); ++band)
        if (bands[band].pixels > 0)
            json[kNames[band]] = {{"pixels", bands[band].pixels}, {"relativeMse", finite(bands[band].relativeMse)}};
    return json;
}

Json passesJson(const measure::EffectTimes& times) {
    Json passes = Json::array();
    for (const measure::PassSpread& pass : times.passes())
        passes.push_back({{"name", pass.name}, {"ms", pass.ms.median}, {"ms95", pass.ms.p95}});
    return passes;
}

Json configJson(const measure::ConfigFigures& config) {
    Json json;
    json["name"] = config.name;
    json["preset"] = config.settings.preset;
    json["hits"] = hitReportJson(config.hits, config.stats.outcomes);
    if (config.exact)
        json["exact"] = exactJson(*config.exact);
    if (config.reference)
        json["reference"] = {{"displayedError", config.reference->displayed.mean},
                             {"displayedWorstShare", config.reference->displayed.share},
                             {"relativeMseWorstShare", config.reference->radiance.share},
                             {"psnr", finite(config.reference->psnr)},
                             {"psnrMirrors", finite(config.reference->psnrMirrors)},
                             {"relativeMse", config.reference->relativeMse},
                             {"relativeMseMirrors", config.reference->relativeMseMirrors},
                             {"mirrorPixels", config.reference->mirrorPixels},
                             {"bands", bandsJson(config.reference->bands)}};
    if (config.settings.reflections.rays.enabled)
        json["sceneRays"] = sceneRaysJson(config.stats.scene);
    json["effectMs"] = config.times.total().median;
    json["effectMs95"] = config.times.total().p95;
    json["floorMs"] = config.times.floor().median;
    json["floorMultiple"] = config.times.floorMultiple();
    json["frames"] = config.times.frames();
    json["passes"] = passesJson(config.times);
    json["rays"] = config.stats.rays;
    json["lookupsPerRay"] = config.stats.lookupsPerRay;
    json["lookups95"] = config.stats.lookups95;
    Json outcomes = Json::object();
    for (const auto& [name, pixels] : config.stats.outcomes)
        outcomes[name] = pixels;
    json["outcomes"] = std::move(outcomes);
    json["notes"] = config.notes;
    json["settings"] = Json::parse(render::settingsJson(config.settings));
    return json;
}

} // namespace

std::string clockWords(bool software) {
    return software ? "timestamps of a software device: compare ratios within one run" : "GPU timestamps";
}

std::string comparisonText(const measure::Comparison& comparison) {
    std::string text = fmt::format("{}, {}x{}, {}; {}\n", comparison.scene, comparison.width, comparison.height,
                                   comparison.device, clockWords(comparison.software));
    if (!comparison.noExact.empty())
        text += fmt::format("wrong mirror pixels: {}\n", comparison.noExact);
    for (const measure::ConfigFigures& config : comparison.configs) {
        const measure::HitFigures& all = config.hits.all;
        text += fmt::format("\n{}\n", config.name);
        text += hitsLine("all", all);
        const measure::HitFigures& mirror = config.hits.bands[static_cast<size_t>(measure::RoughnessBand::Mirror)];
        if (mirror.rays > 0 && mirror.rays < all.rays)
            text += hitsLine("mirrors", mirror);
        text += fmt::format("  outcomes {}\n", sharesText(all.outcomes, config.stats, all.rays));
        text += fmt::format("  missed   {}, of visible truths\n",
                            sharesText(all.missedByOutcome, config.stats, all.visibleTruths));
        text += statedText(all);
        if (config.exact)
            text += exactText(*config.exact);
        if (config.reference)
            text += referenceText(*config.reference);
        if (config.stats.scene.pixels > 0)
            text += sceneRaysText(config.stats.scene);
        text += timesText(config.times);
        for (const std::string& note : config.notes)
            text += fmt::format("  note     {}\n", note);
    }
    return text;
}

std::string comparisonJson(const measure::Comparison& comparison) {
    Json json;
    json["scene"] = comparison.scene;
    json["width"] = comparison.width;
    json["height"] = comparison.height;
    json["device"] = {{"name", comparison.device}, {"driver", comparison.driver}, {"software", comparison.software}};
    json["clock"] = clockWords(comparison.software);
    if (!comparison.reference.empty())
        json["reference"] = comparison.reference;
    if (!comparison.noExact.empty())
        json["noExact"] = comparison.noExact;
    json["configs"] = Json::array();
    for (const measure::ConfigFigures& config : comparison.configs)
        json["configs"].push_back(configJson(config));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
