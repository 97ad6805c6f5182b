// The debug views that the library offers, by name.
#pragma once

#include "shared/trace_constants.h"

#include <array>
#include <string_view>

namespace glint::reflect {

/// In the order of kView* in shared/trace_constants.h.
inline constexpr std::array<std::string_view, shared::kViewCount> kViewNames = {
    "reflection",    "weight",     "weights",      "source",       "outcome",
    "normal",        "depth",      "roughness",    "reflectivity", "hitUV",
    "hitDistance",   "lookups",    "rayDirWS",     "ray",          "color",
    "hitDepth",      "hitSuccess", "probes",       "weightRays",   "weightProbes",
    "weightSky",     "planar",     "weightPlanar", "refraction",   "refractionWeights",
    "historyFrames", "antilag",    "raySent"};

} // namespace glint::reflect
