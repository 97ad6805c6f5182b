// A shadow caster seen from its light.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/scene_bindings.glsl"
#include "shared/light.h"
#include "shared/shadow.h"

layout(scalar, set = 0, binding = 5) readonly buffer LightBlock {
    Light list[];
} lights;
layout(push_constant, scalar) uniform DrawBlock {
    ShadowDrawConstants constants;
} draw;

layout(location = 0) out vec4 uv01;
layout(location = 1) out float alpha;

void main() {
    Instance instance = instances.list[draw.constants.instance];
    VertexAttributes vertex = loadAttributes(gl_VertexIndex);
    uv01 = vec4(vertex.uv0, vertex.uv1);
    alpha = vertex.color.a;
    vec4 tile = lights.list[draw.constants.light].worldToShadow *
                (instance.localToWorld * vec4(loadPositionLS(gl_VertexIndex), 1.0));
    // worldToShadow ends in the tile's UV, rows from the top; the viewport expects clip space, +Y up.
    gl_Position = vec4(2.0 * tile.x - tile.w, tile.w - 2.0 * tile.y, tile.z, tile.w);
}
