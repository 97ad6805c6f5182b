// A rough surface's reflection of an environment, as a sum of lookups in the prefiltered cube. One lookup along the mirror
// direction (Karis 2013, "Real Shading in Unreal Engine 4": N = V = R) is off by half where the lobe is cut off by the
// surface's horizon, drawn out at grazing angles or turned towards the normal. Here the lobe is a mixture of the cube's own
// kernels in the plane of incidence: the widest around the normal, which ends at the horizon, three along the lobe, and a
// small negative one about the horizon that takes back what the others' tails bring from below. Fitted by least squares to
// GGX with height-correlated Smith under skies, rooms and small lights: scripts/lib/environment_lobe.cpp, whose output
// this is. docs/techniques/composite.md.
#ifndef GLINT_LIB_ENVIRONMENT_LOBE_GLSL
#define GLINT_LIB_ENVIRONMENT_LOBE_GLSL

#include "lib/math.glsl"

const int kLobeLookups = 5;

/// Below this roughness the lobe is one lookup: what a mixture would change is narrower than a cube's texels.
const float kSmoothestLobe = 0.1;

/// Of NoV = x and perceptual roughness = y: 1, x, y, x^2; xy, y^2, x^2 y, x y^2; y^3, x^3.
struct LobePolynomial {
    vec4 low;
    vec4 middle;
    vec2 high;
};

/// Of each kernel: its angle from the normal as a multiple of the mirror direction's (the last one's: of a right angle),
/// its roughness as a multiple of the surface's, its weight. The widest takes what the weights leave.
const LobePolynomial kLobePolynomials[12] = LobePolynomial[](
    LobePolynomial(vec4(0.6043, 1.3905, 0.9191, -2.0312), vec4(-1.5932, -3.7372, 0.5965, 0.5900), vec2(2.2628, 1.1156)),
    LobePolynomial(vec4(1.7260, -0.5278, -3.2743, 0.6663), vec4(0.4000, 4.8730, -0.4564, 0.0915), vec2(-2.5094, -0.0976)),
    LobePolynomial(vec4(-0.1806, -0.0717, 2.1751, 0.6770), vec4(-1.4493, -1.4659, -2.6790, 3.6115), vec2(-2.1675, 0.4180)),
    LobePolynomial(vec4(0.9192, 0.4907, -0.4494, -1.5066), vec4(2.1529, -0.2570, 0.2217, -2.4787), vec2(0.1255, 0.9399)),
    LobePolynomial(vec4(0.0072, 0.5104, 1.8911, 0.3174), vec4(-0.9415, -1.4462, 0.3287, -0.1561), vec2(0.5321, -0.0803)),
    LobePolynomial(vec4(0.4528, 0.7176, -1.1637, -0.1921), vec4(-0.1474, 3.1024, 1.5094, -2.0297), vec2(-1.8388, -0.3935)),
    LobePolynomial(vec4(0.8369, 0.7589, 0.5875, -2.5154), vec4(1.8664, -2.2307, 2.4214, -2.6368), vec2(1.8800, 1.5027)),
    LobePolynomial(vec4(0.3833, 0.1097, -0.2097, 2.7020), vec4(-1.2727, 0.9892, -1.9681, 1.2551), vec2(-0.7002, -0.7663)),
    LobePolynomial(vec4(1.0942, -1.9738, -1.8384, 1.3448), vec4(3.4145, 0.9896, -0.3125, -1.6911), vec2(-0.1385, -0.8813)),
    LobePolynomial(vec4(1.0461, -0.7702, -1.2126, -0.8642), vec4(4.3358, 1.1902, 0.9298, -3.9795), vec2(0.0596, -0.1349)),
    LobePolynomial(vec4(0.5566, 2.7834, 1.0247, 0.3872), vec4(-6.4966, -1.2445, -0.7395, 4.1269), vec2(0.1086, 0.2025)),
    LobePolynomial(vec4(-0.1980, 1.2891, -0.8895, -2.1572), vec4(-0.1412, 1.3013, 0.5728, -0.5875), vec2(-0.3620, 1.1613))
);

struct LobeLookup {
    vec3 direction;
    float perceptualRoughness;
    float weight;
};

float lobePolynomial(int i, float x, float y) {
    LobePolynomial p = kLobePolynomials[i];
    return dot(p.low, vec4(1.0, x, y, x * x)) + dot(p.middle, vec4(x * y, y * y, x * x * y, x * y * y)) +
           dot(p.high, vec2(y * y * y, x * x * x));
}

/// A lobe, and what all of its lookups share.
struct EnvironmentLobe {
    vec3 N;
    vec3 T; // unit, in the plane of incidence, to the mirror direction's side
    float NoV;
    float turn; // radians from the normal to the mirror direction
    float fitted; // roughness; smoother lobes are this one, made narrower
    float narrow; // by this factor of roughness
    float left; // weight
};

EnvironmentLobe beginLobe(vec3 N, vec3 V, float perceptualRoughness) {
    const float kLeastFitted = 0.2;
    const float kGrazing = 0.08; // as far as it is fitted
    float NoV = clamp(dot(N, V), kGrazing, 1.0);
    EnvironmentLobe lobe;
    lobe.N = N;
    lobe.T = normalizeOr(dot(N, V) * N - V, orthonormalBasis(N)[0]);
    lobe.NoV = NoV;
    lobe.turn = acos(NoV);
    lobe.fitted = max(perceptualRoughness, kLeastFitted);
    lobe.narrow = perceptualRoughness / lobe.fitted;
    lobe.left = 1.0;
    return lobe;
}

/// Lookup `i` of kLobeLookups, in turn: the last one is the widest.
LobeLookup nextLookup(int i, inout EnvironmentLobe lobe) {
    if (i == kLobeLookups - 1)
        return LobeLookup(lobe.N, 1.0, lobe.left);
    float angle = lobePolynomial(3 * i, lobe.NoV, lobe.fitted) * (i == 3 ? 0.5 * kPi : lobe.turn);
    float roughness = lobe.fitted * lobePolynomial(3 * i + 1, lobe.NoV, lobe.fitted);
    float weight = lobePolynomial(3 * i + 2, lobe.NoV, lobe.fitted);
    angle = mix(lobe.turn, angle, square(lobe.narrow)); // by the lobe's width, which is alpha
    roughness = lobe.narrow * clamp(roughness, 0.1, 1.0);
    lobe.left -= weight;
    return LobeLookup(cos(angle) * lobe.N + sin(angle) * lobe.T, roughness, weight);
}

#endif
