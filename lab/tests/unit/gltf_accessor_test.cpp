// Accessors in every form, seen through what they make of positions, and every way in which one can be wrong.
#include "lab/tests/support/gltf_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace glint::test {
namespace gltf_accessor_test {

using testing::HasSubstr;

/// Positions that the reader makes of accessor 0.
std::vector<glm::vec3> positionsOf(GltfBuilder& builder) {
    builder.addMesh({{"POSITION", 0}});
    const auto scene = builder.read();
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? scene->meshes[0].primitives[0].geometry.positions : std::vector<glm::vec3>();
}

std::string errorOf(GltfBuilder& builder) {
    builder.addMesh({{"POSITION", 0}});
    return builder.readError();
}

template <class T>
std::vector<glm::vec3> convert(const std::vector<T>& components, bool normalized) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", components, normalized);
    return positionsOf(builder);
}

TEST(GltfAccessor, EveryComponentType) {
    const glm::vec3 first(1, 2, 3);
    EXPECT_EQ(convert<float>({1, 2, 3, 0, 0, 0, 4, 5, 6}, false)[0], first);
    EXPECT_EQ(convert<int8_t>({1, 2, 3, 0, 0, 0, 0, -5, 0}, false)[2], glm::vec3(0, -5, 0));
    EXPECT_EQ(convert<uint8_t>({1, 2, 3, 0, 0, 0, 0, 250, 0}, false)[2], glm::vec3(0, 250, 0));
    EXPECT_EQ(convert<int16_t>({1, 2, 3, 0, 0, 0, 0, -500, 0}, false)[2], glm::vec3(0, -500, 0));
    EXPECT_EQ(convert<uint16_t>({1, 2, 3, 0, 0, 0, 0, 65000, 0}, false)[2], glm::vec3(0, 65000, 0));
    EXPECT_EQ(convert<uint32_t>({1, 2, 3, 0, 0, 0, 0, 70000, 0}, false)[2], glm::vec3(0, 70000, 0));
}

TEST(GltfAccessor, NormalizedIntegers) {
    // Specification, section 3.11: -128 and -127 are both -1.
    EXPECT_EQ(convert<int8_t>({-128, -127, 127, 0, 0, 0, 0, 0, 0}, true)[0], glm::vec3(-1, -1, 1));
    EXPECT_EQ(convert<uint8_t>({0, 255, 51, 0, 0, 0, 0, 0, 0}, true)[0], glm::vec3(0, 1, 51.0f / 255));
    EXPECT_EQ(convert<int16_t>({-32768, 32767, 16384, 0, 0, 0, 0, 0, 0}, true)[0], glm::vec3(-1, 1, 16384.0f / 32767));
    EXPECT_EQ(convert<uint16_t>({0, 65535, 13107, 0, 0, 0, 0, 0, 0}, true)[0], glm::vec3(0, 1, 0.2f));
}

TEST(GltfAccessor, InterleavedWithOffset) {
    GltfBuilder builder;
    // Two floats of something else before each position.
    const int view = builder.addView<float>({9, 9, 1, 2, 3, 9, 9, 4, 5, 6, 9, 9, 7, 8, 9}, 20);
    builder.append(
        "accessors",
        {{"bufferView", view}, {"byteOffset", 8}, {"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}});
    EXPECT_EQ(positionsOf(builder), (std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST(GltfAccessor, WithoutViewIsZeros) {
    GltfBuilder builder;
    builder.append("accessors", {{"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}});
    EXPECT_EQ(positionsOf(builder), std::vector<glm::vec3>(3, glm::vec3(0)));
}

Json sparse(GltfBuilder& builder, const std::vector<uint8_t>& indices, const std::vector<float>& values) {
    return {{"count", indices.size()},
            {"indices", {{"bufferView", builder.addView(indices)}, {"componentType", kUInt8}}},
            {"values", {{"bufferView", builder.addView(values)}}}};
}

TEST(GltfAccessor, SparseOverView) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["accessors"][0]["sparse"] = sparse(builder, {0, 2}, {7, 8, 9, 4, 5, 6});
    EXPECT_EQ(positionsOf(builder), (std::vector<glm::vec3>{{7, 8, 9}, {1, 0, 0}, {4, 5, 6}}));
}

TEST(GltfAccessor, SparseOverNothing) {
    GltfBuilder builder;
    builder.append("accessors", {{"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}});
    builder.json["accessors"][0]["sparse"] = sparse(builder, {1}, {7, 8, 9});
    EXPECT_EQ(positionsOf(builder), (std::vector<glm::vec3>{{0, 0, 0}, {7, 8, 9}, {0, 0, 0}}));
}

TEST(GltfAccessor, SparseIndexBeyondTheEnd) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["accessors"][0]["sparse"] = sparse(builder, {3}, {7, 8, 9});
    EXPECT_EQ(errorOf(builder), "test.glb: accessor 0 replaces element 3 but has 3");
}

TEST(GltfAccessor, SparseValuesBeyondTheirView) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["accessors"][0]["sparse"] = sparse(builder, {0, 1}, {7, 8, 9});
    EXPECT_EQ(errorOf(builder), "test.glb: accessor 0: sparse.values ends at byte 24 but bufferView 2 has 12");
}

TEST(GltfAccessor, MoreSparseValuesThanElements) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["accessors"][0]["sparse"] = sparse(builder, {0, 1, 2, 2}, std::vector<float>(12, 0.0f));
    EXPECT_EQ(errorOf(builder), "test.glb: accessor 0 has 4 sparse values but only 3 elements");
}

TEST(GltfAccessor, EndsBeyondItsView) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["accessors"][0]["count"] = 4;
    EXPECT_EQ(errorOf(builder), "test.glb: accessor 0 ends at byte 48 but bufferView 0 has 36");
}

TEST(GltfAccessor, OffsetsAndCountsThatWouldOverflow) {
    for (const char* key : {"count", "byteOffset"}) {
        for (const uint64_t value : {uint64_t(1) << 32, uint64_t(1) << 53, ~uint64_t(0), ~uint64_t(0) / 12 + 2}) {
            GltfBuilder builder;
            builder.addAccessor("VEC3", kTriangle);
            builder.json["accessors"][0][key] = value;
            EXPECT_THAT(errorOf(builder), testing::StartsWith("test.glb: accessor")) << key << " " << value;
        }
    }
}

TEST(GltfAccessor, NegativeOffset) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["accessors"][0]["byteOffset"] = -4;
    EXPECT_THAT(errorOf(builder), HasSubstr("accessors[0].byteOffset must be a whole number, 0 or more"));
}

TEST(GltfAccessor, ViewEndsBeyondItsBuffer) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", kTriangle);
    builder.json["bufferViews"][0]["byteLength"] = 40;
    EXPECT_EQ(errorOf(builder), "test.glb: bufferView 0 ends at byte 40 but buffer 0 has 36");
}

TEST(GltfAccessor, UnknownViewBufferTypeAndComponentType) {
    const auto broken = [](const char* array, const char* key, const Json& value) {
        GltfBuilder builder;
        builder.addAccessor("VEC3", kTriangle);
        builder.json[array][0][key] = value;
        return errorOf(builder);
    };
    EXPECT_EQ(broken("accessors", "bufferView", 1),
              "test.glb: accessors[0].bufferView is 1 but the file has 1 bufferViews");
    EXPECT_EQ(broken("bufferViews", "buffer", 7), "test.glb: bufferViews[0].buffer is 7 but the file has 1 buffers");
    EXPECT_THAT(broken("accessors", "type", "VEC5"), HasSubstr("accessor 0 has type \"VEC5\""));
    EXPECT_THAT(broken("accessors", "componentType", 5124), HasSubstr("is 5124, which is no component type"));
    EXPECT_THAT(broken("bufferViews", "byteStride", 8),
                HasSubstr("accessor 0 has elements of 12 bytes but bufferView 0 has byteStride 8"));
    EXPECT_THAT(broken("bufferViews", "byteStride", 256), HasSubstr("must be between 4 and 252"));
}

TEST(GltfAccessor, WrongShapeForItsUse) {
    GltfBuilder builder;
    builder.addAccessor<float>("VEC2", {1, 2, 3, 4});
    EXPECT_EQ(errorOf(builder),
              "test.glb: accessor 0 is VEC2, but meshes[0].primitives[0].attributes.POSITION needs VEC3");
}

TEST(GltfAccessor, PositionsMustBeFinite) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        GltfBuilder builder;
        builder.addAccessor<float>("VEC3", {0, 0, 0, 1, bad, 0, 0, 1, 0});
        EXPECT_THAT(errorOf(builder),
                    HasSubstr("accessor 0: element 1 of meshes[0].primitives[0].attributes.POSITION is not finite"));
    }
}

TEST(GltfAccessor, HugeZerosAreRefusedBeforeTheyAreMade) {
    GltfBuilder builder;
    builder.append("accessors", {{"componentType", kFloat}, {"count", 4000000000u}, {"type", "VEC3"}});
    EXPECT_EQ(errorOf(builder), "test.glb: accessor 0 has 4000000000 elements but no data for them");
}

TEST(GltfAccessor, SharingOneAccessorCountsEachTime) {
    GltfBuilder builder;
    builder.addAccessor("VEC3", std::vector<float>(3000, 1.0f));
    Json primitives = Json::array();
    for (int i = 0; i < 1000; ++i)
        primitives.push_back({{"attributes", {{"POSITION", 0}}}});
    builder.append("meshes", {{"primitives", primitives}});
    scene::GltfLimits limits;
    limits.sceneBytes = uint64_t(8) << 20;
    EXPECT_THAT(builder.readError(limits), HasSubstr("takes the scene beyond 8 MiB, the limit"));
}

} // namespace gltf_accessor_test
} // namespace glint::test
