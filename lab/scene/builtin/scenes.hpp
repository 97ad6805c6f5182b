// The functions that create the built-in scenes, one file each; lab/scene/builtin/builtin.cpp lists them.
#pragma once

#include "lab/scene/scene.hpp"

namespace glint::scene::builtin {

Scene makeHall();
Scene makeMirror();
Scene makeExact();
Scene makeSpheres();
Scene makeThickness();
Scene makeGlass();
/// About `millions` of triangles, 1 to 10.
Scene makeCity(int millions);

/// What a variant of `builtin:motion` has besides floor, wall, spheres and thin lamps.
struct MotionParts {
    bool objects = false;    ///< a ball and a box that move
    bool hidden = false;     ///< a ball that moves where only the floor shows it
    bool lamp = false;       ///< a lamp that is switched
    bool grille = false;     ///< poles, leaves and a grille; nothing moves
    bool panels = false;     ///< turning reflectors
    bool emitters = false;   ///< small bright lights that wander
    bool bumpyFloor = false; ///< the floor has a normal map
};
Scene makeMotion(std::string name, const MotionParts& parts);

} // namespace glint::scene::builtin
