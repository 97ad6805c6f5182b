#include "lab/measure/motion/frame_error_meter.hpp"

#include <algorithm>

namespace glint::measure {
namespace {

constexpr float kFireflyFactor = 8;
constexpr float kFireflyFloor = 0.01f;     ///< radiance; in black surroundings nothing dimmer counts
constexpr double kGradientAgreement = 0.1; ///< of pure noise, the two references' gradients agree on 0
constexpr int kFireflyRadius = 2;          ///< pixels: 5 x 5

enum Term : size_t {
    Values,
    Bias,
    Noise,
    Tested,
    Reference,
    GradientTest,
    GradientReference,
    GradientAll,
    Fireflies,
    Pixels,
    Count
};
using Sums = BandSums<Count>;

float luminance(const float* rgb) {
    return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]; // Rec.709
}

std::vector<float> referenceLuminance(const MotionFrame& frame) {
    std::vector<float> result(frame.pixels());
    for (size_t i = 0; i < result.size(); ++i) {
        const float mean[] = {frame.referenceMean(3 * i), frame.referenceMean(3 * i + 1),
                              frame.referenceMean(3 * i + 2)};
        result[i] = luminance(mean);
    }
    return result;
}

/// Mean over the square around a pixel, as far as it lies in the image.
float meanAround(const std::vector<float>& image, uint32_t width, uint32_t height, uint32_t x, uint32_t y) {
    float sum = 0, count = 0;
    const int w = static_cast<int>(width), h = static_cast<int>(height);
    for (int v = std::max(int(y) - kFireflyRadius, 0); v <= std::min(int(y) + kFireflyRadius, h - 1); ++v)
        for (int u = std::max(int(x) - kFireflyRadius, 0); u <= std::min(int(x) + kFireflyRadius, w - 1); ++u) {
            sum += image[size_t(v) * width + size_t(u)];
            ++count;
        }
    return sum / count;
}

/// Adds the products of the gradients from pixel `p` to its neighbour `q`.
void addGradient(const MotionFrame& frame, size_t p, size_t q, std::array<double, Count>& sums) {
    for (size_t c = 0; c < 3; ++c) {
        const size_t i = 3 * p + c, k = 3 * q + c;
        const auto change = [&](const Radiance& image) { return double((*image)[k]) - double((*image)[i]); };
        sums[GradientTest] += change(frame.test[0]) * change(frame.test[1]);
        const double a = change(frame.reference[0]), b = change(frame.reference[1]);
        sums[GradientReference] += a * b;
        sums[GradientAll] += (a * a + b * b) / 2;
    }
}

} // namespace

void FrameErrorMeter::add(const MotionFrame& frame) {
    const std::vector<uint8_t>& bands = *frame.bands;
    const std::vector<float> around = referenceLuminance(frame);
    Sums sums;
    for (uint32_t y = 0; y < frame.height; ++y) {
        for (uint32_t x = 0; x < frame.width; ++x) {
            const size_t p = size_t(y) * frame.width + x;
            if (bands[p] == kNoBand)
                continue;
            std::array<double, Count>& to = sums[bands[p]];
            for (size_t i = 3 * p; i < 3 * p + 3; ++i) {
                const RelativeError error = relativeError(frame, i);
                to[Bias] += error.bias;
                to[Noise] += error.noise;
                to[Tested] += frame.testMean(i);
                to[Reference] += frame.referenceMean(i);
            }
            to[Values] += 3;
            to[Pixels] += 1;
            if (x + 1 < frame.width && bands[p + 1] == bands[p])
                addGradient(frame, p, p + 1, to);
            if (y + 1 < frame.height && bands[p + frame.width] == bands[p])
                addGradient(frame, p, p + frame.width, to);
            const float limit =
                std::max(kFireflyFactor * meanAround(around, frame.width, frame.height, x, y), kFireflyFloor);
            for (const Radiance& test : frame.test)
                to[Fireflies] += luminance(test->data() + 3 * p) > limit ? 0.5 : 0;
        }
    }
    for (size_t band = 0; band <= kBands; ++band) {
        const std::array<double, Count> all = sums.of(band);
        Series& series = series_[band];
        series.pixels.add(all[Pixels]);
        if (all[Pixels] == 0)
            continue;
        series.bias.add(all[Bias] / all[Values]);
        series.noise.add(all[Noise] / all[Values]);
        series.relativeMse.add((all[Bias] + all[Noise]) / all[Values]);
        series.fireflies.add(1e6 * all[Fireflies] / all[Pixels]);
        if (all[Reference] > 0)
            series.energy.add(all[Tested] / all[Reference]);
        if (all[GradientReference] > kGradientAgreement * all[GradientAll])
            series.sharp.add(all[GradientTest] / all[GradientReference]);
    }
}

FrameErrorFigures FrameErrorMeter::figures(size_t band) const {
    const Series& series = series_[band];
    return {series.relativeMse.figure(), series.bias.figure(),      series.noise.figure(),      series.sharp.figure(),
            series.energy.figure(),      series.fireflies.figure(), series.pixels.figure().mean};
}

} // namespace glint::measure
