// Traces a list of rays for their nearest hits: for timing. Included by rays_query.comp and rays_bvh.comp.

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 0) readonly buffer RaysBlock {
    Ray item[];
} rays;
layout(scalar, set = 0, binding = 1) writeonly buffer HitsBlock {
    Hit item[];
} hits;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < rays.item.length())
        hits.item[i] = traceRay(rays.item[i]);
}
