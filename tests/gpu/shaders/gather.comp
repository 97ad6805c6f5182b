// Copies one buffer to another, each element from a distant one, so that a wrong order of dispatches shows.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 0) readonly buffer SourceBlock {
    uint value[];
} source;
layout(scalar, set = 0, binding = 1) writeonly buffer TargetBlock {
    uint value[];
} target;
layout(push_constant, scalar) uniform PushBlock {
    uint count;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < count)
        target.value[i] = source.value[count - 1u - i] + 1u;
}
