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

GLINT_CONSTANT(uint, kViewFraction, 0u); ///< render::ViewKind: how a view's values map to colours
GLINT_CONSTANT(uint, kViewDirection, 1u);
GLINT_CONSTANT(uint, kViewDistance, 2u);
GLINT_CONSTANT(uint, kViewCount, 3u);
GLINT_CONSTANT(uint, kViewMotion, 4u);
GLINT_CONSTANT(float, kViewHalfWhite, 5.0f);        ///< metres at which a distance is middle grey
GLINT_CONSTANT(float, kViewRedCount, 4096.0f);      ///< screen.maxSteps' upper bound
GLINT_CONSTANT(float, kViewLargestMotion, 0.0625f); ///< UV, or metres, at which a motion is black or white

struct ViewConstants {
    uint2 size; ///< pixels
    uint kind;  ///< kView...
};

struct MeanConstants {
    uint2 size;  ///< pixels
    uint frames; ///< whose mean it is, with the frame that is added
};

struct FxaaConstants {
    uint2 size; ///< pixels
};

GLINT_SHARED_END
#endif
