// The machine that figures are from: system, processor, threads.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace glint::cli {

/// {"system", "processor", "threads"}; texts are empty where the system does not tell.
nlohmann::ordered_json machineJson();

} // namespace glint::cli
