// Geometry of the scene: bindings of every vertex stage, and of fragment stages that fetch their instance.
#ifndef GLINT_RENDER_SCENE_BINDINGS_GLSL
#define GLINT_RENDER_SCENE_BINDINGS_GLSL

#include "shared/gpu_scene.h"

layout(scalar, set = 0, binding = 0) readonly buffer InstanceBlock {
    Instance list[];
} instances;
layout(scalar, set = 0, binding = 1) readonly buffer PositionBlock {
    vec3 list[];
} positions;
layout(scalar, set = 0, binding = 2) readonly buffer AttributeBlock {
    VertexAttributes list[];
} attributes;

#endif
