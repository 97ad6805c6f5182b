#include "reflect/planar/mirrored_view.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace glint {
namespace {

glm::dmat4 toMatrix(const Matrix4& matrix) {
    return glm::dmat4(glm::make_mat4(matrix.data()));
}

Matrix4 fromMatrix(const glm::dmat4& matrix) {
    Matrix4 result;
    for (glm::length_t i = 0; i < 16; ++i)
        result[static_cast<size_t>(i)] = static_cast<float>(matrix[i / 4][i % 4]);
    return result;
}

glm::dvec3 normalOf(const PlanarMirror& mirror) {
    return glm::normalize(glm::dvec3(reflect::toVec(mirror.normalWS)));
}

double planeOffset(const PlanarMirror& mirror) {
    return -glm::dot(normalOf(mirror), glm::dvec3(reflect::toVec(mirror.centerWS)));
}

/// x -> x - 2 (dot(n, x) + d) n
glm::dmat4 reflection(const PlanarMirror& mirror) {
    const glm::dvec3 n = normalOf(mirror);
    glm::dmat4 result(glm::dmat3(1) - 2.0 * glm::outerProduct(n, n));
    result[3] = glm::dvec4(-2 * planeOffset(mirror) * n, 1);
    return result;
}

} // namespace

View mirroredView(const View& view, const PlanarMirror& mirror) {
    // The reflected camera's image with its columns reversed: negating X in view space makes worldToView rigid again;
    // negating it on both sides of viewToClip flips only off-centre terms such as jitter.
    glm::dmat4 exchange(1);
    exchange[0][0] = -1;
    View result = view;
    result.worldToView = fromMatrix(exchange * toMatrix(view.worldToView) * reflection(mirror));
    result.viewToClip = fromMatrix(exchange * toMatrix(view.viewToClip) * exchange);
    return result;
}

std::array<float, 4> clipPlane(const PlanarMirror& mirror) {
    const glm::vec3 n(normalOf(mirror));
    return {n.x, n.y, n.z, static_cast<float>(planeOffset(mirror) - reflect::toleranceOf(mirror))};
}

bool facesView(const PlanarMirror& mirror, const View& view) {
    const glm::dmat4 viewToClip = toMatrix(view.viewToClip);
    if (viewToClip[2][3] == 0) // orthographic: the view direction is the host's convention, so assume the front
        return true;
    const glm::dvec3 eyeWS = glm::dvec3(glm::inverse(toMatrix(view.worldToView))[3]);
    return glm::dot(normalOf(mirror), eyeWS) + planeOffset(mirror) > 0;
}

} // namespace glint
