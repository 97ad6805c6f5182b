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

/// `answer`: radiance, wanted weight. Returns the weight that the source gets.
float take(inout Walk walk, vec4 answer) {
    float share = clamp(min(answer.a, remaining(walk)), 0.0, 1.0);
    walk.radiance += share * answer.rgb;
    walk.taken += share;
    return share;
}

#endif
