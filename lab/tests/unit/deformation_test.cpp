// Morph targets and skins on vertices whose place is known.
#include "lab/scene/deformation.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace glint::test {
namespace deformation_test {

using scene::Geometry;
using scene::Primitive;

Primitive triangle() {
    Primitive primitive;
    primitive.geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.geometry.normals.assign(3, {0, 0, 1});
    primitive.geometry.tangents.assign(3, {1, 0, 0, 1});
    primitive.geometry.indices = {0, 1, 2};
    return primitive;
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_NEAR(glm::distance(actual, expected), 0, 1e-5) << actual.x << " " << actual.y << " " << actual.z;
}

TEST(Morph, DifferencesAddUp) {
    Primitive primitive = triangle();
    primitive.morphTargets.resize(2);
    primitive.morphTargets[0].positions = {{0, 0, 2}, {0, 0, 0}, {0, 0, 0}};
    primitive.morphTargets[1].positions = {{4, 0, 0}, {0, 4, 0}, {0, 0, 0}};
    primitive.morphTargets[1].normals.assign(3, {2, 0, 0});
    Geometry geometry = primitive.geometry;
    scene::morph(primitive, std::vector<float>{0.5f, 0.25f}, geometry);
    EXPECT_EQ(geometry.positions[0], glm::vec3(1, 0, 1));
    EXPECT_EQ(geometry.positions[1], glm::vec3(1, 1, 0));
    expectNear(geometry.normals[0], glm::normalize(glm::vec3(0.5f, 0, 1)));
    const glm::vec3 tangent(geometry.tangents[0]);
    EXPECT_NEAR(glm::dot(tangent, geometry.normals[0]), 0, 1e-6);
    EXPECT_NEAR(glm::length(tangent), 1, 1e-6);
    EXPECT_EQ(geometry.tangents[0].w, 1);
}

TEST(Morph, NoWeightChangesNothing) {
    Primitive primitive = triangle();
    primitive.morphTargets.resize(1);
    primitive.morphTargets[0].positions.assign(3, {1, 1, 1});
    Geometry geometry = primitive.geometry;
    scene::morph(primitive, std::vector<float>{0}, geometry);
    EXPECT_EQ(geometry.positions, primitive.geometry.positions);
    EXPECT_EQ(geometry.normals, primitive.geometry.normals);
}

TEST(Morph, FlatNormalsFollowTheTriangle) {
    Primitive primitive = triangle();
    primitive.flatNormals = true;
    primitive.geometry.tangents.clear();
    primitive.morphTargets.resize(1);
    primitive.morphTargets[0].positions = {{0, 0, 0}, {0, 0, 0}, {0, -1, 1}}; // the third corner swings up
    Geometry geometry = primitive.geometry;
    scene::morph(primitive, std::vector<float>{1}, geometry);
    expectNear(geometry.normals[0], {0, -1, 0});
}

TEST(Skin, JointsBlendByWeight) {
    Primitive primitive = triangle();
    primitive.skinSets.resize(2);
    primitive.skinSets[0] = {{{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}},
                             {{1, 0, 0, 0}, {1, 0, 0, 0}, {0.25f, 0.25f, 0, 0}}};
    primitive.skinSets[1] = {{{0, 0, 0, 0}, {0, 0, 0, 0}, {2, 0, 0, 0}}, {{0, 0, 0, 0}, {0, 0, 0, 0}, {0.5f, 0, 0, 0}}};
    const std::vector<glm::mat4> joints = {glm::translate(glm::mat4(1), {8, 0, 0}),
                                           glm::translate(glm::mat4(1), {0, 8, 0}),
                                           glm::translate(glm::mat4(1), {0, 0, 8})};
    Geometry geometry = primitive.geometry;
    scene::skin(primitive, joints, geometry);
    expectNear(geometry.positions[0], {8, 0, 0});
    expectNear(geometry.positions[1], {1, 8, 0});
    expectNear(geometry.positions[2], {2, 3, 4});
}

TEST(Skin, WeightsNeedNotSumToOne) {
    Primitive primitive = triangle();
    primitive.skinSets = {{std::vector<glm::u16vec4>(3, glm::u16vec4(0)), std::vector<glm::vec4>(3, {0.5f, 0, 0, 0})}};
    Geometry geometry = primitive.geometry;
    scene::skin(primitive, std::vector<glm::mat4>{glm::translate(glm::mat4(1), {2, 0, 0})}, geometry);
    expectNear(geometry.positions[1], {3, 0, 0});
    primitive.skinSets[0].weights.assign(3, glm::vec4(0));
    geometry = primitive.geometry;
    scene::skin(primitive, std::vector<glm::mat4>{glm::translate(glm::mat4(1), {2, 0, 0})}, geometry);
    expectNear(geometry.positions[1], {3, 0, 0});
}

TEST(Skin, NormalsStayAcrossStretchedSurfaces) {
    Primitive primitive = triangle();
    primitive.geometry.positions = {{0, 0, 0}, {1, 0, -1}, {0, 1, 0}}; // a slope: normal (1, 0, 1)
    primitive.geometry.normals.assign(3, glm::normalize(glm::vec3(1, 0, 1)));
    primitive.geometry.tangents.clear();
    primitive.skinSets = {{std::vector<glm::u16vec4>(3, glm::u16vec4(0)), std::vector<glm::vec4>(3, {1, 0, 0, 0})}};
    Geometry geometry = primitive.geometry;
    scene::skin(primitive, std::vector<glm::mat4>{glm::scale(glm::mat4(1), {3, 1, 1})}, geometry);
    const glm::vec3 face = glm::normalize(
        glm::cross(geometry.positions[1] - geometry.positions[0], geometry.positions[2] - geometry.positions[0]));
    expectNear(geometry.normals[0], face);
}

TEST(Skin, MirroringKeepsFrontsAndHands) {
    Primitive primitive = triangle();
    primitive.skinSets = {{std::vector<glm::u16vec4>(3, glm::u16vec4(0)), std::vector<glm::vec4>(3, {1, 0, 0, 0})}};
    Geometry geometry = primitive.geometry;
    scene::skin(primitive, std::vector<glm::mat4>{glm::scale(glm::mat4(1), {-1, 1, 1})}, geometry);
    expectNear(geometry.normals[0], {0, 0, 1});
    const auto corner = [&](size_t i) { return geometry.positions[geometry.indices[i]]; };
    EXPECT_GT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0) << "still a front from +Z";
    // The bitangent of a mirrored surface is the mirror image of the bitangent, +Y.
    const glm::vec3 bitangent =
        glm::cross(geometry.normals[0], glm::vec3(geometry.tangents[0])) * geometry.tangents[0].w;
    expectNear(bitangent, {0, 1, 0});
}

} // namespace deformation_test
} // namespace glint::test
