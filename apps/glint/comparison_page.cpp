// The page of `glint compare --report`: a table of figures, then each config's images side by side.
#include "base/file.hpp"
#include "comparison_output.hpp"
#include "config_option.hpp"
#include "scene/image_file.hpp"

#include <array>
#include <filesystem>

namespace glint::cli {
namespace {

constexpr std::string_view kStyle = R"(<style>
body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:1500px;padding:0 1rem;background:#14171c;color:#dde3ea}
h1{font-size:1.4rem}h2{font-size:1.1rem;margin:2rem 0 .5rem}p{color:#97a3b0}
table{border-collapse:collapse;width:100%}th,td{padding:.35rem .6rem;text-align:right;border-bottom:1px solid #2b323b}
th:first-child,td:first-child{text-align:left}
.pictures{display:grid;grid-template-columns:repeat(3,1fr);gap:.6rem}
figure{margin:0}img{width:100%;display:block;image-rendering:pixelated}figcaption{color:#97a3b0;font-size:.85rem}
i{display:inline-block;width:.8em;height:.8em;margin:0 .3em 0 .8em}
</style>)";

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text)
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += c;
        }
    return out;
}

std::string pictureName(size_t number, std::string_view config, std::string_view picture) {
    return fmt::format("{}.{}.png", configFileName(number, config), picture);
}

std::string row(const measure::ConfigFigures& config) {
    const measure::HitFigures& all = config.hits.all;
    const measure::HitFigures& mirror = config.hits.bands[static_cast<size_t>(measure::RoughnessBand::Mirror)];
    const std::string wrong = config.exact ? fmt::format("{:.2f} % ({:.2f} %)", 100 * config.exact->oneBounceShare(),
                                                         100 * config.exact->share())
                                           : std::string("-");
    return fmt::format("<tr><td>{}</td><td>{:.4f} ({:.4f})</td><td>{:.4f} ({:.4f})</td><td>{:.2f}, {:.2f}</td>"
                       "<td>{:.1f}, {}</td><td>{:.2f}</td><td>{:.1f}</td><td>{}</td></tr>\n",
                       escaped(config.name), all.precision(), mirror.precision(), all.recall(), mirror.recall(),
                       all.positionErrorMedian, all.positionError95, all.lookupsMean, all.lookups95,
                       config.times.total().median, config.times.floorMultiple(), wrong);
}

std::string page(const measure::Comparison& comparison) {
    std::string html = "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>glint compare</title>\n";
    html += kStyle;
    html += fmt::format("<h1>{}, {}x{}</h1>\n<p>{}; {}</p>\n", escaped(comparison.scene), comparison.width,
                        comparison.height, escaped(comparison.device), clockWords(comparison.software));
    html += "<table><tr><th>settings</th><th>precision (mirrors)</th><th>recall (mirrors)</th>"
            "<th>error px: median, 95 %</th><th>lookups: mean, 95 %</th><th>effect ms</th><th>floors</th>"
            "<th>wrong: one bounce (all)</th></tr>\n";
    for (const measure::ConfigFigures& config : comparison.configs)
        html += row(config);
    html += "</table>\n<p>Hits:<i style=\"background:#28aa3c\"></i>right<i style=\"background:#f59614\"></i>wrong place"
            "<i style=\"background:#dc1e28\"></i>false<i style=\"background:#325ae6\"></i>missed"
            "<i style=\"background:#464646\"></i>rightly none. Figures as JSON: <a href=\"figures.json\" "
            "style=\"color:#7ab7ff\">figures.json</a></p>\n";
    for (size_t i = 0; i < comparison.configs.size(); ++i) {
        const std::string& name = comparison.configs[i].name;
        html += fmt::format("<h2>{}</h2>\n<div class=\"pictures\">", escaped(name));
        for (const std::string_view picture : {"composite", "outcome", "hits"})
            html += fmt::format("<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>",
                                pictureName(i, name, picture), picture);
        html += "</div>\n";
    }
    return html + "</html>\n";
}

} // namespace

Result<void> writeReport(const std::string& folder, const measure::Comparison& comparison) {
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
            GLINT_CHECK(scene::writePng(folder + "/" + pictureName(i, config.name, name), comparison.width,
                                        comparison.height, 3, *rgb));
    }
    GLINT_CHECK(writeFile(folder + "/figures.json", comparisonJson(comparison)));
    return writeFile(folder + "/index.html", page(comparison));
}

} // namespace glint::cli
