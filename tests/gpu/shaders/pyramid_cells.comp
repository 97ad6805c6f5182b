// One level of the depth pyramid, cell by cell, as marchers read it.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/pyramid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

struct ReadCell {
    float front;
    float depth;
    float slab;
    vec2 slope;
    vec2 quarters[4];
};

layout(set = 0, binding = 0) uniform usampler2D pyramid;
layout(scalar, set = 0, binding = 1) writeonly buffer CellsBlock {
    ReadCell values[];
} cells;
layout(push_constant, scalar) uniform PushBlock {
    ivec2 size; // of the image
    int level;
} settings;

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    ivec2 levelSize = pyramidLevelSize(settings.size, settings.level);
    if (any(greaterThanEqual(cell, levelSize)))
        return;
    ivec2 at = pyramidOffset(settings.size, settings.level) + cell;
    Cell read = unpackCell(texelFetch(pyramid, at, 0), 1.0 / float(settings.size.x));
    cells.values[cell.y * levelSize.x + cell.x] = ReadCell(read.front, read.depth, read.slab, read.slope, read.quarters);
}
