// Built-in procedural scenes: the show piece, and scenes whose correct image is known exactly. They need no files, so
// tests, the demo and a first run on a new machine use them.
#pragma once

#include "base/result.hpp"
#include "lab/scene/scene.hpp"

#include <span>
#include <string_view>

namespace glint::scene {

/// One line of the list that `builtin:NAME` selects from.
struct BuiltinInfo {
    std::string_view name;         ///< without "builtin:"; NAME-2 is the same scene twice as large, where `largest` > 1
    std::string_view description;  ///< one line for `--help`
    std::string_view camera;       ///< the default camera; always the scene's first camera node
    std::string_view environment;  ///< default of `--env`: "sky" or "none"
    float environmentStrength = 1; ///< default of `environment.strength`
    int largest = 1;               ///< N of the largest version NAME-N
};

/// Returns all built-in scenes; the first is the show piece.
std::span<const BuiltinInfo> builtinScenes();

/// Returns what is listed for a name without "builtin:", such as hall or city-4; null for an unknown one.
const BuiltinInfo* findBuiltin(std::string_view name);

/// Errors: InvalidArgument for an unknown name; the message lists the known ones.
Result<void> checkBuiltinName(std::string_view name);

/// Creates a scene, with the same bits in every call. Takes up to a second if textures are computed. Errors: those
/// of checkBuiltinName.
Result<Scene> builtinScene(std::string_view name);

/// One box of `builtin:mirror`, axis-aligned. The camera sees its front face (towards +Z) both directly and in the
/// floor (the plane y = 0). The centre of the face, centre + (0, 0, halfExtent.z), mirrored to -y and projected through
/// the camera, is a pixel whose reflection shows `color`.
struct MirrorBox {
    glm::vec3 center;     ///< metres
    glm::vec3 halfExtent; ///< metres
    glm::vec3 color;      ///< emitted radiance, linear
};

/// Returns the boxes of `builtin:mirror`, in the order of its mesh nodes after the floor.
std::span<const MirrorBox> mirrorBoxes();

} // namespace glint::scene
