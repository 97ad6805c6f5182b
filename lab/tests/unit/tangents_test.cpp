// MikkTSpace: analytic patches, mirrored seams, triangles without area, and what Blender's own implementation wrote.
#include "lab/scene/tangents.hpp"

#include "lab/scene/gltf/gltf.hpp"
#include "lab/tests/support/assets.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::test {
namespace tangents_test {

using scene::Geometry;

void expectNear(const glm::vec4& actual, const glm::vec4& expected, float tolerance = 1e-5f) {
    for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(actual[k], expected[k], tolerance) << "component " << k;
}

/// Two triangles on z = 0 from (0, 0) to (1, 1), facing +Z; `uv` says how the picture lies on them.
template <class Uv>
Geometry quad(Uv&& uv) {
    Geometry geometry;
    for (const glm::vec2 p : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        geometry.positions.emplace_back(p, 0);
        geometry.normals.emplace_back(0, 0, 1);
        geometry.uvs[0].push_back(uv(p));
    }
    geometry.indices = {0, 1, 2, 0, 2, 3};
    return geometry;
}

TEST(Tangents, UprightPicture) {
    // u to the right, v down from the top: the bitangent cross(N, T) * w must point up the picture, +Y.
    for (const glm::vec4& tangent :
         scene::computeTangents(quad([](glm::vec2 p) { return glm::vec2(p.x, 1 - p.y); }), 0))
        expectNear(tangent, {1, 0, 0, 1});
}

TEST(Tangents, MirroredPicture) {
    for (const glm::vec4& tangent :
         scene::computeTangents(quad([](glm::vec2 p) { return glm::vec2(1 - p.x, 1 - p.y); }), 0))
        expectNear(tangent, {-1, 0, 0, -1});
}

TEST(Tangents, TurnedAndStretchedPicture) {
    const float c = std::cos(0.5f), s = std::sin(0.5f);
    const auto uv = [&](glm::vec2 p) { return glm::vec2(3 * (c * p.x + s * p.y), -(-s * p.x + c * p.y)); };
    for (const glm::vec4& tangent : scene::computeTangents(quad(uv), 0))
        expectNear(tangent, {c, s, 0, 1});
}

TEST(Tangents, SecondTextureCoordinates) {
    Geometry geometry = quad([](glm::vec2 p) { return p; });
    geometry.uvs[1] = quad([](glm::vec2 p) { return glm::vec2(p.y, p.x); }).uvs[0];
    expectNear(scene::computeTangents(geometry, 1)[0], {0, 1, 0, 1});
}

TEST(Tangents, MirroredSeamIsSplit) {
    // A strip of two quads whose picture is mirrored at x = 1.
    Geometry geometry;
    for (const float x : {0.0f, 1.0f, 2.0f}) {
        for (const float y : {0.0f, 1.0f}) {
            geometry.positions.emplace_back(x, y, 0);
            geometry.normals.emplace_back(0, 0, 1);
            geometry.uvs[0].emplace_back(x < 2 ? x : 0, 1 - y);
        }
    }
    geometry.indices = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
    const std::vector<glm::vec4> tangents = scene::computeTangents(geometry, 0);
    for (size_t corner = 0; corner < 6; ++corner)
        expectNear(tangents[corner], {1, 0, 0, 1});
    for (size_t corner = 6; corner < 12; ++corner)
        expectNear(tangents[corner], {-1, 0, 0, -1});
}

TEST(Tangents, AveragedByAngle) {
    // Two triangles share the edge from the origin to (1, 0, 0); the picture runs over them in different directions. At
    // the origin their corners measure 90 and 45 degrees.
    Geometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -1, 0}};
    geometry.normals.assign(4, {0, 0, 1});
    geometry.uvs[0] = {{0, 0}, {1, -0.5f}, {0.5f, -1}, {1.5f, 1}};
    geometry.indices = {0, 1, 2, 0, 3, 1};
    const auto derivative = [&](uint32_t b, uint32_t c) { // independent of the code: solve the 2 x 2 system
        const glm::mat2 uv(geometry.uvs[0][b], geometry.uvs[0][c]);
        const glm::mat2 xy(glm::vec2(geometry.positions[b]), glm::vec2(geometry.positions[c]));
        return glm::normalize((xy * glm::inverse(uv))[0]);
    };
    const glm::vec2 expected =
        glm::normalize(glm::radians(90.0f) * derivative(1, 2) + glm::radians(45.0f) * derivative(3, 1));
    const std::vector<glm::vec4> tangents = scene::computeTangents(geometry, 0);
    EXPECT_EQ(tangents[0], tangents[3]);
    EXPECT_NEAR(tangents[0].x, expected.x, 1e-5);
    EXPECT_NEAR(tangents[0].y, expected.y, 1e-5);
}

TEST(Tangents, IndependentOfIndexing) {
    const Geometry shared = quad([](glm::vec2 p) { return glm::vec2(p.x + p.y * p.y * 0.3f, 1 - p.y); });
    Geometry split;
    for (const uint32_t index : shared.indices) {
        split.indices.push_back(static_cast<uint32_t>(split.positions.size()));
        split.positions.push_back(shared.positions[index]);
        split.normals.push_back(shared.normals[index]);
        split.uvs[0].push_back(shared.uvs[0][index]);
    }
    EXPECT_EQ(scene::computeTangents(shared, 0), scene::computeTangents(split, 0));
}

TEST(Tangents, TrianglesWithoutAreaBorrow) {
    Geometry geometry = quad([](glm::vec2 p) { return glm::vec2(p.x, 1 - p.y); });
    geometry.indices.insert(geometry.indices.end(), {0, 0, 1}); // two corners in one place
    for (const glm::vec4& tangent : scene::computeTangents(geometry, 0))
        expectNear(tangent, {1, 0, 0, 1});
}

TEST(Tangents, PictureWithoutAreaStillGivesAFrame) {
    for (const glm::vec4& tangent : scene::computeTangents(quad([](glm::vec2) { return glm::vec2(0.5f); }), 0)) {
        EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
        EXPECT_NEAR(tangent.z, 0, 1e-6);
        EXPECT_EQ(std::abs(tangent.w), 1);
    }
}

TEST(Tangents, AnyTangentIsAcrossItsNormal) {
    for (const glm::vec3 normal :
         {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(0.6f, -0.64f, 0.48f)}) {
        const glm::vec3 tangent = scene::anyTangent(normal);
        EXPECT_NEAR(glm::length(tangent), 1, 1e-5);
        EXPECT_NEAR(glm::dot(tangent, normal), 0, 1e-5);
    }
}

/// Blender writes the tangents of its own MikkTSpace into these models; ours must be the same at every corner.
class BlenderTangents : public testing::TestWithParam<const char*> {};

TEST_P(BlenderTangents, Agree) {
    GLINT_NEED_ASSET(path, GetParam());
    const auto scene = scene::readGltf(path);
    ASSERT_TRUE(scene);
    size_t corners = 0;
    for (const scene::Mesh& mesh : scene->meshes) {
        for (const scene::Primitive& primitive : mesh.primitives) {
            const Geometry& geometry = primitive.geometry;
            if (geometry.tangents.empty())
                continue;
            const std::vector<glm::vec4> ours = scene::computeTangents(geometry, 0);
            for (size_t i = 0; i < ours.size(); ++i, ++corners) {
                const glm::vec4& theirs = geometry.tangents[geometry.indices[i]];
                ASSERT_EQ(ours[i].w, theirs.w) << mesh.name << " corner " << i;
                ASSERT_GT(glm::dot(glm::vec3(ours[i]), glm::vec3(theirs)), 0.9995f) << mesh.name << " corner " << i;
            }
        }
    }
    EXPECT_GT(corners, 0u);
}

INSTANTIATE_TEST_SUITE_P(Models, BlenderTangents,
                         testing::Values("models/NormalTangentMirrorTest/glTF-Binary/NormalTangentMirrorTest.glb",
                                         "models/AnisotropyRotationTest/glTF-Binary/AnisotropyRotationTest.glb",
                                         "models/AlphaBlendModeTest/glTF-Binary/AlphaBlendModeTest.glb"),
                         [](const auto& model) { return std::filesystem::path(model.param).stem().string(); });

} // namespace tangents_test
} // namespace glint::test
