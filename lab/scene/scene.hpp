// A scene as a file describes it: created by the glTF reader and the built-in scenes, and converted by `pose`
// (lab/scene/pose.hpp) to drawable items at a time. Plain data with glTF's meanings and units, without Vulkan.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace glint::scene {

// ---------------------------------------------------------------- textures

/// 8-bit RGBA, rows from the top. The slot that uses the image determines whether its colours are sRGB.
struct Image {
    std::string name;
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba; ///< width * height * 4
};

enum class Wrap : uint8_t { Repeat, MirroredRepeat, ClampToEdge };
enum class Filter : uint8_t { Nearest, Linear };
enum class MipFilter : uint8_t { None, Nearest, Linear };

struct Sampler {
    Filter magFilter = Filter::Linear;
    Filter minFilter = Filter::Linear;
    MipFilter mipFilter = MipFilter::Linear;
    Wrap wrapU = Wrap::Repeat;
    Wrap wrapV = Wrap::Repeat;
    bool operator==(const Sampler&) const = default;
};

struct Texture {
    int image = -1; ///< -1: white (the image was unusable; the reader has warned)
    Sampler sampler;
};

/// A use of a texture by a material. Without a texture, only the factor applies.
struct TextureSlot {
    int texture = -1;
    uint32_t texCoord = 0;                ///< index into Geometry::uvs
    glm::mat3 uvTransform = glm::mat3(1); ///< KHR_texture_transform: uv' = (uvTransform * vec3(uv, 1)).xy
};

// ---------------------------------------------------------------- materials

enum class AlphaMode : uint8_t { Opaque, Mask, Blend };

/// The shape that refraction assumes for a transmissive object, if the author declares one.
enum class RefractionShape : uint8_t {
    ByShape, ///< not declared
    None,
    Sphere,
    Plane,
    Thin,
};

/// glTF's metallic-roughness material with the extensions that Glint supports. Names and defaults are glTF's.
struct Material {
    std::string name;
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false; ///< KHR_materials_unlit

    glm::vec4 baseColorFactor = glm::vec4(1); ///< with specularGlossiness: the diffuse factor
    TextureSlot baseColorTexture;             ///< with specularGlossiness: the diffuse texture
    float metallicFactor = 1;
    float roughnessFactor = 1;
    TextureSlot metallicRoughnessTexture;
    TextureSlot normalTexture;
    float normalScale = 1;
    TextureSlot occlusionTexture;
    float occlusionStrength = 1;
    glm::vec3 emissiveFactor = glm::vec3(0); ///< already multiplied by KHR_materials_emissive_strength
    TextureSlot emissiveTexture;

    float specularFactor = 1; ///< KHR_materials_specular
    TextureSlot specularTexture;
    glm::vec3 specularColorFactor = glm::vec3(1);
    TextureSlot specularColorTexture;

    float ior = 1.5f; ///< KHR_materials_ior; 0 means infinite (F = 1), as the extension defines

    float transmissionFactor = 0; ///< KHR_materials_transmission
    TextureSlot transmissionTexture;
    float thicknessFactor = 0; ///< KHR_materials_volume, metres in the mesh's space
    TextureSlot thicknessTexture;
    glm::vec3 attenuationColor = glm::vec3(1);
    float attenuationDistance = std::numeric_limits<float>::infinity(); ///< metres
    float dispersion = 0;                                               ///< KHR_materials_dispersion: 20 / Abbe number

    float clearcoatFactor = 0; ///< KHR_materials_clearcoat
    TextureSlot clearcoatTexture;
    float clearcoatRoughnessFactor = 0;
    TextureSlot clearcoatRoughnessTexture;
    TextureSlot clearcoatNormalTexture;
    float clearcoatNormalScale = 1;

    RefractionShape refraction = RefractionShape::ByShape; ///< extras.glint.refraction
    std::optional<bool> planarMirror;                      ///< extras.glint.planar: requests or forbids a mirrored view

    bool specularGlossiness = false; ///< KHR_materials_pbrSpecularGlossiness replaces metallic-roughness
    glm::vec3 specularGlossinessFactor = glm::vec3(1);
    float glossinessFactor = 1;
    TextureSlot specularGlossinessTexture;
};

// ---------------------------------------------------------------- geometry

/// The reader expands strips, loops and fans, so only lists remain.
enum class Topology : uint8_t { Triangles, Lines, Points };

constexpr uint32_t kMaxTexCoords = 2; ///< TEXCOORD_0 and _1; the reader warns about materials that use more

/// Vertices and indices ready to draw. Every vertex array is empty or as long as `positions`. The reader computes
/// missing normals and, where a normal map needs them, tangents (glTF 2.0, section 3.7.2.1).
struct Geometry {
    Topology topology = Topology::Triangles;
    std::vector<glm::vec3> positions; ///< metres
    std::vector<glm::vec3> normals;   ///< unit; empty for lines and points without normals
    std::vector<glm::vec4> tangents;  ///< xyz unit, w = handedness of the bitangent: cross(normal, tangent.xyz) * w
    std::array<std::vector<glm::vec2>, kMaxTexCoords> uvs;
    std::vector<glm::vec4> colors; ///< linear; multiplies the base colour
    std::vector<uint32_t> indices; ///< never empty for a non-empty primitive; all < positions.size()
};

/// Up to four joints per set; a primitive may have several sets (JOINTS_n, WEIGHTS_n).
struct SkinSet {
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> weights;
};

struct MorphTarget { ///< differences; each array is empty or as long as the base
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;
};

struct Primitive {
    Geometry geometry;
    int material = -1; ///< -1: glTF's default material
    /// The file has no normals: every triangle has its own vertices, and `pose` recomputes the normals.
    bool flatNormals = false;
    std::vector<SkinSet> skinSets;
    std::vector<MorphTarget> morphTargets; ///< all primitives of a mesh have the same number
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<float> weights; ///< default morph weights
};

// ---------------------------------------------------------------- cameras, lights

/// A lens; its node determines its position. Right-handed, looks down -Z.
struct Lens {
    std::string name;
    bool orthographic = false;
    float fovY = 0.8f;                                  ///< radians
    float orthoHeight = 2;                              ///< metres, whole height
    std::optional<float> aspectRatio;                   ///< width / height
    float near = 0.05f;                                 ///< metres
    float far = std::numeric_limits<float>::infinity(); ///< metres
};

enum class LightType : uint8_t { Directional, Point, Spot };

/// KHR_lights_punctual: candela for point and spot, lux for directional; shines down its node's -Z.
struct Light {
    std::string name;
    LightType type = LightType::Directional;
    glm::vec3 color = glm::vec3(1);
    float intensity = 1;
    float range = std::numeric_limits<float>::infinity(); ///< metres
    float innerConeAngle = 0;                             ///< radians
    float outerConeAngle = 0.7853982f;                    ///< radians
};

// ---------------------------------------------------------------- the node tree

struct Node {
    std::string name;
    int parent = -1;
    std::vector<int> children;
    glm::vec3 translation = glm::vec3(0);
    glm::quat rotation = glm::quat(1, 0, 0, 0);
    glm::vec3 scale = glm::vec3(1);
    std::optional<glm::mat4> matrix; ///< replaces translation, rotation and scale; such a node is never animated
    int mesh = -1;
    int skin = -1;
    int camera = -1;
    int light = -1;
    std::vector<float> weights;       ///< override the mesh's weights
    std::vector<glm::mat4> instances; ///< EXT_mesh_gpu_instancing, relative to the node; empty: drawn once
};

struct Skin {
    std::vector<int> joints; ///< nodes
    std::vector<glm::mat4> inverseBindMatrices;
};

enum class AnimationPath : uint8_t { Translation, Rotation, Scale, Weights };
enum class Interpolation : uint8_t { Step, Linear, CubicSpline };

struct AnimationChannel {
    int node = -1;
    AnimationPath path = AnimationPath::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times;  ///< seconds, strictly increasing
    std::vector<float> values; ///< in glTF's order; cubic splines store in-tangent, value, out-tangent
};

struct Animation {
    std::string name;
    std::vector<AnimationChannel> channels;
};

/// glTF allows several scenes in one file; roots are nodes.
struct SceneRoots {
    std::string name;
    std::vector<int> nodes;
};

struct Scene {
    std::string name; ///< file name or "builtin:hall"
    std::vector<Image> images;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Lens> cameras;
    std::vector<Light> lights;
    std::vector<Node> nodes;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<SceneRoots> scenes;
    int defaultScene = 0;
};

} // namespace glint::scene
