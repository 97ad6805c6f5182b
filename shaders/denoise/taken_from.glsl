// Where accumulate.comp took a pixel's history from, for passes with histories of their own: pixels of the previous frame,
// relative to the pixel.
#ifndef GLINT_DENOISE_TAKEN_FROM_GLSL
#define GLINT_DENOISE_TAKEN_FROM_GLSL

const vec2 kNoPlace = vec2(6.0e4);

bool hasPlace(vec2 from) {
    return from.x != kNoPlace.x;
}

#endif
