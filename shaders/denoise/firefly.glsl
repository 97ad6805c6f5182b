// The limit for single bright answers: settings' denoise.firefly.
// Needs reused, reusedMeta, settings and denoise/averaged_surface.glsl.

/// Luminance that this frame's answer may have: some times that of the history, what the history's scatter explains, or
/// some times that of the pixels around. Those that share rays with this one are no witnesses. `history` holds what
/// accumulate.comp's `meta` does.
float mostBrightness(ivec2 px, LobeSurface here, float near, vec4 answer, vec4 history, float frames) {
    const float kKnown = 4.0;      // frames that tell of the scatter
    const float kWideLobe = 4.0;   // pixels: narrower ones may show what one pixel alone shows
    const float kDeviations = 0.5; // of the scatter, for each time of the mean
    float brightness = luminance(answer.rgb);
    float lobe = lobePixels(here.perceptualRoughness, here.viewZ, near);
    if (frames < kKnown && lobe < kWideLobe)
        return brightness;
    float scatter = sqrt(max(history.z - square(history.y), 0.0));
    float usual = max(settings.firefly * history.y, history.y + kDeviations * settings.firefly * scatter);
    float most = frames < kKnown ? 0.0 : usual;
    if (brightness <= most)
        return brightness;
    float radius = 1.0 + 1.5 * clamp(0.5 * lobe, 1.0, settings.reuseRadius);
    mat2 disc = lobeDisc(here, radius);
    Spiral spiral = beginSpiral(1u, hashNoise(uvec2(px), frame.constants.frameIndex, frame.constants.seed).y);
    vec4 around = vec4(0.0);
    for (uint i = 0u; i < 8u; ++i) {
        nextPoint(spiral, i);
        ivec2 tap = floorToInt(vec2(px) + 0.5 + disc * spiral.direction);
        if (isInFrame(tap) && texelFetch(reusedMeta, tap, 0).g > 0.0 && isSameSurface(here, averagedSurfaceAt(tap)))
            around += texelFetch(reused, tap, 0);
    }
    return around.a > 0.0 ? max(most, settings.firefly * luminance(around.rgb) * answer.a / around.a) : brightness;
}
