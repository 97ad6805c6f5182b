// The answer of a ray that passed behind something before its hit, where no back faces tell how thick that is: the ray
// may have met its unseen side instead.
#ifndef GLINT_TRACE_BEHIND_HIDDEN_GLSL
#define GLINT_TRACE_BEHIND_HIDDEN_GLSL

#include "lib/math.glsl"

/// Weight of an answer of the mean radiance `answer`, if a surface as bright as `hiding` is as likely to be right. The
/// squares of both relative errors, (w a - a) / a and (w a - h) / h, have their least sum at w = (1 + a / h) / (1 + (a
/// / h)^2). So a lamp behind a dark body is not taken, and a wall behind another wall is.
float weightBehind(float answer, float hiding) {
    const float kDark = 0.05; // radiance below which differences are not seen
    float ratio = max(answer / max(hiding, kDark), 1.0);
    return (1.0 + ratio) / (1.0 + square(ratio));
}

#endif
