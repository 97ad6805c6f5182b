// shaders/variants.txt and lab/shaders/variants.txt against the shaders that the program embeds.
#include "gpu/embed/shader_variants.hpp"

#include "base/file.hpp"
#include "gpu/embed/shader_reflection.hpp"
#include "lab/view/shaders.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace glint::gpu {
namespace shader_variants_test {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kFolders[] = {std::string(GLINT_SOURCE_DIR) + "/shaders/",
                                std::string(GLINT_SOURCE_DIR) + "/lab/shaders/"};

std::map<std::string_view, const EmbeddedShader*> embeddedShaders() {
    std::map<std::string_view, const EmbeddedShader*> found;
    for (const auto& set : {shaders::reflect(), shaders::render(), shaders::view()})
        for (const EmbeddedShader& shader : set)
            found[shader.name] = &shader;
    return found;
}

ShaderVariants readVariants() {
    ShaderVariants all;
    for (const std::string& folder : kFolders) {
        const auto text = readFile(folder + kShaderVariantsFile, 1 << 20);
        std::vector<std::string> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            files.push_back(std::filesystem::relative(entry.path(), folder).generic_string());
        auto variants = text ? parseShaderVariants(*text, files) : text.error();
        EXPECT_TRUE(variants) << variants.error().message;
        if (variants)
            all.merge(*variants);
    }
    return all;
}

TEST(ShaderVariants, ALineIsANameASourceAndMacros) {
    const auto variants = parseShaderVariants("# comment\n\na/b  a/main.glsl\na/c.frag a/main.glsl  ONE TWO\n");
    ASSERT_TRUE(variants);
    ASSERT_EQ(variants->size(), 2u);
    EXPECT_EQ(shaderSource(*variants, "a/b").file, "a/main.glsl");
    EXPECT_THAT(shaderSource(*variants, "a/b").macros, ElementsAre());
    EXPECT_THAT(shaderSource(*variants, "a/c.frag").macros, ElementsAre("ONE", "TWO"));
    EXPECT_EQ(shaderSource(*variants, "a/d").file, "a/d.comp");

    const auto noSource = parseShaderVariants("# comment\na/b\n");
    ASSERT_FALSE(noSource);
    EXPECT_THAT(noSource.error().message, HasSubstr("variants.txt:2: \"a/b\""));
    const auto twice = parseShaderVariants("a/b c\na/b d\n");
    ASSERT_FALSE(twice);
    EXPECT_THAT(twice.error().message, HasSubstr("variants.txt:2: a/b is stated twice"));
}

TEST(ShaderVariants, ALineWithAStarStandsForOneShaderOfEachFile) {
    const std::vector<std::string> files = {"a/b/one.glsl", "a/b/two.glsl", "a/b/deep/three.glsl", "a/b/four.comp"};
    const auto variants = parseShaderVariants("a/*  a/b/*.glsl\na/log/* a/b/*.glsl LOGS\n", files);
    ASSERT_TRUE(variants);
    ASSERT_EQ(variants->size(), 4u);
    EXPECT_EQ(shaderSource(*variants, "a/one").file, "a/b/one.glsl");
    EXPECT_THAT(shaderSource(*variants, "a/one").macros, ElementsAre());
    EXPECT_EQ(shaderSource(*variants, "a/log/two").file, "a/b/two.glsl");
    EXPECT_THAT(shaderSource(*variants, "a/log/two").macros, ElementsAre("LOGS"));
}

TEST(ShaderVariants, TheTableAndTheEmbeddedShadersAgree) {
    const ShaderVariants variants = readVariants();
    ASSERT_FALSE(variants.empty());
    const auto embedded = embeddedShaders();
    for (const auto& [name, source] : variants)
        EXPECT_TRUE(embedded.contains(name)) << name << " is in no set: does CMakeLists.txt list its folder?";
    for (const auto& [name, shader] : embedded) {
        const std::string file = shaderSource(variants, name).file;
        EXPECT_TRUE(
            std::ranges::any_of(kFolders, [&](const std::string& at) { return std::filesystem::exists(at + file); }))
            << name << " is built from " << file;
    }
}

/// A macro that its source does not know makes a second copy of some other variant.
TEST(ShaderVariants, NoTwoOfASourceAreTheSame) {
    const auto embedded = embeddedShaders();
    const ShaderVariants variants = readVariants();
    for (auto one = variants.begin(); one != variants.end(); ++one)
        for (auto other = std::next(one); other != variants.end(); ++other)
            if (one->second.file == other->second.file) {
                EXPECT_FALSE(std::ranges::equal(embedded.at(one->first)->words, embedded.at(other->first)->words))
                    << one->first << " and " << other->first;
            }
}

} // namespace shader_variants_test
} // namespace glint::gpu
