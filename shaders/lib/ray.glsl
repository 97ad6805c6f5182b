// The ray seam: the interface of every shader that traces the host's triangles. An entry includes one of the two back
// ends, rays/query.glsl or rays/bvh.glsl, which define
//     Hit traceRay(Ray ray);      // the nearest hit
//     bool isOccluded(Ray ray);   // true if there is any hit
// Both give the same hits. Triangles of instances that are not opaque stop a ray only where
//     bool rayMeetsSurface(uint instance, uint primitive, vec2 barycentrics)
// returns true. An entry that tests texels defines rayMeetsSurface and GLINT_RAY_ALPHA_TEST before the include;
// otherwise all triangles are solid.
#ifndef GLINT_LIB_RAY_GLSL
#define GLINT_LIB_RAY_GLSL

#include "shared/ray_flags.h"

struct Ray {
    vec3 originWS;
    float tMin;       // distances are in lengths of the direction: metres for a unit vector
    vec3 directionWS; // any length but 0
    float tMax;       // hits lie strictly between tMin and tMax
    uint mask;        // low 8 bits; the ray tests an instance if their masks share a bit
    uint flags;       // kRay...
};

struct Hit {
    float distance;    // tMax of the ray for a miss
    uint instance;     // in the host's list; kNoInstance: miss
    uint primitive;    // triangle of the instance's mesh
    vec2 barycentrics; // weights of its second and third vertex
    bool frontFace;    // the front faces the ray's origin
};

Ray makeRay(vec3 originWS, vec3 directionWS, float tMin, float tMax) {
    return Ray(originWS, tMin, directionWS, tMax, 0xffu, kRayCullBackFaces);
}

Hit missOf(Ray ray) {
    return Hit(ray.tMax, kNoInstance, 0u, vec2(0.0), true);
}

bool isHit(Hit hit) {
    return hit.instance != kNoInstance;
}

/// False for rays with NaN, infinite or absurdly large numbers, without direction or with an empty range: they hit
/// nothing. Vulkan leaves such ray queries undefined.
bool isTraceable(Ray ray) {
    const float kMost = 1e18; // squares stay finite
    return all(lessThan(abs(ray.originWS), vec3(kMost))) && all(lessThan(abs(ray.directionWS), vec3(kMost))) &&
           any(greaterThan(abs(ray.directionWS), vec3(1e-18))) && ray.tMin >= 0.0 && ray.tMax > ray.tMin;
}

#ifndef GLINT_RAY_ALPHA_TEST
bool rayMeetsSurface(uint instance, uint primitive, vec2 barycentrics) {
    return true;
}
#endif

#endif
