// Inputs of every surface's fragment stage, lit or not.
#ifndef GLINT_RENDER_SURFACE_BINDINGS_GLSL
#define GLINT_RENDER_SURFACE_BINDINGS_GLSL

#include "lib/material.glsl"
#include "render/draw_constants.glsl"
#include "render/material_binding.glsl"
#include "render/scene_bindings.glsl"
#include "shared/render_view.h"

layout(scalar, set = 0, binding = 4) uniform ViewBlock {
    RenderView constants;
}
view;
layout(set = 1, binding = 0) uniform sampler2D textures[];

#define VARYING in
#include "render/surface_varyings.glsl"

#ifdef GLINT_SHADOW_RAYS
bool sharpestTexels = false; // true in a shadow ray's test, which has no neighbours to derive a mip from
#endif

vec4 sampleTexture(TextureRef ref, vec2 uv) {
#ifdef GLINT_SHADOW_RAYS
    if (sharpestTexels)
        return textureLod(textures[nonuniformEXT(ref.index)], uv, 0.0);
#endif
    return texture(textures[ref.index], uv); // one draw has one material, so the index is uniform
}

/// Unit, towards the eye.
vec3 viewVector() {
    return view.constants.orthographic != 0u ? -view.constants.cameraForwardWS
                                             : normalize(view.constants.cameraPositionWS - positionWS);
}

SurfacePoint interpolatedPoint() {
    return SurfacePoint(positionWS, normalWS, tangentWS, uv01.xy, uv01.zw, color, gl_FrontFacing);
}

/// The draw's material; lines and points without normals cannot be lit and show their colour.
Material drawnMaterial() {
    Instance instance = instances.list[draw.constants.instance];
    Material material = materials.list[instance.material];
    if ((instance.flags & kInstanceNoNormals) != 0u)
        material.flags |= kMaterialUnlit;
    return material;
}

#endif
