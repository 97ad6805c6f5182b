// Arithmetic that Vulkan leaves to the device, for arithmetic_test.cpp.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

struct Operands {
    float x, y, z;
    float again[3]; // the same, so that the optimizer does not know it
    float one;
};
struct Results {
    float mixed;    // mix(x, y, 1)
    float fused;    // x * y + z
    float exact;    // the same, without contraction
    float quotient; // x / x
};
layout(scalar, set = 0, binding = 0) readonly buffer OperandsBlock {
    Operands list[];
} operands;
layout(scalar, set = 0, binding = 1) writeonly buffer ResultsBlock {
    Results list[];
} results;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D halves;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(results.list.length()))
        return;
    Operands o = operands.list[i];
    precise float product = o.again[0] * o.again[1];
    precise float exact = product + o.again[2];
    results.list[i] = Results(mix(o.x, o.y, o.one), o.x * o.y + o.z, exact, o.x / o.again[0]);
    imageStore(halves, ivec2(i, 0), vec4(o.x, o.y, o.z, 1.0));
}
