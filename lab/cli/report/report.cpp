#include "lab/cli/report/report.hpp"

namespace glint::cli {

ReportScene reportScene(measure::Comparison comparison, std::vector<std::string> commands, const std::string& camera) {
    ReportScene scene;
    scene.title = fmt::format("{} {}x{}{}", comparison.scene, comparison.width, comparison.height,
                              camera.empty() ? std::string() : " camera " + camera);
    for (size_t i = 0; i < comparison.configs.size(); ++i)
        scene.maps.push_back(measure::comparisonMaps(comparison, i));
    scene.comparison = std::move(comparison);
    scene.commands = std::move(commands);
    return scene;
}

} // namespace glint::cli
