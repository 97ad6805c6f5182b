// The depth pyramid: cells of 2^level pixels a side, each with bounds on what the picture shows there.
//
// Bounds are taken about a plane instead of a constant. Nearness (lib/nearness.glsl) of a plane is linear on screen, so
// a cell that shows one flat surface has bounds as thin as the depth's own rounding at every level: a ray that leaves a
// floor is known to be in front of it at once, and one that meets a wall meets it in a large cell, without going down
// to single pixels. With slope 0 this is the usual minimum and maximum of depth.
//
// Level 0 is viewZ itself. The others lie in one image of rgba32ui, level 1 at the left and the rest in a column beside
// it, so that any size of picture has exact cells: ceil(size / 2^level) of them, none larger than it says.
#ifndef GLINT_LIB_PYRAMID_GLSL
#define GLINT_LIB_PYRAMID_GLSL

/// What is solid in a cell, as depths below the plane of nearness front + dot(slope, d), d px from the cell's centre:
/// every surface lies in [0, depth] and ends behind by `slab`; nothing is solid within `gap`. Between a column and the
/// wall behind it a ray passes as freely as before both.
struct Cell {
    float front; // kEmptyCell: nothing is drawn here
    float depth; // kBroken: some pixel shows no surface
    float slab;
    vec2 gap;    // from, to; equal: none
    vec2 slope;  // a pixel
};

const float kEmptyCell = -1.0e37;
const float kBroken = 1.0e37;

Cell emptyCell() {
    return Cell(kEmptyCell, 0.0, 0.0, vec2(0.0), vec2(0.0));
}

ivec2 pyramidLevelSize(ivec2 size, int level) {
    return (size + (1 << level) - 1) >> level;
}

/// Where a level above 0 starts in the image; the column's levels overlap nowhere, as
/// floor(h/2 - h/2^(level-1)) + level - 2 >= the sum of the ceil(h/2^i) before it.
ivec2 pyramidOffset(ivec2 size, int level) {
    if (level == 1)
        return ivec2(0);
    return ivec2((size.x + 1) >> 1, ((size.y * ((1 << (level - 2)) - 1)) >> (level - 1)) + level - 2);
}

// Front and slab are floats, slopes halves of a picture's width, the gap 2 x 10 bits of the slab, and depth the upper 12
// bits of a half of the front; all rounded so that the bounds stay bounds.

uvec4 packCell(Cell cell, float width) {
    float relative = cell.depth >= kBroken ? 65504.0 : min(cell.depth / max(abs(cell.front), 1e-30), 65504.0);
    uint depth = min((packHalf2x16(vec2(relative, 0.0)) & 0xffffu) + 16u, 0x7bffu) >> 4; // up, past the half's own rounding
    vec2 gap = clamp(cell.gap / max(cell.slab, 1e-37), 0.0, 1.0) * 1023.0;
    uvec2 steps = uvec2(min(ceil(gap.x) + 1.0, 1023.0), max(floor(gap.y) - 1.0, 0.0));
    if (steps.y <= steps.x)
        steps = uvec2(0u);
    return uvec4(floatBitsToUint(cell.front), floatBitsToUint(cell.slab), packHalf2x16(cell.slope * width),
                 (depth << 20) | (steps.x << 10) | steps.y);
}

Cell unpackCell(uvec4 packed, float invWidth) {
    Cell cell;
    cell.front = uintBitsToFloat(packed.x);
    cell.slab = uintBitsToFloat(packed.y);
    cell.slope = unpackHalf2x16(packed.z) * invWidth;
    uint depth = packed.w >> 20;
    cell.depth = depth >= 0x7bfu ? kBroken : unpackHalf2x16(depth << 4).x * abs(cell.front);
    cell.gap = vec2((packed.w >> 10) & 0x3ffu, packed.w & 0x3ffu) * (cell.slab / 1023.0);
    return cell;
}

#endif
