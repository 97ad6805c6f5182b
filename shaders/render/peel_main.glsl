// The depth of a transparent surface, if it is seen and lies behind those of the layer before. Everitt 2001,
// "Interactive Order-Independent Transparency": depth peeling, from the eye on.
#include "render/transparent_present.glsl"

layout(set = 0, binding = 10) uniform sampler2D nearerLayer; // its depth

/// There is a layer before.
layout(constant_id = 1) const bool kBehindAnother = false;

/// Of what is solid, the farthest sample.
float solidDepth(ivec2 px);

void main() {
    ivec2 px = ivec2(gl_FragCoord.xy);
    if (gl_FragCoord.z < solidDepth(px))
        discard;
    if (kBehindAnother && gl_FragCoord.z >= texelFetch(nearerLayer, px, 0).r)
        discard;
    if (!isTransparentPresent())
        discard;
}
