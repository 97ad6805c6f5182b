#include "lab/cli/report/report_json.hpp"

#include "glint/version.hpp"
#include "lab/cli/compare/comparison_output.hpp"
#include "lab/cli/machine_info.hpp"
#include "lab/cli/report/report_figures.hpp"
#include "lab/cli/report/report_legends.hpp"
#include "lab/cli/report/report_pictures.hpp"
#include "lab/cli/sequence/sequence_output.hpp"

namespace glint::cli {
namespace {

using PageJson = nlohmann::ordered_json;

PageJson stripsJson(const ReportScene& scene, size_t index) {
    PageJson strips = PageJson::array();
    const size_t frames = scene.frames.configs.empty() ? 0 : scene.frames.configs.front().size();
    for (size_t frame = 0; frame < frames; ++frame) {
        PageJson pictures = PageJson::array();
        for (size_t config = 0; config < scene.frames.configs.size(); ++config)
            pictures.push_back(framePictureName(index, config, frame));
        strips.push_back({{"frame", frame * scene.frames.stride}, {"pictures", std::move(pictures)}});
    }
    return strips;
}

PageJson sceneJson(const ReportScene& scene, size_t index) {
    PageJson json = PageJson::parse(comparisonJson(scene.comparison));
    json["title"] = scene.title;
    json["pictures"]["without reflections"] = scenePictureName(index, "without");
    if (!scene.comparison.referencePicture.empty())
        json["pictures"]["reference"] = scenePictureName(index, "reference");
    for (size_t i = 0; i < scene.comparison.configs.size(); ++i) {
        PageJson& config = json["configs"][i];
        config["command"] = scene.commands[i];
        config["seeds"] = scene.comparison.configs[i].seeds.size() + 1;
        if (!scene.comparison.referencePicture.empty())
            config["flip"] = scene.maps[i].flipMean;
        for (const std::string_view picture : configPictures())
            config["pictures"][std::string(picture)] = configPictureName(index, i, picture);
    }
    if (scene.motion) {
        json["motion"] = PageJson::parse(sequenceJson(*scene.motion));
        json["motion"]["path"] = scene.path;
        json["motion"]["strips"] = stripsJson(scene, index);
    }
    return json;
}

PageJson deviceJson(const auto& of) {
    return {{"name", of.device}, {"driver", of.driver}, {"software", of.software}};
}

} // namespace

std::string scenePictureName(size_t scene, std::string_view picture) {
    return fmt::format("{}.{}", scene, picture);
}

std::string configPictureName(size_t scene, size_t config, std::string_view picture) {
    return fmt::format("{}.{}.{}", scene, config, picture);
}

std::string framePictureName(size_t scene, size_t config, size_t frame) {
    return fmt::format("{}.{}.frame.{}", scene, config, frame);
}

PageJson reportJson(const Report& report) {
    PageJson json;
    json["format"] = kReportFormat;
    json["glint"] = fmt::format("{}.{}.{}", GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH);
    json["command"] = report.command;
    if (!report.options.is_null())
        json["options"] = report.options;
    json["machine"] = machineJson();
    json["device"] = report.scenes.empty() ? deviceJson(*report.gallery) : deviceJson(report.scenes.front().comparison);
    json["clock"] = clockWords(json["device"]["software"]);
    json["legends"] = legendsJson();
    if (report.gallery)
        json["gallery"] = galleryJson(*report.gallery);
    json["scenes"] = PageJson::array();
    for (size_t i = 0; i < report.scenes.size(); ++i)
        json["scenes"].push_back(sceneJson(report.scenes[i], i));
    if (!report.curve.is_null())
        json["curve"] = report.curve;
    json["figures"] = figuresJson(reportFigures(report.scenes));
    if (report.changes)
        json["changes"] = changesJson(*report.changes);
    return json;
}

std::string reportText(const Report& report) {
    return reportJson(report).dump(2, ' ', false, PageJson::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
