// Path space regularization. A path that a rough bounce sent in a random direction finds a small light in a smooth
// surface with a probability near 0 and a value near infinity: a firefly. So the path shades its hits no smoother than
// its directions resolve. Lobes are widened at equal albedo; no value is clamped. Kaplanyan and Dachsbacher 2013, "Path
// Space Regularization for Holistic and Robust Light Transport", CGF 32(2).
#ifndef GLINT_RAYS_REGULARIZATION_GLSL
#define GLINT_RAYS_REGULARIZATION_GLSL

#include "lib/math.glsl"

/// The directions that a path's random bounces stand for, as a cone of standard deviations.
struct PathSpread {
    float width; // metres, at the path's vertex
    float angle; // radians, of the path's direction
};

/// Half the microfacet normals of GGX lie within atan(alpha); reflection doubles angles.
float lobeAngle(float perceptualRoughness) {
    return 2.0 * square(perceptualRoughness);
}

/// Angle of the part of a lobe that one direction drawn from the lobe stands for, radians. The part's solid angle is the
/// inverse of the direction's density (Křivánek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling",
/// CGF 27(4)), so the angle grows from lobeAngle in the lobe's middle to its tail, where directions are rare. `H`: the half
/// vector. D below: ggxNormals.
float sampledAngle(float perceptualRoughness, vec3 N, vec3 H) {
    float alpha = square(perceptualRoughness);
    if (alpha <= 0.0)
        return 0.0;
    float cosine = dot(N, H);
    vec3 across = H - cosine * N; // not 1 - cosine^2, whose rounding is wider than narrow lobes
    float wider = square(cosine) + dot(across, across) / square(alpha); // sqrt(D(N) / D(H))
    return min(lobeAngle(perceptualRoughness) * wider, 0.5 * kPi);      // no part is wider than the hemisphere
}

PathSpread travelled(PathSpread spread, float distance) {
    return PathSpread(spread.width + spread.angle * distance, spread.angle);
}

/// How far the half vector between the path and a fixed light deviates from the surface's normal: half the angle of the
/// path, plus the turn of the normal across the path's width. `bend`: radians a metre.
float halfVectorSpread(PathSpread spread, float bend) {
    return 0.5 * spread.angle + bend * spread.width;
}

/// Spread after a reflection in a direction of this sampledAngle. The curvature's part depends on the direction before; the
/// lobe's part does not.
PathSpread reflected(PathSpread spread, float bend, float angle) {
    float before = spread.angle + 2.0 * bend * spread.width;
    return PathSpread(spread.width, length(vec2(before, angle)));
}

/// Fraction of the spread that sample number `count` of a mean is blurred by; `first` is the first sample's. The squared
/// bias of the mean falls with count^(-4x) and its variance with count^(2x - 1), x the exponent: both equally fast at
/// x = 1/6.
float regularizationOf(float first, float count) {
    return first * pow(max(count, 1.0), -1.0 / 6.0);
}

/// The roughness to shade with where the half vector deviates by `spread` radians.
float regularized(float perceptualRoughness, float share, float spread) {
    return max(perceptualRoughness, sqrt(min(share * spread, 1.0)));
}

#endif
