// Push constants of the display passes.
#ifndef GLINT_SHARED_DISPLAY_H
#define GLINT_SHARED_DISPLAY_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kTonemapNone, 0u); ///< clamped
GLINT_CONSTANT(uint, kTonemapNeutral, 1u);
GLINT_CONSTANT(uint, kTonemapAgx, 2u);

struct DisplayConstants {
    uint2 size;     ///< pixels
    float exposure; ///< a factor, not EV
    uint tonemap;   ///< kTonemap...
};

struct FxaaConstants {
    uint2 size; ///< pixels
};

GLINT_SHARED_END
#endif
