// The colours of the maps in a report, with their names.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace glint::cli {

/// {"error": colours from 0 to 1, "outcome", "source", "hits": [{"name", "color": "#rrggbb", "meaning"}]}. The colours
/// are those of the views (shaders/lib/outcome_color.glsl, shaders/composite/view.comp) and of measure::classColors. A
/// hit's green is brighter the more lookups it took.
nlohmann::ordered_json legendsJson();

} // namespace glint::cli
