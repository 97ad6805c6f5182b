// Makes every level of the depth pyramid (lib/pyramid.glsl) in one dispatch: each group reduces a tile of 64 pixels to
// one cell of level 6, and the group that ends last reduces those. Runs if there are rays to trace, or layers whose rays may follow.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/nearness.glsl"
#include "lib/pyramid.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 16, local_size_y = 16) in; // a thread takes 4 x 4 pixels

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform sampler2D backViewZ; // of any size
layout(set = 0, binding = 3, rgba32ui) uniform writeonly uimage2D pyramid;
layout(scalar, set = 0, binding = 4) coherent buffer TilesBlock {
    uint finishedGroups; // 0 before and after
    uint padding[3];
    uvec4 cells[]; // level 6; then levels above it in turn behind and in its place
} tiles;
layout(push_constant, scalar) uniform PushBlock {
    PyramidConstants settings;
};

shared uvec4 sharedCells[256];
shared bool isLastGroup;

/// A step of nearness from pixel to pixel that is taken for an edge, in parts of it.
const float kEdge = 0.05;

ivec2 size;
float width;

// ---------------------------------------------------------------- a cell from what it is made of

/// The nearest half, none of the smallest. By its bits: compilers take packing and unpacking again for nothing.
float asHalf(float value) {
    const float kSmallest = 1.0 / 16384.0; // below it drivers may round to 0
    value = clamp(value, -60000.0, 60000.0);
    return abs(value) < kSmallest ? 0.0 : uintBitsToFloat((floatBitsToUint(value) + 0x1000u) & 0xffffe000u);
}

/// As it will be read back: bounds are made for that slope.
vec2 storedSlope(vec2 slope) {
    return vec2(asHalf(slope.x * width), asHalf(slope.y * width)) / width;
}

float slabNearness(ivec2 px, float z, bool orthographic) {
    float reach = z;
    if ((settings.flags & kTraceBackDepth) != 0u) {
        ivec2 backSize = textureSize(backViewZ, 0);
        ivec2 backPX = min(ivec2((vec2(px) + 0.5) * frame.constants.invSize * vec2(backSize)), backSize - 1);
        float backZ = texelFetch(backViewZ, backPX, 0).r;
        if (backZ < kBackgroundZ && backZ >= z * 0.999)
            reach = max(backZ, z);
    }
    return nearnessOf(orthographic, reach + settings.thickness + settings.thicknessRelative * z);
}

/// Of the picture (`broken`), or outside of it.
Cell emptyCell(bool broken) {
    Cell cell = Cell(kEmptyCell, broken ? kBroken : 0.0, 0.0, vec2(0.0), vec2[4](vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0)));
    for (int i = 0; i < 4; ++i)
        cell.quarters[i] = vec2(1.0, 0.0);
    return cell;
}

/// What a cell above needs to know of this one, exactly.
uvec4 packBounds(Cell cell) {
    return uvec4(floatBitsToUint(cell.front), floatBitsToUint(cell.depth), floatBitsToUint(cell.slab),
                 packSlope(cell.slope, width));
}

Cell unpackBounds(uvec4 packed) {
    Cell cell = emptyCell(false);
    cell.front = uintBitsToFloat(packed.x);
    cell.depth = uintBitsToFloat(packed.y);
    cell.slab = uintBitsToFloat(packed.z);
    cell.slope = unpackHalf2x16(packed.w) / width;
    return cell;
}

/// Makes the whole from its quarters, which say from where to where they are solid in nearness above the cell's plane
/// of front 0 (from the nearest down).
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
    bool seen[4];
    bool all4 = true;
    bool broken = false;
    bool any4 = false;
    for (int i = 0; i < 4; ++i) {
        ivec2 px = cell * 2 + ivec2(i & 1, i >> 1);
        bool inside = all(lessThan(px, size));
        float z = inside ? texelFetch(viewZ, px, 0).r : kBackgroundZ;
        seen[i] = z < kBackgroundZ;
        solids[i] = seen[i] ? vec2(nearnessOf(orthographic, z), slabNearness(px, z, orthographic)) : vec2(0.0);
        all4 = all4 && seen[i];
        any4 = any4 || seen[i];
        broken = broken || (inside && !seen[i]);
    }
    if (!any4)
        return emptyCell(broken);
    vec2 slope = vec2(0.0);
    if (all4)
        slope = storedSlope(0.5 * vec2(solids[1].x - solids[0].x + solids[3].x - solids[2].x,
                                       solids[2].x - solids[0].x + solids[3].x - solids[1].x));
    // Four pixels on both sides of an edge lie on a steep plane too; but between their centres nothing does.
    if (max(abs(slope.x), abs(slope.y)) > kEdge * abs(solids[0].x))
        slope = vec2(0.0);
    float low = 1e37;
    for (int i = 0; i < 4; ++i) {
        solids[i] -= dot(slope, vec2(i & 1, i >> 1) - 0.5);
        if (seen[i])
            low = min(low, solids[i].x);
    }
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

/// One cell from four of half its size, `childSize` pixels a side, in the order (0,0), (1,0), (0,1), (1,1): about the
/// planes that leave the least solid, of those of the four and their mean.
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
    Cell value = cellOfCells(children, 2.0);
    store(2, level2, value);
    sharedCells[gl_LocalInvocationIndex] = packBounds(value);

    int across = 16; // cells a side in shared memory
    for (int level = 3; level <= int(kPyramidTileLevel); ++level) {
        barrier();
        int half_ = across / 2;
        bool works = all(lessThan(thread, ivec2(half_)));
        if (works) {
            for (int i = 0; i < 4; ++i) {
                ivec2 child = thread * 2 + ivec2(i & 1, i >> 1);
                children[i] = unpackBounds(sharedCells[child.y * across + child.x]);
            }
            value = cellOfCells(children, float(1 << (level - 1)));
            store(level, ivec2(gl_WorkGroupID.xy) * half_ + thread, value);
        }
        barrier();
        if (works)
            sharedCells[thread.y * half_ + thread.x] = packBounds(value);
        across = half_;
    }
}

/// The last group alone: levels above the tiles', by all of its threads.
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
                                  ? unpackBounds(tiles.cells[from + child.y * childSize.x + child.x])
                                  : emptyCell(false); // outside the picture
            }
            Cell value = cellOfCells(children, float(1 << (level - 1)));
            store(level, cell, value);
            tiles.cells[to + k] = packBounds(value);
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
        memoryBarrierBuffer(); // before anybody can count this group as finished
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
