// Layers by name: which channels a mapping's names mean, and what is said where they mean none or several.
#include "lab/gbuffer_files/gbuffer_layers.hpp"

#include "base/file.hpp"
#include "lab/tests/support/exr_writer.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::scene {
namespace gbuffer_layers_test {

using test::must;
using testing::ElementsAre;
using testing::HasSubstr;

/// A file of 2 x 1 pixels: channel c has the values (value, value + 0.5).
ExrChannels fileOf(const std::vector<std::pair<std::string, float>>& channels, int width = 2) {
    const test::TempFolder temp;
    test::ExrPart part = {"", width, 1, {}};
    for (const auto& [name, value] : channels) {
        std::vector<float> plane;
        for (int i = 0; i < width; ++i)
            plane.push_back(value + 0.5f * float(i));
        part.planes.emplace_back(name, plane);
    }
    test::writeExrFile(temp + "f.exr", part);
    return must(ExrChannels::decode(must(readFile(temp + "f.exr", 1 << 20)), "f.exr", 1 << 20));
}

const std::vector<std::pair<std::string, float>> kChannels = {
    {"View.Depth.Z", 1}, {"View.N.X", 2},     {"View.N.Y", 3}, {"View.N.Z", 4}, {"View.Rough.R", 5},
    {"View.Rough.G", 6}, {"View.Rough.B", 7}, {"View.C.R", 8}, {"View.C.G", 9}, {"View.C.B", 10},
    {"View.C.A", 11},    {"View.D.R", 2},     {"View.D.G", 3}, {"View.D.B", 4}, {"mask.V", 12}};

GBufferMapping mapping() {
    return must(parseMapping(R"({"depth": "Depth.Z", "normal": "N", "roughness": "Rough", "color": "C"})", "m"));
}

std::string errorOf(const ExrChannels& file, const GBufferMapping& mapping) {
    const auto layers = readLayers(file, file, mapping);
    return layers ? "" : layers.error().message;
}

TEST(GBufferLayers, NamesMeanChannelsOfOneLayer) {
    const ExrChannels file = fileOf(kChannels);
    GBufferMapping names = mapping();
    names.coverage = "mask";
    const GBufferLayers layers = must(readLayers(file, file, names));
    EXPECT_THAT(layers.depth, ElementsAre(1, 1.5f));
    EXPECT_THAT(layers.normal, ElementsAre(glm::vec3(2, 3, 4), glm::vec3(2.5f, 3.5f, 4.5f)));
    EXPECT_THAT(layers.roughness, ElementsAre(5, 5.5f)); // a grey colour: its red channel
    EXPECT_THAT(layers.color, ElementsAre(glm::vec3(8, 9, 10), glm::vec3(8.5f, 9.5f, 10.5f)));
    EXPECT_THAT(layers.coverage, ElementsAre(12, 12.5f));
    EXPECT_TRUE(layers.metallic.empty() && layers.reference.empty());
}

TEST(GBufferLayers, ColoursAreSumsOfProducts) {
    const ExrChannels file = fileOf(kChannels);
    GBufferMapping names = mapping();
    names.color = {{"D", {"C", "D"}}, {"", {"C"}}};
    const GBufferLayers layers = must(readLayers(file, file, names));
    const glm::vec3 c(8, 9, 10), d(2, 3, 4);
    EXPECT_EQ(layers.color[0], d * (c + d) + c);
}

TEST(GBufferLayers, WholeNamesSettleWhatIsAmbiguous) {
    auto channels = kChannels;
    channels.emplace_back("Other.Depth.Z", 100.0f);
    channels.emplace_back("Other.N.X", 1.0f);
    channels.emplace_back("Other.N.Y", 1.0f);
    channels.emplace_back("Other.N.Z", 1.0f);
    const ExrChannels file = fileOf(channels);
    GBufferMapping names = mapping();
    EXPECT_THAT(errorOf(file, names), HasSubstr("depth: several channels are called Depth.Z: Other.Depth.Z, View.Dep"));
    names.depth = "View.Depth.Z";
    EXPECT_THAT(errorOf(file, names), HasSubstr("normal: several layers are called N: Other.N, View.N"));
    names.normal = "View.N";
    EXPECT_EQ(must(readLayers(file, file, names)).depth[0], 1);
}

TEST(GBufferLayers, WhatIsMissingIsNamedWithWhatThereIs) {
    const ExrChannels file = fileOf(kChannels);
    GBufferMapping names = mapping();
    names.normal = "Normal";
    EXPECT_THAT(errorOf(file, names),
                HasSubstr("f.exr: normal: no layer is called Normal; the file has View.C, View."));
    names = mapping();
    names.normal = "Depth";
    EXPECT_THAT(errorOf(file, names),
                HasSubstr("normal: layer Depth has the channels View.Depth.Z, but needs X, Y, Z"));
    names = mapping();
    names.depth = "N";
    EXPECT_THAT(errorOf(file, names), HasSubstr("depth: layer N has the channels"));
}

TEST(GBufferLayers, OptionalLayersThatAreMissingAreNotes) {
    const ExrChannels file = fileOf(kChannels);
    GBufferMapping names = mapping();
    names.metallic.layer = "Metal";
    EXPECT_THAT(errorOf(file, names), HasSubstr("metallic: no layer is called Metal"));
    names.optional = {"metallic"};
    const GBufferLayers layers = must(readLayers(file, file, names));
    EXPECT_THAT(layers.notes, ElementsAre(HasSubstr("metallic: no layer is called Metal")));
    EXPECT_TRUE(layers.metallic.empty());
}

TEST(GBufferLayers, MotionIsThePairXY) {
    auto channels = kChannels;
    for (const char* vector : {"View.V.X", "View.V.Y", "View.V.Z", "View.V.W"})
        channels.emplace_back(vector, float(channels.size()));
    GBufferMapping names = mapping();
    names.motion = "V";
    EXPECT_THAT(must(readLayers(fileOf(channels), fileOf(channels), names)).motion,
                ElementsAre(glm::vec2(15, 16), glm::vec2(15.5f, 16.5f)));
    names.motion = "mask";
    EXPECT_THAT(errorOf(fileOf(channels), names),
                HasSubstr("motion: layer mask has the channels mask.V, but needs X, Y"));
}

TEST(GBufferLayers, ThePictureMayBeAFileOfItsOwn) {
    const ExrChannels file = fileOf(kChannels);
    const ExrChannels plain = fileOf({{"R", 20}, {"G", 21}, {"B", 22}});
    EXPECT_EQ(must(readLayers(file, plain, mapping())).color[0], glm::vec3(20, 21, 22));
    const ExrChannels wide = fileOf({{"R", 20}, {"G", 21}, {"B", 22}}, 3);
    const auto layers = readLayers(file, wide, mapping());
    ASSERT_FALSE(layers.ok());
    EXPECT_THAT(layers.error().message, HasSubstr("3x1 pixels, but f.exr has 2x1"));
}

/// What is left out without a word is counted twice: the host's reflections and ours.
TEST(GBufferLayers, WhatReflectionsReplaceMayBeInEitherFile) {
    const ExrChannels file = fileOf(kChannels);
    const ExrChannels plain = fileOf({{"R", 20}, {"G", 21}, {"B", 22}});
    GBufferMapping names = mapping();
    names.fallbackSpecular = {{"D", {"C"}}};
    names.reference = {{"", {"D"}}};
    const glm::vec3 c(8, 9, 10), d(2, 3, 4);
    const GBufferLayers beside = must(readLayers(file, plain, names));
    EXPECT_EQ(beside.color[0], glm::vec3(20, 21, 22));
    EXPECT_EQ(beside.fallbackSpecular[0], d * c);
    EXPECT_EQ(beside.reference[0], d);

    // The picture's own file goes first; each sum is taken from one file.
    const ExrChannels lit = fileOf({{"C.R", 1}, {"C.G", 1}, {"C.B", 1}, {"D.R", 5}, {"D.G", 5}, {"D.B", 5}});
    EXPECT_EQ(must(readLayers(file, lit, names)).reference[0], glm::vec3(5));
    const ExrChannels colorAlone = fileOf({{"C.R", 1}, {"C.G", 1}, {"C.B", 1}});
    EXPECT_EQ(must(readLayers(file, colorAlone, names)).reference[0], d);
    EXPECT_EQ(must(readLayers(file, colorAlone, names)).fallbackSpecular[0], d * c);
}

TEST(GBufferLayers, WhatReflectionsReplaceIsMissedWhereNoFileHasIt) {
    const ExrChannels file = fileOf(kChannels);
    const ExrChannels plain = fileOf({{"R", 20}, {"G", 21}, {"B", 22}});
    GBufferMapping names = mapping();
    names.fallbackSpecular = {{"", {"Gloss"}}};
    const auto layers = readLayers(file, plain, names);
    ASSERT_FALSE(layers.ok());
    EXPECT_THAT(layers.error().message, HasSubstr("f.exr: fallbackSpecular: no layer is called Gloss"));
    names.optional = {"fallbackSpecular"};
    EXPECT_THAT(must(readLayers(file, plain, names)).notes, ElementsAre(HasSubstr("no layer is called Gloss")));
}

} // namespace gbuffer_layers_test
} // namespace glint::scene
