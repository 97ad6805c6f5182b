#include "lab/cli/report/report_gallery.hpp"

#include "base/file.hpp"
#include "lab/cli/file_roles.hpp"
#include "lab/cli/report/gallery_run.hpp"
#include "lab/cli/report/report_page.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace glint::cli {
namespace {

constexpr size_t kLongestGalleryPlan = size_t(1) << 20;

std::string folderOf(const std::string& page) {
    const std::string folder = std::filesystem::path(page).parent_path().string();
    return folder.empty() ? "." : folder;
}

} // namespace

Result<GalleryPlan> openGallery(const std::string& file, const std::string& page) {
    GLINT_TRY(text, readFile(file, kLongestGalleryPlan));
    GLINT_TRY(plan, readGalleryPlan(text, file));
    std::vector<NamedFile> inputs = {{"--pictures", file}};
    std::vector<NamedFile> outputs = {{"-o", page}};
    for (const GalleryEntry& entry : plan.entries) {
        for (NamedFile& input : inputFiles(entry.options))
            inputs.push_back(std::move(input));
        outputs.push_back({"picture " + entry.name, fmt::format("{}/{}.png", folderOf(page), entry.name)});
    }
    GLINT_CHECK(checkOutputs(inputs, outputs));
    return plan;
}

Result<void> renderGalleryPage(const GalleryPlan& plan, const gpu::Context& context, const RenderOptions& common,
                               const std::string& size, const std::string& page, std::FILE* console, Report& report) {
    GLINT_TRY(work, planGallery(plan, context.info(), size, common));
    bool named = false;
    const auto show = [&](const Gallery& gallery) -> Result<void> {
        report.gallery = gallery;
        GLINT_CHECK(writeReportPage(page, report));
        const auto rendered = [](const GalleryPicture& picture) { return picture.rendered.has_value(); };
        if (std::ranges::any_of(gallery.pictures, rendered) && !std::exchange(named, true)) {
            fmt::print(console, "{}\n", page);
            std::fflush(console);
        }
        return {};
    };
    return renderGallery(work, folderOf(page), show);
}

} // namespace glint::cli
