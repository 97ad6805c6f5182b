// Reads and writes one buffer: element i becomes element i * factor + addend of the dispatch before.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 0) buffer ValuesBlock {
    uint value[];
} values;
layout(push_constant, scalar) uniform PushBlock {
    uint count;
    uint factor;
    uint addend;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < count)
        values.value[i] = values.value[i] * factor + addend;
}
