// Sentinels find where reflected light changes: each tile of pixels keeps something that one of its rays found, and the
// next frame finds the same again. What differs is change and not noise: Schied, Peters and Dachsbacher 2018, "Gradient
// Estimation for Real-Time Adaptive Temporal Filtering". A sentinel that saw a change becomes the tile's witness, which
// later frames follow as well: a small light that is off is found by no new ray, but the witness sees it come back.
// docs/techniques/rough.md.
#ifndef GLINT_DENOISE_SENTINEL_GLSL
#define GLINT_DENOISE_SENTINEL_GLSL

// The state of a sentinel, whose other bits are its owner's: whether it exists, frames since it saw a change.
const uint kExists = 1u << 31;
const uint kAgeShift = 16u;
const uint kLongestAge = 255u;

// Slots of a tile in the images of sentinels, side by side.
const int kFresh = 0;
const int kWitness = 1;

uint ageOf(uint state) {
    return (state >> kAgeShift) & kLongestAge;
}

uint withAge(uint state, uint age) {
    return (state & ~(kLongestAge << kAgeShift)) | (min(age, kLongestAge) << kAgeShift);
}

/// True if a change, of how much light and of the larger of both, makes a witness.
bool isChange(vec2 change) {
    const float kChanged = 0.1;
    return change.x > kChanged * change.y;
}

/// A witness is no random sample: the older, the rarer what it saw is among those that start here. (One over its age would
/// be that share, but then small lights come back late: lab/notes/motion.md.)
float weightOfWitness(uint age) {
    return inversesqrt(float(1u + age));
}

/// True if a tile of this frame takes its brightest pixel for its sentinel, so that a light that goes out is not missed;
/// else any.
bool takesBrightest(ivec2 tile, uint frameIndex) {
    return ((uint(tile.x + tile.y) + frameIndex) & 1u) == 0u;
}

#endif
