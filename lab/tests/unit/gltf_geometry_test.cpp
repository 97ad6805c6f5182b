// Primitives: modes, attributes, flat normals, morph targets, and what is refused.
#include "lab/tests/support/gltf_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::test {
namespace gltf_geometry_test {

using scene::Geometry;
using scene::Primitive;
using scene::Topology;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Primitive firstPrimitive(const GltfBuilder& builder) {
    const auto scene = builder.read();
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? scene->meshes[0].primitives[0] : Primitive();
}

/// A triangle with normals, so that the reader leaves its vertices alone.
GltfBuilder triangle(Json** primitive = nullptr) {
    GltfBuilder builder;
    const int positions = builder.addAccessor("VEC3", kTriangle);
    const int normals = builder.addAccessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    Json& added = builder.addMesh({{"POSITION", positions}, {"NORMAL", normals}});
    if (primitive)
        *primitive = &added;
    return builder;
}

std::vector<uint32_t> indicesInMode(int mode, const std::vector<uint8_t>& indices) {
    GltfBuilder builder;
    const std::vector<float> zeros(15, 0.0f);
    Json& primitive = builder.addMesh(
        {{"POSITION", builder.addAccessor("VEC3", zeros)}, {"NORMAL", builder.addAccessor("VEC3", zeros)}});
    primitive["indices"] = builder.addAccessor("SCALAR", indices);
    builder.json["meshes"][0]["primitives"][0]["mode"] = mode;
    return firstPrimitive(builder).geometry.indices;
}

TEST(GltfModes, EveryModeBecomesAList) {
    EXPECT_THAT(indicesInMode(0, {4, 2, 0}), ElementsAre(4, 2, 0));
    EXPECT_THAT(indicesInMode(1, {0, 1, 2, 3, 4}), ElementsAre(0, 1, 2, 3)); // one left over
    EXPECT_THAT(indicesInMode(2, {0, 1, 2}), ElementsAre(0, 1, 1, 2, 2, 0));
    EXPECT_THAT(indicesInMode(3, {0, 1, 2}), ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(indicesInMode(4, {0, 1, 2, 3}), ElementsAre(0, 1, 2));
    EXPECT_THAT(indicesInMode(5, {0, 1, 2, 3, 4}), ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
    EXPECT_THAT(indicesInMode(6, {0, 1, 2, 3}), ElementsAre(1, 2, 0, 2, 3, 0));
    EXPECT_THAT(indicesInMode(5, {0, 1}), ElementsAre());
}

TEST(GltfModes, TopologyIsKept) {
    Json* primitive = nullptr;
    GltfBuilder builder = triangle(&primitive);
    builder.json["meshes"][0]["primitives"][0]["mode"] = 3;
    EXPECT_EQ(firstPrimitive(builder).geometry.topology, Topology::Lines);
    builder.json["meshes"][0]["primitives"][0]["mode"] = 0;
    EXPECT_EQ(firstPrimitive(builder).geometry.topology, Topology::Points);
    builder.json["meshes"][0]["primitives"][0]["mode"] = 7;
    EXPECT_THAT(builder.readError(), HasSubstr("mode is 7, which is no primitive mode"));
}

TEST(GltfGeometry, IndicesAreOptional) {
    EXPECT_THAT(firstPrimitive(triangle()).geometry.indices, ElementsAre(0, 1, 2));
}

TEST(GltfGeometry, IndexBeyondTheVertices) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.addAccessor<uint16_t>("SCALAR", {0, 1, 3});
    EXPECT_EQ(builder.readError(), "test.glb: meshes[0].primitives[0]: index 2 is vertex 3 but there are 3");
}

TEST(GltfGeometry, IndicesMustBeUnsigned) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.addAccessor<int16_t>("SCALAR", {0, 1, 2});
    EXPECT_THAT(builder.readError(), HasSubstr("accessor 2 must hold unsigned integers"));
}

TEST(GltfGeometry, AttributesOfUnequalLength) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        builder.addAccessor<float>("VEC2", {0, 0, 1, 1});
    EXPECT_EQ(builder.readError(),
              "test.glb: meshes[0].primitives[0].attributes.TEXCOORD_0 has 2 elements (accessor 2) "
              "but the primitive has 3 vertices");
}

TEST(GltfGeometry, UnknownAccessorAndMaterial) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    EXPECT_EQ(builder.readError(), "test.glb: meshes[0].primitives[0].material is 0 but the file has 0 materials");
    builder.json["meshes"][0]["primitives"][0].erase("material");
    builder.json["meshes"][0]["primitives"][0]["indices"] = 99;
    EXPECT_EQ(builder.readError(), "test.glb: meshes[0].primitives[0].indices is 99 but the file has 2 accessors");
}

TEST(GltfGeometry, MissingNormalsBecomeFlatAndVerticesSplit) {
    GltfBuilder builder;
    // Two triangles at a right angle that share an edge.
    Json& primitive =
        builder.addMesh({{"POSITION", builder.addAccessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})}});
    primitive["indices"] = builder.addAccessor<uint8_t>("SCALAR", {0, 1, 2, 1, 0, 3});
    const Primitive read = firstPrimitive(builder);
    EXPECT_TRUE(read.flatNormals);
    ASSERT_EQ(read.geometry.positions.size(), 6u);
    EXPECT_THAT(read.geometry.indices, ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_EQ(read.geometry.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(read.geometry.normals[1], glm::vec3(0, 0, 1));
    EXPECT_EQ(read.geometry.normals[3], glm::vec3(0, 1, 0));
    EXPECT_EQ(read.geometry.positions[5], glm::vec3(0, 0, 1));
}

TEST(GltfGeometry, TangentsWithoutNormalsAreDropped) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)},
                     {"TANGENT", builder.addAccessor<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1})}});
    EXPECT_TRUE(firstPrimitive(builder).geometry.tangents.empty());
}

TEST(GltfGeometry, LinesWithoutNormalsStayWithout) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)}})["mode"] = 3;
    EXPECT_TRUE(firstPrimitive(builder).geometry.normals.empty());
}

TEST(GltfGeometry, NormalsAndTangentsAreMended) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)},
                     {"NORMAL", builder.addAccessor<float>("VEC3", {0, 0, 5, 0, 0, 0, kNaN, 0, 0})},
                     {"TANGENT", builder.addAccessor<float>("VEC4", {2, 0, 0, -1, 0, 0, 0, 1, 1, 0, 0, 0.5f})}});
    const Geometry geometry = firstPrimitive(builder).geometry;
    for (const glm::vec3& normal : geometry.normals)
        EXPECT_EQ(normal, glm::vec3(0, 0, 1)); // the last two from the triangle
    EXPECT_EQ(geometry.tangents[0], glm::vec4(1, 0, 0, -1));
    EXPECT_NEAR(glm::length(glm::vec3(geometry.tangents[1])), 1, 1e-6);
    EXPECT_NEAR(geometry.tangents[1].z, 0, 1e-6);
    EXPECT_EQ(geometry.tangents[2].w, 1);
}

TEST(GltfGeometry, ColorsOfEveryKind) {
    const auto color = [](auto components, const std::string& type, bool normalized) {
        GltfBuilder builder = triangle();
        builder.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
            builder.addAccessor(type, components, normalized);
        return firstPrimitive(builder).geometry.colors.at(1);
    };
    EXPECT_EQ(color(std::vector<float>{0, 0, 0, 1, 0.5f, 0, 0, 0, 0}, "VEC3", false), glm::vec4(1, 0.5f, 0, 1));
    EXPECT_EQ(color(std::vector<float>{0, 0, 0, 0, 1, 0.5f, 0, 0.25f, 0, 0, 0, 0}, "VEC4", false),
              glm::vec4(1, 0.5f, 0, 0.25f));
    EXPECT_EQ(color(std::vector<uint8_t>{0, 0, 0, 0, 255, 51, 0, 0, 0, 0, 0, 0}, "VEC4", true),
              glm::vec4(1, 0.2f, 0, 0));
    EXPECT_EQ(color(std::vector<uint16_t>{0, 0, 0, 65535, 13107, 0, 0, 0, 0}, "VEC3", true), glm::vec4(1, 0.2f, 0, 1));
    EXPECT_EQ(color(std::vector<uint8_t>{0, 0, 0, 255, 51, 0, 0, 0, 0}, "VEC3", false), glm::vec4(1, 0.2f, 0, 1))
        << "exporters forget to say normalized";
}

TEST(GltfGeometry, TwoTextureCoordinateSets) {
    GltfBuilder builder = triangle();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = builder.addAccessor<float>("VEC2", {0, 0, 1, 0, 0, kNaN});
    attributes["TEXCOORD_1"] = builder.addAccessor<uint16_t>("VEC2", {0, 0, 65535, 0, 0, 13107}, true);
    const Geometry geometry = firstPrimitive(builder).geometry;
    EXPECT_EQ(geometry.uvs[0][2], glm::vec2(0, 0));
    EXPECT_EQ(geometry.uvs[1][2], glm::vec2(0, 0.2f));
}

TEST(GltfGeometry, SeveralJointSetsAndLeftOverJoints) {
    GltfBuilder builder = triangle();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = builder.addAccessor<uint8_t>("VEC4", {1, 9, 0, 0, 1, 9, 0, 0, 1, 9, 0, 0});
    attributes["WEIGHTS_0"] = builder.addAccessor<uint8_t>("VEC4", {255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, true);
    attributes["JOINTS_1"] = builder.addAccessor<uint16_t>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    attributes["WEIGHTS_1"] = builder.addAccessor<float>("VEC4", {.5f, 0, 0, 0, .5f, 0, 0, 0, .5f, 0, 0, 0});
    const Primitive read = firstPrimitive(builder);
    ASSERT_EQ(read.skinSets.size(), 2u);
    EXPECT_EQ(read.skinSets[0].joints[0], glm::u16vec4(1, 0, 0, 0)) << "joint 9 weighs nothing";
    EXPECT_EQ(read.skinSets[1].weights[0], glm::vec4(.5f, 0, 0, 0));
}

TEST(GltfGeometry, MorphTargetsFollowSplitVertices) {
    GltfBuilder builder;
    Json& primitive =
        builder.addMesh({{"POSITION", builder.addAccessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})}});
    primitive["indices"] = builder.addAccessor<uint8_t>("SCALAR", {0, 1, 2, 1, 0, 3});
    const int target = builder.addAccessor<int8_t>("VEC3", {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3});
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    const Primitive read = firstPrimitive(builder);
    ASSERT_EQ(read.morphTargets.size(), 1u);
    ASSERT_EQ(read.morphTargets[0].positions.size(), 6u);
    EXPECT_EQ(read.morphTargets[0].positions[3], glm::vec3(1));
    EXPECT_EQ(read.morphTargets[0].positions[5], glm::vec3(3));
}

TEST(GltfGeometry, MorphTargetsMustAgree) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["weights"] = {1, 2};
    EXPECT_EQ(builder.readError(), "test.glb: meshes[0].weights has 2 numbers but the mesh has 0 morph targets");

    GltfBuilder uneven = triangle();
    Json second = uneven.json["meshes"][0]["primitives"][0];
    second["targets"] = {{{"POSITION", 0}}};
    uneven.json["meshes"][0]["primitives"].push_back(second);
    EXPECT_THAT(uneven.readError(), HasSubstr("same number of morph targets"));

    GltfBuilder shorter = triangle();
    const int target = shorter.addAccessor<float>("VEC3", {0, 0, 0});
    shorter.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
    EXPECT_THAT(shorter.readError(), HasSubstr("targets[0].POSITION has 1 elements"));
}

TEST(GltfGeometry, PrimitiveWithoutPositionsIsLeftOut) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"NORMAL", 1}}}});
    const auto scene = builder.read();
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->meshes[0].primitives.size(), 1u);
}

TEST(GltfGeometry, NormalMapAsksForTangents) {
    GltfBuilder builder = triangle();
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        builder.addAccessor<float>("VEC2", {0, 1, 1, 1, 0, 0});
    EXPECT_TRUE(firstPrimitive(builder).geometry.tangents.empty());
    builder.json["textures"] = {Json::object()};
    builder.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    EXPECT_THAT(firstPrimitive(builder).geometry.tangents,
                ElementsAre(glm::vec4(1, 0, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(1, 0, 0, 1)));
}

} // namespace gltf_geometry_test
} // namespace glint::test
