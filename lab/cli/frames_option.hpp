// `--config frames=...`: a configuration whose frames another program has made, for `glint sequence`.
#pragma once

#include "base/result.hpp"
#include "lab/measure/motion/stored_frames.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace glint::cli {

inline constexpr std::string_view kFramesPrefix = "frames=";

/// The syntax, for help texts.
extern const char* const kFramesHelp;

/// True if a config is of this form.
bool namesFrames(std::string_view config);

/// "frames=A/%04d.exr", or "frames=A/%04d.exr:B/%04d.exr" with the frames of two seeds: opens frames 0 to `frames` - 1
/// of each. Requires namesFrames. Errors: InvalidArgument names `--config` and the text; as StoredFrames::open.
Result<measure::StoredFrames> openFrames(std::string_view config, uint32_t frames);

} // namespace glint::cli
