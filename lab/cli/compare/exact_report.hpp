// Formats `measure.exact` as JSON.
#pragma once

#include "lab/measure/truth/exact_picture.hpp"

#include <nlohmann/json_fwd.hpp>

namespace glint::cli {

/// {"mirrorPixels", "wrongPixels", "wrongShare", "oneBouncePixels", "oneBounceWrong", "oneBounceWrongShare",
/// "byBounces": [{"bounces", "pixels", "wrong"}]}
nlohmann::ordered_json exactJson(const measure::MirrorError& error);

} // namespace glint::cli
