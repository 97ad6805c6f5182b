// `--config TEXT`: settings in one word, for commands that take several of them.
#pragma once

#include "base/result.hpp"
#include "render/program_settings.hpp"
#include "render_options.hpp"

#include <string>
#include <string_view>

namespace glint::cli {

/// What each `--config` may say, for help texts.
extern const char* const kConfigHelp;

/// "babylon", "mine.json", "screen.step=4,fade.border=none", "babylon+screen.step=4,thickness=0.5": a preset's name or
/// a .json file, then KEY=VALUE; the base and what follows are parted by + or a comma, assignments by commas. Errors:
/// InvalidArgument names `--config` and the text. Keys and values are checked later, by render::loadSettings.
Result<render::SettingsRequest> readConfig(std::string_view text);

/// The job of a scene with one config. `options` has what all configs share: its assignments are weaker than theirs.
/// Errors: as readConfig's and makeRenderJob's; they name `--config` and the text.
Result<render::RenderJob> makeConfigJob(const RenderOptions& options, const std::string& scene,
                                        const std::string& config);

} // namespace glint::cli
