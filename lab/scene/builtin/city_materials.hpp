// The materials of builtin:city, and the colours of its lights.
#pragma once

#include "lab/scene/builtin/city_facade.hpp"
#include "lab/scene/builtin/scene_builder.hpp"

#include <array>
#include <vector>

namespace glint::scene::builtin {

inline constexpr glm::vec3 kLampColor(1.f, 0.56f, 0.22f); ///< sodium
inline constexpr std::array<glm::vec3, 4> kNeonColors = {glm::vec3(1.f, 0.07f, 0.3f), glm::vec3(0.05f, 0.6f, 1.f),
                                                         glm::vec3(0.15f, 1.f, 0.35f), glm::vec3(1.f, 0.45f, 0.05f)};

/// Indices in the scene.
struct CityMaterials {
    int asphalt = -1;
    int pavement = -1;
    int kerb = -1;
    int marking = -1;                                         ///< of the road
    std::array<std::array<int, 2>, kFacadeStyles> walls = {}; ///< by style: two colours
    std::array<int, kFacadeStyles> trims = {};
    std::array<int, kFacadeStyles> frames = {};
    std::array<int, 3> glasses = {}; ///< of dark windows
    std::vector<int> rooms;          ///< lit windows
    std::vector<int> shopWindows;
    std::vector<int> signs;
    std::vector<int> awnings;
    std::array<int, 3> roofs = {};
    int plant = -1; ///< air conditioning
    int tank = -1;
    std::array<int, 4> neon = {};
    std::vector<int> paints; ///< of cars
    int carGlass = -1;
    int tyre = -1;
    int rim = -1;
    int headlamp = -1;
    int tailLamp = -1;
    int iron = -1;
    int lampHead = -1;
    int bark = -1;
    std::vector<int> leaves;
    int red = -1; ///< of hydrants
    int bin = -1;
    int stop = -1; ///< traffic lights
    int amber = -1;
    int go = -1;
};

/// Adds them to a scene, 152 of them, with 37 textures.
CityMaterials cityMaterials(SceneBuilder& builder);

} // namespace glint::scene::builtin
