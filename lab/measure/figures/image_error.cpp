#include "lab/measure/figures/image_error.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace glint::measure {
namespace {

/// Mean of `errorOf(reference, test)` over the colours of the counted pixels; 0 if there are none.
template <class ErrorOf>
double meanError(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask,
                 double brightest, const ErrorOf& errorOf) {
    GLINT_ASSERT(!reference.empty() && reference.size() % 4 == 0 && test.size() == reference.size(), "{} and {} floats",
                 reference.size(), test.size());
    GLINT_ASSERT(mask.empty() || mask.size() == reference.size() / 4, "{} bytes of mask for {} pixels", mask.size(),
                 reference.size() / 4);
    double sum = 0;
    uint64_t colors = 0;
    for (size_t i = 0; i < reference.size(); ++i) {
        const bool alpha = i % 4 == 3;
        if (alpha || (!mask.empty() && mask[i / 4] == 0))
            continue;
        // std::clamp keeps NaN, so that the mean becomes NaN.
        sum += errorOf(std::clamp<double>(reference[i], 0, brightest), std::clamp<double>(test[i], 0, brightest));
        ++colors;
    }
    return colors > 0 ? sum / static_cast<double>(colors) : 0;
}

double relativeError(double reference, double test) {
    constexpr double kEpsilon = 0.01;
    return (test - reference) * (test - reference) / (reference * reference + kEpsilon);
}

void checkSizes([[maybe_unused]] const DisplayPicture& reference, [[maybe_unused]] const DisplayPicture& test) {
    GLINT_ASSERT(reference.width == test.width && reference.height == test.height, "{} x {} and {} x {}",
                 reference.width, reference.height, test.width, test.height);
    GLINT_ASSERT(reference.pixels() > 0 && reference.rgb.size() == 3 * reference.pixels() &&
                     test.rgb.size() == reference.rgb.size(),
                 "{} and {} bytes for {} pixels", reference.rgb.size(), test.rgb.size(), reference.pixels());
}

/// Of a channel of a pixel, in bytes.
int largestDifference(const DisplayPicture& reference, const DisplayPicture& test, size_t pixel) {
    int largest = 0;
    for (size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        largest = std::max(largest, std::abs(int(reference.rgb[i]) - int(test.rgb[i])));
    return largest;
}

} // namespace

double relativeMse(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask) {
    return meanError(reference, test, mask, kBrightestRelative, relativeError);
}

std::vector<double> relativeErrors(std::span<const float> reference, std::span<const float> test, double brightest) {
    GLINT_ASSERT(!reference.empty() && reference.size() % 4 == 0 && test.size() == reference.size(), "{} and {} floats",
                 reference.size(), test.size());
    std::vector<double> errors(reference.size() / 4, 0.0);
    for (size_t i = 0; i < reference.size(); ++i)
        if (i % 4 != 3)
            errors[i / 4] += relativeError(std::clamp<double>(reference[i], 0, brightest),
                                           std::clamp<double>(test[i], 0, brightest)) /
                             3;
    return errors;
}

WorstPixels worstPixels(std::span<const double> errors) {
    GLINT_ASSERT(!errors.empty(), "no pixels");
    const auto count = std::max<size_t>(1, static_cast<size_t>(kWorstShare * static_cast<double>(errors.size())));
    WorstPixels worst;
    worst.pixels.resize(errors.size());
    std::iota(worst.pixels.begin(), worst.pixels.end(), 0u);
    const auto end = worst.pixels.begin() + static_cast<std::ptrdiff_t>(count);
    std::ranges::partial_sort(worst.pixels, end, std::ranges::greater(), [&](uint32_t i) { return errors[i]; });
    worst.pixels.resize(count);
    const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
    double ofWorst = 0;
    for (const uint32_t i : worst.pixels)
        ofWorst += errors[i];
    worst.mean = sum / static_cast<double>(errors.size());
    worst.share = sum > 0 ? ofWorst / sum : 0;
    return worst;
}

double psnr(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask) {
    constexpr double kPeak = 1;
    const double mse = meanError(reference, test, mask, kPeak, [](double r, double t) { return (t - r) * (t - r); });
    return mse == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(kPeak * kPeak / mse);
}

DisplayDifference displayDifference(const DisplayPicture& reference, const DisplayPicture& test, double tolerance) {
    checkSizes(reference, test);
    const auto allowed = static_cast<int>(std::floor(tolerance * 255 + 1e-6)); // 5 / 255.0 * 255 must allow 5
    DisplayDifference difference;
    for (size_t i = 0; i < reference.pixels(); ++i) {
        const int largest = largestDifference(reference, test, i);
        difference.maxAbsDiff = std::max(difference.maxAbsDiff, largest / 255.0);
        difference.failingPixels += largest > allowed;
    }
    difference.failingFraction = double(difference.failingPixels) / double(reference.pixels());
    return difference;
}

std::vector<float> displayDifferenceMap(const DisplayPicture& reference, const DisplayPicture& test) {
    checkSizes(reference, test);
    std::vector<float> map;
    map.reserve(reference.pixels());
    for (size_t i = 0; i < reference.pixels(); ++i)
        map.push_back(static_cast<float>(largestDifference(reference, test, i)) / 255);
    return map;
}

} // namespace glint::measure
