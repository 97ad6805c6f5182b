// Where a layer is seen. Include after `frame`, `viewZ` and `layerDepth`.
#ifndef GLINT_REFRACTION_LAYER_SEEN_GLSL
#define GLINT_REFRACTION_LAYER_SEEN_GLSL

#include "lib/host_surface.glsl"

/// viewZ of the layer at the pixel's centre; kBackgroundZ where there is no layer, or a solid surface hides it.
float seenLayerZ(ivec2 px) {
    float z = storedViewZ(frame.constants, hostViewZ(frame.constants, texelFetch(layerDepth, px, 0).r));
    return z <= texelFetch(viewZ, px, 0).r ? z : kBackgroundZ;
}

#endif
