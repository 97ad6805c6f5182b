// One test for each file in cases/: renders the case with validation on, and compares the image with its golden.
// GLINT_UPDATE_GOLDENS=1 writes the goldens instead; check each before committing it.
#include "lab/session/views.hpp"
#include "lab/tests/image/golden.hpp"
#include "lab/tests/image/image_case.hpp"
#include "lab/tests/image/job_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace glint::test {
namespace image_test {

const std::string kImageFolder = std::string(GLINT_SOURCE_DIR) + "/lab/tests/image/";
const GoldenPlaces kPlaces = {kImageFolder + "goldens", GLINT_IMAGE_FAILURES};

std::string environmentVariable(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::string assetsFolder() {
    const std::string given = environmentVariable("GLINT_ASSETS");
    return given.empty() ? std::string(GLINT_SOURCE_DIR) + "/../shared/assets" : given;
}

std::vector<std::string> caseNames() {
    std::vector<std::string> names;
    std::error_code ignored; // without the folder there are no cases
    for (const auto& entry : std::filesystem::directory_iterator(kImageFolder + "cases", ignored))
        if (entry.path().extension() == ".json")
            names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

/// The image as the program writes it to a PNG file.
Result<std::vector<uint8_t>> displayed(const render::RenderedView& view) {
    GLINT_TRY(info, render::findView(view.name));
    return info->kind == render::ViewKind::Radiance ? view.rgb8 : render::displayBytes(info->kind, view.rgba);
}

/// The test of one case.
class ImageTest : public JobTest {
public:
    explicit ImageTest(std::string name) : name_(std::move(name)) {}

    void TestBody() override {
        const std::string assets = assetsFolder();
        const auto imageCase = readImageCase(kImageFolder + "cases/" + name_ + ".json", assets);
        ASSERT_TRUE(imageCase.ok()) << imageCase.error().message;
        if (imageCase->needsAssets && !std::filesystem::is_directory(assets))
            GTEST_SKIP() << "needs the test assets, which are not at " << assets << ": GLINT_ASSETS names their folder";

        const auto job = cli::makeRenderJob(imageCase->options);
        ASSERT_TRUE(job.ok()) << job.error().message;
        if (job->settings.reflections.rays.backend == RayBackend::Query && !device().rayQuery())
            GTEST_SKIP() << "no ray queries on " << device().info().name;
        const auto result = render::runJob(device(), *job);
        ASSERT_TRUE(result.ok()) << result.error().message;

        ASSERT_EQ(result->views.size(), 1u);
        const auto rgb = displayed(result->views.front());
        ASSERT_TRUE(rgb.ok()) << rgb.error().message;
        const measure::DisplayPicture picture{result->width, result->height, *rgb};
        ASSERT_EQ(picture.rgb.size(), 3 * picture.pixels());
        judge(*imageCase, picture);
    }

private:
    static void judge(const ImageCase& imageCase, const measure::DisplayPicture& picture) {
        if (environmentVariable("GLINT_UPDATE_GOLDENS") == "1") {
            const auto written = writeGolden(imageCase, picture, kPlaces);
            ASSERT_TRUE(written.ok()) << written.error().message;
        }
        const Verdict verdict = compareWithGolden(imageCase, picture, kPlaces, device().info().software);
        if (verdict.meanFlip)
            RecordProperty("meanFlip", fmt::format("{:.6f}", *verdict.meanFlip));
        if (verdict.good)
            fmt::print("{}: {}\n", imageCase.name, verdict.message);
        else
            ADD_FAILURE() << imageCase.name << ": " << verdict.message;
    }

    std::string name_;
};

/// "Image.hall" for cases/hall.json. As value parameters of one test they would have names that CTest cannot filter.
const bool kRegistered = [] {
    for (const std::string& name : caseNames())
        testing::RegisterTest("Image", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                              [name] { return new ImageTest(name); });
    return true;
}();

} // namespace image_test
} // namespace glint::test
