// One function per command: it adds the command with its options, and sets `chosen` to the work if the user runs that
// command.
#pragma once

#include "base/result.hpp"
#include "lab/job/render_job.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace glint::cli {

using Command = std::function<Result<void>()>;
using AddCommand = std::function<void(CLI::App& program, Command& chosen)>;

void addRenderCommand(CLI::App& program, Command& chosen, const render::RenderFunction& render);
void addInspectCommand(CLI::App& program, Command& chosen, const render::RenderFunction& render);
void addCompareCommand(CLI::App& program, Command& chosen);
void addTraceCommand(CLI::App& program, Command& chosen);
void addSequenceCommand(CLI::App& program, Command& chosen);
void addBakeCommand(CLI::App& program, Command& chosen);
void addBenchCommand(CLI::App& program, Command& chosen);
void addReportCommand(CLI::App& program, Command& chosen);
void addTuneCommand(CLI::App& program, Command& chosen);
void addSharesCommand(CLI::App& program, Command& chosen);
void addSweepCommand(CLI::App& program, Command& chosen);
void addSettingsCommand(CLI::App& program, Command& chosen);
void addViewsCommand(CLI::App& program, Command& chosen);
void addDevicesCommand(CLI::App& program, Command& chosen);

} // namespace glint::cli
