// The program `glint`: finds the command, runs it, and turns how it went into an exit code and at most one line.
#pragma once

#include "commands.hpp"

namespace glint::cli {

constexpr int kDone = 0;
constexpr int kFailed = 1;   ///< at work: a device, the memory, the disk
constexpr int kBadInput = 2; ///< arguments or files that cannot be used

/// Runs the command line and returns the exit code; an error is one line on standard error.
/// `render`  does the work of `glint render` and `inspect`; without it these commands are not there
/// `view`    adds the command that opens a window (apps/view), for programs that have one
int runProgram(int argc, const char* const* argv, const render::RenderFunction& render, const AddCommand& view = {});

} // namespace glint::cli
