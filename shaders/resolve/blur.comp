// One axis of the blur by roughness and hit distance. Every pixel gathers over the width of its own reflection's blur,
// from traced pixels of the same surface, and never across an edge. Radiance is weighted by its weight, so a miss next
// to a hit lowers the answer's weight instead of darkening it, and the sources behind take the remaining weight.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "shared/resolve_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform usampler2D rayRecord;
layout(set = 0, binding = 4) uniform sampler2D source; // radiance, not multiplied by weight
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D blurred;
layout(push_constant, scalar) uniform PushBlock {
    BlurPassConstants image;
};
BlurConstants settings = frame.settings.blur;

#include "resolve/blur_radius.glsl"
#include "resolve/neighbourhood.glsl"

/// Babylon.js' kernel is two steps that end at the reach, and shows a bright point as a square. This kernel is the
/// Gaussian of the same variance, round in two passes, up to where it has fallen to a sixtieth. `x`: fraction of the
/// reach.
const float kKernelEnd = 1.5;
float kernel(float x) {
    return exp(-1.824 * x * x);
}

/// In [0, 1), even over every small neighbourhood: Jimenez 2014, "Next Generation Post Processing in Call of Duty".
float gradientNoise(ivec2 px) {
    return fract(52.9829189 * fract(dot(vec2(px), vec2(0.06711056, 0.00583715))));
}

/// Premultiplied answer of one source pixel, with its weight in the fourth component; 0 if the pixel does not show this
/// surface.
struct Gathered {
    vec4 premultiplied;
    float total;
};

void gather(inout Gathered sum, Place here, ivec2 herePX, ivec2 sourcePX, float weight) {
    if (any(lessThan(sourcePX, ivec2(0))) || any(greaterThanEqual(sourcePX, ivec2(image.sourceSize))))
        return;
    ivec2 tracePX = gridToTracePixel(image.sourceSize, sourcePX);
    if (!wasTraced(rayOf(tracePX)))
        return;
    ivec2 tapPX = tracePixelToFull(frame.constants, tracePX);
    if (tapPX != herePX)
        weight *= sameSurface(here, placeOf(tapPX), length(vec2(tapPX - herePX)));
    vec4 answer = texelFetch(source, sourcePX, 0);
    sum.premultiplied += weight * vec4(answer.rgb * answer.a, answer.a);
    sum.total += weight;
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(image.targetSize))))
        return;
    ivec2 tracePX = gridToTracePixel(image.targetSize, px);
    RayRecord ray = rayOf(tracePX);
    if (!wasTraced(ray)) {
        imageStore(blurred, px, vec4(0.0));
        return;
    }
    ivec2 herePX = tracePixelToFull(frame.constants, tracePX);
    Place here = placeOf(herePX);

    int axis = int(image.vertical);
    vec2 shrink = image.sourceSize / image.targetSize; // above 1 when this pass also downsamples
    float rayPX = length(ray.hitUV * frame.constants.size - (vec2(herePX) + 0.5));
    float reach = blurReach(here.perceptualRoughness, rayPX, settings.strength, settings.roughnessFactor);
    reach *= image.sourceSize[axis] / frame.constants.size[axis];
    if (shrink[axis] > 1.0)
        reach = max(reach, 0.75 * shrink[axis]); // no source pixel is skipped
    // One tap for each source pixel, while the taps suffice. Beyond that, neighbours take different taps, so that
    // detail between the taps shows as grain, not as a grid.
    float end = kKernelEnd * reach;
    int side = min(int(ceil(end)), int(settings.maxTaps) / 2);
    float spacing = max(end / max(float(side), 1.0), 1.0);
    float shift = (gradientNoise(px) - 0.5) * (spacing - 1.0);
    vec2 along = axis == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);

    // When downsampling, the first pass takes each of the source rows that map to one target row.
    int lines = max(int(round(shrink[1 - axis])), 1);
    vec2 first = (vec2(px) + 0.5) * shrink - (1.0 - along) * 0.5 * float(lines - 1);
    Gathered sum = Gathered(vec4(0.0), 0.0);
    for (int line = 0; line < lines; ++line)
        for (int i = -side; i <= side; ++i) {
            float offset = float(i) * spacing + shift;
            float weight = kernel(offset / max(reach, 1e-3)) * clamp(end - abs(offset) + 1.0, 0.0, 1.0);
            gather(sum, here, herePX, floorToInt(first + along * offset + (1.0 - along) * float(line)), weight);
        }
    vec4 mean = sum.total > 0.0 ? sum.premultiplied / sum.total : vec4(0.0);
    imageStore(blurred, px, vec4(mean.a > 0.0 ? mean.rgb / mean.a : vec3(0.0), mean.a));
}
