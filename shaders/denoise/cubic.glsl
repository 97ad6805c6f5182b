// Catmull and Rom's cubic between texels, which keeps a picture sharp that is read between its texels frame after frame.
#ifndef GLINT_DENOISE_CUBIC_GLSL
#define GLINT_DENOISE_CUBIC_GLSL

/// Weights of four texels in a row, `share` of the way from the second to the third.
vec4 cubicWeights(float share) {
    float s2 = share * share;
    float s3 = s2 * share;
    return 0.5 * vec4(-s3 + 2.0 * s2 - share, 3.0 * s3 - 5.0 * s2 + 2.0, -3.0 * s3 + 4.0 * s2 + share, s3 - s2);
}

#endif
