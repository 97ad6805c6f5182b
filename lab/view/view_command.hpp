// glint view: the command that opens a window.
#pragma once

#include "lab/cli/commands.hpp"

namespace glint::view {

void addViewCommand(CLI::App& program, cli::Command& chosen);

} // namespace glint::view
