// From scene-referred linear radiance to display-referred linear colour in [0, 1].
#ifndef GLINT_LIB_TONEMAP_GLSL
#define GLINT_LIB_TONEMAP_GLSL

/// Khronos 2024, "PBR Neutral Tone Mapper" (specification, version 1.0): base colours below 0.8 stay unchanged under
/// grey light; brighter ones are compressed towards white along their hue.
vec3 tonemapNeutral(vec3 color) {
    const float kStartCompression = 0.8 - 0.04; // 0.04: the Fresnel reflection, subtracted first
    const float kDesaturation = 0.15;
    const float low = min(color.r, min(color.g, color.b));
    const float offset = low < 0.08 ? low - 6.25 * low * low : 0.04;
    color -= offset;
    const float peak = max(color.r, max(color.g, color.b));
    if (peak < kStartCompression)
        return color;
    const float d = 1.0 - kStartCompression;
    const float newPeak = 1.0 - d * d / (peak + d - kStartCompression);
    color *= newPeak / peak;
    const float toWhite = 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0);
    return mix(color, vec3(newPeak), toWhite);
}

/// AgX's sigmoid over the log-encoded range, as a polynomial: Wrensch 2023, "Minimal AgX Implementation"
/// (iolite-engine.com), mean error 3.7e-6 against Sobotka's table.
vec3 agxContrast(vec3 x) {
    const vec3 x2 = x * x;
    const vec3 x4 = x2 * x2;
    return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
}

/// Sobotka 2022, "AgX"; matrices and range as in Wrensch 2023, with the base look. Saturated light turns to white as on
/// film, at the cost of weaker colours.
vec3 tonemapAgx(vec3 color) {
    const mat3 kInset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051, //
                             0.0784335999999992, 0.878468636469772, 0.0784336,          //
                             0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    const mat3 kOutset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,   //
                              -0.0980208811401368, 1.15190312990417, -0.0980434501171241,   //
                              -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
    const float kMinEv = -12.47393;
    const float kMaxEv = 4.026069;
    const vec3 logged = log2(max(kInset * color, vec3(1e-10)));
    const vec3 shown = agxContrast((clamp(logged, kMinEv, kMaxEv) - kMinEv) / (kMaxEv - kMinEv));
    // The sigmoid's result is meant for a display of gamma 2.2; our display pass encodes sRGB, so this line undoes the
    // gamma.
    return clamp(pow(max(kOutset * shown, vec3(0.0)), vec3(2.2)), vec3(0.0), vec3(1.0));
}

#endif
