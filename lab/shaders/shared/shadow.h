// Push constants of the shadow map passes.
#ifndef GLINT_SHARED_SHADOW_H
#define GLINT_SHARED_SHADOW_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct ShadowDrawConstants {
    uint instance;
    uint light;
};

GLINT_SHARED_END
#endif
