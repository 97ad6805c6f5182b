// The light of an opaque or masked surface: the second half of gbuffer.mode geometry.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/lighting_bindings.glsl"
#include "render/lit_outputs.glsl"
#include "render/surface_visible.glsl"

layout(location = 0) out vec4 outLitRadiance;
layout(location = 1) out vec4 outFallbackSpecular;
layout(location = 2) out vec4 outAlbedo;

void main() {
    beginLighting();
    SurfacePoint point = interpolatedPoint();
    MaterialSample surface = visibleSurface(point);
    Lighting lighting = shownLighting(surface, point, viewVector());
    outLitRadiance = litRadiance(lighting);
    outFallbackSpecular = fallbackSpecular(lighting);
    outAlbedo = vec4(surface.baseColor, 1.0);
}
