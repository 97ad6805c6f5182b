// The files of `glint compare --report DIR` besides its page: images and figures for other programs.
#include "base/file.hpp"
#include "lab/cli/compare/comparison_output.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/scene/images/image_file.hpp"

#include <array>
#include <filesystem>

namespace glint::cli {

Result<void> writeComparisonFolder(const std::string& folder, const measure::Comparison& comparison) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return makeError(ErrorCode::Io, "--report {}: {}", folder, error.message());
    for (size_t i = 0; i < comparison.configs.size(); ++i) {
        const measure::ConfigFigures& config = comparison.configs[i];
        const std::vector<uint8_t> classes = measure::classColors(config.hits.classes);
        const std::array<std::pair<std::string_view, const std::vector<uint8_t>*>, 3> pictures = {
            {{"composite", &config.composite}, {"outcome", &config.outcome}, {"hits", &classes}}};
        for (const auto& [name, rgb] : pictures)
            GLINT_CHECK(scene::writePng(fmt::format("{}/{}.{}.png", folder, configFileName(i, config.name), name),
                                        comparison.width, comparison.height, 3, *rgb));
    }
    return writeFile(folder + "/figures.json", comparisonJson(comparison));
}

} // namespace glint::cli
