#include "lab/tests/image/golden.hpp"

#include "base/file.hpp"
#include "lab/measure/figures/flip.hpp"
#include "lab/scene/images/image_decode.hpp"
#include "lab/scene/images/image_file.hpp"

#include <filesystem>

namespace glint::test {
namespace {

constexpr size_t kLongestGolden = size_t(1) << 28; ///< bytes

struct Golden {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgb;

    operator measure::DisplayPicture() const { return {width, height, rgb}; }
};

std::string goldenPath(const ImageCase& imageCase, const GoldenPlaces& places) {
    return places.goldens + "/" + imageCase.name + ".png";
}

Result<Golden> readGolden(const std::string& path) {
    GLINT_TRY(bytes, readFile(path, kLongestGolden));
    const std::vector<uint8_t> file(bytes.begin(), bytes.end());
    GLINT_TRY(image, scene::decodeImage(file, path));
    Golden golden{image.width, image.height, {}};
    for (size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 != 3)
            golden.rgb.push_back(image.rgba[i]);
    return golden;
}

Result<void> write(const std::string& path, const measure::DisplayPicture& picture) {
    return scene::writePng(path, picture.width, picture.height, 3, picture.rgb);
}

/// NAME.actual.png and its companions, as far as they exist.
class FailurePictures {
public:
    FailurePictures(const ImageCase& imageCase, const GoldenPlaces& places)
        : stem_(places.failures + "/" + imageCase.name), folder_(places.failures) {
        for (const char* const kind : {"actual", "golden", "flip"})
            std::filesystem::remove(path(kind), ignored_);
    }

    void add(const char* kind, const measure::DisplayPicture& picture) {
        std::filesystem::create_directories(folder_, ignored_);
        const auto written = write(path(kind), picture);
        list_ += "\n  " + (written ? path(kind) : written.error().message);
    }
    const std::string& list() const { return list_; }

private:
    std::string path(const char* kind) const { return fmt::format("{}.{}.png", stem_, kind); }

    std::string stem_;
    std::string folder_;
    std::string list_;
    std::error_code ignored_;
};

std::string howToMake(const ImageCase& imageCase) {
    return fmt::format("\nLook at the picture. If it is right, this makes it the golden:\n"
                       "  GLINT_UPDATE_GOLDENS=1 scripts/test -R '^Image.{}$'\nBy hand:\n  {}",
                       imageCase.name, commandOf(imageCase));
}

} // namespace

Verdict compareWithGolden(const ImageCase& imageCase, const measure::DisplayPicture& actual, const GoldenPlaces& places,
                          bool software) {
    FailurePictures pictures(imageCase, places);
    const auto golden = readGolden(goldenPath(imageCase, places));
    if (!golden) {
        pictures.add("actual", actual);
        const bool missing = golden.error().code == ErrorCode::NotFound;
        return {
            false,
            (missing ? fmt::format("there is no golden {}", goldenPath(imageCase, places)) : golden.error().message) +
                pictures.list() + howToMake(imageCase),
            {}};
    }
    if (golden->width != actual.width || golden->height != actual.height) {
        pictures.add("actual", actual);
        pictures.add("golden", *golden);
        return {false,
                fmt::format("the golden is {} x {}, the picture {} x {}", golden->width, golden->height, actual.width,
                            actual.height) +
                    pictures.list() + howToMake(imageCase),
                {}};
    }

    const Tolerance& tolerance = imageCase.tolerance;
    const auto difference = measure::displayDifference(*golden, actual, tolerance.maxAbsDiff);
    const measure::FlipMap flip = measure::flip(*golden, actual);
    Verdict verdict;
    verdict.meanFlip = flip.mean;
    verdict.good = software ? difference.failingFraction <= tolerance.failingFraction : flip.mean <= tolerance.meanFlip;
    const std::string limit =
        software
            ? fmt::format("at most {} with more than {} are allowed", tolerance.failingFraction, tolerance.maxAbsDiff)
            : fmt::format("another driver's golden, so mean FLIP {} is allowed", tolerance.meanFlip);
    verdict.message = fmt::format("mean FLIP {:.5f}, max difference {:.4f}, failing fraction {:.5f}; {}", flip.mean,
                                  difference.maxAbsDiff, difference.failingFraction, limit);
    if (!verdict.good) {
        pictures.add("actual", actual);
        pictures.add("golden", *golden);
        const std::vector<uint8_t> colors = measure::errorColors(flip.error);
        pictures.add("flip", {flip.width, flip.height, colors});
        verdict.message += pictures.list() + howToMake(imageCase);
    }
    return verdict;
}

Result<void> writeGolden(const ImageCase& imageCase, const measure::DisplayPicture& actual,
                         const GoldenPlaces& places) {
    std::error_code ignored; // the write reports what is wrong with the folder
    std::filesystem::create_directories(places.goldens, ignored);
    return write(goldenPath(imageCase, places), actual);
}

} // namespace glint::test
