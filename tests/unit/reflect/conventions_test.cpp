// FrameConstants against an oracle in double precision that knows the camera itself: focal lengths, planes and offsets,
// not matrices. Every combination of what a host may choose.
#include "reflect/prepare/conventions.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::reflect {
namespace conventions_test {

/// A camera and how its host writes it down.
struct Host {
    bool reversed = true;
    bool infinite = true; ///< perspective only
    bool minusOneToOne = false;
    bool yDown = false;
    bool leftHanded = false;
    bool orthographic = false;
    bool jittered = false;

    double focalX = 1.3; ///< perspective: 1 / tan(half the horizontal angle)
    double focalY = 2.1;
    double halfWidth = 4; ///< orthographic, metres
    double halfHeight = 2.5;
    double near = 0.07;
    double far = 90;

    glm::dvec2 offsetNdc() const { return jittered ? glm::dvec2(0.031, -0.017) : glm::dvec2(0); } ///< +Y up

    std::string describe() const {
        return std::string(orthographic ? "orthographic" : "perspective") + (reversed ? " reversed" : " normal") +
               (infinite ? " infinite" : " finite") + (minusOneToOne ? " [-1,1]" : " [0,1]") +
               (yDown ? " y-down" : " y-up") + (leftHanded ? " left" : " right") + (jittered ? " jittered" : "");
    }

    /// NDC depth at `viewZ`: between the ends for near and far, linear in 1/viewZ or in viewZ.
    double ndcDepth(double viewZ) const {
        const double low = minusOneToOne ? -1 : 0;
        const double atNear = reversed ? 1 : low;
        const double atFar = reversed ? low : 1;
        if (orthographic)
            return atNear + (atFar - atNear) * (viewZ - near) / (far - near);
        if (infinite)
            return atFar + (atNear - atFar) * near / viewZ;
        return atFar + (atNear - atFar) * near / (far - near) * (far / viewZ - 1);
    }
    double storedDepth(double viewZ) const { return minusOneToOne ? ndcDepth(viewZ) / 2 + 0.5 : ndcDepth(viewZ); }

    /// Right-handed, +Y up: where Glint sees the point, in pixels from the top left.
    glm::dvec2 pixel(glm::dvec3 positionVS, double width, double height) const {
        glm::dvec2 ndc = orthographic ? glm::dvec2(positionVS.x / halfWidth, positionVS.y / halfHeight)
                                      : glm::dvec2(focalX * positionVS.x, focalY * positionVS.y) / -positionVS.z;
        ndc += offsetNdc();
        return {(ndc.x * 0.5 + 0.5) * width, (0.5 - ndc.y * 0.5) * height};
    }

    /// The matrix that this host uploads: column by column from the oracle's own numbers.
    glm::dmat4 viewToClip() const {
        const double z = leftHanded ? 1 : -1; // sign of the host's z in front of the camera
        const double up = yDown ? -1 : 1;
        glm::dmat4 m(0);
        if (orthographic) {
            m[0].x = 1 / halfWidth;
            m[1].y = up / halfHeight;
            m[3].x = offsetNdc().x;
            m[3].y = up * offsetNdc().y;
            m[3].w = 1;
            const double slope = (ndcDepth(far) - ndcDepth(near)) / (far - near);
            m[2].z = z * slope;
            m[3].z = ndcDepth(near) - slope * near;
        } else {
            m[0].x = focalX;
            m[1].y = up * focalY;
            m[2].x = z * offsetNdc().x;
            m[2].y = z * up * offsetNdc().y;
            m[2].w = z;
            // ndc = constant + slope / viewZ
            const double slope = (ndcDepth(1) - ndcDepth(2)) * 2;
            m[2].z = z * (ndcDepth(1) - slope);
            m[3].z = slope;
        }
        return m;
    }
    /// In Glint's right-handed view space.
    static glm::dmat4 worldToView() { return glm::lookAt(glm::dvec3(3, 2, 5), {0.5, 1, -1}, {0, 1, 0}); }

    View view() const {
        glm::dmat4 hostWorldToView = worldToView();
        if (leftHanded)
            for (int column = 0; column < 4; ++column)
                hostWorldToView[column].z = -hostWorldToView[column].z;
        View out;
        const glm::mat4 toView(hostWorldToView);
        const glm::mat4 toClip(viewToClip());
        std::copy_n(glm::value_ptr(toView), 16, out.worldToView.begin());
        std::copy_n(glm::value_ptr(toClip), 16, out.viewToClip.begin());
        out.frameIndex = 5;
        out.seed = 77;
        return out;
    }
    Conventions conventions() const {
        Conventions out;
        out.depthMinusOneToOne = minusOneToOne;
        out.clipYDown = yDown;
        out.handedness = leftHanded ? Handedness::Left : Handedness::Right;
        return out;
    }
};

std::vector<Host> everyHost() {
    std::vector<Host> all;
    for (int bits = 0; bits < 128; ++bits) {
        Host host;
        host.reversed = bits & 1;
        host.infinite = bits & 2;
        host.minusOneToOne = bits & 4;
        host.yDown = bits & 8;
        host.leftHanded = bits & 16;
        host.orthographic = bits & 32;
        host.jittered = bits & 64;
        if (host.orthographic && host.infinite)
            continue;
        all.push_back(host);
    }
    return all;
}

constexpr uint32_t kWidth = 161;
constexpr uint32_t kHeight = 89;

/// As lib/camera.glsl does it, in the shader's own precision.
float viewZFromDepth(const shared::FrameConstants& frame, float depth) {
    const float ndc = depth * frame.depthScale + frame.depthOffset;
    return (ndc * frame.depthToViewZ.x + frame.depthToViewZ.y) / (ndc * frame.depthToViewZ.z + frame.depthToViewZ.w);
}

TEST(Conventions, depthBecomesMetres) {
    for (const Host& host : everyHost()) {
        SCOPED_TRACE(host.describe());
        const shared::FrameConstants frame = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        for (const double viewZ : {0.08, 0.2, 1.0, 3.3, 12.0, 60.0}) {
            const double exact = host.storedDepth(viewZ);
            const auto stored = static_cast<float>(exact);
            // One step of the stored float is this many metres; the conversion itself may lose a few of them. Depths
            // that crowd at 1 or in the middle of [-1, 1] are coarse by the host's choice.
            const double metresPerStep =
                std::abs(viewZ * 1.001 - viewZ) / std::abs(host.storedDepth(viewZ * 1.001) - exact) * 0x1p-23;
            ASSERT_NEAR(viewZFromDepth(frame, stored), viewZ, 8 * metresPerStep + 2e-6 * viewZ) << "at " << viewZ;
        }
    }
}

TEST(Conventions, nearPlaneIsFound) {
    for (const Host& host : everyHost()) {
        SCOPED_TRACE(host.describe());
        const shared::FrameConstants frame = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        EXPECT_NEAR(frame.nearZ, host.near, 2e-5 * (host.orthographic ? host.far : 1));
    }
}

TEST(Conventions, backgroundIsTheFarEnd) {
    for (const Host& host : everyHost()) {
        SCOPED_TRACE(host.describe());
        const shared::FrameConstants frame = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        EXPECT_EQ((frame.flags & shared::kInputReversedDepth) != 0, host.reversed);
        EXPECT_EQ((frame.flags & shared::kInputOrthographic) != 0, host.orthographic);
        EXPECT_EQ((frame.flags & shared::kInputLeftHanded) != 0, host.leftHanded);
        EXPECT_EQ(frame.farDepth, host.reversed ? 0 : 1) << "as it is stored: GL's -1 becomes 0";
    }
}

TEST(Conventions, viewSpaceLandsOnItsPixel) {
    for (const Host& host : everyHost()) {
        SCOPED_TRACE(host.describe());
        const shared::FrameConstants frame = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        for (const glm::dvec3 position :
             {glm::dvec3(0, 0, -1), glm::dvec3(0.7, 0.4, -3), glm::dvec3(-1.5, -0.9, -20)}) {
            const glm::vec4 h = frame.viewToPixel * glm::vec4(glm::vec3(position), 1);
            const glm::dvec2 expected = host.pixel(position, kWidth, kHeight);
            ASSERT_NEAR(h.x / h.w, expected.x, 2e-4);
            ASSERT_NEAR(h.y / h.w, expected.y, 2e-4);
            ASSERT_NEAR(h.w, host.orthographic ? 1 : -position.z, 1e-5) << "1/w is what is interpolated on screen";
        }
    }
}

TEST(Conventions, pixelsGoBackToViewSpace) {
    for (const Host& host : everyHost()) {
        SCOPED_TRACE(host.describe());
        const shared::FrameConstants frame = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        for (const glm::vec2 uv : {glm::vec2(0.5), glm::vec2(0, 0), glm::vec2(1, 0.25), glm::vec2(0.1f, 0.93f)})
            for (const float viewZ : {0.3f, 4.0f, 50.0f}) {
                const glm::vec2 scaled = uv * glm::vec2(frame.uvToView) + glm::vec2(frame.uvToView.z, frame.uvToView.w);
                const glm::vec3 position(scaled * (host.orthographic ? 1.0f : viewZ), -viewZ);
                const glm::dvec2 pixel = host.pixel(glm::dvec3(position), kWidth, kHeight);
                ASSERT_NEAR(pixel.x, uv.x * kWidth, 2e-4);
                ASSERT_NEAR(pixel.y, uv.y * kHeight, 2e-4);
            }
    }
}

TEST(Conventions, worldIsSeenRightHandedWhateverTheHost) {
    for (const Host& host : everyHost()) {
        SCOPED_TRACE(host.describe());
        const shared::FrameConstants frame = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        const glm::dmat4 expected = Host::worldToView();
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                ASSERT_NEAR(frame.worldToView[column][row], expected[column][row], 1e-5);
                const glm::mat4 identity = frame.worldToView * frame.viewToWorld;
                ASSERT_NEAR(identity[column][row], column == row ? 1 : 0, 1e-5);
            }
    }
}

// A projection is the same camera whatever common factor its sixteen numbers have.
TEST(Conventions, aScaledProjectionIsTheSameCamera) {
    for (Host host : everyHost()) {
        SCOPED_TRACE(host.describe());
        View scaled = host.view();
        for (float& number : scaled.viewToClip)
            number *= 3;
        const shared::FrameConstants frame = makeFrameConstants(scaled, host.conventions(), kWidth, kHeight);
        const shared::FrameConstants plain = makeFrameConstants(host.view(), host.conventions(), kWidth, kHeight);
        for (int i = 0; i < 4; ++i)
            ASSERT_NEAR(frame.uvToView[i], plain.uvToView[i], 1e-5 * std::abs(plain.uvToView[i]) + 1e-6);
        ASSERT_NEAR(frame.nearZ, plain.nearZ, 2e-5 * (host.orthographic ? host.far : 1));
        const auto depth = static_cast<float>(host.storedDepth(2));
        ASSERT_NEAR(viewZFromDepth(frame, depth), 2, 2e-3);
    }
}

TEST(Conventions, theRestIsPassedOn) {
    const Host host;
    Conventions conventions;
    conventions.depth = DepthKind::LinearViewZ;
    conventions.normalSpace = NormalSpace::View;
    conventions.normalEncoding = NormalEncoding::OctahedralUnorm;
    conventions.roughness = RoughnessKind::Smoothness;
    conventions.linearDepthScale = -0.5f;
    const shared::FrameConstants frame = makeFrameConstants(host.view(), conventions, kWidth, kHeight);
    EXPECT_EQ(frame.flags, shared::kInputLinearDepth | shared::kInputReversedDepth | shared::kInputNormalView |
                               shared::kInputNormalOctahedral | shared::kInputNormalUnorm | shared::kInputSmoothness);
    EXPECT_EQ(frame.depthScale, -0.5f);
    EXPECT_EQ(frame.frameIndex, 5u);
    EXPECT_EQ(frame.seed, 77u);
    EXPECT_EQ(frame.size, glm::vec2(kWidth, kHeight));
    EXPECT_EQ(frame.invSize, glm::vec2(1.0 / kWidth, 1.0 / kHeight));

    const auto flagsOf = [&](NormalEncoding encoding) {
        Conventions only;
        only.normalEncoding = encoding;
        return makeFrameConstants(host.view(), only, kWidth, kHeight).flags &
               (shared::kInputNormalOctahedral | shared::kInputNormalUnorm);
    };
    EXPECT_EQ(flagsOf(NormalEncoding::Signed), 0u);
    EXPECT_EQ(flagsOf(NormalEncoding::Unorm), shared::kInputNormalUnorm);
    EXPECT_EQ(flagsOf(NormalEncoding::Octahedral), shared::kInputNormalOctahedral);
}

} // namespace conventions_test
} // namespace glint::reflect
