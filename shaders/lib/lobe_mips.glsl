// The weights of mips from which means over lobes are taken: of eight texels in a row, (1 7 21 35 35 21 7 1) / 128.
// That is twice as wide as a mip need be: texels that overlap so far show no grid where they are filtered linearly, and
// light smaller than a texel stays round.
#ifndef GLINT_LIB_LOBE_MIPS_GLSL
#define GLINT_LIB_LOBE_MIPS_GLSL

const int kLobeMipSide = 8;
const float kLobeMipWeights[4] = float[4](35.0 / 128.0, 21.0 / 128.0, 7.0 / 128.0, 1.0 / 128.0);

/// `distance`: of a texel's centre from the coarser texel's, in texels. Between .5, 1.5, ...: where sizes are odd.
float lobeMipWeight(float distance) {
    float at = max(abs(distance) - 0.5, 0.0);
    int low = int(at);
    return low > 3 ? 0.0 : mix(kLobeMipWeights[low], low < 3 ? kLobeMipWeights[low + 1] : 0.0, at - float(low));
}

#endif
