#include "lab/cli/sequence/sequence_output.hpp"

#include "lab/cli/compare/comparison_output.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glint::cli {
namespace {

using SequenceJson = nlohmann::ordered_json;

constexpr std::array<const char*, measure::kBands + 1> kBandNames = {"mirror", "glossy", "rough", "all"};

/// JSON has no infinity and no NaN.
SequenceJson known(double value) {
    return std::isfinite(value) ? SequenceJson(value) : SequenceJson();
}

SequenceJson seriesJson(const measure::SeriesFigure& figure) {
    return {{"mean", known(figure.mean)}, {"p95", known(figure.p95)}, {"standardError", known(figure.standardError)}};
}

template <class Values>
SequenceJson valuesJson(const Values& values) {
    SequenceJson json = SequenceJson::array();
    for (const double value : values)
        json.push_back(known(value));
    return json;
}

template <class Shares>
SequenceJson sharesJson(const Shares& shares) {
    SequenceJson json = SequenceJson::array();
    for (const measure::Share& share : shares)
        json.push_back({{"share", known(share.value)}, {"standardError", known(share.standardError)}});
    return json;
}

/// The mean over the steps that got so far before the next one.
struct MeanLag {
    double mean = 0; ///< NaN if none did
    size_t reached = 0;
};

MeanLag meanLag(const std::vector<measure::StepResponse>& steps, double measure::StepResponse::*lag) {
    double sum = 0;
    size_t reached = 0;
    for (const measure::StepResponse& step : steps) {
        if (std::isnan(step.*lag))
            continue;
        sum += step.*lag;
        ++reached;
    }
    return {reached > 0 ? sum / static_cast<double>(reached) : std::nan(""), reached};
}

SequenceJson lagJson(const std::vector<measure::StepResponse>& steps, double measure::StepResponse::*lag) {
    const MeanLag mean = meanLag(steps, lag);
    return {{"mean", known(mean.mean)}, {"reached", mean.reached}, {"steps", steps.size()}};
}

SequenceJson bandJson(const measure::MotionBandFigures& band) {
    SequenceJson json;
    json["pixels"] = known(band.error.pixels);
    json["relMse"] = seriesJson(band.error.relativeMse);
    json["bias"] = seriesJson(band.error.bias);
    json["noise"] = seriesJson(band.error.noise);
    json["flicker"] = seriesJson(band.flicker.flicker);
    json["swim"] = seriesJson(band.flicker.swim);
    json["tPsnr"] = known(band.flicker.tPsnr);
    json["sharp"] = seriesJson(band.error.sharp);
    json["energy"] = seriesJson(band.error.energy);
    json["fireflies"] = seriesJson(band.error.fireflies);
    json["trail"] = sharesJson(band.trail);
    json["lead"] = sharesJson(band.lead);
    json["ghost"] = sharesJson(band.ghost.ghost);
    json["ghostError"] = valuesJson(band.ghost.error);
    json["heal"] = known(band.ghost.heal);
    json["disoccluded"] = band.ghost.disoccluded;
    json["lag90"] = lagJson(band.steps, &measure::StepResponse::lag90);
    json["lag99"] = lagJson(band.steps, &measure::StepResponse::lag99);
    json["steps"] = SequenceJson::array();
    for (const measure::StepResponse& step : band.steps)
        json["steps"].push_back({{"frame", step.frame},
                                 {"lag90", known(step.lag90)},
                                 {"lag99", known(step.lag99)},
                                 {"overshoot", known(step.overshoot)},
                                 {"pixels", step.pixels}});
    return json;
}

/// A band has pixels, or its flicker is known without a reference.
bool hasPixels(const measure::MotionBandFigures& band) {
    return band.error.pixels > 0 || !std::isnan(band.flicker.flicker.mean);
}

SequenceJson figuresJson(const std::vector<measure::MotionFigures>& figures) {
    SequenceJson json = SequenceJson::object();
    for (size_t signal = 0; signal < figures.size(); ++signal)
        for (size_t band = 0; band <= measure::kBands; ++band)
            if (hasPixels(figures[signal][band]))
                json[measure::kSignalViews[signal]][kBandNames[band]] = bandJson(figures[signal][band]);
    return json;
}

SequenceJson sequenceConfigJson(const measure::SequenceConfig& config) {
    SequenceJson json;
    json["name"] = config.name;
    if (config.storedSeeds > 0) {
        json["storedSeeds"] = config.storedSeeds;
        json["figures"] = figuresJson(config.figures);
        json["notes"] = config.notes;
        return json;
    }
    json["preset"] = config.settings.preset;
    json["raysPerPixel"] = config.raysPerPixel;
    json["effectMs"] = config.times.total().median;
    json["effectMs95"] = config.times.total().p95;
    json["passes"] = SequenceJson::array();
    for (const measure::PassSpread& pass : config.times.passes())
        json["passes"].push_back({{"name", pass.name}, {"ms", pass.ms.median}, {"ms95", pass.ms.p95}});
    if (!config.figures.empty())
        json["figures"] = figuresJson(config.figures);
    json["notes"] = config.notes;
    json["settings"] = SequenceJson::parse(render::settingsJson(config.settings));
    return json;
}

/// "-" for what is unknown.
std::string cell(double value, const char* format) {
    return fmt::format("{:>9}", std::isnan(value) ? std::string("-") : fmt::format(fmt::runtime(format), value));
}

std::string shareCell(const measure::Share& share) {
    return fmt::format("{:>14}", std::isnan(share.value)
                                     ? std::string("-")
                                     : fmt::format("{:.3f}±{:.3f}", share.value, share.standardError));
}

std::string bandRow(const char* signal, const char* name, const measure::MotionBandFigures& band) {
    const auto lag = [&](double measure::StepResponse::*which) {
        const MeanLag mean = meanLag(band.steps, which);
        return mean.reached == band.steps.size() ? mean.mean : std::nan(""); // the mean of some would flatter
    };
    std::string row = fmt::format("  {:<10} {:<6}", signal, name);
    for (const double value : {band.error.relativeMse.mean, band.error.bias.mean, band.error.noise.mean,
                               band.flicker.flicker.mean, band.flicker.swim.mean})
        row += cell(value, "{:.4f}");
    row += cell(band.flicker.tPsnr, "{:.1f}");
    row += cell(lag(&measure::StepResponse::lag90), "{:.1f}");
    row += cell(lag(&measure::StepResponse::lag99), "{:.1f}");
    row += shareCell(band.trail[3]);
    row += shareCell(band.lead[3]);
    row += shareCell(band.ghost.ghost[4]);
    row += cell(band.ghost.heal, "{:.0f}");
    row += cell(band.error.sharp.mean, "{:.3f}");
    row += cell(band.error.energy.mean, "{:.3f}");
    row += cell(band.error.fireflies.mean, "{:.0f}");
    return row + "\n";
}

} // namespace

std::string sequenceText(const measure::Sequence& sequence) {
    std::string text =
        fmt::format("{}, {} frames of {}x{} at {} frames per second, {}; {}\n", sequence.scene, sequence.frames,
                    sequence.width, sequence.height, sequence.fps, sequence.device, clockWords(sequence.software));
    for (const measure::SequenceConfig& config : sequence.configs) {
        if (config.storedSeeds > 0)
            text += fmt::format("\n{}: frames from files, {}\n", config.name,
                                config.storedSeeds == 1 ? "one seed" : "two seeds");
        else
            text += fmt::format("\n{}: {:.2f} rays per pixel, {:.2f} ms, {:.2f} (95 %)\n", config.name,
                                config.raysPerPixel, config.times.total().median, config.times.total().p95);
        if (!config.figures.empty())
            text +=
                fmt::format("  {:<17}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>14}{:>14}{:>14}{:>9}{:>9}{:>9}{:>9}\n",
                            "", "relMSE", "bias", "noise", "flicker", "swim", "tPSNR", "lag90", "lag99", "trail4",
                            "lead4", "ghost4", "heal", "sharp", "energy", "firefly");
        for (size_t signal = 0; signal < config.figures.size(); ++signal)
            for (size_t band = 0; band <= measure::kBands; ++band)
                if (hasPixels(config.figures[signal][band]))
                    text += bandRow(measure::kSignalViews[signal], kBandNames[band], config.figures[signal][band]);
        for (const std::string& note : config.notes)
            text += fmt::format("  note: {}\n", note);
    }
    return text;
}

std::string sequenceJson(const measure::Sequence& sequence) {
    SequenceJson json;
    json["scene"] = sequence.scene;
    json["width"] = sequence.width;
    json["height"] = sequence.height;
    json["frames"] = sequence.frames;
    json["fps"] = sequence.fps;
    json["warmUp"] = sequence.warmUp;
    json["steps"] = sequence.steps;
    json["device"] = {{"name", sequence.device}, {"driver", sequence.driver}, {"software", sequence.software}};
    json["clock"] = clockWords(sequence.software);
    if (!sequence.reference.empty())
        json["reference"] = {{"name", sequence.reference}, {"frames", sequence.referenceFrames}};
    json["configs"] = SequenceJson::array();
    for (const measure::SequenceConfig& config : sequence.configs)
        json["configs"].push_back(sequenceConfigJson(config));
    return json.dump(2, ' ', false, SequenceJson::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
