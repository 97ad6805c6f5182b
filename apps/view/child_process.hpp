// Another program, run to its end, and what it said.
#pragma once

#include "base/result.hpp"

#include <string>
#include <vector>

namespace glint::view {

struct ProgramOutput {
    int code = 0; ///< 128 + the signal that ended it
    std::string out;
    std::string error;
};

/// `command`  the program, looked for on PATH, and its arguments; no shell reads them
/// Errors: NotFound where there is no such program; Io.
Result<ProgramOutput> runProgram(const std::vector<std::string>& command);

} // namespace glint::view
