// Reads what `glint bench --json` wrote, as the base of `glint bench --check`.
#pragma once

#include "lab/measure/bench/bench_check.hpp"

namespace glint::cli {

/// `fileName`  for messages
/// Errors: InvalidArgument: no JSON, or not a benchmark's; says where.
Result<measure::BenchBase> readBenchBase(std::string_view text, const std::string& fileName);

} // namespace glint::cli
