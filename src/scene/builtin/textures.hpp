// Pictures made by formula: polished stone, tiles, plaster. All repeat without a seam.
#pragma once

#include "scene/scene.hpp"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace glint::scene::builtin {

/// The two pictures that a dielectric's surface needs in glTF.
struct SurfaceImages {
    Image baseColor;         ///< sRGB
    Image metallicRoughness; ///< linear: green = roughness, blue = metalness
};

/// Colours of one kind of stone, linear albedo.
struct StoneColors {
    glm::vec3 ground, cloud, vein;
};

struct StoneFloor {
    int size = 1024;           ///< pixels a side
    int tiles = 4;             ///< along each side of the picture
    StoneColors dark, light;   ///< tiles alternate
    float jointWidth = 0.006f; ///< of a tile
    float roughness = 0.08f;   ///< perceptual, where the polish is clean
    float smudge = 0.08f;      ///< how much rougher it gets where it is worn
};

/// Polished stone tiles: each cut from its own place of the block, so veins break at the joints; the polish is a little
/// worn in patches, and duller in the joints.
SurfaceImages stoneFloor(const std::string& name, const StoneFloor& floor);

/// One slab of veined stone.
Image marble(const std::string& name, int size, const StoneColors& colors, uint32_t seed);

/// Two colours in squares, with joints; roughness is left to the material.
Image checker(const std::string& name, int size, int squares, const glm::vec3& a, const glm::vec3& b);

/// Blocks of dressed stone in running bond, as a height in [0, 1]: `size` x `size`, rows from the top.
std::vector<float> blockHeights(int size, int columns, int rows, uint32_t seed);

/// A tangent-space normal map (green up) of a height picture. `depth`: height 1, as a fraction of the picture's width.
Image normalMap(const std::string& name, const std::vector<float>& heights, int size, float depth);

/// The colour that goes with `blockHeights`: joints darker, blocks each a little different.
Image blockColors(const std::string& name, const std::vector<float>& heights, int size, const glm::vec3& albedo,
                  uint32_t seed);

} // namespace glint::scene::builtin
