// Compressed payloads made here with the encoders: meshopt in every mode and filter, Draco; and damaged ones.
#include "lab/tests/support/gltf_builder.hpp"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

namespace glint::test {
namespace gltf_compression_test {

using testing::HasSubstr;

/// Makes view `view` a compressed one, over a fallback buffer that has no bytes.
void compressView(GltfBuilder& builder, int view, const std::vector<uint8_t>& compressed, const std::string& mode,
                  size_t count, size_t stride, const std::string& filter = "NONE") {
    const int data = builder.addView(compressed);
    const Json place = builder.json["bufferViews"][size_t(data)];
    builder.json["bufferViews"].erase(size_t(data));
    builder.json["bufferViews"][size_t(view)] = {{"buffer", 1},
                                                 {"byteLength", count * stride},
                                                 {"extensions",
                                                  {{"EXT_meshopt_compression",
                                                    {{"buffer", 0},
                                                     {"byteOffset", place["byteOffset"]},
                                                     {"byteLength", compressed.size()},
                                                     {"byteStride", stride},
                                                     {"count", count},
                                                     {"mode", mode},
                                                     {"filter", filter}}}}}};
    if (mode == "ATTRIBUTES")
        builder.json["bufferViews"][size_t(view)]["byteStride"] = stride;
    builder.json["buffers"] = {
        {{"byteLength", builder.binary.size()}},
        {{"byteLength", count * stride}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    builder.json["extensionsRequired"] = {"EXT_meshopt_compression"};
}

template <class T>
std::vector<uint8_t> encodeVertices(const std::vector<T>& data, size_t count, size_t stride) {
    std::vector<uint8_t> out(meshopt_encodeVertexBufferBound(count, stride));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), data.data(), count, stride));
    return out;
}

std::vector<uint8_t> encodeTriangles(const std::vector<uint32_t>& indices) {
    std::vector<uint8_t> out(meshopt_encodeIndexBufferBound(indices.size(), 16));
    out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size()));
    return out;
}

std::vector<uint8_t> encodeSequence(const std::vector<uint32_t>& indices) {
    std::vector<uint8_t> out(meshopt_encodeIndexSequenceBound(indices.size(), 16));
    out.resize(meshopt_encodeIndexSequence(out.data(), out.size(), indices.data(), indices.size()));
    return out;
}

const std::vector<float> kPositions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.25f};
const std::vector<float> kNormals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};

GltfBuilder square() {
    GltfBuilder builder;
    Json& primitive = builder.addMesh(
        {{"POSITION", builder.addAccessor("VEC3", kPositions)}, {"NORMAL", builder.addAccessor("VEC3", kNormals)}});
    primitive["indices"] = builder.addAccessor<uint16_t>("SCALAR", {0, 1, 2, 2, 1, 3});
    return builder;
}

scene::Geometry firstGeometry(const GltfBuilder& builder) {
    const auto scene = builder.read();
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? scene->meshes[0].primitives[0].geometry : scene::Geometry();
}

TEST(Meshopt, Attributes) {
    GltfBuilder builder = square();
    compressView(builder, 0, encodeVertices(kPositions, 4, 12), "ATTRIBUTES", 4, 12);
    EXPECT_EQ(firstGeometry(builder).positions, firstGeometry(square()).positions);
}

TEST(Meshopt, TrianglesAndSequencesInBothWidths) {
    for (const size_t width : {size_t(2), size_t(4)}) {
        for (const std::string mode : {"TRIANGLES", "INDICES"}) {
            GltfBuilder builder = square();
            const std::vector<uint32_t> indices = {0, 1, 2, 2, 1, 3};
            compressView(builder, 2, mode == "TRIANGLES" ? encodeTriangles(indices) : encodeSequence(indices), mode, 6,
                         width);
            builder.json["accessors"][2]["componentType"] = width == 2 ? kUInt16 : kUInt32;
            const std::vector<uint32_t> read = firstGeometry(builder).indices;
            if (mode == "INDICES")
                EXPECT_EQ(read, indices);
            else // the codec may turn triangles, not flip them
                EXPECT_THAT(read, testing::UnorderedElementsAre(0, 1, 2, 2, 1, 3));
        }
    }
}

TEST(Meshopt, OctahedralNormals) {
    for (const size_t stride : {size_t(4), size_t(8)}) {
        const std::vector<float> wanted = {0, 0, 1, 0, 0, 1, 0, 0, 0.6f, 0, 0.8f, 0, -1, 0, 0, 0};
        std::vector<uint8_t> filtered(4 * stride);
        meshopt_encodeFilterOct(filtered.data(), 4, stride, stride == 4 ? 8 : 16, wanted.data());
        GltfBuilder builder = square();
        compressView(builder, 1, encodeVertices(filtered, 4, stride), "ATTRIBUTES", 4, stride, "OCTAHEDRAL");
        builder.json["accessors"][1]["componentType"] = stride == 4 ? kInt8 : kInt16;
        builder.json["accessors"][1]["normalized"] = true;
        const scene::Geometry geometry = firstGeometry(builder);
        ASSERT_EQ(geometry.normals.size(), 4u);
        for (size_t i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(geometry.normals[i][k], wanted[i * 4 + size_t(k)], 0.02) << i;
    }
}

/// Calls meshopt_encodeFilterExp, which takes a mode too from version 0.19 on; 1 is what older ones do: one exponent a
/// vector.
template <typename... Mode>
void encodeExponential(void (*encode)(void*, size_t, size_t, int, const float*, Mode...),
                       std::vector<uint8_t>& filtered, size_t count) {
    encode(filtered.data(), count, filtered.size() / count, 15, kPositions.data(), static_cast<Mode>(1)...);
}

TEST(Meshopt, ExponentialPositions) {
    std::vector<uint8_t> filtered(4 * 12);
    encodeExponential(meshopt_encodeFilterExp, filtered, 4);
    GltfBuilder builder = square();
    compressView(builder, 0, encodeVertices(filtered, 4, 12), "ATTRIBUTES", 4, 12, "EXPONENTIAL");
    const scene::Geometry geometry = firstGeometry(builder);
    ASSERT_EQ(geometry.positions.size(), 4u);
    EXPECT_NEAR(geometry.positions[3].z, 0.25f, 1e-3);
}

TEST(Meshopt, QuaternionRotations) {
    const std::vector<float> rotations = {0, 0, 0, 1, 0, 0.6f, 0, 0.8f};
    std::vector<uint8_t> filtered(2 * 8);
    meshopt_encodeFilterQuat(filtered.data(), 2, 8, 16, rotations.data());
    GltfBuilder builder;
    builder.json["nodes"] = Json::parse("[{}]");
    const int times = builder.addAccessor<float>("SCALAR", {0, 1});
    const int values = builder.addAccessor<int16_t>("VEC4", std::vector<int16_t>(8), true);
    compressView(builder, 1, encodeVertices(filtered, 2, 8), "ATTRIBUTES", 2, 8, "QUATERNION");
    builder.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}}}},
                                   {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    const auto scene = builder.read();
    ASSERT_TRUE(scene) << scene.error().message;
    const std::vector<float>& read = scene->animations[0].channels[0].values;
    ASSERT_EQ(read.size(), 8u);
    EXPECT_NEAR(read[5], 0.6f, 1e-3);
    EXPECT_NEAR(read[7], 0.8f, 1e-3);
}

TEST(Meshopt, Mistakes) {
    const auto broken = [](const char* key, const Json& value) {
        GltfBuilder builder = square();
        compressView(builder, 0, encodeVertices(kPositions, 4, 12), "ATTRIBUTES", 4, 12);
        builder.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
        return builder.readError();
    };
    EXPECT_THAT(broken("mode", "ZIP"), HasSubstr("bufferView 0: EXT_meshopt_compression: mode \"ZIP\" is not known"));
    EXPECT_THAT(broken("mode", "TRIANGLES"), HasSubstr("byteStride 12 must be 2 or 4"));
    EXPECT_THAT(broken("filter", "OCTAHEDRAL"), HasSubstr("needs byteStride 4 or 8"));
    EXPECT_THAT(broken("filter", "BLUR"), HasSubstr("filter \"BLUR\" is not known"));
    EXPECT_THAT(broken("byteStride", 10), HasSubstr("must be a multiple of 4"));
    EXPECT_THAT(broken("byteStride", 0), HasSubstr("must be a multiple of 4"));
    EXPECT_THAT(broken("count", 3), HasSubstr("should have 48 bytes but decompresses to 36"));
    EXPECT_THAT(broken("count", 4000000000u), HasSubstr("compressed bytes can hold"));
    EXPECT_THAT(broken("byteLength", 100000), HasSubstr("but buffer 0 has"));
    EXPECT_THAT(broken("byteLength", 3), HasSubstr("damaged"));
}

TEST(Meshopt, PlainViewOfAFallbackBuffer) {
    GltfBuilder builder = square();
    compressView(builder, 0, encodeVertices(kPositions, 4, 12), "ATTRIBUTES", 4, 12);
    builder.json["bufferViews"][1]["buffer"] = 1;
    EXPECT_THAT(builder.readError(), HasSubstr("but buffer 1 has 0"));
}

/// The square as Draco data; attribute 0 holds positions, 1 normals.
std::vector<uint8_t> dracoSquare() {
    draco::TriangleSoupMeshBuilder soup;
    soup.Start(2);
    const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int normal = soup.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
    const int corners[2][3] = {{0, 1, 2}, {2, 1, 3}};
    for (int face = 0; face < 2; ++face) {
        const auto at = [&](const std::vector<float>& values, int k) { return &values[size_t(corners[face][k]) * 3]; };
        const draco::FaceIndex index(static_cast<uint32_t>(face));
        soup.SetAttributeValuesForFace(position, index, at(kPositions, 0), at(kPositions, 1), at(kPositions, 2));
        soup.SetAttributeValuesForFace(normal, index, at(kNormals, 0), at(kNormals, 1), at(kNormals, 2));
    }
    const std::unique_ptr<draco::Mesh> mesh = soup.Finalize();
    draco::ExpertEncoder encoder(*mesh);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
    return {buffer.data(), buffer.data() + buffer.size()};
}

GltfBuilder dracoFile(const std::vector<uint8_t>& data) {
    GltfBuilder builder;
    const Json accessor = {{"componentType", kFloat}, {"count", 4}, {"type", "VEC3"}};
    builder.append("accessors", accessor);
    builder.append("accessors", accessor);
    builder.append("accessors", {{"componentType", kUInt16}, {"count", 6}, {"type", "SCALAR"}});
    Json& primitive = builder.addMesh({{"POSITION", 0}, {"NORMAL", 1}});
    primitive["indices"] = 2;
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", builder.addView(data)},
                                                             {"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}};
    return builder;
}

TEST(Draco, SquareSurvives) {
    const scene::Geometry geometry = firstGeometry(dracoFile(dracoSquare()));
    ASSERT_EQ(geometry.positions.size(), 4u);
    ASSERT_EQ(geometry.indices.size(), 6u);
    float area = 0;
    for (size_t i = 0; i < 6; i += 3) {
        const glm::vec3& a = geometry.positions[geometry.indices[i]];
        area += glm::length(glm::cross(geometry.positions[geometry.indices[i + 1]] - a,
                                       geometry.positions[geometry.indices[i + 2]] - a)) /
                2;
    }
    EXPECT_NEAR(area, 0.5f + 0.5f * std::sqrt(1.125f), 1e-5);
    EXPECT_EQ(geometry.normals[3], glm::vec3(0, 0, 1));
}

TEST(Draco, Mistakes) {
    const auto broken = [](const auto& change) {
        GltfBuilder builder = dracoFile(dracoSquare());
        change(builder.json, builder.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]);
        return builder.readError();
    };
    EXPECT_EQ(broken([](Json& json, Json&) { json["accessors"][0]["count"] = 5; }),
              "test.glb: accessor 0 has 5 elements but its Draco data has 4");
    EXPECT_THAT(broken([](Json&, Json& draco) { draco["attributes"]["POSITION"] = 9; }),
                HasSubstr("attributes.POSITION is 9, but the Draco data has no such attribute"));
    EXPECT_THAT(broken([](Json&, Json& draco) { draco["attributes"]["COLOR_0"] = 1; }),
                HasSubstr("COLOR_0 is missing"));
    EXPECT_THAT(broken([](Json& json, Json&) { json["accessors"][1]["componentType"] = kUInt16; }),
                HasSubstr("the Draco data does not fit accessor 1"));
    EXPECT_THAT(broken([](Json&, Json& draco) { draco["bufferView"] = 3; }), HasSubstr("bufferView is 3"));
    EXPECT_THAT(dracoFile({1, 2, 3, 4, 5}).readError(), HasSubstr("test.glb: bufferView 0: Draco: "));
}

TEST(Draco, EveryCutIsAnError) {
    const std::vector<uint8_t> whole = dracoSquare();
    for (size_t size = 0; size < whole.size(); ++size)
        EXPECT_THAT(dracoFile({whole.begin(), whole.begin() + long(size)}).readError(), HasSubstr("test.glb: "))
            << size;
}

} // namespace gltf_compression_test
} // namespace glint::test
