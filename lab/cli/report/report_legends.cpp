#include "lab/cli/report/report_legends.hpp"

#include "lab/measure/figures/flip.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace glint::cli {
namespace {

struct LegendEntry {
    const char* name;
    const char* color;
    const char* meaning;
};

constexpr LegendEntry kOutcomeLegend[] = {
    {"hit", "#008000", "met a visible surface; brighter green: more lookups"},
    {"side", "#73bf1a", "ran into the slab behind a surface and shows its front's colour"},
    {"inferred", "#bfffcc", "crossed a surface behind an occluder and shows the nearest of it that is seen"},
    {"backFace", "#734d26", "met a surface from its unseen side"},
    {"hidden", "#800080", "ended behind what the picture shows there"},
    {"tooThick", "#e64de6", "the same, within twice the thickness"},
    {"offScreen", "#ffff00", "left the picture"},
    {"behindCamera", "#ff8000", "reached the near plane"},
    {"sky", "#4099e6", "ended over the background"},
    {"maxDistance", "#0000ff", "reached screen.maxDistance"},
    {"outOfSteps", "#ff0000", "screen.maxSteps were not enough"},
    {"belowThreshold", "#262626", "not traced: reflects too little"},
    {"tooRough", "#4d4d4d", "not traced: rougher than reflect.maxRoughness"},
    {"facingCamera", "#008080", "not traced: fade.facingCamera leaves nothing"},
    {"fromNeighbours", "#334d73", "no ray in this frame: neighbours' rays answer (reuse.rate, rays.interpolate)"},
    {"none", "#000000", "no ray"},
};

constexpr LegendEntry kSourceLegend[] = {
    {"screen", "#1acc33", "screen space"},   {"rays", "#e68026", "rays through the scene's triangles"},
    {"planar", "#f2d933", "planar mirrors"}, {"probes", "#b366e6", "reflection probes"},
    {"sky", "#4099e6", "the environment"},   {"none", "#000000", "no source answered"},
};

constexpr LegendEntry kHitsLegend[] = {
    {"right", "#28aa3c", "a hit at the true position"},
    {"wrong place", "#f59614", "a hit, but the true hit is visible elsewhere"},
    {"false hit", "#dc1e28", "a hit, though the true hit is not visible"},
    {"missed", "#325ae6", "no hit, though the true hit is visible"},
    {"rightly none", "#464646", "no hit, and the true hit is not visible"},
    {"no ray", "#000000", "background, or a surface that does not reflect"},
};

template <size_t kCount>
nlohmann::ordered_json legendJson(const LegendEntry (&entries)[kCount]) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const LegendEntry& entry : entries)
        json.push_back({{"name", entry.name}, {"color", entry.color}, {"meaning", entry.meaning}});
    return json;
}

/// The colours of errors, from 0 to 1.
nlohmann::ordered_json rampJson() {
    constexpr std::array kErrors = {0.0f, 0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.875f, 1.0f};
    const std::vector<uint8_t> rgb = measure::errorColors(kErrors);
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (size_t i = 0; i < rgb.size(); i += 3)
        json.push_back(fmt::format("#{:02x}{:02x}{:02x}", rgb[i], rgb[i + 1], rgb[i + 2]));
    return json;
}

} // namespace

nlohmann::ordered_json legendsJson() {
    return {{"error", rampJson()},
            {"outcome", legendJson(kOutcomeLegend)},
            {"source", legendJson(kSourceLegend)},
            {"hits", legendJson(kHitsLegend)}};
}

} // namespace glint::cli
