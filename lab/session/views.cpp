#include "lab/session/views.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "lab/renderer/gbuffer.hpp"
#include "shared/display.h"
#include "shared/views.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace glint::render {
namespace {

#define GLINT_VIEW_ROW(name, kind, channels, meaning, value) ViewInfo{#name, ViewKind::kind, channels, meaning, #value},

constexpr std::array kViews = {
    ViewInfo{"composite", ViewKind::Radiance, "RGBA", "the frame with its reflections; alpha: opacity"},
    ViewInfo{"scene", ViewKind::Radiance, "RGB", "the frame without them"},
    ViewInfo{"albedo", ViewKind::Fraction, "RGB", "base colour", {}, &GBuffer::albedo},
    ViewInfo{"fallbackSpecular",
             ViewKind::Radiance,
             "RGB",
             "the part of the scene that reflections replace",
             {},
             &GBuffer::fallbackSpecular},
    ViewInfo{"motion",
             ViewKind::Motion,
             "XYZ",
             "motion of the surface: previous UV - current UV, and previous - current depth in metres; grey: none",
             {},
             &GBuffer::motion},
    GLINT_VIEWS(GLINT_VIEW_ROW)};

#undef GLINT_VIEW_ROW

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

/// displayColor in words.
std::string_view colorsOf(ViewKind kind) {
    switch (kind) {
    case ViewKind::Radiance: return "exposed and tone-mapped";
    case ViewKind::Fraction: return "unchanged";
    case ViewKind::Direction: return "(x + 1) / 2";
    case ViewKind::Distance: return "white is near, black is far or none";
    case ViewKind::Count: return "blue to red by the logarithm, black is 0";
    case ViewKind::Motion: return "grey is 0, darker and lighter by the root";
    }
    return {};
}

} // namespace

std::span<const ViewInfo> viewList() {
    return kViews;
}

std::string viewsPage() {
    std::string page = "# Debug views\n"
                       "\n"
                       "`scripts/glint views --markdown` writes this page. `glint render --view NAME,...` shows views, "
                       "`glint view` lists\n"
                       "them, and a host records those of the library with `Reflections::recordView`. An image that a "
                       "pass wrote is a\n"
                       "view, too: `--view PASS:IMAGE`.\n"
                       "\n"
                       "| view | shows | channels | as colours | value |\n"
                       "|---|---|---|---|---|\n";
    for (const ViewInfo& view : kViews)
        page +=
            fmt::format("| `{}` | {} | {} | {} | {} |\n", view.name, view.meaning, view.channels, colorsOf(view.kind),
                        view.value.empty() ? "the image itself" : fmt::format("`{}`", view.value));
    return page +
           "\n"
           "A view of the library is one row of [shared/views.h](../shaders/shared/views.h), its value an expression\n"
           "in [view.comp](../shaders/composite/view.comp).\n";
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
