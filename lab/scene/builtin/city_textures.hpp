// Images of builtin:city: wet asphalt, pavement, what lit windows show, signs, leaves. All repeat without a
// seam.
#pragma once

#include "lab/scene/builtin/textures.hpp"

namespace glint::scene::builtin {

struct GroundImages {
    SurfaceImages surface;
    Image normal;
};

/// Asphalt after rain: a smooth film of water in the hollows, grain between them.
GroundImages wetAsphalt(int size);
/// Square slabs, wet where they are worn.
GroundImages wetPavement(int size);

/// What a window shows at night: a lit room between curtains. Emission.
Image litRoom(const std::string& name, int size, uint32_t seed);
/// A shop's window: shelves of goods under lamps. Emission.
Image shopWindow(const std::string& name, int size, uint32_t seed);
/// A board with a row of invented letters; one of the two colours is the letters'. Emission; for boards `aspect` times
/// as wide as high.
Image signBoard(const std::string& name, int size, float aspect, uint32_t seed, const glm::vec3& ground,
                const glm::vec3& letters);
/// A twig with leaves, cut out by alpha.
Image leaves(const std::string& name, int size, uint32_t seed);

} // namespace glint::scene::builtin
