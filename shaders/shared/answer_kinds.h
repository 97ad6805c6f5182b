// Kinds of answers of screen rays, by what the march knows of them. trace/answer_shares.glsl has the share of right
// ones of each kind, which `glint shares` measures.
#ifndef GLINT_SHARED_ANSWER_KINDS_H
#define GLINT_SHARED_ANSWER_KINDS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kAnswerPlain, 0);       // a hit; nothing of another brightness lies beside it
GLINT_CONSTANT(uint, kAnswerAfterHidden, 1); // the same, after the ray passed behind something
GLINT_CONSTANT(uint, kAnswerBeforeEdge, 2);  // a hit beside a silhouette, on the surface in front: 4 by place
GLINT_CONSTANT(uint, kAnswerBehindEdge, 6);  // the same, on the surface behind
GLINT_CONSTANT(uint, kAnswerSunk, 10);       // a hit of a ray that came from beside: 4 by depth
GLINT_CONSTANT(uint, kAnswerSide, 14);       // outcome side: 4 by depth, for each 3 by thickness
GLINT_CONSTANT(uint, kAnswerBackFace, 26);   // outcome backFace
GLINT_CONSTANT(uint, kAnswerInferred, 27);   // outcome inferred, on two opposite sides: 4 by distance
GLINT_CONSTANT(uint, kAnswerOneSided, 31);   // outcome inferred, on one side
GLINT_CONSTANT(uint, kAnswerKinds, 32);

GLINT_SHARED_END

#endif
