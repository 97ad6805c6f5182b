// Places a vertex of the scene. Vertices are pulled from storage buffers by index, so one pipeline draws any geometry.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/math.glsl"
#include "render/draw_constants.glsl"
#include "render/scene_bindings.glsl"
#include "shared/render_view.h"

layout(scalar, set = 0, binding = 4) uniform ViewBlock {
    RenderView constants;
} view;

#define VARYING out
#include "render/surface_varyings.glsl"
invariant gl_Position; // passes that draw the same surface get equal depth

void main() {
    Instance instance = instances.list[draw.constants.instance];
    vec3 positionLS = loadPositionLS(gl_VertexIndex);
    vec3 prevPositionLS = loadPositionLS(gl_VertexIndex + instance.prevVertexDelta);
    VertexAttributes vertex = loadAttributes(gl_VertexIndex);

    // Normals are transformed by the cofactor matrix, which is the inverse transpose times the determinant: no
    // division, and valid where a scale is zero. The determinant's sign corrects the cofactors' sign and that of a
    // mirrored tangent frame.
    mat3 linear = mat3(instance.localToWorld);
    mat3 cofactor = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    float side = (instance.flags & kInstanceMirrored) != 0u ? -1.0 : 1.0;
    vec4 world = instance.localToWorld * vec4(positionLS, 1.0);
    positionWS = world.xyz;
    normalWS = normalizeOr(cofactor * vertex.normal * side, vec3(0.0, 0.0, 1.0));
    tangentWS = vec4(linear * vertex.tangent.xyz, vertex.tangent.w * side);
    uv01 = vec4(vertex.uv0, vertex.uv1);
    color = vertex.color;

    gl_Position = view.constants.worldToClip * world;
    currentCS = gl_Position;
    vec4 prevWorld = instance.prevLocalToWorld * vec4(prevPositionLS, 1.0);
    previousCS = view.constants.prevWorldToClip * prevWorld;
    depthMotion = dot(view.constants.prevWorldToViewZ, prevWorld) - dot(view.constants.worldToViewZ, world);
    gl_ClipDistance[0] = dot(view.constants.clipPlaneWS, vec4(world.xyz, 1.0));
    gl_PointSize = 1.0;
}
