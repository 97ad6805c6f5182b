#include "lab/cli/report/report_figures.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/report/report_json.hpp"

#include <algorithm>
#include <cmath>

namespace glint::cli {
namespace {

using ReportValues = nlohmann::ordered_json;
using measure::Estimate;
using measure::Figure;
using measure::FigureKind;
using measure::Verdict;

constexpr size_t kMostBytes = size_t(64) << 20;
constexpr size_t kMostFigures = 100000;
constexpr std::array<const char*, measure::kBands + 1> kReportBands = {"mirror", "glossy", "rough", "all"};
constexpr std::array<const char*, 4> kVerdicts = {"better", "worse", "noise", "same"};

/// The figures of one config.
class ConfigFigureList {
public:
    ConfigFigureList(std::string scene, std::string config, std::vector<Figure>& figures)
        : scene_(std::move(scene)), config_(std::move(config)), figures_(figures) {}

    void exact(std::string name, FigureKind kind, double value) { add(std::move(name), kind, {value, 0, 0}); }

    /// Nothing, where there is only one seed.
    void seeds(std::string name, FigureKind kind, const std::vector<double>& values) {
        if (values.size() >= 2)
            add(std::move(name), kind, Estimate::of(values));
    }

    /// `values`: how many the error is of.
    void series(std::string name, FigureKind kind, double value, double standardError, double values) {
        const bool noisy = standardError > 0;
        if (std::isfinite(standardError) && values >= 2)
            add(std::move(name), kind, {value, noisy ? standardError : 0, noisy ? values - 1 : 0});
    }

private:
    void add(std::string name, FigureKind kind, const Estimate& estimate) {
        if (std::isfinite(estimate.value) && std::isfinite(estimate.standardError))
            figures_.push_back({scene_, config_, std::move(name), kind, estimate});
    }

    std::string scene_, config_;
    std::vector<Figure>& figures_;
};

void addHits(const measure::HitReport& hits, ConfigFigureList& list) {
    const auto addBand = [&](const measure::HitFigures& figures, const std::string& band) {
        if (figures.rays == 0)
            return;
        if (figures.reported > 0)
            list.exact("hits.precision." + band, FigureKind::Share, figures.precision());
        if (figures.visibleTruths > 0)
            list.exact("hits.recall." + band, FigureKind::Share, figures.recall());
    };
    addBand(hits.all, "all");
    for (size_t band = 0; band < hits.bands.size(); ++band)
        addBand(hits.bands[band], kReportBands[band]);
    if (hits.all.rays > 0)
        list.exact("hits.lookupsPerRay", FigureKind::Error, hits.all.lookupsMean);
}

/// The figures of a config's images and times, with every seed.
void addImages(const measure::ConfigFigures& config, const measure::ComparisonMaps& maps, bool reference,
               ConfigFigureList& list) {
    const auto all = [&](double first, const auto& ofSeed) {
        std::vector<double> values = {first};
        for (const measure::SeedFigures& seed : config.seeds)
            values.push_back(ofSeed(seed));
        return values;
    };
    using Seed = measure::SeedFigures;
    if (config.exact)
        list.seeds("exact.oneBounceWrong", FigureKind::Wrong,
                   all(config.exact->oneBounceShare(), [](const Seed& seed) { return seed.exact->oneBounceShare(); }));
    if (config.reference)
        for (size_t band = 0; band < kReportBands.size(); ++band)
            if (config.reference->bands[band].pixels > 0)
                list.seeds(fmt::format("error.relativeMse.{}", kReportBands[band]), FigureKind::Error,
                           all(config.reference->bands[band].relativeMse,
                               [band](const Seed& seed) { return seed.reference->bands[band].relativeMse; }));
    if (reference) {
        std::vector<double> flips = {maps.flipMean};
        flips.insert(flips.end(), maps.flipMeans.begin(), maps.flipMeans.end());
        list.seeds("error.flip", FigureKind::Error, flips);
    }
    if (config.times.floorMultiple() > 0)
        list.seeds("time.floors", FigureKind::Time,
                   all(config.times.floorMultiple(), [](const Seed& seed) { return seed.floorMultiple; }));
}

/// Of the reflected radiance, over all reflective pixels: the figures that are better the smaller they are.
void addMotion(const measure::Sequence& motion, const measure::SequenceConfig& config, ConfigFigureList& list) {
    if (config.figures.empty())
        return;
    const measure::MotionBandFigures& all =
        config.figures[static_cast<size_t>(measure::Signal::Reflection)][measure::kBands];
    const double frames = motion.frames - motion.warmUp;
    const auto series = [&](const char* name, const measure::SeriesFigure& figure, double changes) {
        list.series(fmt::format("motion.{}", name), FigureKind::Error, figure.mean, figure.standardError, changes);
    };
    series("relMse", all.error.relativeMse, frames);
    series("noise", all.error.noise, frames);
    series("flicker", all.flicker.flicker, frames - 1); // changes from frame to frame
    series("swim", all.flicker.swim, frames - 1);
    list.series("motion.trail4", FigureKind::Wrong, all.trail[3].value, all.trail[3].standardError,
                motion.frames - 4.0);
}

/// The parts of a figure in a file.
Result<double> readNumber(const ReportValues& json, const char* key, size_t index) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number() || !std::isfinite(found->get<double>()))
        return invalidInput("figure {}: {} is no number", index, key);
    return found->get<double>();
}

Result<std::string> readName(const ReportValues& json, const char* key, size_t index) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string())
        return invalidInput("figure {}: {} is no text", index, key);
    return found->get<std::string>();
}

Result<Figure> readFigure(const ReportValues& json, size_t index) {
    if (!json.is_object())
        return invalidInput("figure {} is no object", index);
    Figure figure;
    GLINT_TRY(scene, readName(json, "scene", index));
    GLINT_TRY(config, readName(json, "config", index));
    GLINT_TRY(name, readName(json, "name", index));
    GLINT_TRY(kind, readName(json, "kind", index));
    GLINT_TRY(value, readNumber(json, "value", index));
    GLINT_TRY(standardError, readNumber(json, "standardError", index));
    GLINT_TRY(freedom, readNumber(json, "freedom", index));
    const auto kinds = measure::figureKindNames();
    const auto known = std::ranges::find(kinds, kind);
    if (known == kinds.end())
        return invalidInput("figure {}: kind '{}' is unknown", index, printable(kind));
    if (standardError < 0 || (standardError > 0 && freedom < 1))
        return invalidInput("figure {}: standardError {:g} with freedom {:g}", index, standardError, freedom);
    return Figure{std::move(scene),
                  std::move(config),
                  std::move(name),
                  static_cast<FigureKind>(known - kinds.begin()),
                  {value, standardError, freedom}};
}

/// Text at a path of keys; empty if there is none.
std::string textAt(const ReportValues& json, std::initializer_list<const char*> keys) {
    const ReportValues* at = &json;
    for (const char* key : keys) {
        const auto found = at->is_object() ? at->find(key) : at->end();
        if (found == at->end())
            return {};
        at = &*found;
    }
    return at->is_string() ? at->get<std::string>() : std::string();
}

/// Options of an earlier report: texts by their names.
Result<ReportValues> readOptions(const ReportValues& json) {
    const auto options = json.find("options");
    if (options == json.end())
        return invalidInput("it does not say with which options it was measured, as an earlier version wrote it; make "
                            "it again");
    if (!options->is_object() ||
        !std::ranges::all_of(*options, [](const ReportValues& value) { return value.is_string(); }))
        return invalidInput("options is no object of texts");
    return *options;
}

/// "--env sky", "no --env"
std::string optionText(const std::string& name, const std::string& value) {
    return value.empty() ? "no " + name : name + " " + value;
}

std::string changeText(const measure::FigureChange& change) {
    const bool points = change.now.kind == FigureKind::Share || change.now.kind == FigureKind::Wrong;
    if (std::isinf(change.worse))
        return "from 0";
    const double sign = change.now.kind == FigureKind::Share ? -1 : 1; // as the figure itself changes
    return fmt::format("{:+.2f} {}", sign * change.worse, points ? "points" : "%");
}

ReportValues named(const std::vector<Figure>& figures) {
    ReportValues json = ReportValues::array();
    for (const Figure& figure : figures)
        json.push_back({{"scene", figure.scene}, {"config", figure.config}, {"name", figure.name}});
    return json;
}

ReportValues bounded(double value) {
    return std::isfinite(value) ? ReportValues(value) : ReportValues();
}

} // namespace

std::vector<Figure> reportFigures(const std::vector<ReportScene>& scenes) {
    std::vector<Figure> figures;
    for (const ReportScene& scene : scenes)
        for (size_t i = 0; i < scene.comparison.configs.size(); ++i) {
            const measure::ConfigFigures& config = scene.comparison.configs[i];
            ConfigFigureList list(scene.title, config.name, figures);
            addHits(config.hits, list);
            addImages(config, scene.maps[i], !scene.comparison.referencePicture.empty(), list);
            if (scene.motion)
                addMotion(*scene.motion, scene.motion->configs[i], list);
        }
    return figures;
}

ReportValues figuresJson(const std::vector<Figure>& figures) {
    ReportValues json = ReportValues::array();
    for (const Figure& figure : figures)
        json.push_back({{"scene", figure.scene},
                        {"config", figure.config},
                        {"name", figure.name},
                        {"kind", measure::figureKindNames()[static_cast<size_t>(figure.kind)]},
                        {"value", figure.estimate.value},
                        {"standardError", figure.estimate.standardError},
                        {"freedom", figure.estimate.freedom}});
    return json;
}

Result<std::vector<Figure>> readFigures(const ReportValues& json) {
    if (!json.is_array() || json.size() > kMostFigures)
        return invalidInput("figures is no list of at most {}", kMostFigures);
    std::vector<Figure> figures;
    for (const ReportValues& entry : json) {
        GLINT_TRY(figure, readFigure(entry, figures.size()));
        figures.push_back(std::move(figure));
    }
    return figures;
}

Result<EarlierReport> readEarlierReport(const std::string& file) {
    auto bytes = readFile(file, kMostBytes);
    if (!bytes)
        return makeError(bytes.error().code, "--against {}", bytes.error().message);
    const ReportValues json = ReportValues::parse(*bytes, nullptr, false);
    if (json.is_discarded() || textAt(json, {"format"}) != kReportFormat)
        return invalidInput("--against {}: this is no '{}': give the file that glint report --json wrote",
                            printable(file), kReportFormat);
    const auto list = json.find("figures");
    auto figures = readFigures(list == json.end() ? ReportValues() : *list);
    if (!figures)
        return invalidInput("--against {}: {}", printable(file), figures.error().message);
    auto options = readOptions(json);
    if (!options)
        return invalidInput("--against {}: {}", printable(file), options.error().message);
    return EarlierReport{file,
                         textAt(json, {"glint"}),
                         textAt(json, {"device", "name"}),
                         textAt(json, {"device", "driver"}),
                         std::move(options).value(),
                         std::move(figures).value()};
}

Result<void> checkSameOptions(const EarlierReport& earlier, const ReportValues& options) {
    ReportValues all = options;
    all.update(earlier.options);
    std::vector<std::string> differing;
    for (const auto& [name, unused] : all.items()) {
        const std::string before = textAt(earlier.options, {name.c_str()}), now = textAt(options, {name.c_str()});
        if (before != now)
            differing.push_back(fmt::format("{} (now {})", optionText(name, before), optionText(name, now)));
    }
    if (differing.empty())
        return {};
    return invalidInput("--against {}: it was measured with {}, so its figures are no measure for these; repeat its "
                        "options, or make it again",
                        printable(earlier.file), printable(joinText(differing, ", "), 1000));
}

Result<ReportChanges> changesSince(const EarlierReport& earlier, const std::vector<ReportScene>& scenes) {
    ReportChanges changes;
    changes.file = earlier.file;
    changes.glint = earlier.glint;
    changes.device = earlier.device;
    const measure::Comparison& now = scenes.front().comparison;
    changes.figures = measure::compareFigures(earlier.figures, reportFigures(scenes),
                                              earlier.device == now.device && earlier.driver == now.driver);
    if (changes.figures.changes.empty())
        return invalidInput("--against {}: it has no figure of these scenes, sizes and configs",
                            printable(earlier.file));
    return changes;
}

std::string changesText(const ReportChanges& changes) {
    std::array<size_t, kVerdicts.size()> counts = {};
    std::string lines;
    for (const measure::FigureChange& change : changes.figures.changes) {
        ++counts[static_cast<size_t>(change.verdict)];
        if (change.verdict != Verdict::Better && change.verdict != Verdict::Worse)
            continue;
        lines += fmt::format("  {:<7} {}, {}: {} {:.5g} -> {:.5g}, {}{}\n",
                             kVerdicts[static_cast<size_t>(change.verdict)], change.now.scene, change.now.config,
                             change.now.name, change.before.estimate.value, change.now.estimate.value,
                             changeText(change), changes.fails(change) ? ": more than the threshold" : "");
    }
    std::string text =
        fmt::format("\nagainst {} (glint {}, {}): {} better, {} worse, {} only noise, {} the same\n",
                    printable(changes.file), printable(changes.glint), printable(changes.device),
                    counts[static_cast<size_t>(Verdict::Better)], counts[static_cast<size_t>(Verdict::Worse)],
                    counts[static_cast<size_t>(Verdict::Noise)], counts[static_cast<size_t>(Verdict::Same)]);
    text += lines;
    if (changes.figures.otherDevice > 0)
        text += fmt::format("  {} times are of another device or driver and are not compared\n",
                            changes.figures.otherDevice);
    if (!changes.figures.added.empty())
        text += fmt::format("  {} figures are new\n", changes.figures.added.size());
    if (!changes.figures.removed.empty())
        text += fmt::format("  {} figures are no longer measured\n", changes.figures.removed.size());
    return text;
}

ReportValues changesJson(const ReportChanges& changes) {
    ReportValues json;
    json["file"] = changes.file;
    json["glint"] = changes.glint;
    json["device"] = changes.device;
    json["threshold"] = changes.threshold;
    json["timeThreshold"] = changes.timeThreshold;
    json["otherDevice"] = changes.figures.otherDevice;
    json["changes"] = ReportValues::array();
    for (const measure::FigureChange& change : changes.figures.changes)
        json["changes"].push_back({{"scene", change.now.scene},
                                   {"config", change.now.config},
                                   {"name", change.now.name},
                                   {"kind", measure::figureKindNames()[static_cast<size_t>(change.now.kind)]},
                                   {"before", change.before.estimate.value},
                                   {"now", change.now.estimate.value},
                                   {"worse", bounded(change.worse)},
                                   {"low", bounded(change.low)},
                                   {"high", bounded(change.high)},
                                   {"verdict", kVerdicts[static_cast<size_t>(change.verdict)]},
                                   {"fails", changes.fails(change)}});
    json["added"] = named(changes.figures.added);
    json["removed"] = named(changes.figures.removed);
    return json;
}

} // namespace glint::cli
