// LDR-FLIP in the order of the paper: the eye's resolution, the distance of colours, edges and points that appear or
// disappear, and their combination. Every filter is a sum of separable ones, so rows are filtered before columns.
#include "lab/measure/figures/flip.hpp"

#include "base/assert.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glint::measure {
namespace {

constexpr double kPi = std::numbers::pi;

// ---------------------------------------------------------------- colour spaces

constexpr double kWhiteX = 0.31271, kWhiteY = 0.32902; ///< chromaticity of CIE D65, 2 degrees

/// CIE XYZ of a chromaticity at luminance 1.
glm::dvec3 xyzOf(double x, double y) {
    return {x / y, 1, (1 - x - y) / y};
}

/// Linear RGB to XYZ. The primaries of ITU-R BT.709, scaled so that (1, 1, 1) is the white.
const glm::dmat3& rgbToXyz() {
    static const glm::dmat3 matrix = [] {
        const glm::dmat3 primaries(xyzOf(0.64, 0.33), xyzOf(0.30, 0.60), xyzOf(0.15, 0.06));
        const glm::dvec3 scale = glm::inverse(primaries) * xyzOf(kWhiteX, kWhiteY);
        return glm::dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
    }();
    return matrix;
}

/// Linear RGB to XYZ relative to the white, where every grey has three equal values; and back.
struct WhiteRelative {
    glm::dmat3 fromRgb;
    glm::dmat3 toRgb;
};
const WhiteRelative& whiteRelative() {
    static const WhiteRelative matrices = [] {
        const glm::dvec3 white = xyzOf(kWhiteX, kWhiteY);
        glm::dmat3 matrix = rgbToXyz();
        for (int column = 0; column < 3; ++column)
            matrix[column] /= white;
        return WhiteRelative{matrix, glm::inverse(matrix)};
    }();
    return matrices;
}

// IEC 61966-2-1
double linearOf(uint8_t srgb) {
    const double x = srgb / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

// YyCxCz (Flohr et al. 1993): linear in the light, one axis of lightness and two of opponent colours (red-green,
// blue-yellow).
glm::dvec3 opponentOf(const glm::dvec3& linearRgb) {
    const glm::dvec3 relative = whiteRelative().fromRgb * linearRgb;
    return {116 * relative.y - 16, 500 * (relative.x - relative.y), 200 * (relative.y - relative.z)};
}
glm::dvec3 linearOf(const glm::dvec3& opponent) {
    const double y = (opponent.x + 16) / 116;
    return whiteRelative().toRgb * glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200);
}

// CIE 15:2004, L*a*b*
double labCurve(double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

/// L*a*b* with chroma scaled by lightness (Hunt effect): dark colours appear less colourful.
// Andersson et al. 2020, section 4.1
glm::dvec3 huntLab(const glm::dvec3& linearRgb) {
    const glm::dvec3 relative = whiteRelative().fromRgb * linearRgb;
    const glm::dvec3 f(labCurve(relative.x), labCurve(relative.y), labCurve(relative.z));
    const double lightness = 116 * f.y - 16;
    const double hunt = 0.01 * lightness;
    return {lightness, hunt * 500 * (f.x - f.y), hunt * 200 * (f.y - f.z)};
}

// ---------------------------------------------------------------- filters

/// One weight vector per tap, so that several filters of one radius run at once.
template <class Weight>
struct Taps {
    int radius = 0;
    std::vector<Weight> weights; ///< 2 * radius + 1
};

/// Combines neighbours along one axis; border pixels are repeated beyond the border.
template <class Out, class In, class Weight, class Combine>
std::vector<Out> filterAlong(bool rows, int width, int height, const std::vector<In>& in, const Taps<Weight>& taps,
                             const Combine& combine) {
    std::vector<Out> out;
    out.reserve(in.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Out sum(0);
            for (int tap = -taps.radius; tap <= taps.radius; ++tap) {
                const int sx = rows ? std::clamp(x + tap, 0, width - 1) : x;
                const int sy = rows ? y : std::clamp(y + tap, 0, height - 1);
                sum += combine(in[size_t(sy) * size_t(width) + size_t(sx)],
                               taps.weights[static_cast<size_t>(tap) + static_cast<size_t>(taps.radius)]);
            }
            out.push_back(sum);
        }
    return out;
}

/// Contrast sensitivity: the eye as low-pass filters, one for lightness and wider ones for the opponent colours.
struct EyeFilter {
    Taps<glm::dvec4> taps;      ///< lightness, red-green, and the two Gaussians of blue-yellow; each sums to 1
    double blueYellowFirst = 1; ///< weight of the first of the two
};

// Andersson et al. 2020, section 4.1 and its table of constants (after Johnson and Fairchild 2003): the Fourier
// transform of the sensitivity, a sum of a * sqrt(pi / b) * exp(-pi^2 d^2 / b) at d degrees from the pixel.
EyeFilter eyeFilter(double pixelsPerDegree) {
    constexpr std::array<double, 4> kB = {0.0047, 0.0053, 0.04, 0.025};
    constexpr double kFirstA = 34.1, kSecondA = 13.5;
    const double widest = *std::max_element(kB.begin(), kB.end());
    EyeFilter filter;
    // Three standard deviations of the widest Gaussian; exp(-pi^2 d^2 / b) has the variance b / (2 pi^2).
    filter.taps.radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * kPi * kPi)) * pixelsPerDegree));
    glm::dvec4 sums(0);
    for (int tap = -filter.taps.radius; tap <= filter.taps.radius; ++tap) {
        const double degrees = tap / pixelsPerDegree;
        glm::dvec4 weight;
        for (int i = 0; i < 4; ++i)
            weight[i] = std::exp(-kPi * kPi * degrees * degrees / kB[static_cast<size_t>(i)]);
        filter.taps.weights.push_back(weight);
        sums += weight;
    }
    for (glm::dvec4& weight : filter.taps.weights)
        weight /= sums;
    // The 2D filter is normalised as a whole; the sum of a 2D Gaussian is the square of its 1D sum.
    const double first = kFirstA * std::sqrt(kPi / kB[2]) * sums[2] * sums[2];
    const double second = kSecondA * std::sqrt(kPi / kB[3]) * sums[3] * sums[3];
    filter.blueYellowFirst = first / (first + second);
    return filter;
}

/// Edge and point detectors: a Gaussian with its first and second derivative.
// Andersson et al. 2020, section 4.2. The positive weights of a derivative sum to 1, the negative ones to -1.
Taps<glm::dvec3> featureTaps(double pixelsPerDegree) {
    constexpr double kFeatureWidth = 0.082; // degrees from peak to trough in human vision (DeValois and DeValois)
    const double sigma = 0.5 * kFeatureWidth * pixelsPerDegree;
    Taps<glm::dvec3> taps;
    taps.radius = static_cast<int>(std::ceil(3 * sigma));
    glm::dvec3 positive(0), negative(0);
    for (int x = -taps.radius; x <= taps.radius; ++x) {
        const double gauss = std::exp(-x * x / (2 * sigma * sigma));
        taps.weights.emplace_back(gauss, -x * gauss, (x * x / (sigma * sigma) - 1) * gauss);
        positive += glm::max(taps.weights.back(), glm::dvec3(0));
        negative -= glm::min(taps.weights.back(), glm::dvec3(0));
    }
    for (glm::dvec3& weight : taps.weights)
        weight /= glm::mix(positive, negative, glm::lessThan(weight, glm::dvec3(0)));
    return taps;
}

// ---------------------------------------------------------------- a picture as it is seen

struct Seen {
    std::vector<glm::dvec3> lab; ///< filtered by the eye, Hunt-adjusted
    std::vector<double> edge;    ///< length of the gradient of lightness
    std::vector<double> point;
};

Seen look(const DisplayPicture& picture, const EyeFilter& eye, const Taps<glm::dvec3>& features) {
    const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    std::array<double, 256> linear = {};
    for (size_t i = 0; i < linear.size(); ++i)
        linear[i] = linearOf(static_cast<uint8_t>(i));

    std::vector<glm::dvec4> opponent;
    std::vector<double> lightness;
    for (size_t i = 0; i < picture.pixels(); ++i) {
        const uint8_t* const rgb = &picture.rgb[3 * i];
        const glm::dvec3 color = opponentOf({linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]});
        opponent.emplace_back(color, color.z);
        lightness.push_back((color.x + 16) / 116);
    }

    Seen seen;
    const auto weigh = [](const glm::dvec4& value, const glm::dvec4& weight) { return value * weight; };
    opponent = filterAlong<glm::dvec4>(true, width, height, opponent, eye.taps, weigh);
    opponent = filterAlong<glm::dvec4>(false, width, height, opponent, eye.taps, weigh);
    for (const glm::dvec4& filtered : opponent) {
        const glm::dvec3 color(filtered.x, filtered.y, glm::mix(filtered.w, filtered.z, eye.blueYellowFirst));
        seen.lab.push_back(huntLab(glm::clamp(linearOf(color), 0.0, 1.0)));
    }

    const auto spread = [](double value, const glm::dvec3& weight) { return value * weight; };
    const auto rows = filterAlong<glm::dvec3>(true, width, height, lightness, features, spread);
    const auto cross = [](const glm::dvec3& row, const glm::dvec3& weight) {
        return glm::dvec4(row.y * weight.x, row.x * weight.y, row.z * weight.x, row.x * weight.z);
    };
    for (const glm::dvec4& d : filterAlong<glm::dvec4>(false, width, height, rows, features, cross)) {
        seen.edge.push_back(std::sqrt(d.x * d.x + d.y * d.y));
        seen.point.push_back(std::sqrt(d.z * d.z + d.w * d.w));
    }
    return seen;
}

// ---------------------------------------------------------------- differences

// Abasi et al. 2020, "Distance metrics for very large color differences", HyAB: lightness and chroma add up, which
// holds for large differences too.
double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// [0, 1].
// Andersson et al. 2020, section 4.1: the error to the power 0.7. Errors below 0.4 of sRGB's largest error (pure green
// against pure blue) map to [0, 0.95], larger errors to the rest.
double colorDifference(const glm::dvec3& a, const glm::dvec3& b) {
    constexpr double kExponent = 0.7, kBendFrom = 0.4, kBendTo = 0.95;
    static const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), kExponent);
    const double bend = kBendFrom * largest;
    const double error = std::pow(hyab(a, b), kExponent);
    const double mapped =
        error < bend ? kBendTo / bend * error : kBendTo + (error - bend) / (largest - bend) * (1 - kBendTo);
    return std::min(mapped, 1.0);
}

/// [0, 1].
// Andersson et al. 2020, section 4.2; sqrt 2 is the longest possible gradient.
double featureDifference(double edgeA, double edgeB, double pointA, double pointB) {
    const double larger = std::max(std::abs(edgeA - edgeB), std::abs(pointA - pointB));
    return std::min(std::sqrt(larger / std::numbers::sqrt2), 1.0);
}

} // namespace

FlipMap flip(const DisplayPicture& reference, const DisplayPicture& test, double pixelsPerDegree) {
    GLINT_ASSERT(reference.width == test.width && reference.height == test.height, "{} x {} and {} x {}",
                 reference.width, reference.height, test.width, test.height);
    GLINT_ASSERT(reference.pixels() > 0 && reference.rgb.size() == 3 * reference.pixels() &&
                     test.rgb.size() == reference.rgb.size(),
                 "{} and {} bytes for {} pixels", reference.rgb.size(), test.rgb.size(), reference.pixels());
    GLINT_ASSERT(pixelsPerDegree > 0, "{}", pixelsPerDegree);
    const EyeFilter eye = eyeFilter(pixelsPerDegree);
    const Taps<glm::dvec3> features = featureTaps(pixelsPerDegree);
    const Seen a = look(reference, eye, features);
    const Seen b = look(test, eye, features);

    FlipMap map;
    map.width = reference.width;
    map.height = reference.height;
    double sum = 0;
    for (size_t i = 0; i < reference.pixels(); ++i) {
        // Andersson et al. 2020, section 4.3: features increase colour errors and never cause one alone.
        const double feature = featureDifference(a.edge[i], b.edge[i], a.point[i], b.point[i]);
        const double error = std::pow(colorDifference(a.lab[i], b.lab[i]), 1 - feature);
        map.error.push_back(static_cast<float>(error));
        sum += error;
    }
    map.mean = sum / static_cast<double>(reference.pixels());
    return map;
}

std::vector<uint8_t> errorColors(std::span<const float> error) {
    // Magma (van der Walt and Smith 2015, CC0) at every eighth, linear in between; lightness increases evenly.
    static constexpr std::array<std::array<float, 3>, 9> kMagma = {{{0, 0, 4},
                                                                    {29, 17, 71},
                                                                    {81, 18, 124},
                                                                    {130, 38, 129},
                                                                    {182, 54, 121},
                                                                    {230, 81, 100},
                                                                    {251, 136, 97},
                                                                    {254, 194, 135},
                                                                    {252, 253, 191}}};
    std::vector<uint8_t> rgb;
    rgb.reserve(3 * error.size());
    for (const float value : error) {
        const float at = (value > 0 ? std::min(value, 1.0f) : 0) * (kMagma.size() - 1);
        const size_t below = std::min(static_cast<size_t>(at), kMagma.size() - 2);
        for (size_t c = 0; c < 3; ++c) {
            const float color = glm::mix(kMagma[below][c], kMagma[below + 1][c], at - static_cast<float>(below));
            rgb.push_back(static_cast<uint8_t>(std::lround(color)));
        }
    }
    return rgb;
}

} // namespace glint::measure
