// A blended or light-transmitting surface, lit: drawn over a frame, or provided as a layer.
#ifndef GLINT_RENDER_TRANSPARENT_SURFACE_GLSL
#define GLINT_RENDER_TRANSPARENT_SURFACE_GLSL

#include "render/lighting_bindings.glsl"

struct TransparentSurface {
    Material material;
    MaterialSample surface;
    Lighting lighting;
    vec3 V;           // unit, towards the eye
    vec3 mirrored;    // highlights and the fallback for reflections
    float present;    // 0 where a texture cuts a shape out: no sheen below 5 % of opacity, smoothly
    float thickness;  // metres in world space
};

/// The surface at this fragment; ends the invocation where the material has a hole.
TransparentSurface transparentSurface() {
    beginLighting();
    TransparentSurface s;
    s.material = drawnMaterial();
    SurfacePoint point = interpolatedPoint();
    if ((s.material.flags & kMaterialAlphaMask) != 0u && sampleBaseColor(s.material, point).a < s.material.alphaCutoff)
        discard;
    s.surface = sampleMaterial(s.material, point);
    s.V = viewVector();
    s.lighting = shownLighting(s.surface, point, s.V);
    s.mirrored = s.lighting.directSpecular + s.lighting.environmentSpecular + s.lighting.coatSpecular;
    s.present = saturate(s.surface.opacity * 20.0);
    mat4 localToWorld = instances.list[draw.constants.instance].localToWorld;
    s.thickness = s.surface.thickness *
                  (length(localToWorld[0].xyz) + length(localToWorld[1].xyz) + length(localToWorld[2].xyz)) / 3.0;
    return s;
}

#endif
