// What the pass of a transparent layer reads and writes, and its settings.
#ifndef GLINT_REFRACTION_LAYER_INPUTS_GLSL
#define GLINT_REFRACTION_LAYER_INPUTS_GLSL

#include "frame/prepared.glsl"
#include "lib/input_color.glsl"
#include "shared/refraction.h"

layout(set = 0, binding = 23) uniform sampler2D layerDepth;
layout(set = 0, binding = 24) uniform sampler2D layerNormal;
layout(set = 0, binding = 25) uniform sampler2D layerMaterial;
layout(set = 0, binding = 26) uniform sampler2D layerRadiance;
layout(set = 0, binding = 27) uniform sampler2D layerFallback;
layout(set = 0, binding = 28) uniform sampler2D layerTransmittance;
layout(set = 0, binding = 29) uniform sampler2D layerAbsorption;
layout(set = 0, binding = 30) uniform sampler2D layerBody;
layout(set = 0, binding = 31) uniform sampler2D layerCenter;
layout(set = 0, binding = 40) uniform sampler2D layerCoverage;
layout(set = 0, binding = 32) uniform sampler2D behind;  // the frame so far, with mips
layout(set = 0, binding = 38) uniform sampler2D solid;   // the frame without layers, with mips
layout(set = 0, binding = 39) uniform sampler2D layersZ; // viewZ of the nearest layer that `behind` shows
layout(set = 0, binding = 33) uniform samplerCube environment;
layout(set = 0, binding = 34) uniform sampler2D dfg;
layout(set = 0, binding = 35, rgba16f) uniform writeonly image2D composite;
layout(set = 0, binding = 36, rgba16f) uniform writeonly image2D refracted;         // of the nearest layer, for views
layout(set = 0, binding = 37, rgba16f) uniform writeonly image2D refractionWeights; // screen, probes, sky

layout(push_constant, scalar) uniform PushBlock {
    uint layerImages; // kLayer* of the images that are bound
};
RefractionConstants refraction = frame.settings.refraction;

bool layerHas(uint flag) {
    return ((refraction.flags | layerImages) & flag) != 0u;
}

/// The frame so far.
vec3 pictureAt(ivec2 px) {
    return linearColor(texelFetch(behind, px, 0).rgb, (frame.constants.flags & kOutputGamma) != 0u);
}

vec3 toWorld(vec3 directionVS) {
    return mat3(frame.constants.viewToWorld) * directionVS;
}

#endif
