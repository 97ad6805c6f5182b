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

/// Over the pixels of the cell, at offset `d` (px) from its centre:
///     front + dot(slope, d) - depth <= nearness of the surface <= front + dot(slope, d)
///     front + dot(slope, d) - slab  <= nearness of where it ends behind
struct Cell {
    float front; // kEmptyCell: nothing is drawn here
    float depth; // kBroken: some pixel shows no surface
    float slab;
    vec2 slope; // a pixel
};

const float kEmptyCell = -1.0e37;
const float kBroken = 1.0e37;

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

/// Slopes are kept as halves of a picture's width, which keeps them clear of the smallest halves.
uvec4 packCell(Cell cell, float width) {
    return uvec4(floatBitsToUint(cell.front), floatBitsToUint(cell.depth), floatBitsToUint(cell.slab),
                 packHalf2x16(cell.slope * width));
}

Cell unpackCell(uvec4 packed, float invWidth) {
    return Cell(uintBitsToFloat(packed.x), uintBitsToFloat(packed.y), uintBitsToFloat(packed.z),
                unpackHalf2x16(packed.w) * invWidth);
}

#endif
