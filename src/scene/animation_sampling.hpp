// The value of an animation channel at a moment.
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace glint::scene {

/// Samples `channel` at `time` seconds, clamped to its own first and last key. Returns as many floats as a key has:
/// 3 for translation and scale, 4 (x, y, z, w, unit) for rotation, one a morph target for weights.
///
/// `channel`    at least one key; times never fall; values fit the times (the reader has checked)
/// Based on: glTF 2.0 specification, appendix C, "Interpolation".
std::vector<float> sampleChannel(const AnimationChannel& channel, double time);

/// Which animations play together: in file order, each that drives no property that an earlier one drives already.
/// A file's animations are often alternatives (walk, run), sometimes parts of one show; this plays the first
/// alternative and all the parts, as the Khronos sample viewer does.
std::vector<const Animation*> playedAnimations(const Scene& scene);

} // namespace glint::scene
