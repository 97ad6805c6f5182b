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

/// An answer that wants so much of what is left gets all of it. Weights pass through quotients, which GPUs may round to a
/// little below 1, and are stored as halves, rounded toward 0. A bright sky would show through what that leaves.
const float kAll = 1.0 - 1.0 / 512.0;

/// `answer`: radiance, wanted weight. Returns the weight that the source gets.
float take(inout Walk walk, vec4 answer) {
    float left = remaining(walk);
    bool takesAll = answer.a >= kAll * left;
    float share = takesAll ? left : max(answer.a, 0.0);
    walk.radiance += share * answer.rgb;
    walk.taken = takesAll ? 1.0 : walk.taken + share;
    return share;
}

#endif
