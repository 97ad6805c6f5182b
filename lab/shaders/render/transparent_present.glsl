// Where a transparent surface's texture leaves part of the surface.
#ifndef GLINT_RENDER_TRANSPARENT_PRESENT_GLSL
#define GLINT_RENDER_TRANSPARENT_PRESENT_GLSL

#include "render/surface_bindings.glsl"

bool isTransparentPresent() {
    Material material = drawnMaterial();
    if ((material.flags & (kMaterialAlphaMask | kMaterialAlphaBlend)) == 0u)
        return true;
    float alpha = sampleBaseColor(material, interpolatedPoint()).a;
    return (material.flags & kMaterialAlphaMask) != 0u ? alpha >= material.alphaCutoff : alpha > 0.0;
}

#endif
