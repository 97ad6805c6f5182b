// The depth pyramid: cells of 2^level pixels a side, each with bounds on the surfaces that the frame shows there.
//
// Bounds are taken about a plane instead of a constant. Nearness (lib/nearness.glsl) of a plane is linear on screen, so
// a cell that shows one flat surface has bounds as thin as the depth's own rounding at every level. A ray that leaves a
// floor is known to be in front of it at once, and a ray that hits a wall hits it in a large cell, without descending
// to single pixels. With slope 0 these bounds are the usual minimum and maximum of depth. Each cell also bounds its
// four quarters, coarsely, so one lookup tells which quarters need another.
//
// Level 0 is viewZ itself. The other levels lie in one image of rgba32ui, level 1 at the left and the rest in a column
// beside it, so that every image size has exact cells: ceil(size / 2^level) of them, none that covers more pixels than
// its level says.
#ifndef GLINT_LIB_PYRAMID_GLSL
#define GLINT_LIB_PYRAMID_GLSL

#include "lib/math.glsl"

/// The solid part of a cell, as depths (of nearness) below the plane front + dot(slope, d), d px from the cell's
/// centre: every surface lies in [0, depth] and ends behind by `slab`.
struct Cell {
    float front; // kEmptyCell: no surface
    float depth; // kBroken: some pixel of the image in the cell shows no surface
    float slab;
    vec2 slope; // a pixel
    vec2 quarters[4]; // the same for (0,0), (1,0), (0,1), (1,1): solid from, to; from > to: empty
};

const float kEmptyCell = -1.0e37;
const float kBroken = 1.0e37;

ivec2 pyramidLevelSize(ivec2 size, int level) {
    return (size + (1 << level) - 1) >> level;
}

/// Where a level above 0 starts in the image. The column's levels do not overlap, because floor(h/2 - h/2^(level-1)) +
/// level - 2 >= the sum of the ceil(h/2^i) before it.
ivec2 pyramidOffset(ivec2 size, int level) {
    if (level == 1)
        return ivec2(0);
    return ivec2((size.x + 1) >> 1, ((size.y * ((1 << (level - 2)) - 1)) >> (level - 1)) + level - 2);
}

// A cell in four words: front as a float; slopes as halves, times the image's width, which avoids the smallest halves;
// twice two quarters of 2 x 6 bits, in 63rds of the slab; beside them depth and slab as fractions of the front, in
// floats of 6 bits of exponent and 2 of mantissa. All values are rounded so that the bounds stay conservative.

const uint kSmallestExponent = 127u - 40u;

/// A byte for `value` / `unit`, rounded up: 2^-40 to 2^23.
uint packShare(float value, float unit) {
    if (value >= kBroken)
        return 255u;
    uint bits = (floatBitsToUint(max(value, 0.0) / max(unit, 1e-37)) >> 21) + 1u;
    return clamp(bits, kSmallestExponent << 2, (kSmallestExponent << 2) + 255u) - (kSmallestExponent << 2);
}

float unpackShare(uint packed, float unit) {
    return packed == 255u ? kBroken : unit * uintBitsToFloat((packed + (kSmallestExponent << 2)) << 21);
}

uint packQuarter(vec2 quarter, float slab) {
    if (quarter.x > quarter.y)
        return 63u; // from 63 to 0
    vec2 steps = clamp(quarter / slab, 0.0, 1.0) * 63.0;
    return uint(floorToInt(max(steps.x - 0.01, 0.0))) | (uint(floorToInt(min(ceil(steps.y + 0.01), 63.0))) << 6);
}

/// Packs a slope that was stored before to exactly the same halves: adds an eighth of a step, because drivers may round
/// down, and may divide by the width a little less than exactly.
uint packSlope(vec2 slope, float width) {
    return packHalf2x16(slope * (width * (1.0 + 1.0 / 16384.0)));
}

uvec4 packCell(Cell cell, float width) {
    float unit = abs(cell.front);
    uint slabShare = packShare(cell.slab, unit);
    float slab = unpackShare(slabShare, unit);
    return uvec4(floatBitsToUint(cell.front), packSlope(cell.slope, width),
                 packQuarter(cell.quarters[0], slab) | (packQuarter(cell.quarters[1], slab) << 12) |
                     (packShare(cell.depth, unit) << 24),
                 packQuarter(cell.quarters[2], slab) | (packQuarter(cell.quarters[3], slab) << 12) |
                     (slabShare << 24));
}

/// A cell whose quarters are still packed, for rays, which look at few of them.
struct CellBounds {
    float front;
    float depth;
    float slab;
    vec2 slope;
    uvec2 quarters; // the upper two, the lower two
};

CellBounds unpackBounds(uvec4 packed, float invWidth) {
    float front = uintBitsToFloat(packed.x);
    return CellBounds(front, unpackShare(packed.z >> 24, abs(front)), unpackShare(packed.w >> 24, abs(front)),
                      unpackHalf2x16(packed.y) * invWidth, packed.zw);
}

/// The solid part of quarter `which`: 1 for the right ones, plus 2 for the lower ones.
vec2 quarterSolid(CellBounds cell, int which) {
    uint packed = ((which & 2) != 0 ? cell.quarters.y : cell.quarters.x) >> (12 * (which & 1));
    return vec2(packed & 63u, (packed >> 6) & 63u) * (cell.slab / 63.0);
}

Cell unpackCell(uvec4 packed, float invWidth) {
    CellBounds cell = unpackBounds(packed, invWidth);
    return Cell(cell.front, cell.depth, cell.slab, cell.slope,
                vec2[4](quarterSolid(cell, 0), quarterSolid(cell, 1), quarterSolid(cell, 2), quarterSolid(cell, 3)));
}

#endif
