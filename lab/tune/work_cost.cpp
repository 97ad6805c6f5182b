#include "lab/tune/work_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string_view>

namespace glint::tune {
namespace {

/// What a pass's work grows with; all relative to the frame's pixels.
enum class Unit : uint8_t {
    Pixels,     ///< of the frame
    Traced,     ///< pixels of the traced image: screen.resolutionScale
    Rays,       ///< screen-space rays
    Lookups,    ///< their depth lookups
    Spread,     ///< those of rays that the denoiser spreads over lobes: neighbours take other ways
    SceneRays,  ///< rays through triangles
    SpreadRays, ///< those that the denoiser spreads over lobes
    LitRays,    ///< these rays, times the shadow rays from the hit of each: rays.shadowRays
    Rough,      ///< pixels that the denoiser averages
    RoughRays,  ///< those of them that send rays through triangles: rays.maxRoughness
    Reused,     ///< their neighbours' rays: reuse.samples
    Filtered,   ///< these pixels, where denoise.maxRadius is above 0
    Cones,      ///< traced rough pixels whose hits are blurred: rough.cones, reflect.maxRoughness
    BlurTaps,   ///< these pixels in the blurred image, times taps
    BackFaces,  ///< pixels of the back-face image
    Triangles,  ///< of the scene
};

struct UnitCost {
    std::string_view pass; ///< without the ray back end
    Unit unit = Unit::Pixels;
    double floors = 0;
};

// Measured with glint bench on builtin:hall, builtin:exact and stage1 at 640x360, llvmpipe 25 on two quiet cores
// (docs/tune.md); a floor is 16 ns a pixel there.
constexpr std::array kUnitCosts = {
    UnitCost{"render/back_faces", Unit::BackFaces, 0.4},
    UnitCost{"render/back_faces", Unit::Triangles, 3.9},
    UnitCost{"render/back_faces_masked", Unit::BackFaces, 0.2},
    UnitCost{"prepare/surface", Unit::Pixels, 1.25},
    UnitCost{"prepare/classified", Unit::Pixels, 2.2},
    UnitCost{"prepare/back_faces", Unit::Pixels, 1.2},
    UnitCost{"prepare/pyramid", Unit::Pixels, 1.6},
    UnitCost{"trace/classify", Unit::Traced, 1.25},
    UnitCost{"trace/list", Unit::Traced, 0.4},
    UnitCost{"trace/picture", Unit::Pixels, 0.75},
    UnitCost{"trace/picture", Unit::Cones, 2.8}, // the marchers read it
    UnitCost{"trace/hiz", Unit::Rays, 1},
    UnitCost{"trace/hiz", Unit::Lookups, 1.15},
    UnitCost{"trace/hiz", Unit::Spread, 0.8},
    UnitCost{"trace/linear", Unit::Rays, 3},
    UnitCost{"trace/linear", Unit::Lookups, 0.95},
    UnitCost{"trace/adaptive", Unit::Rays, 1},
    UnitCost{"trace/adaptive", Unit::Lookups, 0.45},
    UnitCost{"trace/proxy", Unit::Rays, 5},
    UnitCost{"rays/list", Unit::Pixels, 1.4},
    UnitCost{"rays/list", Unit::SceneRays, 1.3},
    UnitCost{"rays/interpolate", Unit::Pixels, 0.6},
    UnitCost{"rays/interpolate", Unit::SceneRays, 7}, // they serve about as many pixels again
    UnitCost{"rays/reflect", Unit::SceneRays, 45},
    UnitCost{"rays/reflect", Unit::SpreadRays, 65},
    UnitCost{"rays/reflect", Unit::LitRays, 7.5},
    UnitCost{"rays/reflect_lights", Unit::SceneRays, 70},
    UnitCost{"rays/reflect_lights", Unit::SpreadRays, 65},
    UnitCost{"rays/reflect_lights", Unit::LitRays, 7.5},
    UnitCost{"rays/sentinels", Unit::RoughRays, 22},
    UnitCost{"rays/sentinels", Unit::SceneRays, 8},
    UnitCost{"denoise/gather", Unit::Pixels, 2},
    UnitCost{"denoise/gather", Unit::Rough, 1.3},
    UnitCost{"denoise/sentinels", Unit::Pixels, 0.45},
    UnitCost{"denoise/sentinels", Unit::Rough, 0.7},
    UnitCost{"denoise/change", Unit::Pixels, 0.3},
    UnitCost{"denoise/reuse", Unit::Pixels, 1.45},
    UnitCost{"denoise/reuse", Unit::Reused, 1.5},
    UnitCost{"denoise/accumulate", Unit::Pixels, 1.65},
    UnitCost{"denoise/accumulate", Unit::Rough, 8},
    UnitCost{"denoise/rate", Unit::Pixels, 0.17},
    UnitCost{"denoise/filter", Unit::Pixels, 0.9},
    UnitCost{"denoise/filter", Unit::Filtered, 6.8},
    UnitCost{"denoise/stabilize", Unit::Pixels, 1.6},
    UnitCost{"denoise/stabilize", Unit::Rough, 3},
    UnitCost{"resolve/upsample", Unit::Pixels, 2.9},
    UnitCost{"resolve/blur", Unit::Pixels, 3},
    UnitCost{"resolve/blur", Unit::BlurTaps, 0.65},
    UnitCost{"composite/combined", Unit::Pixels, 1.9},
    UnitCost{"composite/combined", Unit::Rough, 1.5},
    // With views, as here, two passes do what hosts without them do in one: they count as that one.
    UnitCost{"hierarchy/combine", Unit::Pixels, 0.6},
    UnitCost{"hierarchy/combine", Unit::Rough, 0.9},
    UnitCost{"composite/composite", Unit::Pixels, 1.3},
    UnitCost{"composite/composite", Unit::Rough, 0.6},
    UnitCost{"composite/remember", Unit::Pixels, 0.1},
    UnitCost{"refraction/solidPicture", Unit::Pixels, 0.8},
    // Of each transparent layer, which covers a small part of the frame there.
    UnitCost{"refraction/picture", Unit::Pixels, 0.3},
    UnitCost{"refraction/layer", Unit::Pixels, 0.25},
    UnitCost{"refraction/layers_depth", Unit::Pixels, 0.15},
};

/// A pass that no row knows: as a pass over all pixels.
constexpr double kOtherPass = 2;

/// Figures count these (measure::effectSum), so they are not part of the effect.
constexpr std::array<std::string_view, 3> kNotCounted = {"composite/statistics", "rays/statistics", "prepare/dfg"};

/// By blur.quality (src/reflect/resolve/screen_resolve.cpp).
constexpr std::array kBlurTaps = {9, 21, 41};

double square(double x) {
    return x * x;
}

/// Share of the frame's pixels whose hits are blurred: some, if the copies of the picture are made.
double blurredPixels(const FrameWork& work) {
    const bool blurs = std::ranges::find(work.passes, "trace/picture") != work.passes.end();
    return blurs ? work.rough.upTo(work.settings->reflect.maxRoughness) : 0;
}

/// Shadow rays from a hit, mean over the pixels: mirrors send one to each light, what the denoiser averages a few.
double shadowRays(const FrameWork& work) {
    if (!work.settings->denoise.enabled)
        return work.lights;
    const double spread = work.rough.upTo(work.settings->rays.maxRoughness);
    return std::lerp(work.lights, std::min<double>(work.settings->rays.shadowRays, work.lights), spread);
}

/// Units that the frame counts as a whole, in however many runs of a pass.
bool isTotal(Unit unit) {
    return unit == Unit::SceneRays || unit == Unit::SpreadRays || unit == Unit::LitRays;
}

double amount(Unit unit, const FrameWork& work) {
    const Settings& settings = *work.settings;
    const double rays = static_cast<double>(work.stats.rays) / work.pixels;
    const double sceneRays = static_cast<double>(work.stats.scene.rays) / work.pixels;
    switch (unit) {
    case Unit::Pixels: return 1;
    case Unit::Traced: return settings.denoise.enabled ? 1 : square(settings.screen.resolutionScale);
    case Unit::Rays: return rays;
    case Unit::Lookups: return rays * work.stats.lookupsPerRay;
    case Unit::Spread: return settings.denoise.enabled ? rays * work.stats.lookupsPerRay * work.rough.all() : 0;
    case Unit::SceneRays: return sceneRays;
    case Unit::SpreadRays:
        return settings.denoise.enabled ? sceneRays * work.rough.upTo(settings.rays.maxRoughness) : 0;
    case Unit::LitRays: return sceneRays * shadowRays(work);
    case Unit::Rough: return work.rough.all();
    case Unit::RoughRays: return work.rough.upTo(settings.rays.maxRoughness);
    case Unit::Reused: return work.rough.all() * settings.reuse.samples;
    case Unit::Filtered: return settings.denoise.maxRadius > 0 ? work.rough.all() : 0;
    case Unit::Cones: return blurredPixels(work) * square(settings.screen.resolutionScale);
    case Unit::BlurTaps:
        return work.rough.all() *
               square(settings.screen.resolutionScale / static_cast<float>(settings.blur.downsample + 1)) *
               kBlurTaps[static_cast<size_t>(std::clamp(settings.blur.quality, 1, 3) - 1)];
    case Unit::BackFaces: return 1 / square(settings.screen.backfaceDownsample + 1);
    case Unit::Triangles: return work.triangles / work.pixels;
    }
    return 0;
}

/// "rays/reflect_query" and "rays/reflect_bvh" are one pass, by its back end.
std::string_view withoutBackEnd(std::string_view pass) {
    for (const std::string_view end : {"_query", "_bvh"})
        if (pass.ends_with(end))
            pass.remove_suffix(end.size());
    return pass;
}

size_t hundredthsOf(float perceptualRoughness) {
    return static_cast<size_t>(std::lround(100 * std::clamp(perceptualRoughness, 0.0f, 1.0f)));
}

} // namespace

void RoughShare::add(float perceptualRoughness, double share) {
    shares_[hundredthsOf(perceptualRoughness)] += share;
}

void RoughShare::add(const RoughShare& other, double part) {
    for (size_t i = 0; i < shares_.size(); ++i)
        shares_[i] += part * other.shares_[i];
}

double RoughShare::upTo(float perceptualRoughness) const {
    const auto end = shares_.begin() + static_cast<ptrdiff_t>(hundredthsOf(perceptualRoughness)) + 1;
    return std::accumulate(shares_.begin(), end, 0.0);
}

double countedFloors(const FrameWork& work) {
    double floors = 0;
    for (size_t i = 0; i < work.passes.size(); ++i) {
        const std::string_view pass = work.passes[i];
        if (std::ranges::find(kNotCounted, pass) != kNotCounted.end())
            continue;
        const std::span earlier(work.passes.data(), i);
        const bool again = std::ranges::find(earlier, pass) != earlier.end();
        bool known = false;
        for (const UnitCost& row : kUnitCosts) {
            if (row.pass != withoutBackEnd(pass))
                continue;
            floors += again && isTotal(row.unit) ? 0 : row.floors * amount(row.unit, work);
            known = true;
        }
        floors += known ? 0 : kOtherPass;
    }
    return floors;
}

} // namespace glint::tune
