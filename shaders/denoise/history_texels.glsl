// Texels of the previous frame that show a pixel's surface, and the mean between them.
// Needs lib/previous_place.glsl, meanBefore, placeBefore and settings.
#include "denoise/cubic.glsl"

/// Lobes narrower than this on screen, in pixels, suffer from a linear mix of texels: see sharpMean.
const float kSharpBelow = 16.0;

/// This pixel's surface and its ray's end, in the previous frame's view space.
struct Was {
    vec3 position; // behind a mirror: of the image, as are the normal and the end
    vec3 normal;
    vec3 keptNormal; // as `place` keeps it: of the surface itself
    vec3 end;
    bool moved;      // by motion
    bool isMirrored;
    float allowed;   // metres that texels of the same surface may lie beside its plane
};

/// True where the previous frame showed this pixel's surface at `texel`.
bool showedIt(Was was, ivec2 texel, out vec3 position, out vec3 normal) {
    if (!wasInFrame(texel))
        return false;
    uvec2 packed = texelFetch(placeBefore, texel, 0).xy;
    float z = uintBitsToFloat(packed.x);
    bool isMirrored = z < 0.0;
    z = abs(z);
    if (z == 0.0 || z >= kBackgroundZ || isMirrored != was.isMirrored)
        return false; // no ray there, or a mirror's edge
    normal = decodeOctahedral(unpackSnorm2x16(packed.y));
    position = previousPosition((vec2(texel) + 0.5) * frame.constants.prevInvSize, z);
    return abs(dot(was.normal, position - was.position)) <= was.allowed && dot(normal, was.keptNormal) >= 0.7;
}

/// The mean between four texels that show this pixel's surface, by a cubic: a linear mix blurs a little in each frame of
/// a movement, and thirty frames of it as wide as many a smooth lobe. False where one of the texels shows another
/// surface, or is so much darker than another that the cubic would fall below 0 (to cut that off would add light), and
/// where `at` is a texel's middle, which a linear mix does not blur.
bool sharpMean(Was was, vec2 at, out vec4 mean) {
    const float kAtTexel = 0.03; // pixels: nearer than that no mix blurs
    vec2 fromTexel = abs(fract(at) - 0.5);
    if (max(fromTexel.x, fromTexel.y) <= kAtTexel)
        return false;
    vec2 corner = floor(at - 0.5);
    vec2 share = at - 0.5 - corner;
    vec4 wx = cubicWeights(share.x);
    vec4 wy = cubicWeights(share.y);
    vec4 sum = vec4(0.0);
    vec4 least = vec4(1e30);
    vec4 most = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 16; ++i) {
        ivec2 offset = ivec2(i & 3, i >> 2);
        bool outerX = offset.x == 0 || offset.x == 3;
        bool outerY = offset.y == 0 || offset.y == 3;
        if (outerX && outerY)
            continue; // the corners hardly count
        ivec2 texel = floorToInt(corner) + offset - 1;
        vec3 position;
        vec3 normal;
        if ((outerX || outerY) && !showedIt(was, texel, position, normal))
            return false;
        vec4 there = texelFetch(meanBefore, texel, 0);
        float weight = wx[offset.x] * wy[offset.y];
        sum += weight * there;
        total += weight;
        least = min(least, there);
        most = max(most, there);
    }
    mean = max(sum / total, vec4(0.0));
    const float kDark = 0.03;
    return all(greaterThanEqual(least, kDark * most));
}
