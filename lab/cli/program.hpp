// The program `glint`: finds the command, runs it, and converts the result to an exit code and at most one line of
// error.
#pragma once

#include "lab/cli/commands.hpp"

namespace glint::cli {

constexpr int kDone = 0;
constexpr int kFailed = 1;   ///< failed at run time: a device, the memory, the disk
constexpr int kBadInput = 2; ///< unusable arguments or files

/// Runs the command line and returns the exit code; an error is one line on standard error.
/// `render`  does the work of `glint render` and `inspect`; without it these commands do not exist
/// `view`    adds the command that opens a window (lab/view), for programs that have one
int runProgram(int argc, const char* const* argv, const render::RenderFunction& render, const AddCommand& view = {});

} // namespace glint::cli
