// Traces a list of rays through the scene, both ways. Included by ray_query.comp and ray_bvh.comp.

layout(local_size_x = 64) in;

struct TestHit {
    Hit hit;
    uint occluded;
};
layout(scalar, set = 0, binding = 0) readonly buffer RaysBlock {
    Ray item[];
} rays;
layout(scalar, set = 0, binding = 1) writeonly buffer HitsBlock {
    TestHit item[];
} hits;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.item.length())
        return;
    Ray ray = rays.item[i];
    Hit hit = traceRay(ray);
    hits.item[i].hit = hit;
    hits.item[i].occluded = isOccluded(ray) ? 1u : 0u;
}
