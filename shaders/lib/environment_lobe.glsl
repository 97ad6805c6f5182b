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
    LobePolynomial(vec4(0.5384, 1.8597, 1.5099, -3.3465), vec4(-1.9528, -5.8059, 2.1779, 0.6941), vec2(3.9623, 1.7725)),
    LobePolynomial(vec4(1.8427, 0.9447, -4.9415, -1.0872), vec4(-1.2046, 8.0130, 1.3540, 0.2474), vec2(-4.0206, 0.2544)),
    LobePolynomial(vec4(-0.2418, 0.9395, 2.6828, -1.7286), vec4(-1.7948, -3.7782, -0.8021, 2.8406), vec2(0.1092, 1.8124)),
    LobePolynomial(vec4(0.8679, 0.8359, -0.3842, -1.8179), vec4(0.7512, 0.3121, 0.9455, -1.3501), vec2(-0.7906, 1.0286)),
    LobePolynomial(vec4(0.1940, 0.2708, 0.9838, 0.5785), vec4(-0.5791, 0.2010, -0.3400, 0.2004), vec2(-0.5675, -0.1394)),
    LobePolynomial(vec4(0.4098, 0.8697, -1.2884, 1.1157), vec4(-3.4447, 5.9783, 0.9070, 1.8956), vec2(-5.8172, -1.4043)),
    LobePolynomial(vec4(0.9037, 0.7705, -0.1557, -2.5379), vec4(1.6416, 0.3937, 2.4720, -2.7318), vec2(-0.6730, 1.5586)),
    LobePolynomial(vec4(0.1897, 1.9521, -0.4730, 1.3404), vec4(-4.1420, 1.8934, -0.4765, 1.9085), vec2(-0.6472, -0.7549)),
    LobePolynomial(vec4(1.1565, -1.0608, -2.5976, -0.2881), vec4(4.8200, 0.4806, 0.5748, -4.2991), vec2(1.8854, -0.5011)),
    LobePolynomial(vec4(0.9545, -0.0261, -1.0519, -1.0211), vec4(1.1946, 1.3594, 0.6818, -0.6138), vec2(-0.2423, -0.0435)),
    LobePolynomial(vec4(0.6161, 2.1999, 0.7248, -1.4779), vec4(-1.7476, -1.2946, -0.8512, 0.0310), vec2(0.6438, 1.7066)),
    LobePolynomial(vec4(-0.2249, -0.5521, -0.0419, 0.3627), vec4(1.1065, 0.2562, -1.3085, 0.0545), vec2(-0.1346, 0.4720))
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
