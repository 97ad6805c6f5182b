// Holes in alpha-tested shadow casters.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/material.glsl"
#include "render/material_binding.glsl"
#include "render/scene_bindings.glsl"
#include "shared/shadow.h"

layout(set = 1, binding = 0) uniform sampler2D textures[];
layout(push_constant, scalar) uniform DrawBlock {
    ShadowDrawConstants constants;
} draw;

layout(location = 0) in vec4 uv01;
layout(location = 1) in float alpha;

vec4 sampleTexture(TextureRef ref, vec2 uv) {
    return texture(textures[ref.index], uv);
}

void main() {
    Material material = materials.list[instances.list[draw.constants.instance].material];
    SurfacePoint point = SurfacePoint(vec3(0.0), vec3(0.0), vec4(0.0), uv01.xy, uv01.zw, vec4(1.0, 1.0, 1.0, alpha),
                                      true);
    if (sampleBaseColor(material, point).a < material.alphaCutoff)
        discard;
}
