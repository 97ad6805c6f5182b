// The one rule by which sources share a pixel, or a ray. Sources are asked front to back, each gets at most the
// remaining weight, and the walk ends at 1. Replace, never add twice.
#ifndef GLINT_HIERARCHY_WALK_GLSL
#define GLINT_HIERARCHY_WALK_GLSL

/// The sum of the answers so far.
struct Walk {
    vec3 radiance; // sum of weight * radiance
    float taken;   // sum of weights, [0, 1]
};

Walk beginWalk() {
    return Walk(vec3(0.0), 0.0);
}

float remaining(Walk walk) {
    return 1.0 - walk.taken;
}

/// The largest half below 1. On GPUs the quotient of equal sums may be a little below 1, and halves may be stored rounded
/// toward 0: a weight of 1 then comes back as this one. What it would leave, a bright sky would shine through.
const float kWholeWeight = 2047.0 / 2048.0;

/// `answer`: radiance, wanted weight. Returns the weight that the source gets.
float take(inout Walk walk, vec4 answer) {
    float wanted = answer.a >= kWholeWeight ? 1.0 : answer.a;
    float share = clamp(min(wanted, remaining(walk)), 0.0, 1.0);
    walk.radiance += share * answer.rgb;
    walk.taken += share;
    return share;
}

#endif
