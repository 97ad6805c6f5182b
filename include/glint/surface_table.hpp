// SPDX-License-Identifier: MIT
// Materials, textures, vertex data and lights for the triangles of a RayScene, with which Glint shades ray hits. The
// material model is glTF's metallic-roughness. A host with another lighting model shades hits itself
// (glint/ray_hits.hpp).
#pragma once

#include "glint/api.h"
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

/// A texture of the host. Requires the layout SHADER_READ_ONLY_OPTIMAL while rays are traced, a view of all mips, and
/// the sampler of the host's own passes (wrap mode, filter, mip limit). Colour textures require sRGB views, so that
/// sampling returns linear values.
struct SurfaceTexture {
    VkImageView view = VK_NULL_HANDLE;
    VkSampler sampler = VK_NULL_HANDLE;
};

/// One use of a texture by a material.
struct SurfaceTextureRef {
    uint32_t index = kNoSurfaceTexture; ///< into SurfaceTableDesc::textures; kNoSurfaceTexture: the factor only
    uint32_t texCoord = 0;              ///< 0: SurfaceMesh::uv0, 1: uv1
    /// uv' = (u[0] u + u[1] v + u[2], u[3] u + u[4] v + u[5]), KHR_texture_transform
    std::array<float, 6> uvTransform = {1, 0, 0, 0, 1, 0};
};

enum class SurfaceAlpha : uint8_t {
    Opaque,
    Mask,  ///< a hole where the base colour's alpha is below the cutoff; requires RayInstance::opaque false
    Blend, ///< the base colour's alpha is coverage: rays continue behind it; requires RayInstance::opaque false
};

/// A material. Names, channels, units and defaults follow glTF 2.0 and its extensions.
struct SurfaceMaterial {
    SurfaceAlpha alpha = SurfaceAlpha::Opaque;
    float alphaCutoff = 0.5f;
    bool unlit = false;
    std::array<float, 4> baseColorFactor = {1, 1, 1, 1}; ///< with specularGlossiness: the diffuse factor
    SurfaceTextureRef baseColorTexture;
    float metallicFactor = 1;
    float roughnessFactor = 1;
    SurfaceTextureRef metallicRoughnessTexture; ///< roughness in g, metallic in b
    SurfaceTextureRef normalTexture;            ///< requires SurfaceMesh::tangents
    float normalScale = 1;
    SurfaceTextureRef occlusionTexture;
    float occlusionStrength = 1;
    std::array<float, 3> emissiveFactor = {0, 0, 0}; ///< multiplied by KHR_materials_emissive_strength
    SurfaceTextureRef emissiveTexture;

    float specularFactor = 1; ///< KHR_materials_specular
    SurfaceTextureRef specularTexture;
    std::array<float, 3> specularColorFactor = {1, 1, 1};
    SurfaceTextureRef specularColorTexture;
    float ior = 1.5f; ///< KHR_materials_ior; 0: infinite

    /// KHR_materials_transmission. Above 0 rays pass through the surface, limited by rays.transparents; this requires
    /// RayInstance::opaque false.
    float transmissionFactor = 0;
    SurfaceTextureRef transmissionTexture;
    /// KHR_materials_volume, metres in the mesh's local space. Above 0 the mesh is the surface of a body, which
    /// refracts light where it enters and leaves. 0: a thin wall without refraction.
    float thicknessFactor = 0;
    SurfaceTextureRef thicknessTexture;
    std::array<float, 3> attenuationColor = {1, 1, 1};
    float attenuationDistance = 0; ///< metres in world space; 0 or infinite: no absorption

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

/// Vertex data in the host's buffers, 32-bit floats. Requires SHADER_DEVICE_ADDRESS and STORAGE_BUFFER usage, and that
/// the buffers exist until the frames that use them are done. The host's writes must be visible to the compute shaders
/// of the recorded passes.
struct VertexStream {
    VkDeviceAddress address = 0; ///< address of vertex 0, a multiple of 4; 0: absent
    uint32_t stride = 0;         ///< bytes from vertex to vertex, a multiple of 4
};

/// Vertex data for shading the RayMesh of the same index; in an adopted RayScene, one geometry of a bottom level.
struct SurfaceMesh {
    VertexStream positions; ///< x, y, z; same as the RayMesh's
    VertexStream normals;   ///< x, y, z unit; absent: flat shading
    VertexStream tangents;  ///< x, y, z unit, w = handedness; absent: no normal maps
    VertexStream uv0;       ///< u, v; absent: 0
    VertexStream uv1;
    VertexStream colors;         ///< linear r, g, b, a, multiplied into the base colour; absent: white
    VkDeviceAddress indices = 0; ///< uint32, three per triangle, in the RayMesh's order
    /// Positions in the previous frame, for meshes that deform; absent: same as `positions`.
    VertexStream previousPositions;
};

/// Material and transform for shading the RayInstance of the same index; in an adopted RayScene, the hits of the same
/// number (InstanceNumbering). An instance that keeps its index and its mesh
/// from frame to frame is one that moves; denoise.hitMotion follows it in reflections.
struct SurfaceInstance {
    uint32_t mesh = 0;
    uint32_t material = 0;
    /// Same as the RayInstance's, which an adopted RayScene does not have. Emissive triangles and denoise.hitMotion use
    /// it.
    Matrix4 localToWorld = kIdentity;
};

enum class SurfaceLightKind : uint8_t { Directional, Point, Spot };

/// A light of KHR_lights_punctual.
struct SurfaceLight {
    SurfaceLightKind kind = SurfaceLightKind::Directional;
    std::array<float, 3> color = {1, 1, 1}; ///< multiplied by intensity: candela (point, spot) or lux (directional)
    std::array<float, 3> positionWS = {0, 0, 0};
    std::array<float, 3> directionWS = {0, -1, 0}; ///< unit, the direction in which light travels
    float range = 0;                               ///< metres; 0: infinite
    float innerConeAngle = 0;                      ///< radians
    float outerConeAngle = 0.7853982f;
    bool castsShadow = true; ///< true: trace a shadow ray to the light
};

struct SurfaceTableDesc {
    std::span<const SurfaceTexture> textures;
    std::span<const SurfaceMaterial> materials; ///< at least one
    std::span<const SurfaceMesh> meshes;        ///< as many as the RayScene's; any number if it is adopted
    std::span<const SurfaceInstance> instances; ///< as many as the RayScene's
    std::span<const SurfaceLight> lights;
    uint32_t maxInstances = 0; ///< maximum count for setInstances; raised to the count of `instances`
    uint32_t maxLights = 0;    ///< maximum count for setLights; raised to the count of `lights`
};

/// Shading data of a RayScene for Reflections::setRays. Threading: external synchronization.
class GLINT_API SurfaceTable {
public:
    /// Copies all data except textures and vertex data, which the host keeps.
    /// Errors: InvalidArgument for an index out of range, an address or stride that is not a multiple of 4, or a mesh
    /// without positions or indices; OutOfMemory.
    static Result<SurfaceTable> create(Context& context, const SurfaceTableDesc& desc);
    ~SurfaceTable();
    SurfaceTable(SurfaceTable&&) noexcept;
    SurfaceTable& operator=(SurfaceTable&&) noexcept;

    /// Each of these four functions replaces a whole list. It takes effect with the next record.
    /// Errors: InvalidArgument as in create; setInstances and setLights: for more than maxInstances or maxLights;
    /// setMaterials and setMeshes: for more than in create.
    Result<void> setInstances(std::span<const SurfaceInstance> instances);
    Result<void> setLights(std::span<const SurfaceLight> lights);
    Result<void> setMaterials(std::span<const SurfaceMaterial> materials);
    Result<void> setMeshes(std::span<const SurfaceMesh> meshes);

    /// Each of these two functions replaces the items from `first` on, as many as are given, and uploads these alone.
    /// Errors: InvalidArgument as in create, and for items after the list's last one.
    Result<void> updateInstances(uint32_t first, std::span<const SurfaceInstance> instances);
    Result<void> updateMaterials(uint32_t first, std::span<const SurfaceMaterial> materials);

    /// Records the pending updates of the calls above, outside of rendering; without pending updates it records
    /// nothing. Call it before Reflections::record. Updates are stored in the command buffer itself, so any number of
    /// frames may be in flight.
    void record(VkCommandBuffer commands);

    reflect::SurfaceTableState& state() { return *state_; } ///< for Glint's own classes

private:
    explicit SurfaceTable(std::unique_ptr<reflect::SurfaceTableState> state);
    std::unique_ptr<reflect::SurfaceTableState> state_;
};

} // namespace glint
