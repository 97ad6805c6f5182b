// The appearance of triangles: the host's instances, meshes, materials and textures (glint/surface_table.hpp), and the
// texel test of the ray seam. Include before rays/back_end.glsl.
#ifndef GLINT_RAYS_SURFACE_TABLE_GLSL
#define GLINT_RAYS_SURFACE_TABLE_GLSL

#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_nonuniform_qualifier : require

#include "lib/material.glsl"
#include "shared/surface_table.h"

#define GLINT_RAY_ALPHA_TEST

/// Defined by the entry. True if alpha-tested surfaces have holes.
bool rayAsksHoles();

layout(scalar, set = 0, binding = 19) readonly buffer SurfaceInstancesBlock {
    SurfaceInstanceRecord item[];
}
surfaceInstances;
layout(scalar, set = 0, binding = 20) readonly buffer SurfaceMeshesBlock {
    SurfaceMeshRecord item[];
}
surfaceMeshes;
layout(scalar, set = 0, binding = 21) readonly buffer SurfaceMaterialsBlock {
    Material item[];
}
surfaceMaterials;
layout(set = 1, binding = 0) uniform sampler2D textures[];

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer FloatStream {
    float item[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer UintStream {
    uint item[];
};

// ---------------------------------------------------------------- textures

/// Change of UVs across the ray's cone, along both axes of the ellipse that the cone cuts from the surface; indexed by
/// texCoord.
struct UvFootprint {
    vec2 along;
    vec2 across;
};
UvFootprint uvFootprint[2] = UvFootprint[2](UvFootprint(vec2(0.0), vec2(0.0)), UvFootprint(vec2(0.0), vec2(0.0)));

/// Most taps along the longer axis of a stretched footprint.
const float kMostTaps = 4.0;

/// The mean over the footprint: taps along its longer axis, each from the mip in which the tap covers one texel.
/// Heckbert 1989, "Fundamentals of Texture Mapping and Image Warping". Computed by hand, because drivers differ in
/// textureGrad.
vec4 sampleTexture(TextureRef ref, vec2 uv) {
    UvFootprint footprint = uvFootprint[min(ref.texCoord, 1u)];
    vec2 along = vec2(0.0);
    float taps = 1.0;
    float lod = 0.0;
    if (footprint.along != vec2(0.0)) {
        mat2 turned = mat2(ref.uvRow0.x, ref.uvRow1.x, ref.uvRow0.y, ref.uvRow1.y);
        vec2 size = vec2(textureSize(textures[nonuniformEXT(ref.index)], 0));
        along = turned * footprint.along;
        vec2 across = turned * footprint.across;
        float alongTexels = length(along * size);
        float acrossTexels = length(across * size);
        if (acrossTexels > alongTexels) {
            along = across;
            float shorter = alongTexels;
            alongTexels = acrossTexels;
            acrossTexels = shorter;
        }
        taps = clamp(ceil(alongTexels / max(acrossTexels, 1.0)), 1.0, kMostTaps);
        lod = log2(max(alongTexels / taps, 1e-6));
    }
    vec4 sum = vec4(0.0);
    for (float tap = 0.5; tap < taps; tap += 1.0)
        sum += textureLod(textures[nonuniformEXT(ref.index)], uv + along * (tap / taps - 0.5), lod);
    return sum / taps;
}

void setSharpest() {
    uvFootprint[0] = uvFootprint[1] = UvFootprint(vec2(0.0), vec2(0.0));
}

// ---------------------------------------------------------------- vertices

bool isPresent(StreamRecord stream) {
    return (stream.address.x | stream.address.y) != 0u;
}

vec2 load2(StreamRecord stream, uint vertex) {
    FloatStream data = FloatStream(stream.address);
    uint at = vertex * stream.stride;
    return vec2(data.item[at], data.item[at + 1u]);
}

vec3 load3(StreamRecord stream, uint vertex) {
    FloatStream data = FloatStream(stream.address);
    uint at = vertex * stream.stride;
    return vec3(data.item[at], data.item[at + 1u], data.item[at + 2u]);
}

vec4 load4(StreamRecord stream, uint vertex) {
    FloatStream data = FloatStream(stream.address);
    uint at = vertex * stream.stride;
    return vec4(data.item[at], data.item[at + 1u], data.item[at + 2u], data.item[at + 3u]);
}

uvec3 loadTriangle(SurfaceMeshRecord mesh, uint primitive) {
    UintStream data = UintStream(mesh.indices);
    return uvec3(data.item[3u * primitive], data.item[3u * primitive + 1u], data.item[3u * primitive + 2u]);
}

/// A vertex attribute at a point of a triangle; `absent` everywhere if the mesh lacks the attribute.
vec2 interpolate2(StreamRecord stream, uvec3 triangle, vec3 weights, vec2 absent) {
    if (!isPresent(stream))
        return absent;
    return load2(stream, triangle.x) * weights.x + load2(stream, triangle.y) * weights.y +
           load2(stream, triangle.z) * weights.z;
}

vec3 interpolate3(StreamRecord stream, uvec3 triangle, vec3 weights, vec3 absent) {
    if (!isPresent(stream))
        return absent;
    return load3(stream, triangle.x) * weights.x + load3(stream, triangle.y) * weights.y +
           load3(stream, triangle.z) * weights.z;
}

vec4 interpolate4(StreamRecord stream, uvec3 triangle, vec3 weights, vec4 absent) {
    if (!isPresent(stream))
        return absent;
    return load4(stream, triangle.x) * weights.x + load4(stream, triangle.y) * weights.y +
           load4(stream, triangle.z) * weights.z;
}

vec3 weightsOf(vec2 barycentrics) {
    return vec3(1.0 - barycentrics.x - barycentrics.y, barycentrics);
}

/// Change of an attribute along an offset, given as weights of the second and third vertex.
vec2 change2(StreamRecord stream, uvec3 triangle, vec2 weights) {
    return interpolate2(stream, triangle, vec3(-weights.x - weights.y, weights), vec2(0.0));
}

vec3 change3(StreamRecord stream, uvec3 triangle, vec2 weights) {
    return interpolate3(stream, triangle, vec3(-weights.x - weights.y, weights), vec3(0.0));
}

// ---------------------------------------------------------------- hits

/// Whether the following rays test transparent surfaces in rayMeetsSurface. Shadow rays pass transparent surfaces.
bool rayMeetsTransparents = false;

bool isTransparent(Material material) {
    const uint kNoTransmission = kMaterialUnlit | kMaterialSpecularGlossiness;
    return (material.flags & kMaterialAlphaBlend) != 0u ||
           (material.transmissionFactor > 0.0 && (material.flags & kNoTransmission) == 0u);
}

Material instanceMaterial(uint instance) {
    return surfaceMaterials.item[surfaceInstances.item[instance].material];
}

/// False where the material has a hole: the test of the ray seam (lib/ray.glsl).
bool rayMeetsSurface(uint instance, uint primitive, vec2 barycentrics) {
    SurfaceInstanceRecord placed = surfaceInstances.item[instance];
    Material material = surfaceMaterials.item[placed.material];
    if (isTransparent(material) && !rayMeetsTransparents)
        return false;
    if ((material.flags & kMaterialAlphaMask) == 0u || !rayAsksHoles())
        return true;
    SurfaceMeshRecord mesh = surfaceMeshes.item[placed.mesh];
    uvec3 triangle = loadTriangle(mesh, primitive);
    vec3 weights = weightsOf(barycentrics);
    setSharpest();
    SurfacePoint point = SurfacePoint(vec3(0.0), vec3(0.0), vec4(0.0), vec2(0.0), vec2(0.0), vec4(1.0), true);
    point.uv0 = interpolate2(mesh.uv0, triangle, weights, vec2(0.0));
    point.uv1 = interpolate2(mesh.uv1, triangle, weights, vec2(0.0));
    point.color = interpolate4(mesh.colors, triangle, weights, vec4(1.0));
    return sampleBaseColor(material, point).a >= material.alphaCutoff;
}

/// A ray's hit: the point as rasterization would interpolate it, and the triangle itself.
struct HitSurface {
    SurfacePoint point;
    vec3 faceNormalWS; // unit, of the triangle, towards the side from which the ray came
    Material material;
    float area;  // of the triangle, in world space
    float scale; // metres in world space for each metre in mesh space
    float bend;  // radians that the normal turns for each metre across the ray, root mean square of both axes
};

/// `coneWidthWS`: width of the ray at the hit, metres. Sets the footprint that sampleTexture filters over.
HitSurface hitSurface(uint instance, uint primitive, vec2 barycentrics, bool frontFace, vec3 directionWS,
                      float coneWidthWS) {
    SurfaceInstanceRecord placed = surfaceInstances.item[instance];
    SurfaceMeshRecord mesh = surfaceMeshes.item[placed.mesh];
    uvec3 triangle = loadTriangle(mesh, primitive);
    vec3 weights = weightsOf(barycentrics);
    mat3 linear = transpose(mat3(placed.localToWorld[0].xyz, placed.localToWorld[1].xyz, placed.localToWorld[2].xyz));
    vec3 translation = vec3(placed.localToWorld[0].w, placed.localToWorld[1].w, placed.localToWorld[2].w);
    // As in render/surface.vert: the cofactor matrix, and the sign of the determinant.
    mat3 cofactor = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    float side = dot(linear[0], cofactor[0]) < 0.0 ? -1.0 : 1.0;

    vec3 a = load3(mesh.positions, triangle.x);
    vec3 u = load3(mesh.positions, triangle.y) - a;
    vec3 v = load3(mesh.positions, triangle.z) - a;
    vec3 areaNormalWS = cofactor * cross(u, v) * side; // its length is twice the triangle's area in the world
    float area2 = length(areaNormalWS);
    vec3 frontNormalWS = normalizeOr(areaNormalWS, -directionWS);

    HitSurface result;
    result.material = surfaceMaterials.item[placed.material];
    result.scale = (length(linear[0]) + length(linear[1]) + length(linear[2])) / 3.0;
    result.area = 0.5 * area2;
    result.faceNormalWS = frontFace ? frontNormalWS : -frontNormalWS;
    result.point.positionWS = linear * (a + (u * weights.y + v * weights.z)) + translation;
    vec3 normalWS = cofactor * interpolate3(mesh.normals, triangle, weights, vec3(0.0)) * side;
    result.point.normalWS = normalizeOr(normalWS, frontNormalWS);
    vec4 tangent = interpolate4(mesh.tangents, triangle, weights, vec4(0.0));
    result.point.tangentWS = vec4(linear * tangent.xyz, tangent.w * side);
    result.point.uv0 = interpolate2(mesh.uv0, triangle, weights, vec2(0.0));
    result.point.uv1 = interpolate2(mesh.uv1, triangle, weights, vec2(0.0));
    result.point.color = interpolate4(mesh.colors, triangle, weights, vec4(1.0));
    result.point.frontFacing = frontFace;

    // The ellipse that the cone cuts from the surface's plane. Akenine-Moller et al. 2021, "Improved Shader and Texture
    // Level of Detail Using Ray Cones", JCGT 10(1), section 5.
    vec3 along = directionWS - frontNormalWS * dot(frontNormalWS, directionWS);
    along = normalizeOr(along, orthonormalBasis(frontNormalWS)[0]);
    vec3 across = cross(frontNormalWS, along);
    along /= max(length(along - directionWS * dot(directionWS, along)), 1e-2); // a metre across the ray
    vec3 uWS = linear * u;
    vec3 vWS = linear * v;
    vec3 toWeightU =
        cross(vWS, frontNormalWS) / max(area2, 1e-30) * side; // dot with an offset in the plane: its weight of u
    vec3 toWeightV = cross(frontNormalWS, uWS) / max(area2, 1e-30) * side;
    vec2 weightsAlong = vec2(dot(along, toWeightU), dot(along, toWeightV));
    vec2 weightsAcross = vec2(dot(across, toWeightU), dot(across, toWeightV));
    vec3 turnAlong = cofactor * change3(mesh.normals, triangle, weightsAlong);
    vec3 turnAcross = cofactor * change3(mesh.normals, triangle, weightsAcross);
    float turn2 = dot(turnAlong, turnAlong) + dot(turnAcross, turnAcross);
    result.bend = sqrt(0.5 * turn2 / max(dot(normalWS, normalWS), 1e-30));
    weightsAlong *= coneWidthWS;
    weightsAcross *= coneWidthWS;
    uvFootprint[0] = UvFootprint(change2(mesh.uv0, triangle, weightsAlong), change2(mesh.uv0, triangle, weightsAcross));
    uvFootprint[1] = UvFootprint(change2(mesh.uv1, triangle, weightsAlong), change2(mesh.uv1, triangle, weightsAcross));
    return result;
}

#endif
