// The shape of a surface's lobe on the screen: how far the mirror directions of a pixel's neighbours turn away from
// what the pixel's own ray hits, and the Gaussians whose sum is GGX. Shared by the means over a lobe of the screen's
// answers (resolve/lobe.comp) and of planar mirrors.
#ifndef GLINT_LIB_LOBE_SHAPE_GLSL
#define GLINT_LIB_LOBE_SHAPE_GLSL

#include "lib/math.glsl"

/// GGX half vectors lean by slopes beyond s with the share 1 / (1 + x), x = (s / alpha)^2. That is the mean of exp(-t
/// x) over t with the density exp(-t): Gaussians of the variance alpha^2 / (2 t) an axis. Four of them, each for one
/// part of all t, are within .016 of the share, and within a quarter of it out to ten times alpha.
const int kLobeParts = 4;
const float kLobeShares[kLobeParts] = float[kLobeParts](0.4493, 0.3295, 0.1630, 0.0582);
const float kLobeWidths[kLobeParts] = float[kLobeParts](0.5423, 1.0206, 1.8898, 5.0); // standard deviations in alpha

/// Turns beyond this say nothing of a place on the screen; radians.
const float kWidestTurn = 0.5;

/// A ray that leaves a surface, and the surface's lobe around it. A half vector that leans by a slope s turns the ray
/// by 2 s in the plane of incidence, and by 2 s NoV across.
struct LobeAxes {
    vec3 upVS;   // unit, at right angles to the ray, in the plane of incidence towards the normal
    vec3 sideVS; // unit, across both
    float NoV;
    float sine;
};

LobeAxes lobeAxes(vec3 directionVS, vec3 normalVS) {
    LobeAxes axes;
    axes.NoV = clamp(dot(directionVS, normalVS), 1e-3, 1.0);
    axes.sine = sqrt(1.0 - square(axes.NoV));
    vec3 any = abs(directionVS.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    axes.upVS = normalVS - dot(directionVS, normalVS) * directionVS;
    axes.upVS = dot(axes.upVS, axes.upVS) > 1e-8 ? normalize(axes.upVS) : normalize(cross(directionVS, any));
    axes.sideVS = cross(directionVS, axes.upVS);
    return axes;
}

vec2 alongAxes(LobeAxes axes, vec3 v) {
    return vec2(dot(v, axes.upVS), dot(v, axes.sideVS));
}

/// What a facet counts that turns the ray by `turn` towards `up`, relative to one that does not: by how much of it is
/// visible to the eye. 0 where it reflects below the surface.
float facetVisible(LobeAxes axes, float turn) {
    float slope = clamp(0.5 * turn, -1.0, 1.0);
    bool below = axes.NoV + turn * axes.sine <= 0.0;
    return below ? 0.0 : max(1.0 + slope * axes.sine / axes.NoV, 0.0);
}

/// An ellipse on the screen: standard deviations in pixels along its axes.
struct LobeEllipse {
    vec2 along; // unit
    float longPX;
    float shortPX;
};

/// `turns`: change of direction from pixel to pixel, along up and side, of a step in x and in y. `widths`: standard
/// deviations of the lobe along up and side.
LobeEllipse lobeEllipse(mat2 turns, vec2 widths) {
    float area = determinant(turns);
    const float kWidest = 1e4; // pixels
    if (abs(area) < 1e-14)
        return LobeEllipse(vec2(1.0, 0.0), kWidest, kWidest);
    mat2 pixels = inverse(turns);
    vec2 up = pixels[0] * widths.x;
    vec2 side = pixels[1] * widths.y;
    float xx = square(up.x) + square(side.x);
    float yy = square(up.y) + square(side.y);
    float xy = up.x * up.y + side.x * side.y;
    float mean = 0.5 * (xx + yy);
    float apart = sqrt(square(0.5 * (xx - yy)) + square(xy));
    vec2 along = xx >= yy ? vec2(mean + apart - yy, xy) : vec2(xy, mean + apart - xx);
    return LobeEllipse(normalizeOr(vec3(along, 0.0), vec3(1.0, 0.0, 0.0)).xy, min(sqrt(mean + apart), kWidest),
                       min(sqrt(max(mean - apart, 0.0)), kWidest));
}

/// Filtered texels in a line, which together have the shape of an ellipse.
struct LobeTaps {
    int side;      // number to each side of the middle one
    float blur;    // standard deviation of each, pixels
    float spacing; // pixels
    float line;    // standard deviation of their weights, pixels
    float mip;
};

/// The standard deviation of a texel of mip 0, filtered linearly, and of mip 1 (lib/lobe_mips.glsl), in texels of mip 0;
/// further mips double it.
const float kSharpTexel = 0.41;
const float kFirstMip = 1.6;

/// The mip at which texels are a blur of this standard deviation. Between two mips variances mix.
float lobeMip(float blur) {
    if (blur < kFirstMip)
        return clamp((square(blur) - square(kSharpTexel)) / (square(kFirstMip) - square(kSharpTexel)), 0.0, 1.0);
    float finer = floor(log2(blur / kFirstMip));
    return 1.0 + finer + (square(blur / (kFirstMip * exp2(finer))) - 1.0) / 3.0;
}

/// Standard deviations of one of the Gaussians along up and side.
vec2 lobeWidths(LobeAxes axes, float alpha, int part) {
    float lean = 2.0 * alpha * kLobeWidths[part];
    return min(vec2(lean, lean * axes.NoV), vec2(kWidestTurn));
}

/// `lastMip`: the coarsest.
LobeTaps lobeTaps(LobeEllipse ellipse, int mostToSide, float lastMip) {
    const float kReach = 2.3;   // standard deviations
    const float kSpacing = 2.0; // of the texels' own blur: their sum has ripples below .015
    float narrowest = kReach * ellipse.longPX / (kSpacing * float(mostToSide) + kReach);
    float blur = max(max(ellipse.shortPX, narrowest), kSharpTexel);
    LobeTaps taps;
    taps.blur = blur;
    taps.line = sqrt(max(square(ellipse.longPX) - square(blur), 0.0));
    taps.side = int(clamp(ceil(kReach * taps.line / (kSpacing * blur) - 0.2), 0.0, float(mostToSide)));
    taps.spacing = kReach * taps.line / max(float(taps.side), 1.0);
    taps.mip = min(lobeMip(blur), lastMip);
    return taps;
}

/// Of the tap this many places from the middle.
float tapWeight(LobeTaps taps, int place) {
    return taps.side > 0 ? exp(-0.5 * square(float(place) * taps.spacing / taps.line)) : 1.0;
}

/// What light counts that a tap shows, if its lobe is `ratio` times as wide as the taps' ellipse: the quotient of both
/// Gaussians, at most 1, as the ellipse is that of the widest. Texels cannot be told apart in less than their own blur.
/// `away`: from the middle, in standard deviations of the ellipse.
float narrowerLobe(LobeEllipse ellipse, LobeTaps taps, float away, float ratio) {
    float least = clamp(taps.blur / max(ellipse.longPX, 1e-3), 0.3, 1.0);
    float inverse2 = 1.0 / square(clamp(ratio, least, 1.0));
    return min(inverse2 * exp(0.5 * square(away) * (1.0 - inverse2)), 1.0);
}

#endif
