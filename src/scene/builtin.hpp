// Scenes that Glint carries with it, made by code: the show piece, and scenes whose right picture is known exactly.
// They need no files, so tests, the demo and a first try on a new machine all start from here.
#pragma once

#include "base/result.hpp"
#include "scene/scene.hpp"

#include <span>
#include <string_view>

namespace glint::scene {

/// One line of the list that `builtin:NAME` chooses from.
struct BuiltinInfo {
    std::string_view name;         ///< without "builtin:"
    std::string_view description;  ///< one line for `--help`
    std::string_view camera;       ///< the default view; always the scene's first camera node
    std::string_view environment;  ///< what `--env` should default to: "sky" or "none"
    float environmentStrength = 1; ///< what `environment.strength` should default to
};

/// All built-in scenes; the first is the show piece.
std::span<const BuiltinInfo> builtinScenes();

/// Makes a scene: the same bits at every call. Takes up to a second where textures are computed.
/// Errors: InvalidArgument for an unknown name; the message lists the known ones.
Result<Scene> builtinScene(std::string_view name);

/// One box of `builtin:mirror`, axis-aligned. Its front face (towards +Z) is what the camera sees both directly and in
/// the floor (the plane y = 0): the face's middle, centre + (0, 0, halfExtent.z), mirrored to -y and projected through
/// the camera, is a pixel whose reflection shows `color`.
struct MirrorBox {
    glm::vec3 center;     ///< metres
    glm::vec3 halfExtent; ///< metres
    glm::vec3 color;      ///< emitted radiance, linear
};

/// The boxes of `builtin:mirror`, in the order of its mesh nodes after the floor.
std::span<const MirrorBox> mirrorBoxes();

} // namespace glint::scene
