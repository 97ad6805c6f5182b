#include "lab/measure/motion/step_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::measure {
namespace {

constexpr float kChangeRelative = 0.1f, kChangeAbsolute = 0.01f; ///< radiance: what counts as a change
constexpr uint64_t kFewestPixels = 16;
constexpr double kStepAgreement = 0.25; ///< of pure noise, the two references agree on 0

std::vector<float> luminances(const std::vector<float>& rgb) {
    std::vector<float> result(rgb.size() / 3);
    for (size_t p = 0; p < result.size(); ++p)
        result[p] = 0.2126f * rgb[3 * p] + 0.7152f * rgb[3 * p + 1] + 0.0722f * rgb[3 * p + 2]; // Rec.709
    return result;
}

double firstBelow(const std::vector<double>& rest, double limit) {
    const auto found = std::ranges::find_if(rest, [&](double value) { return value <= limit; });
    return found == rest.end() ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(found - rest.begin());
}

} // namespace

void StepMeter::add(const MotionFrame& frame, uint32_t index) {
    if (std::ranges::find(steps_, index) != steps_.end() && !prevLuminance_[0].empty())
        begin(frame, index);
    if (!found_.empty())
        follow(frame);
    for (size_t k = 0; k < 2; ++k)
        prevLuminance_[k] = luminances(*frame.reference[k]);
}

void StepMeter::begin(const MotionFrame& frame, uint32_t index) {
    Step step;
    step.frame = index;
    const std::array<std::vector<float>, 2> now = {luminances(*frame.reference[0]), luminances(*frame.reference[1])};
    BandSums<2> sums; // change that the selecting reference sees, and that the measuring one confirms
    BandSums<1> pixels;
    for (size_t p = 0; p < frame.pixels(); ++p) {
        const uint8_t band = (*frame.bands)[p];
        if (band == kNoBand)
            continue;
        for (uint8_t select = 0; select < 2; ++select) {
            const auto measure = static_cast<uint8_t>(1 - select);
            const float before = prevLuminance_[select][p], change = now[select][p] - before;
            if (!(std::abs(change) > kChangeRelative * 0.5f * (before + now[select][p]) + kChangeAbsolute))
                continue;
            const float sign = change > 0 ? 1.0f : -1.0f;
            step.changed.push_back({static_cast<uint32_t>(p), band, measure, sign, prevLuminance_[measure][p]});
            sums[band][0] += std::abs(change);
            sums[band][1] += sign * (now[measure][p] - prevLuminance_[measure][p]);
            pixels[band][0] += 0.5;
        }
    }
    for (size_t band = 0; band <= kBands; ++band) {
        const std::array<double, 2> change = sums.of(band);
        step.pixels[band] = static_cast<uint64_t>(pixels.of(band)[0]);
        step.counts[band] = step.pixels[band] >= kFewestPixels && change[1] >= kStepAgreement * change[0];
    }
    found_.push_back(std::move(step));
}

void StepMeter::follow(const MotionFrame& frame) {
    Step& step = found_.back();
    const std::array<std::vector<float>, 2> test = {luminances(*frame.test[0]), luminances(*frame.test[1])};
    const std::array<std::vector<float>, 2> reference = {luminances(*frame.reference[0]),
                                                         luminances(*frame.reference[1])};
    BandSums<2> sums; // what is missing, and the whole change
    for (const Changed& changed : step.changed) {
        const float now = reference[changed.measure][changed.pixel];
        const float shown = 0.5f * (test[0][changed.pixel] + test[1][changed.pixel]);
        sums[changed.band][0] += changed.sign * (now - shown);
        sums[changed.band][1] += changed.sign * (now - changed.before);
    }
    for (size_t band = 0; band <= kBands; ++band)
        step.rest[band].push_back(sums.of(band)[0] / sums.of(band)[1]);
}

std::vector<StepResponse> StepMeter::figures(size_t band) const {
    std::vector<StepResponse> responses;
    for (const Step& step : found_) {
        if (!step.counts[band])
            continue;
        const std::vector<double>& rest = step.rest[band];
        responses.push_back({step.frame, firstBelow(rest, 0.1), firstBelow(rest, 0.01),
                             std::max(0.0, -*std::ranges::min_element(rest)), step.pixels[band]});
    }
    return responses;
}

} // namespace glint::measure
