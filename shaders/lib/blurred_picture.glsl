// Blurs an image with its mips and shows no blocks: a cubic B-spline over each mip, with four filtered fetches instead
// of sixteen texels. Sigg and Hadwiger 2005, "Fast Third-Order Texture Filtering", GPU Gems 2, chapter 20.
#ifndef GLINT_LIB_BLURRED_PICTURE_GLSL
#define GLINT_LIB_BLURRED_PICTURE_GLSL

vec3 splineMip(sampler2D picture, vec2 uv, float mip) {
    vec2 size = vec2(textureSize(picture, int(mip)));
    vec2 at = uv * size - 0.5;
    vec2 corner = floor(at);
    vec2 f = at - corner;
    vec2 w0 = (1.0 - f) * (1.0 - f) * (1.0 - f) / 6.0;
    vec2 w1 = (4.0 - 6.0 * f * f + 3.0 * f * f * f) / 6.0;
    vec2 w3 = f * f * f / 6.0;
    vec2 w2 = 1.0 - w0 - w1 - w3;
    vec2 low = w0 + w1;
    vec2 high = w2 + w3;
    vec2 lowUV = (corner - 0.5 + w1 / low) / size;
    vec2 highUV = (corner + 1.5 + w3 / high) / size;
    vec3 top = low.x * textureLod(picture, lowUV, mip).rgb + high.x * textureLod(picture, vec2(highUV.x, lowUV.y), mip).rgb;
    vec3 bottom =
        low.x * textureLod(picture, vec2(lowUV.x, highUV.y), mip).rgb + high.x * textureLod(picture, highUV, mip).rgb;
    return low.y * top + high.y * bottom;
}

/// `radiusPX`: approximate standard deviation of the blur, in pixels of mip 0. Up to a quarter: the image itself.
vec3 blurredPicture(sampler2D picture, vec2 uv, float radiusPX) {
    vec3 sharp = textureLod(picture, uv, 0.0).rgb;
    if (radiusPX <= 0.25)
        return sharp;
    // The spline alone blurs by 0.58 of a texel, and box-filtered texels by 0.29: 0.65 together.
    float mip = clamp(log2(radiusPX / 0.65), 0.0, float(textureQueryLevels(picture) - 1));
    vec3 blurred = mix(splineMip(picture, uv, floor(mip)), splineMip(picture, uv, ceil(mip)), fract(mip));
    return mix(sharp, blurred, clamp((radiusPX - 0.25) / 0.4, 0.0, 1.0));
}

#endif
