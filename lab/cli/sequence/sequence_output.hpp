// Formats the figures of a sequence as text and as JSON (docs/motion.md).
#pragma once

#include "lab/measure/motion/sequence.hpp"

namespace glint::cli {

/// Returns text for the terminal: a table of the main figures by config and roughness band.
std::string sequenceText(const measure::Sequence& sequence);

/// {"scene", "width", "height", "frames", "fps", "warmUp", "steps", "device": {...}, "reference": {"name", "frames"},
///  "configs": [{"name", "preset", "raysPerPixel", "effectMs", "effectMs95", "passes": [{"name", "ms", "ms95"}],
///               "figures": {"reflection" and "composite": {"mirror", "glossy", "rough", "all": band}},
///               "notes", "settings"}]}
/// A config whose frames are files: {"name", "storedSeeds", "figures", "notes"}.
/// A band: {"pixels", "relMse", "bias", "noise", "flicker", "swim", "sharp", "energy", "fireflies": {"mean", "p95",
/// "standardError"}, "tPsnr", "trail": 16, "lead": 16 and "ghost": 32 of {"share", "standardError"}, "ghostError":
/// [32], "heal", "disoccluded", "lag90" and "lag99": {"mean", "reached", "steps"}, "steps": [{"frame", "lag90",
/// "lag99", "overshoot", "pixels"}]}. Unknown figures are null; bands without pixels are absent.
std::string sequenceJson(const measure::Sequence& sequence);

} // namespace glint::cli
