// Procedural images: polished stone, tiles, plaster. All repeat without a seam.
#pragma once

#include "lab/scene/scene.hpp"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace glint::scene::builtin {

/// The two images of a dielectric surface in glTF.
struct SurfaceImages {
    Image baseColor;         ///< sRGB
    Image metallicRoughness; ///< linear: green = roughness, blue = metalness
};

/// Colours of one kind of stone, linear albedo.
struct StoneColors {
    glm::vec3 ground, cloud, vein;
};

struct StoneFloor {
    int size = 1024;           ///< pixels per side
    int tiles = 4;             ///< along each side of the image
    StoneColors dark, light;   ///< tiles alternate between the two
    float jointWidth = 0.006f; ///< of a tile
    float roughness = 0.08f;   ///< perceptual, where the polish is clean
    float smudge = 0.08f;      ///< increase of roughness where the polish is worn
};

/// Polished stone tiles. Each tile is cut from a different part of the block, so that veins break at the joints. The
/// polish is slightly worn in patches, and duller in the joints.
SurfaceImages stoneFloor(const std::string& name, const StoneFloor& floor);

/// One slab of veined stone.
Image marble(const std::string& name, int size, const StoneColors& colors, uint32_t seed);

/// Squares of two colours with joints; the material sets the roughness.
Image checker(const std::string& name, int size, int squares, const glm::vec3& a, const glm::vec3& b);

/// Blocks of dressed stone in running bond, as heights in [0, 1]: `size` x `size`, rows from the top.
std::vector<float> blockHeights(int size, int columns, int rows, uint32_t seed);

/// A tangent-space normal map (green up) of a height image. `depth`: the height difference of 1, as a fraction of the
/// image's width.
Image normalMap(const std::string& name, const std::vector<float>& heights, int size, float depth);

/// The colour for `blockHeights`: joints are darker, each block differs slightly.
Image blockColors(const std::string& name, const std::vector<float>& heights, int size, const glm::vec3& albedo,
                  uint32_t seed);

} // namespace glint::scene::builtin
