// The images from which rough surfaces' means over their lobes are taken: resolve/lobe*.comp.
#ifndef GLINT_SHARED_LOBE_MEAN_H
#define GLINT_SHARED_LOBE_MEAN_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kLobeMips, 7);
GLINT_CONSTANT(uint, kLobeTile, 1u << (kLobeMips - 1u)); ///< texels along a side that make one of the last mip

/// Texels of two mips that stand for traced pixels: the images may be larger.
struct LobeShrinkConstants {
    uint2 used;
    uint2 finerUsed;
};

GLINT_SHARED_END

#endif
