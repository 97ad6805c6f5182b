// Geometry of the scene: bindings of every vertex stage, and of fragment stages that fetch their instance.
#ifndef GLINT_RENDER_SCENE_BINDINGS_GLSL
#define GLINT_RENDER_SCENE_BINDINGS_GLSL

#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require

#include "shared/gpu_scene.h"

layout(scalar, set = 0, binding = 0) readonly buffer InstanceBlock {
    Instance list[];
} instances;
layout(scalar, set = 0, binding = 1) readonly buffer GeometryBlock {
    GeometryAddresses at;
} geometry;
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Positions {
    vec3 list[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Attributes {
    VertexAttributes list[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Indices {
    uint list[];
};

vec3 loadPositionLS(int vertex) {
    return Positions(geometry.at.positions).list[vertex];
}

VertexAttributes loadAttributes(int vertex) {
    return Attributes(geometry.at.attributes).list[vertex];
}

/// The vertex, relative to the instance's vertexOffset, of a corner of one of its triangles.
uint loadIndex(Instance instance, uint triangle, uint corner) {
    return Indices(geometry.at.indices).list[instance.firstIndex + 3u * triangle + corner];
}

#endif
