// The ray seam (lib/ray.glsl) over Glint's own two-level hierarchy (shared/bvh.h), traversed in compute on any device,
// without subgroup operations. A short stack of groups of siblings replaces recursion; shared/bvh.h bounds the stack.
#ifndef GLINT_RAYS_BVH_GLSL
#define GLINT_RAYS_BVH_GLSL

#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_control_flow_attributes : require

#include "lib/bvh_node.glsl"
#include "lib/ray.glsl"
#include "lib/triangle_ray.glsl"

/// Two words, declared as an address: it is read as one value of 64 bits, without the feature shaderInt64. Software drivers
/// load a word of one ray after another, and spent half of the traversal on it. GPUs merge neighbouring loads either way.
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer WordPair {
    uint unused;
};
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer BvhArray {
    WordPair pairs[];
};
// Bindings 16 to 18 belong to the scene in both back ends (RayScene's bind).
layout(std430, set = 0, binding = 16) readonly buffer BvhBlock {
    BvhAddresses at;
}
bvh;

uvec4 loadWords(BvhArray array, uint at) {
    return uvec4(uvec2(array.pairs[2u * at]), uvec2(array.pairs[2u * at + 1u]));
}

BvhNode loadNode(uint index) {
    const uint kQuads = 5u;
    BvhArray nodes = BvhArray(bvh.at.nodes);
    BvhNode node;
    [[unroll]] for (uint i = 0u; i < kQuads; ++i)
        node.words[i] = loadWords(nodes, kQuads * index + i);
    return node;
}

BvhTriangle loadTriangleOfLeaf(uint index) {
    const uint kQuads = 3u;
    BvhArray triangles = BvhArray(bvh.at.triangles);
    BvhTriangle triangle;
    [[unroll]] for (uint i = 0u; i < kQuads; ++i)
        triangle.vertices[i] = uintBitsToFloat(loadWords(triangles, kQuads * index + i));
    return triangle;
}

BvhInstance loadInstance(uint index) {
    const uint kQuads = 4u;
    BvhArray instances = BvhArray(bvh.at.instances);
    vec4 rows[3];
    [[unroll]] for (uint i = 0u; i < 3u; ++i)
        rows[i] = uintBitsToFloat(loadWords(instances, kQuads * index + i));
    uvec4 rest = loadWords(instances, kQuads * index + 3u);
    return BvhInstance(rows, rest.x, rest.y, rest.z, rest.w);
}

/// A ray in one space: world space, or the local space of the current instance.
struct BvhRay {
    BoxRay boxes;
    ShearedRay triangles;
};

BvhRay makeBvhRay(vec3 origin, vec3 direction) {
    return BvhRay(makeBoxRay(origin, direction), shearRay(origin, direction));
}

/// The ray in the local space of an instance.
BvhRay rayInInstance(BvhInstance instance, Ray ray) {
    // Subtract the translation first: near the instance little is lost by rounding, wherever in the world it is. The
    // direction keeps its world length, so distances are world distances.
    vec4 rows[3] = instance.worldToLocal;
    mat3 transposed = mat3(rows[0].xyz, rows[1].xyz, rows[2].xyz);
    return makeBvhRay((ray.originWS - vec3(rows[0].w, rows[1].w, rows[2].w)) * transposed,
                      ray.directionWS * transposed);
}

// A group is a stack entry to visit. Group of nodes: x is the first sibling; y holds the hits of intersectChildren and,
// below them, the bits of the slots that hold nodes. Group of primitives: x is the first primitive; y holds the hits,
// all below bit 24.
const uint kFirstNodeBit = 0x01000000u;

/// A group with the single node `root`.
uvec2 groupOfRoot(uint root) {
    return uvec2(root, 0x80000000u);
}

/// The largest component of the result is 1.
vec3 normalOf(BvhTriangle triangle, uint axis) {
    vec2 others = vec2(triangle.vertices[1].w, triangle.vertices[2].w);
    return axis == 0u ? vec3(1.0, others) : axis == 1u ? vec3(others.x, 1.0, others.y) : vec3(others, 1.0);
}

TriangleHit intersectLeaf(ShearedRay ray, BvhTriangle triangle, uint axis) {
    return intersectTriangle(ray, triangle.vertices[0].xyz, triangle.vertices[1].xyz, triangle.vertices[2].xyz,
                             normalOf(triangle, axis));
}

bool isCulled(Ray ray, TriangleHit met, uint instanceFlags) {
    return (ray.flags & kRayCullBackFaces) != 0u && !met.frontFace && (instanceFlags & kBvhInstanceDoubleSided) == 0u;
}

/// Returns the nearest hit or, with `any`, the first hit found.
Hit traverseBvh(Ray ray, bool any) {
    Hit hit = missOf(ray);
    if (!isTraceable(ray))
        return hit;
    BvhRay current = makeBvhRay(ray.originWS, ray.directionWS);
    bool inInstance = false;
    uint instanceNumber = kNoInstance;
    uint instanceFlags = 0u;
    uvec2 stack[kBvhStackSize];
    uint height = 0u;
    uint instanceHeight = 0u; // height of the stack when the instance was entered
    uvec2 nodes = groupOfRoot(0u);
    uvec2 primitives = uvec2(0u);

    while (true) {
        if (nodes.y >= kFirstNodeBit) {
            uint bit = uint(findMSB(nodes.y));
            nodes.y ^= 1u << bit;
            if (nodes.y >= kFirstNodeBit)
                stack[height++] = nodes;
            uint slot = (bit - 24u) ^ current.boxes.order;
            uint before = bitCount(nodes.y & 0xffu & ((1u << slot) - 1u));
            BvhNode node = loadNode(nodes.x + before);
            uint hits = intersectChildren(node, current.boxes, ray.tMin, hit.distance);
            nodes = uvec2(node.words[1].x, (hits & 0xff000000u) | node.words[0].w >> 24);
            primitives = uvec2(node.words[1].y, hits & 0x00ffffffu);
        }

        while (primitives.y != 0u) {
            uint index = primitives.x + uint(findLSB(primitives.y));
            primitives.y &= primitives.y - 1u;
            if (!inInstance) {
                BvhInstance instance = loadInstance(index);
                if ((instance.maskAndFlags & ray.mask & 0xffu) == 0u)
                    continue;
                if (nodes.y >= kFirstNodeBit)
                    stack[height++] = nodes;
                if (primitives.y != 0u)
                    stack[height++] = primitives;
                inInstance = true;
                instanceHeight = height;
                instanceNumber = instance.number;
                instanceFlags = instance.maskAndFlags;
                current = rayInInstance(instance, ray);
                nodes = groupOfRoot(instance.rootNode);
                primitives.y = 0u;
                continue;
            }
            BvhTriangle triangle = loadTriangleOfLeaf(index);
            uint numberAndAxis = floatBitsToUint(triangle.vertices[0].w);
            TriangleHit met = intersectLeaf(current.triangles, triangle, numberAndAxis >> kBvhNormalAxisShift);
            if (!met.met || !(met.distance > ray.tMin) || !(met.distance < hit.distance))
                continue;
            if (isCulled(ray, met, instanceFlags))
                continue;
            uint primitive = numberAndAxis & ((1u << kBvhNormalAxisShift) - 1u);
            bool ask = (ray.flags & kRayAllOpaque) == 0u && (instanceFlags & kBvhInstanceOpaque) == 0u;
            if (ask && !rayMeetsSurface(instanceNumber, primitive, met.barycentrics))
                continue;
            hit = Hit(met.distance, instanceNumber, primitive, met.barycentrics, met.frontFace);
            if (any)
                return hit;
        }

        if (nodes.y < kFirstNodeBit) {
            if (inInstance && height == instanceHeight) {
                inInstance = false;
                current = makeBvhRay(ray.originWS, ray.directionWS);
            }
            if (height == 0u)
                return hit;
            uvec2 group = stack[--height];
            bool isNodes = group.y >= kFirstNodeBit;
            nodes = isNodes ? group : uvec2(0u);
            primitives = isNodes ? uvec2(0u) : group;
        }
    }
}

Hit traceRay(Ray ray) {
    return traverseBvh(ray, false);
}

bool isOccluded(Ray ray) {
    return isHit(traverseBvh(ray, true));
}

#endif
