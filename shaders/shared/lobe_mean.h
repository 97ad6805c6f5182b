// The images from which rough surfaces' means over their lobes are taken: resolve/lobe*.comp.
#ifndef GLINT_SHARED_LOBE_MEAN_H
#define GLINT_SHARED_LOBE_MEAN_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kLobeMips, 7);

GLINT_SHARED_END

#endif
