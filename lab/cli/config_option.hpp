// `--config TEXT`: settings in one argument, for commands that take several of them.
#pragma once

#include "base/result.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/job/program_settings.hpp"

#include <string>
#include <string_view>

namespace glint::cli {

/// The syntax of `--config`, for help texts.
extern const char* const kConfigHelp;

/// Parses "babylon", "mine.json", "screen.step=4,fade.border=none" or "babylon+screen.step=4,thickness=0.5": a preset's
/// name or a .json file, then KEY=VALUE assignments. A + or a comma separates the base from the assignments, commas
/// separate assignments. Errors: InvalidArgument names `--config` and the text. Keys and values are checked later, by
/// render::loadSettings.
Result<render::SettingsRequest> readConfig(std::string_view text);

/// Returns the job of a scene with one config. `options` are shared by all configs; a config's assignments override
/// theirs. Errors: as readConfig and makeRenderJob; they name `--config` and the text.
Result<render::RenderJob> makeConfigJob(const RenderOptions& options, const std::string& scene,
                                        const std::string& config);

/// Frames of a reference with these settings, for `glint compare` and `glint sweep`: 16 if they accumulate, enough for
/// preset `reference` to converge, else 1.
uint32_t defaultReferenceFrames(const render::ProgramSettings& settings);

/// "2-screen.step-4": the number of a config, from one, and its name without characters that file names cannot have.
std::string configFileName(size_t index, std::string_view config);

} // namespace glint::cli
