// The depth of a transparent surface, if it is visible and lies behind the layer before. Everitt 2001, "Interactive
// Order-Independent Transparency": depth peeling, starting at the eye.
#include "render/transparent_present.glsl"

layout(set = 0, binding = 10) uniform sampler2D nearerLayer; // depth of the layer before

/// True if there is a layer before.
layout(constant_id = 1) const bool kBehindAnother = false;

/// Depth of the farthest sample of the solid surfaces.
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
