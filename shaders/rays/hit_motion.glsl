// Where the surface that a ray hit was in the previous frame: by the instances' transforms and, for meshes that deform,
// the host's earlier positions. Include after rays_inputs.glsl and surface_table.glsl.
#ifndef GLINT_RAYS_HIT_MOTION_GLSL
#define GLINT_RAYS_HIT_MOTION_GLSL

#include "lib/ray_start.glsl"

layout(scalar, set = 0, binding = 26) readonly buffer InstancesBeforeBlock {
    SurfaceInstanceRecord item[];
}
instancesBefore; // as the previous frame's rays met them

float volumeOf(SurfaceInstanceRecord instance) {
    return abs(dot(instance.localToWorld[0].xyz, cross(instance.localToWorld[1].xyz, instance.localToWorld[2].xyz)));
}

/// True if an instance shows what it did not show before: nothing that moves grows or shrinks so much in one frame, but
/// hosts hide things by their size.
bool appeared(SurfaceInstanceRecord before, SurfaceInstanceRecord now) {
    const float kLargestChange = 4.0;
    float was = volumeOf(before);
    float is = volumeOf(now);
    return was > kLargestChange * is || is > kLargestChange * was;
}

/// Where the hit point was - where it is, metres in world space; 0 for instances that the previous frame did not have.
vec3 hitStepWS(Hit hit, vec3 hitWS) {
    if (hit.instance >= settings.instancesBefore)
        return vec3(0.0);
    SurfaceInstanceRecord before = instancesBefore.item[hit.instance];
    SurfaceInstanceRecord now = surfaceInstances.item[hit.instance];
    SurfaceMeshRecord mesh = surfaceMeshes.item[now.mesh];
    bool deforms = isPresent(mesh.previousPositions);
    bool rests = before.localToWorld[0] == now.localToWorld[0] && before.localToWorld[1] == now.localToWorld[1] &&
                 before.localToWorld[2] == now.localToWorld[2];
    if (before.mesh != now.mesh || (rests && !deforms) || appeared(before, now))
        return vec3(0.0);
    uvec3 triangle = loadTriangle(mesh, hit.primitive);
    StreamRecord positions = mesh.positions;
    if (deforms)
        positions = mesh.previousPositions;
    vec4 was = vec4(interpolate3(positions, triangle, weightsOf(hit.barycentrics), vec3(0.0)), 1.0);
    vec3 wasWS =
        vec3(dot(before.localToWorld[0], was), dot(before.localToWorld[1], was), dot(before.localToWorld[2], was));
    // Rounding is no movement, of a deforming mesh that rests.
    return distance(wasWS, hitWS) > hitUncertainty(hitWS) ? wasWS - hitWS : vec3(0.0);
}

#endif
