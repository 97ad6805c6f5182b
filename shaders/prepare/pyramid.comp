// Builds every level of the depth pyramid (lib/pyramid.glsl) in one dispatch. Each group reduces a tile of 64 pixels to
// one cell of level 6; the group that finishes last reduces those cells. Runs if there are rays to trace, or layers
// whose rays may follow.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/back_face.glsl"
#include "lib/nearness.glsl"
#include "lib/pyramid.glsl"
#include "lib/surface.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 16, local_size_y = 16) in; // a thread reduces 4 x 4 pixels

layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform sampler2D backViewZ; // with kTraceBackInPlace the host's depth
layout(set = 0, binding = 3, rgba32ui) uniform writeonly uimage2D pyramid;
layout(scalar, set = 0, binding = 4) coherent buffer TilesBlock {
    uint finishedGroups; // 0 before and after the dispatch
    uint padding[3];
    uvec4 cells[]; // level 6; then the levels above it, in turn behind and in its place
} tiles;
layout(set = 0, binding = 5) uniform usampler2D surface;
layout(push_constant, scalar) uniform PushBlock {
    PyramidConstants settings;
};

shared uvec4 sharedCells[256];
shared bool isLastGroup;

/// A step of nearness from pixel to pixel that counts as an edge, as a fraction of the nearness.
const float kEdge = 0.05;

ivec2 size;
float width;

// ---------------------------------------------------------------- a cell from its parts

/// The nearest half, never a denormal one. Uses the bits, because compilers treat packing and unpacking as a no-op.
float asHalf(float value) {
    const float kSmallest = 1.0 / 16384.0; // below it drivers may round to 0
    value = clamp(value, -60000.0, 60000.0);
    return abs(value) < kSmallest ? 0.0 : uintBitsToFloat((floatBitsToUint(value) + 0x1000u) & 0xffffe000u);
}

/// True if the four pixels of a cell show flat faces that meet in a corner, each in front of the other's plane. On a
/// curved surface, planes do not predict the surface a pixel away; neither does a face beyond a convex edge.
bool isCorner(vec3 positions[4], vec3 normals[4]) {
    const float kFlat = 0.9995; // cosine of 2 degrees
    const float kAngle = 0.9;   // of 25 degrees
    bool meets = false;
    for (int i = 0; i < 4; ++i)
        for (int k = i + 1; k < 4; ++k) {
            float cosine = dot(normals[i], normals[k]);
            if (cosine >= kFlat)
                continue;
            vec3 apart = positions[k] - positions[i];
            if (cosine > kAngle || dot(normals[i], apart) < 0.0 || dot(normals[k], apart) > 0.0)
                return false;
            meets = true;
        }
    return meets;
}

/// How much deeper than at its centre rays may hit a pixel's own plane, in nearness over a plane of `slope`: rays hit
/// the plane anywhere in the pixel, and up to a pixel before.
float ownReach(vec3 positionVS, vec3 normalVS, vec2 slope) {
    const float kReach = 1.5; // pixels from the centre
    vec2 apart = abs(nearnessSlope(frame.constants, positionVS, normalVS) - slope);
    float most = kEdge * abs(nearnessOf(frame.constants, -positionVS.z)); // planes seen edge-on give no bound
    return min(kReach * (apart.x + apart.y), most);
}

/// Where a cell shows one plane, rays hit its pixels' planes on that plane. In a corner the cell's plane is none of the
/// pixels' planes: a ray that passes close above one surface would be classified as behind it.
void reachIntoCorner(ivec2 cell, vec2 slope, float z[4], inout vec2 solids[4]) {
    vec3 positions[4];
    vec3 normals[4];
    uvec2 packed[4];
    bool differ = false;
    for (int i = 0; i < 4; ++i) {
        packed[i] = texelFetch(surface, cell * 2 + ivec2(i & 1, i >> 1), 0).xy;
        differ = differ || !haveOneNormal(packed[i], packed[0]);
    }
    if (!differ) // most cells: one flat face
        return;
    for (int i = 0; i < 4; ++i) {
        vec2 uv = (vec2(cell * 2 + ivec2(i & 1, i >> 1)) + 0.5) * frame.constants.invSize;
        positions[i] = viewPosition(frame.constants, uv, z[i]);
        normals[i] = unpackSurface(packed[i]).normalVS;
    }
    if (!isCorner(positions, normals))
        return;
    for (int i = 0; i < 4; ++i)
        solids[i].y -= ownReach(positions[i], normals[i], slope);
}

/// The slope as it will be read back: bounds are computed for that slope.
vec2 storedSlope(vec2 slope) {
    return vec2(asHalf(slope.x * width), asHalf(slope.y * width)) / width;
}

float slabNearness(ivec2 px, float z, bool orthographic) {
    float reach = z;
    if ((settings.flags & kTraceBackDepth) != 0u) {
        float backZ = texelFetch(backViewZ, px, 0).r;
        if ((settings.flags & kTraceBackInPlace) != 0u)
            backZ = storedViewZ(frame.constants, backViewZOf(frame.constants, backZ, z));
        if (backZ < kBackgroundZ)
            reach = backZ;
    }
    return nearnessOf(orthographic, reach + settings.thickness + settings.thicknessRelative * z);
}

/// A cell of the image (`broken`), or outside of the image.
Cell emptyCell(bool broken) {
    Cell cell = Cell(kEmptyCell, broken ? kBroken : 0.0, 0.0, vec2(0.0), vec2[4](vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0)));
    for (int i = 0; i < 4; ++i)
        cell.quarters[i] = vec2(1.0, 0.0);
    return cell;
}

/// The values that a cell above needs of this one, exactly.
uvec4 packShared(Cell cell) {
    return uvec4(floatBitsToUint(cell.front), floatBitsToUint(cell.depth), floatBitsToUint(cell.slab),
                 packSlope(cell.slope, width));
}

Cell unpackShared(uvec4 packed) {
    Cell cell = emptyCell(false);
    cell.front = uintBitsToFloat(packed.x);
    cell.depth = uintBitsToFloat(packed.y);
    cell.slab = uintBitsToFloat(packed.z);
    cell.slope = unpackHalf2x16(packed.w) / width;
    return cell;
}

/// Builds a cell from its quarters. Each quarter gives its solid range in nearness above the cell's plane of front 0
/// (from the nearest down).
Cell cellOfQuarters(vec2 slope, vec2 solids[4], bool there[4], float lowestFront, bool broken) {
    Cell cell = emptyCell(false);
    cell.slope = slope;
    float lowest = 1e37;
    for (int i = 0; i < 4; ++i)
        if (there[i]) {
            cell.front = max(cell.front, solids[i].x);
            lowest = min(lowest, solids[i].y);
        }
    for (int i = 0; i < 4; ++i)
        if (there[i])
            cell.quarters[i] = cell.front - solids[i];
    cell.depth = broken ? kBroken : cell.front - lowestFront;
    cell.slab = cell.front - lowest;
    return cell;
}

/// Level 1 at `cell`, from its pixels.
Cell cellOfPixels(ivec2 cell) {
    bool orthographic = isOrthographic(frame.constants);
    vec2 solids[4];
    float depths[4]; // viewZ
    bool seen[4];
    bool all4 = true;
    bool broken = false;
    bool any4 = false;
    for (int i = 0; i < 4; ++i) {
        ivec2 px = cell * 2 + ivec2(i & 1, i >> 1);
        bool inside = all(lessThan(px, size));
        float z = inside ? texelFetch(viewZ, px, 0).r : kBackgroundZ;
        depths[i] = z;
        seen[i] = z < kBackgroundZ;
        solids[i] = seen[i] ? vec2(nearnessOf(orthographic, z), slabNearness(px, z, orthographic)) : vec2(0.0);
        all4 = all4 && seen[i];
        any4 = any4 || seen[i];
        broken = broken || (inside && !seen[i]);
    }
    if (!any4)
        return emptyCell(broken);
    float nearest = max(max(solids[0].x, solids[1].x), max(solids[2].x, solids[3].x));
    float farthest = min(min(solids[0].x, solids[1].x), min(solids[2].x, solids[3].x));
    bool joined = all4 && nearest - farthest <= kEdge * abs(nearest);
    vec2 slope = vec2(0.0);
    if (all4)
        slope = storedSlope(0.5 * vec2(solids[1].x - solids[0].x + solids[3].x - solids[2].x,
                                       solids[2].x - solids[0].x + solids[3].x - solids[1].x));
    // Four pixels on both sides of an edge lie on a steep plane too, but between their centres there is no surface.
    if (max(abs(slope.x), abs(slope.y)) > kEdge * abs(solids[0].x))
        slope = vec2(0.0);
    float low = 1e37;
    for (int i = 0; i < 4; ++i) {
        solids[i] -= dot(slope, vec2(i & 1, i >> 1) - 0.5);
        if (seen[i])
            low = min(low, solids[i].x);
    }
    if (joined)
        reachIntoCorner(cell, slope, depths, solids);
    return cellOfQuarters(slope, solids, seen, low, broken);
}

/// One cell from four of half its size, about planes of this slope.
Cell boundCells(Cell children[4], float childSize, vec2 slope) {
    vec2 solids[4];
    bool there[4];
    float low = 1e37;
    bool broken = false;
    for (int i = 0; i < 4; ++i) {
        Cell child = children[i];
        broken = broken || child.depth >= kBroken;
        there[i] = child.front > kEmptyCell;
        // Two planes differ most at a corner of the pixels' centres.
        vec2 tilt = abs(child.slope - slope);
        float apart = (tilt.x + tilt.y) * 0.5 * (childSize - 1.0);
        float front = child.front - dot(slope, (vec2(i & 1, i >> 1) - 0.5) * childSize);
        solids[i] = vec2(front + apart, front - child.slab - apart);
        if (there[i])
            low = min(low, front - (child.depth >= kBroken ? 0.0 : child.depth) - apart);
    }
    return cellOfQuarters(slope, solids, there, low, broken);
}

float solidIn(Cell cell) {
    float sum = 0.0;
    for (int i = 0; i < 4; ++i)
        sum += max(cell.quarters[i].y - cell.quarters[i].x, 0.0);
    return sum;
}

/// One cell from four of half its size, `childSize` pixels a side, in the order (0,0), (1,0), (0,1), (1,1). Uses the
/// planes with the smallest solid range among those of the four and their mean.
Cell cellOfCells(Cell children[4], float childSize) {
    vec2 mean = vec2(0.0);
    float count = 0.0;
    bool broken = false;
    for (int i = 0; i < 4; ++i) {
        broken = broken || children[i].depth >= kBroken;
        if (children[i].front > kEmptyCell) {
            mean += children[i].slope;
            count += 1.0;
        }
    }
    if (count == 0.0)
        return emptyCell(broken);
    Cell best = boundCells(children, childSize, storedSlope(mean / count));
    for (int i = 0; i < 4; ++i)
        if (children[i].front > kEmptyCell) {
            Cell other = boundCells(children, childSize, children[i].slope);
            if (solidIn(other) < solidIn(best))
                best = other;
        }
    return best;
}

// ---------------------------------------------------------------- levels

void store(int level, ivec2 cell, Cell value) {
    if (level <= int(settings.levels) && all(lessThan(cell, pyramidLevelSize(size, level))))
        imageStore(pyramid, pyramidOffset(size, level) + cell, packCell(value, width));
}

void reduceTile() {
    ivec2 thread = ivec2(gl_LocalInvocationID.xy);
    ivec2 level2 = ivec2(gl_WorkGroupID.xy) * 16 + thread;
    Cell children[4];
    for (int i = 0; i < 4; ++i) {
        ivec2 cell = level2 * 2 + ivec2(i & 1, i >> 1);
        children[i] = cellOfPixels(cell);
        store(1, cell, children[i]);
    }
    int across = 32; // cells a side of the level below
    for (int level = 2; level <= int(kPyramidTileLevel); ++level) {
        int half_ = across / 2;
        bool works = all(lessThan(thread, ivec2(half_)));
        Cell value;
        if (works) {
            for (int i = 0; i < 4 && level > 2; ++i) {
                ivec2 child = thread * 2 + ivec2(i & 1, i >> 1);
                children[i] = unpackShared(sharedCells[child.y * across + child.x]);
            }
            value = cellOfCells(children, float(1 << (level - 1)));
            store(level, ivec2(gl_WorkGroupID.xy) * half_ + thread, value);
        }
        barrier();
        if (works)
            sharedCells[thread.y * half_ + thread.x] = packShared(value);
        barrier();
        across = half_;
    }
}

/// The last group alone: levels above the tiles' level, by all of its threads.
void reduceTiles() {
    int from = 0;
    ivec2 childSize = pyramidLevelSize(size, int(kPyramidTileLevel));
    int to = childSize.x * childSize.y;
    for (int level = int(kPyramidTileLevel) + 1; level <= int(settings.levels); ++level) {
        ivec2 levelSize = pyramidLevelSize(size, level);
        for (int k = int(gl_LocalInvocationIndex); k < levelSize.x * levelSize.y; k += 256) {
            ivec2 cell = ivec2(k % levelSize.x, k / levelSize.x);
            Cell children[4];
            for (int i = 0; i < 4; ++i) {
                ivec2 child = cell * 2 + ivec2(i & 1, i >> 1);
                children[i] = all(lessThan(child, childSize))
                                  ? unpackShared(tiles.cells[from + child.y * childSize.x + child.x])
                                  : emptyCell(false); // outside the image
            }
            Cell value = cellOfCells(children, float(1 << (level - 1)));
            store(level, cell, value);
            tiles.cells[to + k] = packShared(value);
        }
        memoryBarrierBuffer();
        barrier();
        int wasFrom = from;
        from = to;
        to = wasFrom;
        childSize = levelSize;
    }
}

void main() {
    size = ivec2(frame.constants.size);
    width = frame.constants.size.x;
    reduceTile();
    if (gl_LocalInvocationIndex == 0u) {
        tiles.cells[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sharedCells[0];
        memoryBarrierBuffer(); // before any group can count this one as finished
        uint groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
        isLastGroup = atomicAdd(tiles.finishedGroups, 1u) == groups - 1u;
    }
    barrier();
    if (!isLastGroup)
        return;
    memoryBarrierBuffer();
    reduceTiles();
    if (gl_LocalInvocationIndex == 0u)
        tiles.finishedGroups = 0u;
}
