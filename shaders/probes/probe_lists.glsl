// The probes around a place, from the grid over their volumes. docs/techniques/probes.md.
#ifndef GLINT_PROBES_PROBE_LISTS_GLSL
#define GLINT_PROBES_PROBE_LISTS_GLSL

#include "lib/probe.glsl"

layout(scalar, set = 0, binding = 20) readonly buffer ProbesBlock {
    ProbeRecord list[];
} probes;
layout(scalar, set = 0, binding = 21) readonly buffer CellsBlock {
    ProbeGridHeader grid;
    uint first[];
} probeCells;
layout(scalar, set = 0, binding = 22) readonly buffer ListsBlock {
    uint probe[];
} probeLists;

/// First and end index (exclusive) in probeLists; empty outside of the grid.
uvec2 probesAround(vec3 positionWS) {
    ProbeGridHeader grid = probeCells.grid;
    vec3 at = (positionWS - grid.originWS) * grid.cellsPerMetre;
    if (!(all(greaterThanEqual(at, vec3(0.0))) && all(lessThan(at, vec3(grid.size))))) // also false for NaN
        return uvec2(0u);
    uvec3 cell = min(uvec3(at), grid.size - 1u);
    uint index = (cell.z * grid.size.y + cell.y) * grid.size.x + cell.x;
    return uvec2(probeCells.first[index], probeCells.first[index + 1u]);
}

#endif
