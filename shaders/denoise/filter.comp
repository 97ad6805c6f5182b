// Smooths the noise that the mean over frames has left, for display only: the mean itself stays unfiltered, so that a
// view at rest converges to the truth. As wide as the noise asks and the lobe allows. docs/techniques/rough.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/lobe_surface.glsl"
#include "lib/color.glsl"
#include "lib/half.glsl"
#include "lib/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 3) uniform sampler2D mean; // weight * radiance, weight
layout(set = 0, binding = 4) uniform sampler2D meta; // frames; luminance: mean, mean square; nearness
layout(set = 0, binding = 5, rgba16f) uniform writeonly image2D answer; // radiance, weight
// lib/mirrored.glsl, if settings.mirrored
layout(set = 0, binding = 6) uniform usampler2D mirroredSurface;
layout(set = 0, binding = 7) uniform usampler2D mirroredLight;
DenoiseConstants settings = frame.settings.denoise;

#include "denoise/averaged_surface.glsl"

const uint kTaps = 16u;
const uint kYoungTaps = 32u; // in the first frames, which look twice as far

/// 1 in a pixel's first frame, 0 once the variance over frames says how noisy the pixel is.
float youth(float frames) {
    const float kEnough = 4.0;
    return saturate(1.0 - (frames - 1.0) / kEnough);
}

/// Standard deviation of the mean, from the variance over frames; without enough frames, as large as the mean.
float deviation(vec4 moments) {
    float overFrames = sqrt(max(moments.z - square(moments.y), 0.0) / max(moments.x, 1.0));
    return max(overFrames, moments.y * youth(moments.x));
}

/// This mean's part of the difference that noise explains. The deviation of few frames is itself uncertain; a settled
/// mean's neighbours share rays, and differ by less. measured: docs/techniques/rough.md.
float tolerance(vec4 moments) {
    return min(0.7 + 8.0 / max(moments.x, 1.0), 2.0) * deviation(moments);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isInFrame(px))
        return;
    vec4 moments = texelFetch(meta, px, 0);
    if (moments.x == 0.0) { // no ray
        imageStore(answer, px, vec4(0.0));
        return;
    }
    vec4 sum = texelFetch(mean, px, 0);
    LobeSurface here = averagedSurfaceAt(px);
    if (!isMirror(here.perceptualRoughness) && settings.filterRadius > 0.0) {
        float noise = deviation(moments);
        float strength = noise / max(settings.noiseTarget * moments.y, 1e-6);
        // A first frame is one sample of the lobe: its neighbours' are all that there is.
        float young = youth(moments.x);
        // Of the lobe. tuned: builtin:motion-objects; with 0.5 and 1 relMSE of rough surfaces is 0.0062 instead of 0.0055.
        float widest = mix(0.3, 0.7, young);
        float lobe = lobePixels(here.perceptualRoughness, here.viewZ, moments.w);
        float radius = min(strength * min(0.5 * lobe, settings.filterRadius), min(widest * lobe, settings.filterRadius));
        uint taps = young > 0.0 ? kYoungTaps : kTaps;
        if (radius >= 0.5) {
            mat2 disc = lobeDisc(here, radius);
            Spiral spiral =
                beginSpiral(taps, hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed).y);
            float own = luminance(sum.rgb);
            float tolerated = tolerance(moments);
            float total = 1.0;
            for (uint i = 0u; i < taps; ++i) {
                vec2 at = nextPoint(spiral, i);
                ivec2 tap = floorToInt(vec2(px) + 0.5 + disc * at);
                if (tap == px || !isInFrame(tap))
                    continue;
                vec4 theirs = texelFetch(meta, tap, 0);
                if (theirs.x == 0.0 || !isSameSurface(here, averagedSurfaceAt(tap)))
                    continue;
                vec4 other = texelFetch(mean, tap, 0);
                float apart = abs(luminance(other.rgb) - own) / (tolerated + tolerance(theirs) + 1e-4);
                float weight = exp(-1.5 * dot(at, at) - apart * apart);
                sum += weight * other;
                total += weight;
            }
            sum /= total;
        }
    }
    if (here.isMirrored) {
        MirroredLight light = unpackMirroredLight(texelFetch(mirroredLight, px, 0));
        vec3 both = light.exact + light.share * sum.rgb / max(sum.a, 1e-6);
        sum = vec4(min(both, vec3(kLargestStored)), uintBitsToFloat(light.last));
    }
    imageStore(answer, px, vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), sum.a));
}
