// Command lines as text that a shell reads back: so that a report says how it was made.
#pragma once

#include "lab/cli/render/render_options.hpp"

#include <string>
#include <string_view>

namespace glint::cli {

/// The word as a POSIX shell reads it: in quotes where it has a character with a meaning of its own.
std::string shellWord(std::string_view word);

/// The command with the options that were given, "glint report builtin:hall --size 640x360". Call it once the command
/// line has been parsed.
std::string commandText(const CLI::App& command);

/// The command that renders one config of a comparison: "glint render SCENE --size WxH ... --preset fast".
/// `config`  as in `--config`, and valid
std::string renderCommand(const RenderOptions& options, const std::string& scene, std::string_view config,
                          uint32_t width, uint32_t height);

} // namespace glint::cli
