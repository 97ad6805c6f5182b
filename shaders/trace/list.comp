// Lists the rays that trace/ray_list.glsl marked: tile by tile, and row by row within a tile. Neighbours stay
// neighbours, and tracing runs over full groups. The order follows from the image alone, because the rays that share a
// subgroup may change the last bits of what a driver computes for them (lab/notes/subgroups.md).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shared/trace_constants.h"

layout(local_size_x = 256) in; // a block of kTilesPerBlock tiles

layout(scalar, set = 0, binding = 0) readonly buffer RayTilesBlock {
    uvec2 masks[];
}
rayTiles;
layout(scalar, set = 0, binding = 1) readonly buffer RayBlocksBlock {
    uint counts[];
}
rayBlocks;
layout(scalar, set = 0, binding = 2) writeonly buffer RaysBlock {
    RayListHeader header;
    uint pixels[];
}
rays;
layout(push_constant, scalar) uniform PushBlock {
    RayListConstants settings;
};

const uint kRowTiles = 8u;

shared uint blockStart;
shared uint anyFromRough; // of the rays before the block
shared uvec2 tileMasks[kTilesPerBlock];
shared uint tileStarts[kTilesPerBlock]; // rays of the block before each tile
shared uint rowEnds[kTilesPerBlock];    // rays of the tile's row of kRowTiles, up to and including the tile

uint raysOf(uvec2 mask) {
    return uint(bitCount(mask.x) + bitCount(mask.y));
}

/// Number of rays of the pixels before `pixel`.
uint raysBefore(uvec2 mask, uint pixel) {
    uint low = bitfieldExtract(mask.x, 0, int(min(pixel, 32u)));
    uint high = bitfieldExtract(mask.y, 0, int(max(pixel, 32u)) - 32);
    return raysOf(uvec2(low, high));
}

void findBlockStart(uint block) {
    if (gl_LocalInvocationIndex == 0u) {
        blockStart = 0u;
        anyFromRough = 0u;
    }
    barrier();
    uint before = 0u;
    bool fromRough = false;
    for (uint i = gl_LocalInvocationIndex; i < block; i += gl_WorkGroupSize.x) {
        before += rayBlocks.counts[i] & 0xffffu;
        fromRough = fromRough || (rayBlocks.counts[i] & kFromRough) != 0u;
    }
    if (before > 0u)
        atomicAdd(blockStart, before);
    if (fromRough)
        atomicOr(anyFromRough, 1u);
    barrier();
}

void findTiles(uint block) {
    uint i = gl_LocalInvocationIndex;
    uint tile = block * kTilesPerBlock + i;
    if (i < kTilesPerBlock)
        tileMasks[i] = tile < settings.tiles.x * settings.tiles.y ? rayTiles.masks[tile] : uvec2(0u);
    barrier();
    // Two short sums, because each barrier costs more than a few additions.
    if (i < kTilesPerBlock) {
        uint sum = 0u;
        for (uint other = i / kRowTiles * kRowTiles; other <= i; ++other)
            sum += raysOf(tileMasks[other]);
        rowEnds[i] = sum;
    }
    barrier();
    if (i < kTilesPerBlock) {
        uint sum = rowEnds[i] - raysOf(tileMasks[i]);
        for (uint end = kRowTiles - 1u; end < i; end += kRowTiles)
            sum += rowEnds[end];
        tileStarts[i] = sum;
    }
    barrier();
}

void writeHeader(uint count, bool fromRough) {
    const uint kRowRays = kRaysPerGroup * kRayGroupsX;
    bool any = count > 0u || settings.always != 0u;
    uvec2 pyramid = any ? settings.pyramidGroups : uvec2(0u);
    uvec2 backFaces = any ? settings.backFaceGroups : uvec2(0u);
    uvec2 picture = fromRough || settings.always != 0u ? settings.pyramidGroups : uvec2(0u);
    rays.header.rayGroups = uint[3](kRayGroupsX, (count + kRowRays - 1u) / kRowRays, 1u);
    rays.header.rayCount = count;
    rays.header.pyramidGroups = uint[3](pyramid.x, pyramid.y, 1u);
    rays.header.backFaceGroups = uint[3](backFaces.x, backFaces.y, 1u);
    rays.header.pictureGroups = uint[3](picture.x, picture.y, 1u);
}

void main() {
    uint block = gl_WorkGroupID.x;
    uint count = rayBlocks.counts[block] & 0xffffu;
    bool last = block + 1u == gl_NumWorkGroups.x;
    if (count == 0u && !last)
        return;
    findBlockStart(block);
    if (last && gl_LocalInvocationIndex == 0u)
        writeHeader(blockStart + count, anyFromRough != 0u || (rayBlocks.counts[block] & kFromRough) != 0u);
    findTiles(block);
    for (uint i = gl_LocalInvocationIndex; i < kTilesPerBlock * kRayTilePixels; i += gl_WorkGroupSize.x) {
        uint tile = i / kRayTilePixels;
        uint pixel = i % kRayTilePixels;
        uvec2 mask = tileMasks[tile];
        if ((mask[pixel >> 5] >> (pixel & 31u) & 1u) == 0u)
            continue;
        uint number = block * kTilesPerBlock + tile;
        uvec2 corner = uvec2(number % settings.tiles.x, number / settings.tiles.x) * kRayTileWidth;
        uvec2 px = corner + uvec2(pixel % kRayTileWidth, pixel / kRayTileWidth);
        rays.pixels[blockStart + tileStarts[tile] + raysBefore(mask, pixel)] = px.x | (px.y << 16);
    }
}
