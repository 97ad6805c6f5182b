// Runs another program to completion and returns its output.
#pragma once

#include "base/result.hpp"

#include <string>
#include <vector>

namespace glint::cli {

struct ProgramOutput {
    int code = 0; ///< or 128 + the signal that ended the program
    std::string out;
    std::string error;
};

/// `command`  the program, found through PATH, and its arguments; not interpreted by a shell
/// Errors: NotFound if there is no such program; Io.
Result<ProgramOutput> runChild(const std::vector<std::string>& command);

} // namespace glint::cli
