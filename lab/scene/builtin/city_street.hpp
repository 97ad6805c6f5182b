// What stands in the streets of builtin:city: lamps, cars, trees, small things. Geometry by material, for the caller to
// choose; everything stands on y = 0.
#pragma once

#include "lab/scene/builtin/mesh_tools.hpp"

#include <cstdint>

namespace glint::scene::builtin {

inline constexpr float kLampHeight = 5.6f; ///< of the light, metres
inline constexpr float kLampReach = 1.6f;  ///< from the pole to the light, along +X

struct StreetLamp {
    Geometry pole;
    Geometry head; ///< shines down
};
StreetLamp streetLamp();

struct Car { ///< faces +X, 4.2 m long
    Geometry body;
    Geometry windows;
    Geometry tyres;
    Geometry rims;
    Geometry headlamps;
    Geometry tailLamps;
};
Car car();

struct Tree {
    Geometry trunk;
    Geometry leaves; ///< cards; uv in [0, 1], for an image that alpha cuts out
};
Tree tree(uint32_t seed);

Geometry bollard();
Geometry litterBin();
Geometry hydrant();

struct TrafficLight { ///< on its own pole, faces +Z
    Geometry housing;
    Geometry red, amber, green;
};
TrafficLight trafficLight();

} // namespace glint::scene::builtin
