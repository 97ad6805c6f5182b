// Internal colours are linear with Rec. 709 primaries; the sRGB curve is applied at the display only.
#ifndef GLINT_LIB_COLOR_GLSL
#define GLINT_LIB_COLOR_GLSL

/// ITU-R BT.709: relative luminance of linear RGB.
float luminance(vec3 rgb) {
    return dot(rgb, vec3(0.2126, 0.7152, 0.0722));
}

/// Non-negative colour for a format that ends at 1: scales a brighter colour down as a whole, which keeps its hue.
vec3 scaledToOne(vec3 rgb) {
    return rgb / max(max(rgb.r, max(rgb.g, rgb.b)), 1.0);
}

/// IEC 61966-2-1: linear [0, 1] -> sRGB [0, 1].
vec3 encodeSrgb(vec3 linear) {
    const vec3 low = linear * 12.92;
    const vec3 high = 1.055 * pow(max(linear, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

/// The inverse of encodeSrgb; continues past 1 along the same curve.
vec3 decodeSrgb(vec3 encoded) {
    const vec3 low = encoded / 12.92;
    const vec3 high = pow((max(encoded, vec3(0.0)) + 0.055) / 1.055, vec3(2.4));
    return mix(high, low, lessThanEqual(encoded, vec3(0.04045)));
}

#endif
