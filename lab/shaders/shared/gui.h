// The viewer's panels, as Dear ImGui generates them.
#ifndef GLINT_SHARED_GUI_H
#define GLINT_SHARED_GUI_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kGuiTextures, 11u); ///< the font, and two for each of five images

struct GuiVertex {
    float2 positionPX;
    float2 uv;
    uint color; ///< RGBA, 8 bits each, as displayed; red lowest
};

struct GuiConstants {
    float2 originPX; ///< of the window, in the vertices' pixels
    float2 scale;    ///< from pixels to clip space
    uint texture;    ///< index into the texture table
};

GLINT_SHARED_END
#endif
