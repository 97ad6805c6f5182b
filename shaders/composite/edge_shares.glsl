// The surfaces that a pixel with several samples shows, and what their neighbours know of them.
// Needs the bindings, Share and the loads of composite_main.glsl.

/// The pixel whose surface is most similar to this one, among `px` and the pixels around it; -1 if none is similar.
/// `whole`: only pixels that show one surface alone.
ivec2 likestPixel(ivec2 px, float z, vec3 normalVS, bool whole) {
    ivec2 best = ivec2(-1);
    float bestDifference = 0.3; // a quarter of the distance, or 45 degrees
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = clamp(px + ivec2(x, y), ivec2(0), ivec2(frame.constants.size) - 1);
            if (whole && loadMaterial(at).a < 1.0)
                continue;
            Surface there = unpackSurface(texelFetch(surface, at, 0).xy);
            float difference = abs(texelFetch(viewZ, at, 0).r - z) / z + (1.0 - dot(there.normalVS, normalVS));
            if (difference < bestDifference) {
                bestDifference = difference;
                best = at;
            }
        }
    return best;
}

/// The surface's lit radiance, taken from nearby where the pixel itself shows other surfaces too.
vec3 litNearby(ivec2 px, float z, vec3 normalVS) {
    ivec2 at = likestPixel(px, z, normalVS, true);
    return loadLit(at.x >= 0 ? at : px);
}

/// `lit`: the pixel's.
Share frontShare(ivec2 px, float z, Surface here, vec3 lit) {
    vec4 resolved = loadMaterial(px);
    vec3 f0 = here.reflectivity > 0.0 ? resolved.rgb : vec3(0.0);
    if (resolved.a < 1.0 && settings.model != 0u)
        lit = litNearby(px, z, here.normalVS);
    return Share(resolved.a, f0, loadF90(px), here.perceptualRoughness, viewCosine(px, z, here.normalVS),
                 texelFetch(reflected, px, 0), lit, px);
}

/// The second surface of an edge. No ray was traced for it, but its neighbour has the answer. Without a neighbour's
/// answer no light is replaced.
Share secondShare(ivec2 px, float frontCoverage) {
    Share none = Share(0.0, vec3(0.0), 1.0, 1.0, 1.0, vec4(0.0), vec3(0.0), px);
    if (frontCoverage >= 1.0)
        return none;
    Edge second = unpackEdge(texelFetch(edge, px, 0));
    if (second.coverage <= 0.0)
        return none;
    ivec2 at = likestPixel(px, second.viewZ, second.normalVS, false);
    if (at.x < 0)
        return none;
    vec3 lit = settings.model != 0u ? litNearby(px, second.viewZ, second.normalVS) : vec3(0.0);
    float roughness = unpackSurface(texelFetch(surface, at, 0).xy).perceptualRoughness;
    return Share(second.coverage, second.f0, loadF90(at), roughness,
                 viewCosine(px, second.viewZ, second.normalVS), texelFetch(reflected, at, 0), lit, at);
}
