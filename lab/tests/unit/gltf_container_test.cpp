// Files and wrappings: what is no glTF, what is cut off, what lies elsewhere.
#include "base/log.hpp"
#include "lab/tests/support/gltf_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace glint::test {
namespace gltf_container_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string readText(const std::string& text, const scene::UriResolver& resolve = {}) {
    const std::vector<uint8_t> bytes(text.begin(), text.end());
    const auto scene = scene::readGltfMemory(bytes, "test.gltf", resolve);
    return scene ? "read without error" : scene.error().message;
}

/// A folder that is gone after the test.
class GltfFile : public testing::Test {
protected:
    GltfFile() {
        folder_ = fs::temp_directory_path() /
                  ("glint-gltf-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::create_directories(folder_);
    }
    ~GltfFile() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return (folder_ / name).string();
    }
    std::string error(const std::string& path) {
        const auto scene = scene::readGltf(path);
        return scene ? "read without error" : scene.error().message;
    }

    fs::path folder_;
};

TEST_F(GltfFile, Missing) {
    const auto scene = scene::readGltf((folder_ / "gone.glb").string());
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::NotFound);
    EXPECT_EQ(scene.error().message, "gone.glb: no such file");
}

TEST_F(GltfFile, Empty) {
    EXPECT_EQ(error(write("empty.glb", "")), "empty.glb: is empty (0 bytes)");
}

TEST_F(GltfFile, Folder) {
    EXPECT_THAT(error(folder_.string()), HasSubstr(": is a folder, not a file"));
}

TEST_F(GltfFile, TextNamedGlb) {
    EXPECT_THAT(error(write("text.glb", "hello, world")), StartsWith("text.glb: is not glTF"));
}

TEST_F(GltfFile, JsonNamedGlbIsReadByContent) {
    EXPECT_EQ(error(write("json.glb", R"({"asset":{"version":"2.0"}})")), "read without error");
}

TEST_F(GltfFile, MissingBufferIsNamed) {
    const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"uri":"no%20where.bin","byteLength":4}]})";
    EXPECT_EQ(error(write("a.gltf", text)), "a.gltf: buffers[0]: \"no where.bin\": no such file");
}

TEST_F(GltfFile, ShortBufferIsNamed) {
    write("short.bin", "abc");
    const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"uri":"short.bin","byteLength":4}]})";
    EXPECT_EQ(error(write("a.gltf", text)), "a.gltf: buffer 0 should have 4 bytes but its data has 3");
}

TEST_F(GltfFile, ImageThatIsTextIsNamed) {
    write("wood.png", "not a picture");
    const std::string text = R"({"asset":{"version":"2.0"},"images":[{"uri":"wood.png"}],"textures":[{"source":0}]})";
    EXPECT_EQ(error(write("a.gltf", text)), "a.gltf: images[0] (wood.png): is no PNG, JPEG or WebP image");
}

TEST_F(GltfFile, NamesWithSpacesPercentsAndUnicode) {
    write("My 100% ❤.bin", "abcd");
    for (const std::string uri : {"My%20100%25%20%E2%9D%A4.bin", "My 100% ❤.bin"}) {
        const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + uri + R"(","byteLength":4}]})";
        EXPECT_EQ(error(write("a.gltf", text)), "read without error") << uri;
    }
}

TEST(GltfUri, OnlyBesideTheModel) {
    for (const std::string uri : {"http://example.org/a.bin", "file:///etc/passwd", "/etc/passwd", ""}) {
        const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + uri + R"(","byteLength":4}]})";
        const auto forbidden = [](const std::string&) -> Result<std::vector<uint8_t>> {
            ADD_FAILURE() << "must not be asked";
            return std::vector<uint8_t>();
        };
        EXPECT_THAT(readText(text, forbidden), StartsWith("test.gltf: buffers[0]: uri ")) << uri;
    }
}

TEST(GltfUri, DataUris) {
    const auto read = [](const std::string& uri) {
        return readText(R"({"asset":{"version":"2.0"},"buffers":[{"uri":")" + uri + R"(","byteLength":4}]})");
    };
    EXPECT_EQ(read("data:application/octet-stream;base64,YWJjZA=="), "read without error");
    EXPECT_EQ(read("data:;base64,YWJjZA"), "read without error");
    EXPECT_EQ(read("data:,ab%20d"), "read without error");
    EXPECT_THAT(read("data:;base64,YWJj!A=="), HasSubstr("0x21"));
    EXPECT_THAT(read("data:;base64,YWJjZ"), HasSubstr("cut off"));
    EXPECT_THAT(read("data:;base64"), HasSubstr("no comma"));
    EXPECT_THAT(read("data:;base64,YWI="), HasSubstr("buffer 0 should have 4 bytes but its data has 2"));
}

TEST(GlbContainer, EveryCutIsAnError) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)}});
    const std::vector<uint8_t> whole = builder.glb();
    ASSERT_TRUE(scene::readGltfMemory(whole, "test.glb", {}));
    for (size_t size = 0; size < whole.size(); ++size) {
        const auto scene = scene::readGltfMemory(std::span(whole).first(size), "test.glb", {});
        ASSERT_FALSE(scene) << size;
        EXPECT_THAT(scene.error().message, AllOf(StartsWith("test.glb: "), Not(HasSubstr("\n"))));
    }
}

TEST(GlbContainer, VersionOne) {
    std::vector<uint8_t> bytes = GltfBuilder().glb();
    bytes[4] = 1;
    EXPECT_EQ(scene::readGltfMemory(bytes, "old.glb", {}).error().message,
              "old.glb: is binary glTF version 1, only version 2 can be read");
}

TEST(GlbContainer, UnknownChunksAreSkipped) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)}});
    std::vector<uint8_t> bytes = builder.glb();
    const std::vector<uint8_t> chunk = {4, 0, 0, 0, 'X', 'T', 'R', 'A', 1, 2, 3, 4};
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    const auto length = static_cast<uint32_t>(bytes.size());
    std::memcpy(bytes.data() + 8, &length, 4);
    EXPECT_TRUE(scene::readGltfMemory(bytes, "test.glb", {}));
}

TEST(GltfJson, MistakesHaveAPlace) {
    EXPECT_THAT(readText("{\"asset\": {\n  \"version\": }}"), HasSubstr("line 2"));
    EXPECT_THAT(readText("{\"asset\": 3}"), HasSubstr("asset must be an object"));
    EXPECT_THAT(readText("{}"), HasSubstr("asset.version is missing"));
    EXPECT_THAT(readText(R"({"asset":{"version":"1.0"}})"), HasSubstr("is glTF version \"1.0\""));
    EXPECT_THAT(readText(R"({"asset":{"version":"2.1","minVersion":"2.1"}})"), HasSubstr("needs a reader of glTF 2.1"));
    EXPECT_THAT(readText(R"({"asset":{"version":"2.0"},"nodes":3})"), HasSubstr("nodes must be an array"));
    EXPECT_THAT(readText(R"({"asset":{"version":"2.0"},"nodes":[3]})"), HasSubstr("nodes[0] must be an object"));
    EXPECT_THAT(readText(R"({"asset":{"version":"2.0"},"scene":1.5})"), HasSubstr("scene must be a whole number"));
    EXPECT_THAT(readText(R"({"asset":{"version":"2.0"},"x":1e999})"), HasSubstr("number overflow"));
}

TEST(GltfJson, DepthIsLimited) {
    const std::string deep = R"({"asset":)" + std::string(100000, '[') + std::string(100000, ']') + "}";
    EXPECT_EQ(readText(deep), "test.gltf: JSON is nested deeper than 128 levels");
}

TEST(GltfJson, WholeNumbersMayBeWrittenAsFloats) {
    EXPECT_EQ(readText(R"({"asset":{"version":"2.0"},"scenes":[{}],"scene":0.0})"), "read without error");
}

TEST(GltfJson, ByteOrderMarkIsAllowed) {
    EXPECT_EQ(readText("\xEF\xBB\xBF{\"asset\":{\"version\":\"2.0\"}}"), "read without error");
}

TEST(GltfExtensions, RequiredAndUnknownIsAnError) {
    GltfBuilder builder;
    builder.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_materials_iridescence"};
    const auto scene = builder.read();
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::Unsupported);
    EXPECT_EQ(scene.error().message, "test.glb: requires KHR_materials_iridescence, which Glint does not support");
}

TEST(GltfExtensions, OptionalAndUnknownIsOneWarning) {
    std::vector<std::string> lines;
    log::setSink(
        [](std::string_view line, void* user) { static_cast<std::vector<std::string>*>(user)->emplace_back(line); },
        &lines);
    GltfBuilder builder;
    builder.json["extensionsUsed"] = {"KHR_materials_sheen", "KHR_texture_transform", "EXT_lights_ies"};
    EXPECT_EQ(builder.readError(), "read without error");
    log::setSink(nullptr, nullptr);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_THAT(lines[0], HasSubstr("test.glb: ignores KHR_materials_sheen, EXT_lights_ies"));
}

} // namespace gltf_container_test
} // namespace glint::test
