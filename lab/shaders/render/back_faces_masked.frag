// Holes in back faces: where an alpha test cuts them, and where a blended surface is fully transparent.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/material.glsl"
#include "render/draw_constants.glsl"
#include "render/material_binding.glsl"
#include "render/scene_bindings.glsl"

layout(set = 1, binding = 0) uniform sampler2D textures[];

layout(location = 0) in vec4 uv01;
layout(location = 1) in float alpha;

vec4 sampleTexture(TextureRef ref, vec2 uv) {
    return texture(textures[ref.index], uv);
}

float alphaCutoff(Material material) {
    if ((material.flags & kMaterialAlphaMask) != 0u)
        return material.alphaCutoff;
    return (material.flags & kMaterialAlphaBlend) != 0u ? 1.0 / 255.0 : 0.0;
}

void main() {
    Material material = materials.list[instances.list[draw.constants.instance].material];
    SurfacePoint point = SurfacePoint(vec3(0.0), vec3(0.0), vec4(0.0), uv01.xy, uv01.zw, vec4(1.0, 1.0, 1.0, alpha),
                                      true);
    if (sampleBaseColor(material, point).a < alphaCutoff(material))
        discard;
}
