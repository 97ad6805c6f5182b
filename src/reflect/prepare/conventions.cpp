#include "reflect/prepare/conventions.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace glint::reflect {
namespace {

using glm::dmat4;
using glm::dvec4;

/// NDC depth of a point `viewZ` metres away; `hostZSign` is -1 where the host's view space looks down -Z.
double ndcDepth(const dmat4& hostViewToClip, double hostZSign, double viewZ) {
    const dvec4 clip = hostViewToClip * dvec4(0, 0, hostZSign * viewZ, 1);
    return clip.z / clip.w;
}

} // namespace

shared::FrameConstants makeFrameConstants(const View& view, const Conventions& conventions, uint32_t width,
                                          uint32_t height) {
    const bool leftHanded = conventions.handedness == Handedness::Left;
    const double hostZSign = leftHanded ? 1 : -1;
    const dmat4 flipZ = dmat4(dvec4(1, 0, 0, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, -1, 0), dvec4(0, 0, 0, 1));
    dmat4 hostViewToClip = glm::make_mat4(view.viewToClip.data());
    const bool orthographic = hostViewToClip[2].w == 0;
    // A projection is defined up to a factor: scale it so that clip.w is viewZ (orthographic: 1).
    hostViewToClip /= orthographic ? hostViewToClip[3].w : std::abs(hostViewToClip[2].w);
    const dmat4 hostWorldToView = glm::make_mat4(view.worldToView.data());
    const dmat4 worldToView = leftHanded ? flipZ * hostWorldToView : hostWorldToView;
    dmat4 viewToClip = leftHanded ? hostViewToClip * flipZ : hostViewToClip;
    if (conventions.clipYDown)
        for (int column = 0; column < 4; ++column)
            viewToClip[column].y = -viewToClip[column].y;

    shared::FrameConstants frame = {};
    const double w = width;
    const double h = height;
    frame.size = {static_cast<float>(width), static_cast<float>(height)};
    frame.invSize = {static_cast<float>(1 / w), static_cast<float>(1 / h)};
    // +Y up in NDC, but pixel rows count from the top.
    const dmat4 clipToPixel(dvec4(w / 2, 0, 0, 0), dvec4(0, -h / 2, 0, 0), dvec4(0, 0, 1, 0),
                            dvec4(w / 2, h / 2, 0, 1));
    frame.viewToPixel = glm::mat4(clipToPixel * viewToClip);
    frame.worldToView = glm::mat4(worldToView);
    frame.viewToWorld = glm::mat4(glm::inverse(worldToView));
    frame.worldToEnvironment = glm::mat4(1);

    // For a perspective camera clip.w = viewZ, so ndc = m00 * x / viewZ - m20; for an orthographic one w = 1.
    const double offsetX = orthographic ? -viewToClip[3].x : viewToClip[2].x;
    const double offsetY = orthographic ? -viewToClip[3].y : viewToClip[2].y;
    frame.uvToView = glm::vec4(dvec4(2 / viewToClip[0].x, -2 / viewToClip[1].y, (offsetX - 1) / viewToClip[0].x,
                                     (offsetY + 1) / viewToClip[1].y));

    // ndc = (z22 z + z32) / (w23 z + w33) with z = hostZSign * viewZ, solved for viewZ.
    const double z22 = hostViewToClip[2].z;
    const double z32 = hostViewToClip[3].z;
    const double w23 = hostViewToClip[2].w;
    const double w33 = hostViewToClip[3].w;
    frame.depthToViewZ =
        glm::vec4(dvec4(-w33 * hostZSign, z32 * hostZSign, w23, -z22)); // viewZ = (y + x ndc) / (w + z ndc)
    const bool linear = conventions.depth == DepthKind::LinearViewZ;
    frame.depthScale = linear ? conventions.linearDepthScale : (conventions.depthMinusOneToOne ? 2.0f : 1.0f);
    frame.depthOffset = conventions.depthMinusOneToOne ? -1 : 0;

    const bool reversed = ndcDepth(hostViewToClip, hostZSign, 1) > ndcDepth(hostViewToClip, hostZSign, 2);
    const double nearNdc = reversed ? 1 : (conventions.depthMinusOneToOne ? -1 : 0);
    frame.farDepth = reversed ? 0 : 1;
    const double nearZ = hostZSign * (z32 - nearNdc * w33) / (nearNdc * w23 - z22);
    frame.nearZ = static_cast<float>(orthographic ? nearZ : std::max(nearZ, 1e-6));

    frame.flags =
        (orthographic ? shared::kInputOrthographic : 0) | (reversed ? shared::kInputReversedDepth : 0) |
        (leftHanded ? shared::kInputLeftHanded : 0) | (linear ? shared::kInputLinearDepth : 0) |
        (conventions.normalSpace == NormalSpace::View ? shared::kInputNormalView : 0) |
        (conventions.roughness == RoughnessKind::Alpha ? shared::kInputAlpha : 0) |
        (conventions.roughness == RoughnessKind::Smoothness || conventions.material == MaterialKind::SpecularGlossiness
             ? shared::kInputSmoothness
             : 0);
    const NormalEncoding encoding = conventions.normalEncoding;
    if (encoding == NormalEncoding::Octahedral || encoding == NormalEncoding::OctahedralUnorm)
        frame.flags |= shared::kInputNormalOctahedral;
    if (encoding == NormalEncoding::Unorm || encoding == NormalEncoding::OctahedralUnorm)
        frame.flags |= shared::kInputNormalUnorm;
    frame.materialKind = static_cast<uint32_t>(conventions.material);
    frame.frameIndex = view.frameIndex;
    frame.seed = view.seed;
    return frame;
}

} // namespace glint::reflect
