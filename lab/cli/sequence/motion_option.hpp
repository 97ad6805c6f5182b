// `--path TEXT`: the movement of the camera in moving pictures, and their reference.
#pragma once

#include "base/result.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/measure/motion/sequence.hpp"

#include <string>

namespace glint::cli {

/// The names of the built-in movements, and ".json": for help texts.
std::string pathHelp();

/// "pan", or the name of a path file. Errors: InvalidArgument names `--path`; those of the file.
Result<measure::SequencePath> readPath(const std::string& text);

/// Frames of these settings that have so many samples per pixel together. Errors: InvalidArgument, naming `config`, if
/// its frames are not averaged.
Result<uint32_t> motionReferenceFrames(const render::ProgramSettings& settings, std::string_view config,
                                       int64_t samples);

/// The reference of moving pictures: enough frames of a config for so many samples per pixel, frame and seed. Errors:
/// InvalidArgument if its frames are not averaged; as makeConfigJob.
Result<measure::ComparedConfig> motionReference(const RenderOptions& options, const std::string& config,
                                                int64_t samples);

} // namespace glint::cli
