// Evaluates an animation channel at a time.
#pragma once

#include "lab/scene/scene.hpp"

#include <vector>

namespace glint::scene {

/// Samples `channel` at `time` seconds, clamped to the channel's first and last key. Returns as many floats as a key
/// has: 3 for translation and scale, 4 (x, y, z, w, unit) for rotation, one per morph target for weights.
///
/// `channel`    has at least one key; times never decrease; the number of values fits the times (checked by the reader)
/// Based on: glTF 2.0 specification, appendix C, "Interpolation".
std::vector<float> sampleChannel(const AnimationChannel& channel, double time);

/// Returns the animations that play together: in file order, each that drives no property of an earlier one. A file's
/// animations are often alternatives (walk, run), and sometimes parts of one performance. This plays the first
/// alternative and all parts, as the Khronos sample viewer does.
std::vector<const Animation*> playedAnimations(const Scene& scene);

/// Returns the seconds at which a stepped channel of a played animation changes its value, in order, each once.
std::vector<double> stepTimes(const Scene& scene);

} // namespace glint::scene
