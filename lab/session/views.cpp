#include "lab/session/views.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "shared/display.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace glint::render {
namespace {

constexpr std::array kViews = {
    ViewInfo{"composite", ViewKind::Radiance, "RGBA", "the frame with its reflections; alpha: opacity"},
    ViewInfo{"scene", ViewKind::Radiance, "RGB", "the frame without them"},
    ViewInfo{"reflection", ViewKind::Radiance, "RGB", "reflected radiance, all sources together"},
    ViewInfo{"weight", ViewKind::Fraction, "Y", "weight of the screen-space answer"},
    ViewInfo{"weights", ViewKind::Fraction, "RGBA", "weight of each source: screen, sky, rays, probes"},
    ViewInfo{"source", ViewKind::Fraction, "RGB",
             "which source answered most: green screen, orange rays, yellow planar, violet probes, blue sky"},
    ViewInfo{"outcome", ViewKind::Fraction, "RGB", "how each ray ended, as colours"},
    ViewInfo{"normal", ViewKind::Direction, "XYZ", "world-space normal"},
    ViewInfo{"depth", ViewKind::Distance, "Z", "metres along the view axis"},
    ViewInfo{"albedo", ViewKind::Fraction, "RGB", "base colour"},
    ViewInfo{"fallbackSpecular", ViewKind::Radiance, "RGB", "the part of the scene that reflections replace"},
    ViewInfo{"roughness", ViewKind::Fraction, "Y", "perceptual roughness"},
    ViewInfo{"reflectivity", ViewKind::Fraction, "RGB", "F0"},
    ViewInfo{"motion", ViewKind::Motion, "XYZ",
             "motion of the surface: previous UV - current UV, and previous - current depth in metres; grey: none"},
    ViewInfo{"hitUV", ViewKind::Fraction, "UV", "where on the screen the ray hit"},
    ViewInfo{"hitDistance", ViewKind::Distance, "Z", "metres along the ray to its hit"},
    ViewInfo{"lookups", ViewKind::Count, "Y", "depth reads of the ray"},
    ViewInfo{"rayDirWS", ViewKind::Direction, "XYZ", "world-space direction of the mirror ray"},
    ViewInfo{"color", ViewKind::Radiance, "RGB", "radiance that the screen source found"},
    ViewInfo{"hitDepth", ViewKind::Distance, "Z", "metres along the view axis to the surface that the ray hit"},
    ViewInfo{"hitSuccess", ViewKind::Fraction, "RGB",
             "light green: hit, light blue: failed, yellow: a side or back, black: no ray"},
    ViewInfo{"probes", ViewKind::Radiance, "RGB", "radiance that the probes answered with"},
    ViewInfo{"weightRays", ViewKind::Fraction, "Y", "share of the rays"},
    ViewInfo{"weightProbes", ViewKind::Fraction, "Y", "share of the probes"},
    ViewInfo{"weightSky", ViewKind::Fraction, "Y", "share of the environment"},
    ViewInfo{"planar", ViewKind::Radiance, "RGB", "radiance that the planar mirrors answered with"},
    ViewInfo{"weightPlanar", ViewKind::Fraction, "Y", "share of the planar mirrors"},
    ViewInfo{"refraction", ViewKind::Radiance, "RGB", "radiance that comes through the nearest transparent layer"},
    ViewInfo{"refractionWeights", ViewKind::Fraction, "RGB", "where it is from: screen, probes, sky"},
    ViewInfo{"historyFrames", ViewKind::Count, "Y", "frames that the denoised answer is a mean of"},
    ViewInfo{"antilag", ViewKind::Fraction, "Y", "share of the last mean's frames given up because light changed"},
    ViewInfo{"raySent", ViewKind::Fraction, "Y",
             "white: a ray was sent from here and denoised, grey: its neighbours' rays are taken"},
    ViewInfo{"ray", ViewKind::Fraction, "RGBA", "for programs: hitUV, number of the outcome, lookups"},
};

constexpr ViewInfo kPassImage = {"PASS:IMAGE", ViewKind::Radiance, "RGBA", "an image that a pass of the frame wrote"};

/// Blue, cyan, green, yellow, red for t in (0, 1]; black for 0, which means no ray.
glm::vec3 heat(float t) {
    if (t <= 0)
        return glm::vec3(0);
    const float x = t * 4;
    return glm::clamp(glm::vec3(x - 2, 2 - std::abs(x - 2), 2 - x), glm::vec3(0), glm::vec3(1));
}

glm::vec3 displayColor(ViewKind kind, const glm::vec3& value) {
    switch (kind) {
    case ViewKind::Direction: return value * 0.5f + 0.5f;
    case ViewKind::Distance:
        return glm::vec3(value.x > 0 ? shared::kViewHalfWhite / (shared::kViewHalfWhite + value.x) : 0.0f);
    case ViewKind::Motion:
        return 0.5f + 0.5f * glm::sign(value) * glm::sqrt(glm::abs(value) / shared::kViewLargestMotion);
    case ViewKind::Count: return heat(std::log2(1 + std::max(value.x, 0.0f)) / std::log2(1 + shared::kViewRedCount));
    case ViewKind::Radiance:
    case ViewKind::Fraction: break;
    }
    return value;
}

} // namespace

std::span<const ViewInfo> viewList() {
    return kViews;
}

Result<const ViewInfo*> findView(std::string_view name) {
    if (name.find(':') != std::string_view::npos)
        return &kPassImage;
    const auto found = std::ranges::find(kViews, name, &ViewInfo::name);
    if (found != kViews.end())
        return &*found;
    std::vector<std::string> names;
    for (const ViewInfo& view : kViews)
        names.emplace_back(view.name);
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view meant = likelyMeant(name, views);
    const std::string hint = meant.empty() ? std::string() : fmt::format(" did you mean '{}'?", meant);
    return invalidArgument("unknown view '{}';{} there are {}", printable(name), hint, listText(names, " and "));
}

std::vector<uint8_t> displayBytes(ViewKind kind, std::span<const float> rgba) {
    GLINT_ASSERT(kind != ViewKind::Radiance && rgba.size() % 4 == 0, "{} floats", rgba.size());
    std::vector<uint8_t> bytes;
    bytes.reserve(rgba.size() / 4 * 3);
    for (size_t i = 0; i < rgba.size(); i += 4) {
        glm::vec3 color = displayColor(kind, {rgba[i], rgba[i + 1], rgba[i + 2]});
        if (glm::any(glm::isnan(color)))
            color = {1, 0, 1};
        color = glm::clamp(color, glm::vec3(0), glm::vec3(1));
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<uint8_t>(std::lround(color[c] * 255)));
    }
    return bytes;
}

} // namespace glint::render
