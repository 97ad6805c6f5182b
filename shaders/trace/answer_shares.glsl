// Written by `glint shares --output shaders/trace/answer_shares.glsl`: share of right answers of each kind
// (shared/answer_kinds.h) in views of the built-in scenes. Do not edit.
#ifndef GLINT_TRACE_ANSWER_SHARES_GLSL
#define GLINT_TRACE_ANSWER_SHARES_GLSL

#include "shared/answer_kinds.h"

const float kRightShares[kAnswerKinds] = float[kAnswerKinds](
    0.944, // 201001 of 212883
    0.797, // 33904 of 42549
    0.775, // 1557 of 2002
    0.669, // 1124 of 1676
    0.390, // 218 of 564
    0.195, // 119 of 642
    0.803, // 1569 of 1947
    0.767, // 1327 of 1723
    0.460, // 228 of 497
    0.252, // 84 of 353
    0.716, // 374 of 516
    0.523, // 526 of 1004
    0.500, // 23 of 46
    0.500, // 0 of 0
    0.621, // 8 of 9
    0.520, // 3 of 5
    0.545, // 2 of 2
    0.368, // 344 of 941
    0.780, // 976 of 1244
    0.658, // 378 of 570
    0.326, // 125 of 394
    0.430, // 3810 of 8870
    0.471, // 1855 of 3941
    0.322, // 19 of 70
    0.149, // 12 of 128
    0.153, // 2204 of 14444
    0.233, // 4018 of 17292
    0.711, // 3683 of 5175
    0.760, // 5916 of 7775
    0.739, // 2084 of 2813
    0.709, // 356 of 496
    0.622); // 3238 of 5205

#endif
