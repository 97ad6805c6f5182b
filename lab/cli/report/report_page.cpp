#include "lab/cli/report/report_page.hpp"

#include "base/file.hpp"
#include "lab/cli/report/page_template.hpp"
#include "lab/cli/report/report_json.hpp"
#include "lab/cli/report/report_pictures.hpp"

#include <algorithm>

namespace glint::cli {
namespace {

std::string titleOf(const Report& report) {
    if (report.gallery)
        return "Glint: scenes without and with reflections";
    std::string title = "Glint report:";
    for (const ReportScene& scene : report.scenes)
        title += (&scene == &report.scenes.front() ? " " : ", ") + scene.title;
    return title;
}

} // namespace

Result<std::string> reportPage(const Report& report) {
    nlohmann::ordered_json json = reportJson(report);
    size_t fixed = 100000; // of JSON around the images
    for (const PagePart& part : pageParts())
        fixed += part.text.size();
    fixed += scriptJson(json).size();
    if (fixed >= kMostPageBytes)
        return invalidArgument("the figures do not fit into a page: name fewer scenes and configs");
    GLINT_TRY(pictures, encodePictures(report.scenes, kMostPageBytes - fixed));
    json["pictureLoss"] = pictures.loss;
    json["images"] = std::move(pictures.images);
    return filledPage(pageParts(), titleOf(report), scriptJson(json));
}

Result<void> writeReportPage(const std::string& file, const Report& report) {
    GLINT_TRY(page, reportPage(report));
    return writeFile(file, page);
}

} // namespace glint::cli
