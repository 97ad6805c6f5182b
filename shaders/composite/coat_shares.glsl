// The clear coats over the surfaces that a pixel shows. Each reflects the scene by itself, and dims its surface by what it
// reflects: KHR_materials_clearcoat, "Layering". Needs the bindings, Share and the loads of composite_main.glsl.

struct Coat {
    float reflectivity; // F0 times strength; 0: there is no coat
    float reflectance;  // fraction of reflected light that it sends to the eye
    float NoV;
    vec4 reflection; // weighted radiance, total weight
};

/// The coat over the surface of a share.
Coat coatOver(ivec2 px, Share share) {
    Coat coat = Coat(0.0, 0.0, 1.0, vec4(0.0));
    if (share.coverage <= 0.0 || texelFetch(viewZ, share.at, 0).r >= kBackgroundZ)
        return coat;
    Surface film = unpackSurface(texelFetch(coatSurface, share.at, 0).xy);
    if (film.reflectivity <= 0.0)
        return coat;
    coat.reflectivity = film.reflectivity;
    coat.NoV = max(viewCosine(px, 1.0, film.normalVS), 1e-3); // the line of sight is the same at any depth
    coat.reflectance = coatReflectance(film.reflectivity, coat.NoV);
    coat.reflection = texelFetch(coatReflected, share.at, 0);
    return coat;
}

bool isReflecting(Coat coat) {
    return coat.reflectivity * coat.reflection.a > 0.0;
}

/// Sums over the lobes of a pixel.
struct Lobes {
    vec3 value;    // parts of what the pixel reflects
    vec3 replaced; // those whose light the sources know
    vec3 added;    // that light
};

void addLobe(float part, Response response, vec4 reflection, inout Lobes sum) {
    sum.value += part * response.value;
    sum.replaced += part * response.value * (reflection.a * response.taken);
    sum.added += part * (reflection.rgb * response.value);
}

void addLobes(Share share, Coat coat, inout Lobes sum) {
    addLobe(share.coverage * (1.0 - coat.reflectance), response(share), share.reflection, sum);
    if (coat.reflectivity <= 0.0)
        return;
    float full = settings.fresnel != 0u ? coat.reflectance : coat.reflectivity;
    addLobe(share.coverage, userResponse(settings, vec3(full)), coat.reflection, sum);
}

/// As `physical`: each lobe gets the part of `fallback` that its response claims.
vec3 physicalCoated(vec3 lit, vec3 fallback, Share front, Coat frontCoat, Share second, Coat secondCoat) {
    Lobes sum = Lobes(vec3(0.0), vec3(0.0), vec3(0.0));
    addLobes(front, frontCoat, sum);
    addLobes(second, secondCoat, sum);
    return lit - sum.replaced / max(sum.value, vec3(1e-6)) * fallback + sum.added;
}

/// The coat's reflection over the surface's.
vec3 lerpedCoat(Share share, Coat coat) {
    vec3 below = lerpedSurface(share);
    if (coat.reflectivity <= 0.0)
        return below;
    return lerpedReflection(settings, below, coat.reflection, vec3(coat.reflectivity), coat.reflectivity / kCoatF0,
                            coat.NoV);
}

vec3 lerpedCoated(vec3 lit, Share front, Coat frontCoat, Share second, Coat secondCoat) {
    if (front.coverage >= 1.0)
        return lerpedCoat(front, frontCoat);
    return lit + front.coverage * (lerpedCoat(front, frontCoat) - front.lit) +
           second.coverage * (lerpedCoat(second, secondCoat) - second.lit);
}

/// The pixel with its reflections. False if no source has answered for any lobe.
bool coated(ivec2 px, vec3 lit, vec3 fallback, Share front, Share second, out vec3 result) {
    Coat frontCoat = coatOver(px, front);
    Coat secondCoat = coatOver(px, second);
    result = lit;
    if (!isReflecting(front) && !isReflecting(second) && !isReflecting(frontCoat) && !isReflecting(secondCoat))
        return false;
    result = settings.model == 0u ? physicalCoated(lit, fallback, front, frontCoat, second, secondCoat)
                                  : lerpedCoated(lit, front, frontCoat, second, secondCoat);
    return true;
}
