// Stated weights against shares of right answers, as lines of text.
#pragma once

#include "lab/measure/truth/ray_hits.hpp"

#include <string>

namespace glint::cli {

/// A line for each bin of stated weight that has a thousandth of the answers. Empty without answers.
std::string statedText(const measure::HitFigures& hits);

/// A line for each kind of answer.
std::string kindsText(const measure::HitFigures& hits);

} // namespace glint::cli
