// Packs and unpacks vectors with the library's packings.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/sent_ray.glsl"
#include "lib/math.glsl"
#include "lib/ray_record.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 64) in;

struct Packed {
    vec4 direction;  // in; w: perceptual roughness
    vec4 decoded;    // through the octahedron in full precision; w: 1 if the record kept uncertain
    vec4 unpacked;   // through packSurface; w: perceptual roughness
    vec4 ray;        // in: hitUV, hit distance, reflectivity
    vec4 rayOut;     // hitUV, hit distance, reflectivity
    uvec4 counts;    // in: lookups, outcome; out: zw
    vec4 sent;       // direction and ray.x through packSentRay
    vec2 real;       // in
    ivec2 whole;     // floorToInt(real)
};
layout(scalar, set = 0, binding = 0) buffer ItemsBlock {
    Packed item[];
} items;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= items.item.length())
        return;
    Packed p = items.item[i];
    p.decoded = vec4(decodeOctahedral(encodeOctahedral(p.direction.xyz)), 0.0);
    Surface surface = unpackSurface(packSurface(Surface(p.direction.xyz, p.direction.w, p.ray.w)));
    p.unpacked = vec4(surface.normalVS, surface.perceptualRoughness);
    bool uncertain = (i & 1u) != 0u;
    RayRecord record =
        unpackRayRecord(packRayRecord(RayRecord(p.ray.xy, p.ray.z, p.counts.x, p.counts.y, uncertain)));
    p.rayOut = vec4(record.hitUV, record.hitDistance, surface.reflectivity);
    p.counts.zw = uvec2(record.lookups, record.outcome);
    p.decoded.w = record.uncertain == uncertain ? 1.0 : 0.0;
    SentRay ray = unpackSentRay(packSentRay(SentRay(p.direction.xyz, p.ray.x, true, false)));
    p.sent = vec4(ray.directionVS, ray.sent ? ray.nearness : -1.0);
    p.whole = floorToInt(p.real);
    items.item[i] = p;
}
