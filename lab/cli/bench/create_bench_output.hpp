// Formats times of creating the library's objects as text and as JSON.
#pragma once

#include "lab/measure/bench/create_bench.hpp"

#include <string>

namespace glint::cli {

/// Returns text for the terminal: a table with a row for each config, two where it traces rays.
std::string createBenchText(const measure::CreateResult& result);

/// {"device": {"name", "driver"}, "width", "height", "repeats", "configs": [{"name", "create", "setRays" (null without
///  rays): {"firstMs", "cachedMs", "againMs"}, "resizeMs", "pipelineCacheBytes"}]}
std::string createBenchJson(const measure::CreateResult& result);

} // namespace glint::cli
