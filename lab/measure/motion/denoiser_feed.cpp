#include "lab/measure/motion/denoiser_feed.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace glint::measure {
namespace {

constexpr std::array kFeedLayers = {
    FeedLayer{
        "noisy", "RGBA", true, "radiance, linear",
        "what the pixel's one ray found: RGB is weight * radiance without the material's reflectance, A the weight "
        "of screen and rays together, [0, 1]; 0 where no ray was sent"},
    FeedLayer{"rest", "RGB", true, "radiance, linear",
              "what the sources that are not denoised add in our own frame (environment, probes, planar mirrors): a "
              "reflection is the denoised weight * radiance plus this"},
    FeedLayer{"raySent", "Y", true, "",
              "1: a ray was sent from here; 0.25: none, but the surface reflects and waits for its neighbours' rays "
              "(reuse.rate); 0: nothing to denoise"},
    FeedLayer{"hitDistance", "Z", false, "metres",
              "length of the pixel's ray to what it hit, the harmonic mean where screen and rays both answered; 0: it "
              "hit nothing, or none was sent"},
    FeedLayer{"depth", "Z", false, "metres", "distance along the view axis, positive (viewZ); 0: no surface"},
    FeedLayer{"normal", "XYZ", false, "", "shading normal, world space, unit length; 0: no surface"},
    FeedLayer{"roughness", "Y", false, "", "perceptual roughness, [0, 1]; GGX's alpha is its square"},
    FeedLayer{"reflectivity", "RGB", true, "", "F0, reflectance at normal incidence; 0: the surface reflects nothing"},
    FeedLayer{
        "motion", "XYZ", true, "UV, metres",
        "X, Y: previous UV - current UV of the surface, without jitter; UV is (0, 0) at the top left and (1, 1) at "
        "the bottom right. Z: previous - current depth of the surface"},
};

constexpr float kShareStep = 1 / 1023.0f; ///< the view "weights" has ten bits for each source

enum FeedView : size_t {
    Noisy,
    SentRay,
    RaySent,
    Depth,
    Normal,
    Roughness,
    Reflectivity,
    Motion,
    Reflection,
    Answer,
    Weights,
    WeightPlanar,
    FeedViewCount
};
constexpr std::array<std::string_view, FeedViewCount> kFeedViews = {
    "denoise/gather:noisy",
    "denoise/gather:sentRay",
    "raySent",
    "depth",
    "normal",
    "roughness",
    "reflectivity",
    "motion",
    "reflection",
    "denoise/filter:answer",
    "weights",
    "weightPlanar",
};

/// What kFeedViews has in the place of Answer if the settings stabilize it.
constexpr std::string_view kStabilized = "denoise/stabilize:answer";

using FeedViews = std::array<const std::vector<float>*, FeedViewCount>;

FeedViews sortedViews(std::span<const render::RenderedView> views) {
    FeedViews sorted = {};
    for (size_t i = 0; i < FeedViewCount; ++i) {
        const auto found = std::ranges::find_if(views, [&](const render::RenderedView& view) {
            return view.name == kFeedViews[i] || (i == Answer && view.name == kStabilized);
        });
        GLINT_ASSERT(found != views.end(), "the feed lacks view {}", kFeedViews[i]);
        sorted[i] = &found->rgba;
    }
    return sorted;
}

/// What remains of the reflection without the denoised answer, whose place in the order of sources may be any:
/// `weights` tells its share, and its own weight tells that exactly where no earlier source took a part.
void addRest(const FeedViews& views, size_t i, std::vector<float>& rest) {
    const float* const weights = views[Weights]->data() + i; // screen, sky, rays, probes
    const float* const answer = views[Answer]->data() + i;
    if (weights[1] + weights[3] + (*views[WeightPlanar])[i] < kShareStep / 2)
        return; // the difference would be rounding alone
    const float stored = weights[0] + weights[2];
    const float share = std::abs(stored - answer[3]) < kShareStep ? answer[3] : stored;
    for (size_t c = 0; c < 3; ++c)
        rest[i + c] = std::max((*views[Reflection])[i + c] - share * answer[c], 0.0f);
}

} // namespace

std::span<const FeedLayer> feedLayers() {
    return kFeedLayers;
}

std::vector<std::string> feedViews(const Settings& settings) {
    std::vector<std::string> names(kFeedViews.begin(), kFeedViews.end());
    if (settings.denoise.stabilizeSeconds > 0)
        names[Answer] = kStabilized;
    return names;
}

float sentDistance(float bits) {
    constexpr float kEnd = 4294967296.0f;
    if (!(bits >= 0 && bits < kEnd))
        return 0;
    const auto nearness = std::bit_cast<float>(static_cast<uint32_t>(bits));
    return nearness > 0 && std::isfinite(nearness) ? 1 / nearness : 0;
}

std::vector<std::vector<float>> feedPixels(std::span<const render::RenderedView> given) {
    const FeedViews views = sortedViews(given);
    const size_t floats = views[Noisy]->size();
    std::vector<float> noisy(floats), rest(floats), distance(floats);
    for (size_t i = 0; i < floats; i += 4) {
        addRest(views, i, rest);
        if ((*views[RaySent])[i] != 1) // the image holds there what an earlier frame left
            continue;
        std::copy_n(views[Noisy]->data() + i, 4, noisy.data() + i);
        distance[i] = sentDistance((*views[SentRay])[i + 1]);
    }
    return {std::move(noisy), std::move(rest),   *views[RaySent],      std::move(distance), *views[Depth],
            *views[Normal],   *views[Roughness], *views[Reflectivity], *views[Motion]};
}

} // namespace glint::measure
