// The content of a report: what `glint report` has measured, before any of it is formatted.
#pragma once

#include "lab/cli/report/gallery.hpp"
#include "lab/measure/figures/comparison_maps.hpp"
#include "lab/measure/figures/figure_change.hpp"
#include "lab/measure/motion/sequence.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// The frames of a sequence that are shown.
struct MotionFrames {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t stride = 1;                           ///< of so many frames, the first is shown
    std::vector<std::vector<std::string>> configs; ///< encoded as WebP
};

struct ReportScene {
    std::string title; ///< scene and size, and the camera where one was asked for
    measure::Comparison comparison;
    std::vector<measure::ComparisonMaps> maps; ///< of each config
    std::vector<std::string> commands;         ///< `glint render ...` of each config
    std::optional<measure::Sequence> motion;   ///< with the same configs
    std::string path;                          ///< of the camera in motion
    MotionFrames frames;
};

/// Changes since an earlier report.
struct ReportChanges {
    std::string file;
    std::string glint; ///< version that wrote it
    std::string device;
    double threshold = 0;     ///< FigureChange::exceeds, of every kind but times
    double timeThreshold = 0; ///< of times
    measure::FigureChanges figures;

    double thresholdOf(const measure::FigureChange& change) const {
        return change.now.kind == measure::FigureKind::Time ? timeThreshold : threshold;
    }
    bool fails(const measure::FigureChange& change) const { return change.exceeds(thresholdOf(change)); }
};

struct Report {
    std::string command;
    /// What the figures depend on besides scenes and configs: the option's name and its value as the user wrote it,
    /// {"--reference": "reference", "--env": ""}. null: unknown.
    nlohmann::ordered_json options;
    std::optional<Gallery> gallery;
    std::vector<ReportScene> scenes; ///< at least one, unless the gallery is not complete
    nlohmann::ordered_json curve;    ///< readCurve; null: none
    std::optional<ReportChanges> changes;
};

/// The scene's comparison with its maps; `commands` are its configs'.
ReportScene reportScene(measure::Comparison comparison, std::vector<std::string> commands, const std::string& camera);

} // namespace glint::cli
