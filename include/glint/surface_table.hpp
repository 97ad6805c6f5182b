// What the triangles of a RayScene look like, so that Glint lights what rays hit by itself: glTF's metallic-roughness
// materials, textures, vertex data and lights. A host with another light model takes the hits out instead
// (glint/ray_hits.hpp).
#pragma once

#include "glint/api.hpp"
#include "glint/context.hpp"
#include "glint/view.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace glint {

namespace reflect {
class SurfaceTableState;
}

constexpr uint32_t kNoSurfaceTexture = 0xffffffff;

/// In SHADER_READ_ONLY_OPTIMAL while rays are traced. The view has all mips; the sampler repeats, filters and ends at
/// mips as it does in the host's own passes. Colours are sRGB views: sampling them gives linear values.
struct SurfaceTexture {
    VkImageView view = VK_NULL_HANDLE;
    VkSampler sampler = VK_NULL_HANDLE;
};

/// One use of a texture by a material.
struct SurfaceTextureRef {
    uint32_t index = kNoSurfaceTexture; ///< into SurfaceTableDesc::textures; none: the factor alone counts
    uint32_t texCoord = 0;              ///< SurfaceMesh::uv0 or uv1
    /// uv' = (u[0] u + u[1] v + u[2], u[3] u + u[4] v + u[5]), KHR_texture_transform
    std::array<float, 6> uvTransform = {1, 0, 0, 0, 1, 0};
};

enum class SurfaceAlpha : uint8_t {
    Opaque,
    Mask,  ///< a hole where base colour's alpha is below the cutoff; its RayInstance must not be `opaque`
    Blend, ///< lit as if opaque: leave blended surfaces out of the RayScene (mask 0)
};

/// Names, channels, units and defaults are glTF 2.0's and its extensions'.
struct SurfaceMaterial {
    SurfaceAlpha alpha = SurfaceAlpha::Opaque;
    float alphaCutoff = 0.5f;
    bool unlit = false;
    std::array<float, 4> baseColorFactor = {1, 1, 1, 1}; ///< with specularGlossiness: the diffuse factor
    SurfaceTextureRef baseColorTexture;
    float metallicFactor = 1;
    float roughnessFactor = 1;
    SurfaceTextureRef metallicRoughnessTexture; ///< roughness in g, metallic in b
    SurfaceTextureRef normalTexture;            ///< needs SurfaceMesh::tangents
    float normalScale = 1;
    SurfaceTextureRef occlusionTexture;
    float occlusionStrength = 1;
    std::array<float, 3> emissiveFactor = {0, 0, 0}; ///< times KHR_materials_emissive_strength
    SurfaceTextureRef emissiveTexture;

    float specularFactor = 1; ///< KHR_materials_specular
    SurfaceTextureRef specularTexture;
    std::array<float, 3> specularColorFactor = {1, 1, 1};
    SurfaceTextureRef specularColorTexture;
    float ior = 1.5f; ///< KHR_materials_ior; 0: infinite

    float transmissionFactor = 0; ///< takes from the diffuse part alone: what is behind is not seen in reflections
    SurfaceTextureRef transmissionTexture;

    float clearcoatFactor = 0; ///< KHR_materials_clearcoat
    float clearcoatRoughnessFactor = 0;
    SurfaceTextureRef clearcoatTexture;
    SurfaceTextureRef clearcoatRoughnessTexture;
    SurfaceTextureRef clearcoatNormalTexture;
    float clearcoatNormalScale = 1;

    bool specularGlossiness = false; ///< KHR_materials_pbrSpecularGlossiness instead of metallic-roughness
    std::array<float, 3> specularGlossinessFactor = {1, 1, 1};
    float glossinessFactor = 1;
    SurfaceTextureRef specularGlossinessTexture;
};

/// Vertex data where the host has it: in buffers made with SHADER_DEVICE_ADDRESS and STORAGE_BUFFER usage that stay
/// until the frames are done, written before what is recorded reads them in compute shaders. 32-bit floats.
struct VertexStream {
    VkDeviceAddress address = 0; ///< of vertex 0, a multiple of 4; 0: absent
    uint32_t stride = 0;         ///< bytes from vertex to vertex, a multiple of 4
};

/// The RayMesh of the same number, as seen.
struct SurfaceMesh {
    VertexStream positions; ///< x, y, z; the RayMesh's own
    VertexStream normals;   ///< x, y, z unit; absent: flat
    VertexStream tangents;  ///< x, y, z unit, w = handedness; absent: no normal maps
    VertexStream uv0;       ///< u, v; absent: 0
    VertexStream uv1;
    VertexStream colors;         ///< r, g, b, a linear, multiply the base colour; absent: white
    VkDeviceAddress indices = 0; ///< uint32, three a triangle, in the RayMesh's order
};

/// The RayInstance of the same number, as seen.
struct SurfaceInstance {
    uint32_t mesh = 0;
    uint32_t material = 0;
    Matrix4 localToWorld = kIdentity; ///< the RayInstance's own
};

enum class SurfaceLightKind : uint8_t { Directional, Point, Spot };

/// KHR_lights_punctual.
struct SurfaceLight {
    SurfaceLightKind kind = SurfaceLightKind::Directional;
    std::array<float, 3> color = {1, 1, 1}; ///< times intensity: candela (point, spot) or lux (directional)
    std::array<float, 3> positionWS = {0, 0, 0};
    std::array<float, 3> directionWS = {0, -1, 0}; ///< unit, the way the light travels
    float range = 0;                               ///< metres; 0: infinite
    float innerConeAngle = 0;                      ///< radians
    float outerConeAngle = 0.7853982f;
    bool castsShadow = true; ///< a ray asks what stands between
};

struct SurfaceTableDesc {
    std::span<const SurfaceTexture> textures;
    std::span<const SurfaceMaterial> materials; ///< at least one
    std::span<const SurfaceMesh> meshes;        ///< as many as the RayScene's
    std::span<const SurfaceInstance> instances; ///< as many as the RayScene's
    std::span<const SurfaceLight> lights;
    uint32_t maxInstances = 0; ///< most that setInstances may be given; at least as many as `instances`
    uint32_t maxLights = 0;    ///< likewise
};

/// Threading: external synchronisation.
class GLINT_API SurfaceTable {
public:
    /// Copies all but textures and vertices, which stay the host's.
    /// Errors: InvalidArgument for a number that is out of range, an address or stride that is no multiple of 4, or a
    /// mesh without positions or indices; OutOfMemory. `context` must outlive the table.
    static Result<SurfaceTable> create(Context& context, const SurfaceTableDesc& desc);
    ~SurfaceTable();
    SurfaceTable(SurfaceTable&&) noexcept;
    SurfaceTable& operator=(SurfaceTable&&) noexcept;

    /// All of them anew; take effect with the next record. Errors: InvalidArgument as in create; for meshes and
    /// materials also if there are more than at creation.
    Result<void> setInstances(std::span<const SurfaceInstance> instances);
    Result<void> setLights(std::span<const SurfaceLight> lights);
    Result<void> setMaterials(std::span<const SurfaceMaterial> materials);
    Result<void> setMeshes(std::span<const SurfaceMesh> meshes);

    /// Records what the calls above left to do, outside of rendering, before Reflections::record; nothing if there is
    /// nothing. It travels in the command buffer itself, so any number of frames may be in flight.
    void record(VkCommandBuffer commands);

    reflect::SurfaceTableState& state() { return *state_; } ///< for Glint's own classes

private:
    explicit SurfaceTable(std::unique_ptr<reflect::SurfaceTableState> state);
    std::unique_ptr<reflect::SurfaceTableState> state_;
};

} // namespace glint
