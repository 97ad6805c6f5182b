// Builds the split-sum table once: x = NoV, y = perceptual roughness (lib/dfg.glsl).
#version 460
#extension GL_GOOGLE_include_directive : require

#include "lib/dfg.glsl"
#include "lib/environment.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rg16f) uniform writeonly image2D dfg;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(dfg);
    if (any(greaterThanEqual(px, size)))
        return;
    vec2 argument = dfgArgument(px, size.x);
    imageStore(dfg, px, vec4(integrateDfg(max(argument.x, 1e-3), argument.y), 0.0, 0.0));
}
