// Written by `glint shares --output shaders/trace/answer_shares.glsl`: share of right answers of each kind
// (shared/answer_kinds.h) in the built-in scenes. Do not edit.
#ifndef GLINT_TRACE_ANSWER_SHARES_GLSL
#define GLINT_TRACE_ANSWER_SHARES_GLSL

#include "shared/answer_kinds.h"

const float kRightShares[kAnswerKinds] = float[kAnswerKinds](
    0.990, 0.900, 0.900, 0.800, 0.650, 0.500, 0.900, 0.800, 0.650, 0.500, 0.700, 0.600, 0.500, 0.500, 0.500, 0.500,
    0.500, 0.500, 0.500, 0.500, 0.500, 0.500, 0.500, 0.500, 0.500, 0.500, 0.300, 0.900, 0.800, 0.700, 0.600, 0.500);

#endif
