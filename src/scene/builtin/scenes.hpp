// The functions that create the built-in scenes, one file each; scene/builtin.cpp lists them.
#pragma once

#include "scene/scene.hpp"

namespace glint::scene::builtin {

Scene makeHall();
Scene makeMirror();
Scene makeExact();
Scene makeSpheres();
Scene makeThickness();
Scene makeGlass();

} // namespace glint::scene::builtin
