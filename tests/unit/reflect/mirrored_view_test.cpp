// The camera that a planar mirror's picture is drawn with, for all kinds of hosts.
#include "glint/planar.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace glint {
namespace mirrored_view_test {

Matrix4 toMatrix4(const glm::mat4& matrix) {
    Matrix4 result;
    std::copy_n(glm::value_ptr(matrix), 16, result.begin());
    return result;
}

glm::dmat4 toMat(const Matrix4& matrix) {
    return glm::dmat4(glm::make_mat4(matrix.data()));
}

glm::dvec2 ndc(const View& view, const glm::dvec3& positionWS) {
    const glm::dvec4 clip = toMat(view.viewToClip) * toMat(view.worldToView) * glm::dvec4(positionWS, 1);
    return glm::dvec2(clip) / clip.w;
}

PlanarMirror someMirror() {
    const glm::vec3 normal = glm::normalize(glm::vec3(0.2f, 0.9f, -0.3f));
    const glm::vec3 tangent = glm::normalize(glm::cross(normal, glm::vec3(0, 0, 1)));
    PlanarMirror mirror;
    mirror.centerWS = {0.5f, -1, -4};
    mirror.normalWS = {normal.x, normal.y, normal.z};
    mirror.tangentWS = {tangent.x, tangent.y, tangent.z};
    mirror.halfExtents = {2, 3};
    return mirror;
}

glm::dvec3 vec(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// View space left- or right-handed, pictures up or down, perspective or not, off centre as jitter makes them.
std::vector<View> someViews() {
    std::vector<View> views;
    for (const bool leftHanded : {false, true})
        for (const bool down : {false, true})
            for (const bool orthographic : {false, true}) {
                const glm::vec3 eye(1, 2, 3);
                const glm::mat4 worldToView = leftHanded ? glm::lookAtLH(eye, {0, -1, -4}, {0, 1, 0})
                                                         : glm::lookAtRH(eye, {0, -1, -4}, {0, 1, 0});
                glm::mat4 viewToClip;
                if (orthographic)
                    viewToClip = leftHanded ? glm::orthoLH_ZO(-4.f, 5.f, -3.f, 3.f, 0.1f, 50.f)
                                            : glm::orthoRH_ZO(-4.f, 5.f, -3.f, 3.f, 0.1f, 50.f);
                else
                    viewToClip = leftHanded ? glm::frustumLH_ZO(-0.1f, 0.12f, -0.06f, 0.05f, 0.1f, 50.f)
                                            : glm::frustumRH_ZO(-0.1f, 0.12f, -0.06f, 0.05f, 0.1f, 50.f);
                if (down)
                    viewToClip = glm::scale(glm::mat4(1), {1, -1, 1}) * viewToClip;
                views.push_back({toMatrix4(worldToView), toMatrix4(viewToClip)});
            }
    return views;
}

TEST(MirroredView, SeesInItsPictureWhatTheMirrorShows) {
    const PlanarMirror mirror = someMirror();
    const glm::dvec3 normal = glm::normalize(vec(mirror.normalWS));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const View& view : someViews()) {
        const View mirrored = mirroredView(view, mirror);
        const glm::dmat3 rotation(toMat(mirrored.worldToView));
        EXPECT_NEAR(glm::determinant(rotation), glm::determinant(glm::dmat3(toMat(view.worldToView))), 1e-5);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 at = vec(mirror.centerWS) + glm::dvec3(unit(random), unit(random), unit(random)) * 2.0;
            const double off = glm::dot(at - vec(mirror.centerWS), normal);
            const glm::dvec3 behind = at - 2 * off * normal; // where the eye sees it in the mirror
            const glm::dvec2 seen = ndc(view, behind);
            const glm::dvec2 drawn = ndc(mirrored, at);
            EXPECT_NEAR(drawn.x, -seen.x, 1e-4);
            EXPECT_NEAR(drawn.y, seen.y, 1e-4);
            const std::array<float, 4> plane = clipPlane(mirror);
            const double beyond = glm::dot(glm::dvec3(plane[0], plane[1], plane[2]), at) + double(plane[3]);
            EXPECT_EQ(beyond > 0, off > 2e-4 * 3) << off;
        }
    }
}

TEST(MirroredView, AMirrorFacesTheEyesInFrontOfIt) {
    PlanarMirror mirror = someMirror();
    for (const View& view : someViews()) {
        const bool orthographic = toMat(view.viewToClip)[2][3] == 0;
        mirror.normalWS = someMirror().normalWS;
        EXPECT_TRUE(facesView(mirror, view));
        for (float& value : mirror.normalWS)
            value = -value;
        EXPECT_EQ(facesView(mirror, view), orthographic);
        EXPECT_EQ(facesView(mirror, mirroredView(view, mirror)), true); // from behind it, it is the other way round
    }
}

} // namespace mirrored_view_test
} // namespace glint
