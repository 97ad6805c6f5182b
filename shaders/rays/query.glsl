// The ray seam (lib/ray.glsl) over VK_KHR_ray_query: the driver's acceleration structures, in hardware where available.
#ifndef GLINT_RAYS_QUERY_GLSL
#define GLINT_RAYS_QUERY_GLSL

#extension GL_EXT_ray_query : require

#include "lib/ray.glsl"

// Bindings 16 to 18 belong to the scene in both back ends (RayScene's bind).
layout(set = 0, binding = 16) uniform accelerationStructureEXT scene;

// True if the host numbers hits by custom indices (rays::Scene::constants); Glint's own scenes have none.
layout(constant_id = 2) const bool kCustomIndices = false;

/// The number of a hit's surface: glint::InstanceNumbering.
uint numberOf(int index, int customIndex, int geometry) {
    return uint(kCustomIndices ? customIndex + geometry : index);
}

/// Returns the nearest hit or, with gl_RayFlagsTerminateOnFirstHitEXT in `flags`, the first hit found.
Hit proceedQuery(Ray ray, uint flags) {
    Hit hit = missOf(ray);
    if (!isTraceable(ray))
        return hit;
    if ((ray.flags & kRayCullBackFaces) != 0u)
        flags |= gl_RayFlagsCullBackFacingTrianglesEXT;
    if ((ray.flags & kRayAllOpaque) != 0u)
        flags |= gl_RayFlagsOpaqueEXT;
    rayQueryEXT query;
    rayQueryInitializeEXT(query, scene, flags, ray.mask & 0xffu, ray.originWS, ray.tMin, ray.directionWS, ray.tMax);
    while (rayQueryProceedEXT(query)) // stops at each triangle that may have holes
        if (rayQueryGetIntersectionTypeEXT(query, false) == gl_RayQueryCandidateIntersectionTriangleEXT &&
            rayMeetsSurface(numberOf(rayQueryGetIntersectionInstanceIdEXT(query, false),
                                     rayQueryGetIntersectionInstanceCustomIndexEXT(query, false),
                                     rayQueryGetIntersectionGeometryIndexEXT(query, false)),
                            rayQueryGetIntersectionPrimitiveIndexEXT(query, false),
                            rayQueryGetIntersectionBarycentricsEXT(query, false)))
            rayQueryConfirmIntersectionEXT(query);
    if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT) {
        hit.distance = rayQueryGetIntersectionTEXT(query, true);
        hit.instance = numberOf(rayQueryGetIntersectionInstanceIdEXT(query, true),
                                rayQueryGetIntersectionInstanceCustomIndexEXT(query, true),
                                rayQueryGetIntersectionGeometryIndexEXT(query, true));
        hit.primitive = rayQueryGetIntersectionPrimitiveIndexEXT(query, true);
        hit.barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, true);
        hit.frontFace = rayQueryGetIntersectionFrontFaceEXT(query, true);
    }
    return hit;
}

Hit traceRay(Ray ray) {
    return proceedQuery(ray, gl_RayFlagsNoneEXT);
}

bool isOccluded(Ray ray) {
    return isHit(proceedQuery(ray, gl_RayFlagsTerminateOnFirstHitEXT));
}

#endif
