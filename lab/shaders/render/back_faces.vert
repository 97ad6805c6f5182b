// Places a vertex for depth alone, to the same bits as surface.vert: a sheet's back is where its front is.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/draw_constants.glsl"
#include "render/scene_bindings.glsl"
#include "shared/render_view.h"

layout(scalar, set = 0, binding = 4) uniform ViewBlock {
    RenderView constants;
} view;

layout(location = 0) out vec4 uv01;
layout(location = 1) out float alpha;
invariant gl_Position;

void main() {
    Instance instance = instances.list[draw.constants.instance];
    VertexAttributes vertex = loadAttributes(gl_VertexIndex);
    uv01 = vec4(vertex.uv0, vertex.uv1);
    alpha = vertex.color.a;
    vec4 world = instance.localToWorld * vec4(loadPositionLS(gl_VertexIndex), 1.0);
    gl_Position = view.constants.worldToClip * world;
    gl_ClipDistance[0] = dot(view.constants.clipPlaneWS, vec4(world.xyz, 1.0));
    gl_PointSize = 1.0;
}
