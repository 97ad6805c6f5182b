// Mapping files: what is read from them, and what is said of those that are wrong.
#include "lab/gbuffer_files/gbuffer_mapping.hpp"

#include "tests/support/must.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::scene {
namespace gbuffer_mapping_test {

using test::must;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view kLeast = R"({"depth": "Z", "normal": "N", "roughness": 0.5, "color": "C"})";

TEST(GBufferMapping, PresetsAreMappingFiles) {
    EXPECT_THAT(mappingPresets(), ElementsAre("blender", "glint"));
    for (const std::string_view name : mappingPresets())
        EXPECT_TRUE(readMapping(std::string(name)).ok()) << name;
    const GBufferMapping blender = must(readMapping("blender"));
    EXPECT_EQ(blender.meaning.axes, StoredAxes::ZUp);
    EXPECT_EQ(blender.fallbackSpecular.at(0).times, "GlossCol");
    EXPECT_THAT(blender.fallbackSpecular.at(0).sum, ElementsAre("GlossDir", "GlossInd"));
}

TEST(GBufferMapping, TheLeastIsFourKeys) {
    const GBufferMapping mapping = must(parseMapping(kLeast, "m.json"));
    EXPECT_EQ(mapping.depth, "Z");
    EXPECT_EQ(mapping.normal, "N");
    EXPECT_EQ(mapping.roughness.constant, 0.5f);
    EXPECT_EQ(mapping.color.at(0).sum.at(0), "C");
    EXPECT_EQ(mapping.meaning.depth, StoredDepth::ViewZ);
    EXPECT_EQ(mapping.meaning.axes, StoredAxes::YUp);
    EXPECT_EQ(mapping.meaning.normalSpace, StoredSpace::World);
}

TEST(GBufferMapping, EveryKeyIsRead) {
    const GBufferMapping mapping = must(parseMapping(
        R"({"description": "all", "axes": "zUp", "metres": 0.01, "rowsFromBottom": true,
            "depth": {"layer": "D", "is": "distance", "background": 1000}, "position": "P", "coverage": "A",
            "normal": {"layer": "N", "space": "view", "unorm": true, "inward": true},
            "smoothness": "S", "f0": "F", "metallic": "M", "baseColor": "B", "ior": 1.33,
            "motion": {"layer": "V", "unit": "pixels", "scale": [1, -0.5]},
            "color": ["C1", {"times": "C2", "sum": ["C3", "C4"]}], "fallbackSpecular": "G", "reference": "R",
            "optional": ["metallic"]})",
        "m.json"));
    EXPECT_EQ(mapping.meaning.axes, StoredAxes::ZUp);
    EXPECT_FLOAT_EQ(mapping.meaning.metres, 0.01f);
    EXPECT_TRUE(mapping.meaning.rowsFromBottom);
    EXPECT_EQ(mapping.depth, "D");
    EXPECT_EQ(mapping.meaning.depth, StoredDepth::Distance);
    EXPECT_EQ(mapping.background, 1000);
    EXPECT_EQ(mapping.position, "P");
    EXPECT_EQ(mapping.coverage, "A");
    EXPECT_EQ(mapping.meaning.normalSpace, StoredSpace::View);
    EXPECT_TRUE(mapping.meaning.normalUnorm && mapping.meaning.normalInward && mapping.smoothness);
    EXPECT_EQ(mapping.roughness.layer, "S");
    EXPECT_EQ(mapping.f0, "F");
    EXPECT_EQ(mapping.metallic.layer, "M");
    EXPECT_EQ(mapping.baseColor, "B");
    EXPECT_FLOAT_EQ(mapping.ior.constant, 1.33f);
    EXPECT_EQ(mapping.motion, "V");
    EXPECT_TRUE(mapping.motionInPixels);
    EXPECT_EQ(mapping.motionScale, glm::vec2(1, -0.5f));
    ASSERT_EQ(mapping.color.size(), 2u);
    EXPECT_EQ(mapping.color[1].times, "C2");
    EXPECT_THAT(mapping.color[1].sum, ElementsAre("C3", "C4"));
    EXPECT_EQ(mapping.fallbackSpecular.size(), 1u);
    EXPECT_EQ(mapping.reference.size(), 1u);
    EXPECT_THAT(mapping.optional, ElementsAre("metallic"));
}

TEST(GBufferMapping, MistakesAreNamedByTheirKey) {
    const std::pair<std::string_view, std::string_view> cases[] = {
        {"", "m.json"},
        {"[1]", "the JSON is not an object"},
        {R"({"depth": )", "m.json: parse error at line 1"},
        {R"({"dept": "Z"})", "dept is not a key of mapping files; did you mean 'depth'?"},
        {R"({"depth": 3})", "depth must be the name of a layer"},
        {R"({"depth": {"is": "viewZ"}})", "depth.layer is missing"},
        {R"({"depth": {"layer": "Z", "is": "far"}})", "depth.is must be viewZ, negativeViewZ"},
        {R"({"depth": {"layer": "Z", "kind": "viewZ"}})", "depth.kind is unknown"},
        {R"({"depth": {"layer": "Z", "background": -1}})", "depth.background must be a number"},
        {R"({"axes": "up"})", "axes must be yUp or zUp"},
        {R"({"metres": 0})", "metres must be a number"},
        {R"({"rowsFromBottom": 1})", "rowsFromBottom must be true or false"},
        {R"({"normal": {"layer": "N", "space": "tangent"}})", "normal.space must be world or view"},
        {R"({"roughness": 2})", "roughness must be a number from 0 to 1"},
        {R"({"roughness": 0.5, "smoothness": 0.5})", "is given twice"},
        {R"({"ior": 0.5})", "ior must be a number from 1"},
        {R"({"motion": {"layer": "V", "unit": "metres"}})", "motion.unit must be uv or pixels"},
        {R"({"motion": {"layer": "V", "scale": 2}})", "motion.scale must be two numbers"},
        {R"({"motion": {"layer": "V", "scale": [1, "x"]}})", "motion.scale must be a number"},
        {R"({"color": []})", "color must have 1 to"},
        {R"({"color": {"times": "A"}})", "color.sum must be a list"},
        {R"({"color": {"plus": "A", "sum": ["B"]}})", "color.plus is unknown"},
        {R"({"optional": ["depth"]})", "optional must be position"},
        {R"({"normal": "N", "roughness": 1, "color": "C"})", "depth is missing"},
        {R"({"depth": "Z", "roughness": 1, "color": "C"})", "normal is missing"},
        {R"({"depth": "Z", "normal": "N", "color": "C"})", "roughness is missing"},
        {R"({"depth": "Z", "normal": "N", "roughness": 1})", "color is missing"},
    };
    for (const auto& [text, part] : cases) {
        const auto mapping = parseMapping(text, "m.json");
        ASSERT_FALSE(mapping.ok()) << text;
        EXPECT_EQ(mapping.error().code, ErrorCode::InvalidInput);
        EXPECT_THAT(mapping.error().message, testing::StartsWith("m.json"));
        EXPECT_THAT(mapping.error().message, HasSubstr(std::string(part))) << text;
        EXPECT_EQ(mapping.error().message.find('\n'), std::string::npos);
    }
}

TEST(GBufferMapping, AnUnknownFileListsThePresets) {
    const auto mapping = readMapping("no/such/file.json");
    ASSERT_FALSE(mapping.ok());
    EXPECT_EQ(mapping.error().code, ErrorCode::NotFound);
    EXPECT_THAT(mapping.error().message, HasSubstr("blender and glint"));
}

} // namespace gbuffer_mapping_test
} // namespace glint::scene
