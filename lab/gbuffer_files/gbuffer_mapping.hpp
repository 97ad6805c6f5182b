// What the layers of a G-buffer file are called and what they mean: a JSON file, or one of the presets
// (docs/trace.md).
#pragma once

#include "base/result.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::scene {

/// A layer of the file by name, or the same number for every pixel. A name is that of a layer ("Normal") or of one
/// channel ("Depth.Z"), with or without what stands before it in the file ("ViewLayer.Normal").
struct LayerSource {
    std::string layer;
    float constant = 0; ///< if `layer` is empty
};

/// times * (sum[0] + sum[1] + ...), channel by channel; an empty `times` is 1.
struct ColorTerm {
    std::string times;
    std::vector<std::string> sum;
};
/// A sum of terms; empty: the file does not have this colour.
using ColorSum = std::vector<ColorTerm>;

enum class StoredDepth : uint8_t {
    ViewZ,          ///< distance along the view axis, positive
    NegativeViewZ,  ///< z of view space, negative in front of the camera
    Distance,       ///< distance from the camera's position
    Device,         ///< 0 at the camera's near plane, 1 at its far plane (at infinity without one)
    ReversedDevice, ///< 1 at the near plane, 0 at the far plane
};
enum class StoredAxes : uint8_t { YUp, ZUp }; ///< of the world; both right-handed; ZUp: Blender, (x, z, -y) is Glint's
enum class StoredSpace : uint8_t { World, View };

/// Names of the enums above in mapping files, in their order.
std::span<const std::string_view> storedDepthNames();
std::span<const std::string_view> storedAxesNames();
std::span<const std::string_view> storedSpaceNames();

/// Meaning of depth, positions and normals.
struct GBufferMeaning {
    StoredDepth depth = StoredDepth::ViewZ;
    StoredAxes axes = StoredAxes::YUp;
    StoredSpace normalSpace = StoredSpace::World;
    bool normalUnorm = false;    ///< stored as n * 0.5 + 0.5
    bool normalInward = false;   ///< normals point into the surface
    bool rowsFromBottom = false; ///< the first row is the bottom of the picture
    float metres = 1;            ///< per unit of depth and position
};

struct GBufferMapping {
    GBufferMeaning meaning;
    std::string depth;       ///< empty: computed from `position`
    std::string position;    ///< of the surface in the world; beside `depth` it is only checked
    float background = 1e9f; ///< depth in the file's units from which a pixel shows no surface
    std::string coverage;    ///< below 0.5: no surface; empty: depth alone decides
    std::string normal;
    LayerSource roughness;   ///< perceptual roughness
    bool smoothness = false; ///< `roughness` holds 1 - perceptual roughness
    std::string f0;          ///< specular colour; empty: from metallic, baseColor and ior
    LayerSource metallic;
    std::string baseColor;             ///< linear; empty: white
    LayerSource ior = {"", 1.5f};      ///< of dielectrics
    std::string motion;                ///< of sequences; empty: nothing moves but the camera
    glm::vec2 motionScale = {1, 1};    ///< stored motion to previous - current position, +X right, +Y down
    bool motionInPixels = false;       ///< else in UV
    ColorSum color;                    ///< the lit picture, linear
    ColorSum fallbackSpecular;         ///< part of `color` that reflections replace
    ColorSum reference;                ///< the true reflection, which figures are measured against
    std::vector<std::string> optional; ///< keys of this mapping whose layers may be missing (presets)
};

/// "blender": the passes of Cycles and four AOVs. "glint": the layers of `glint render -o x.exr --view ...`.
std::vector<std::string_view> mappingPresets();
/// Returns the JSON of a preset, to start a mapping file from. Errors: NotFound.
Result<std::string_view> mappingPresetText(std::string_view name);

/// `name` is used in error messages. Errors: InvalidInput, with the line for JSON that does not parse and the key for
/// everything else.
Result<GBufferMapping> parseMapping(std::string_view text, std::string_view name);

/// `asked`: the name of a preset or the path of a mapping file. Errors: as parseMapping; NotFound, Io.
Result<GBufferMapping> readMapping(const std::string& asked);

} // namespace glint::scene
