// The measured images of a hierarchy: its own, those of its sources alone, and a reference.
#pragma once

#include "lab/measure/truth/pixel_camera.hpp"
#include "lab/tests/image/source_choices.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::test {

/// Rays are excluded: with one sample they are noise, and with many they are the reference.
constexpr size_t kMeasured = 4;
constexpr std::array<const char*, kMeasured> kMeasuredNames = {"screen", "planar", "probes", "sky"};

constexpr size_t kScreenHits = 0, kPlanarMirrors = 1, kProbeLookups = 2;

/// Bytes of 255. Steps on one surface are visible from about 1 % of its luminance on (Barten 1999), which is near one
/// byte anywhere on the sRGB curve; rounding adds up to one to either side of a difference.
constexpr double kNoticeable = 3;

using Rgb = std::array<double, 3>; ///< sRGB bytes

/// The image and each source's weight in it.
struct SourcePicture {
    std::vector<Rgb> rgb;
    std::vector<std::array<float, kMeasured>> shares;
};

struct SourcePictures {
    measure::PixelCamera camera;
    SourcePicture whole;          ///< in the order of the settings
    SourcePicture withoutMirrors; ///< the same with planar mirrors off
    /// Each source with no source before it. Planar mirrors are first in the whole, and their image is the whole's:
    /// mirrors show the other sources' answers for what they reflect.
    std::array<SourcePicture, kMeasured> alone;
    std::vector<Rgb> reference;
    std::vector<double> noise; ///< bytes: standard error of the reference, of all channels
    std::vector<float> depth, normal, roughness, reflectivity; ///< RGBA of the views
    std::vector<bool> reflective;                              ///< a source answered, and no glass covers the pixel

    size_t pixels() const { return reflective.size(); }
};

/// The hierarchy without planar mirrors, compared with the same reference.
inline SourcePictures withoutMirrors(SourcePictures pictures) {
    pictures.whole = pictures.withoutMirrors;
    pictures.alone[kPlanarMirrors] = pictures.whole; // which has none of their answers
    return pictures;
}

inline double meanDifference(const Rgb& a, const Rgb& b) {
    return (std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2])) / 3;
}

inline size_t winner(const std::array<float, kMeasured>& shares) {
    return static_cast<size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
}

inline std::vector<Rgb> toRgb(const std::vector<uint8_t>& bytes) {
    std::vector<Rgb> out(bytes.size() / 3);
    for (size_t i = 0; i < bytes.size(); ++i)
        out[i / 3][i % 3] = bytes[i];
    return out;
}

inline SourcePicture readSources(render::ReflectionSession& session) {
    SourcePicture out;
    out.rgb = toRgb(must(session.readView("composite")).rgb8);
    const std::vector<float> weights = must(session.readView("weights")).rgba; // screen, sky, rays, probes
    const std::vector<float> planar = must(session.readView("weightPlanar")).rgba;
    for (size_t i = 0; i < weights.size(); i += 4)
        out.shares.push_back({weights[i], planar[i], weights[i + 3], weights[i + 1]});
    return out;
}

/// The standard error of `all` samples, half of which made `half`: their difference, averaged over 3 x 3 pixels,
/// because one pixel's two halves may agree by chance.
inline std::vector<double> noiseOf(const std::vector<Rgb>& half, const std::vector<Rgb>& all, size_t width) {
    std::vector<double> out(all.size());
    const size_t height = all.size() / width;
    for (size_t i = 0; i < all.size(); ++i) {
        const size_t x = i % width, y = i / width;
        size_t count = 0;
        for (size_t v = y - std::min<size_t>(y, 1); v <= std::min(y + 1, height - 1); ++v)
            for (size_t u = x - std::min<size_t>(x, 1); u <= std::min(x + 1, width - 1); ++u, ++count)
                out[i] += meanDifference(half[v * width + u], all[v * width + u]);
        out[i] /= static_cast<double>(count);
    }
    return out;
}

/// The reference gets `samples` a pixel twice: the difference of the halves is its noise.
inline SourcePictures drawSources(gpu::Context& device, render::RenderJob job, uint32_t samples) {
    const TempFolder folder;
    bakeProbes(device, job, folder);
    render::ReflectionSession session = must(render::openJob(device, job));
    SourcePictures out{.camera = measure::PixelCamera(session.view())};

    must(session.setSettings(referenceOf(job.settings, samples)));
    must(session.renderFrame(0));
    const std::vector<Rgb> half = toRgb(must(session.readView("composite")).rgb8);
    must(session.renderFrame(1)); // adds as many samples
    out.reference = toRgb(must(session.readView("composite")).rgb8);
    out.noise = noiseOf(half, out.reference, job.width);

    render::ProgramSettings settings = job.settings;
    choose(settings, kScreen | kPlanar | kProbes | kSky);
    must(session.setSettings(settings));
    must(session.renderFrame(0));
    out.whole = readSources(session);
    out.depth = must(session.readView("depth")).rgba;
    out.normal = must(session.readView("normal")).rgba;
    out.roughness = must(session.readView("roughness")).rgba;
    out.reflectivity = must(session.readView("reflectivity")).rgba;
    const std::vector<float> glass = must(session.readView("refractionWeights")).rgba;
    for (size_t i = 0; i < half.size(); ++i) {
        const std::array<float, kMeasured>& shares = out.whole.shares[i];
        out.reflective.push_back(shares[winner(shares)] > 0 && glass[i * 4] + glass[i * 4 + 1] + glass[i * 4 + 2] == 0);
    }
    out.alone[kPlanarMirrors] = out.whole;
    const std::array<unsigned, kMeasured> sources = {kScreen, kPlanar, kProbes, kSky};
    const auto draw = [&](unsigned chosen) {
        choose(settings, chosen);
        must(session.setSettings(settings));
        must(session.renderFrame(0));
        return readSources(session);
    };
    out.withoutMirrors = draw(kScreen | kProbes | kSky);
    for (size_t source = 0; source < kMeasured; ++source)
        if (source != kPlanarMirrors)
            out.alone[source] = draw(sources[source]);
    return out;
}

} // namespace glint::test
