// The materials of the scene, for fragment stages.
#ifndef GLINT_RENDER_MATERIAL_BINDING_GLSL
#define GLINT_RENDER_MATERIAL_BINDING_GLSL

#include "shared/material.h"

layout(scalar, set = 0, binding = 3) readonly buffer MaterialBlock {
    Material list[];
} materials;

#endif
