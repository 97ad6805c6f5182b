// Material overrides: what the file says reaches the materials, and every mistake in it is one line.
#include "base/file.hpp"
#include "lab/job/job_inputs.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/scene/material_overrides.hpp"
#include "lab/sources/scene_hash.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace glint::scene {
namespace material_file_test {

using test::must;
using testing::HasSubstr;

class MaterialFileTest : public testing::Test {
protected:
    MaterialFileTest() {
        for (const char* name : {"floor", "glass", "floor", "", "glossy"})
            scene_.materials.emplace_back().name = name;
        scene_.materials[4].specularGlossiness = true;
        scene_.materials[0].emissiveFactor = {1, 2, 3};
    }

    Result<MaterialOverrides> read(std::string_view json) {
        must(writeFile(file_, json));
        return readMaterialFile(file_, scene_);
    }
    /// The materials of the scene as the file changes them.
    std::vector<Material> materials(std::string_view json) {
        MaterialOverrides overrides = must(read(json));
        must(loadTextures(overrides, scene_));
        std::vector<Material> result = scene_.materials;
        for (const auto& [index, override] : overrides)
            result[index] = overridden(result[index], override);
        return result;
    }
    std::string errorOf(std::string_view json) {
        const auto overrides = read(json);
        EXPECT_FALSE(overrides) << json;
        if (overrides)
            return {};
        EXPECT_EQ(overrides.error().code, ErrorCode::InvalidInput);
        EXPECT_EQ(overrides.error().message.find('\n'), std::string::npos);
        EXPECT_THAT(overrides.error().message, testing::StartsWith(file_ + ": "));
        return overrides.error().message.substr(std::min(file_.size() + 2, overrides.error().message.size()));
    }

    const test::TempFolder temp_;
    const std::string file_ = temp_ + "room.glb.materials.json";
    Scene scene_;
};

TEST_F(MaterialFileTest, AnEmptyFileChangesNothing) {
    EXPECT_TRUE(must(read(R"({"description": "nothing yet", "materials": {}})")).empty());
}

TEST_F(MaterialFileTest, NamesSelectEveryMaterialOfThatNameAndAnIndexOne) {
    const auto m = materials(R"({"materials": {"#2": {"roughness": 0.5}, "floor": {"roughness": 0.25, "metallic": 0},
                                               "#3": {"opacity": 0.75}}})");
    EXPECT_EQ(m[0].roughnessFactor, 0.25f);
    EXPECT_EQ(m[2].roughnessFactor, 0.5f) << "an index is stronger than a name";
    EXPECT_EQ(m[2].metallicFactor, 0);
    EXPECT_EQ(m[1].roughnessFactor, 1);
    EXPECT_EQ(m[3].baseColorFactor, glm::vec4(1, 1, 1, 0.75f));
}

TEST_F(MaterialFileTest, FieldsReachTheMaterial) {
    const Material m = materials(R"({"materials": {"glass": {
        "baseColor": [0.1, 0.2, 0.3], "ior": 1.33, "transmission": 1, "thickness": 0.5, "dispersion": 2,
        "attenuationColor": [0.5, 1, 0], "attenuationDistance": 3, "refraction": "thin", "planar": false,
        "emission": [1, 1, 2], "emissionStrength": 4, "specular": 0.5, "specularColor": [1, 0.5, 2],
        "doubleSided": true}}})")[1];
    EXPECT_EQ(m.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 1));
    EXPECT_EQ(m.ior, 1.33f);
    EXPECT_EQ(m.transmissionFactor, 1);
    EXPECT_EQ(m.thicknessFactor, 0.5f);
    EXPECT_EQ(m.dispersion, 2);
    EXPECT_EQ(m.attenuationColor, glm::vec3(0.5f, 1, 0));
    EXPECT_EQ(m.attenuationDistance, 3);
    EXPECT_EQ(m.refraction, RefractionShape::Thin);
    EXPECT_EQ(m.planarMirror, std::optional<bool>(false));
    EXPECT_EQ(m.emissiveFactor, glm::vec3(4, 4, 8));
    EXPECT_EQ(m.specularFactor, 0.5f);
    EXPECT_EQ(m.specularColorFactor, glm::vec3(1, 0.5f, 2));
    EXPECT_TRUE(m.doubleSided);
}

TEST_F(MaterialFileTest, EmissionStrengthAloneScalesTheFilesEmission) {
    EXPECT_EQ(materials(R"({"materials": {"#0": {"emissionStrength": 2}}})")[0].emissiveFactor, glm::vec3(2, 4, 6));
}

TEST_F(MaterialFileTest, NoAttenuationDistanceIsNoAbsorption) {
    const Material m = materials(R"({"materials": {"glass": {"attenuationDistance": 0}}})")[1];
    EXPECT_TRUE(std::isinf(m.attenuationDistance));
}

TEST_F(MaterialFileTest, EveryFieldAndTextureCanBeSetAndIsWrittenBack) {
    for (size_t i = 0; i < materialFields().size(); ++i) {
        const MaterialField& field = materialFields()[i];
        // A value inside the range that no default has.
        const float value = field.type == FieldType::Switch ? 1.0f : field.type == FieldType::Choice ? 2.0f : 0.625f;
        const float inside = std::max(field.min, value);
        MaterialOverride override;
        override.kind = static_cast<MaterialKind>(std::countr_zero(field.kinds));
        override.values[i] = field.type == FieldType::Color ? FieldValue(inside, 0.5f, 0.25f) : FieldValue(inside);
        Material plain;
        setKind(plain, *override.kind);
        if (field.name != "emissionStrength") { // multiplies: it has no value of its own
            EXPECT_EQ(field.get(overridden(plain, override)), override.values[i]) << field.name;
        }
        const MaterialOverrides all = {{0, override}};
        const MaterialOverrides back = must(read(materialFileText(file_, scene_.materials, all)));
        ASSERT_EQ(back.size(), 1u) << field.name;
        EXPECT_EQ(back.at(0).kind, override.kind) << field.name;
        EXPECT_EQ(back.at(0).values, override.values) << field.name;
    }
    for (size_t i = 0; i < materialTextures().size(); ++i) {
        MaterialOverride override;
        override.kind = static_cast<MaterialKind>(std::countr_zero(materialTextures()[i].kinds));
        override.textures[i] = {temp_ + "textures/a.png", -1};
        const std::string text = materialFileText(file_, scene_.materials, {{1, override}});
        EXPECT_THAT(text, HasSubstr("\"textures/a.png\"")) << "relative to the file's own folder";
        EXPECT_EQ(must(read(text)).at(1).textures.at(i).file, temp_ + "textures/a.png");
    }
}

TEST_F(MaterialFileTest, SeveralMaterialsOfOneNameAreWrittenByIndex) {
    MaterialOverrides overrides;
    for (const size_t index : {0, 1, 3})
        overrides[index].values[0] = FieldValue(0.5f);
    overrides[2] = {}; // changes nothing
    const std::string text = materialFileText(file_, scene_.materials, overrides);
    EXPECT_THAT(text, HasSubstr("\"#0\""));
    EXPECT_THAT(text, HasSubstr("\"glass\""));
    EXPECT_THAT(text, HasSubstr("\"#3\""));
    EXPECT_EQ(must(read(text)).size(), 3u);
}

TEST_F(MaterialFileTest, AStandardMaterialIsSharpAndWhiteUnlessToldOtherwise) {
    Material rough;
    rough.roughnessFactor = 0.9f;
    rough.specularGlossinessTexture.texture = 0;
    scene_.materials[1] = rough;
    scene_.materials[1].name = "glass";
    const Material plain = materials(R"({"materials": {"glass": {"kind": "standard"}}})")[1];
    EXPECT_TRUE(plain.specularGlossiness);
    EXPECT_EQ(plain.specularGlossinessFactor, glm::vec3(1));
    EXPECT_EQ(plain.glossinessFactor, 1);
    EXPECT_EQ(plain.specularGlossinessTexture.texture, -1);
    const Material red =
        materials(R"({"materials": {"glass": {"kind": "standard", "specularColor": [0.5, 0, 0]}}})")[1];
    EXPECT_EQ(red.specularGlossinessFactor, glm::vec3(0.5f, 0, 0));
}

TEST_F(MaterialFileTest, TexturesAreReadOnceRelativeToTheFileOrRemoved) {
    const std::vector<uint8_t> rgba = {10, 20, 30, 40};
    must(writePng(temp_ + "specular.png", 1, 1, 4, rgba));
    scene_.materials[2].baseColorTexture.texture = 7;
    const auto m = materials(R"({"materials": {
        "#0": {"kind": "standard", "textures": {"specularColor": "specular.png"}},
        "#1": {"kind": "standard", "textures": {"specularColor": "specular.png"}},
        "#2": {"textures": {"baseColor": null}},
        "#4": {"textures": {"specularGlossiness": "specular.png"}}}})");
    ASSERT_EQ(scene_.images.size(), 2u) << "once without alpha, once with it";
    EXPECT_EQ(m[0].specularGlossinessTexture.texture, m[1].specularGlossinessTexture.texture);
    const auto imageOf = [&](const TextureSlot& slot) {
        return scene_.images[size_t(scene_.textures[size_t(slot.texture)].image)].rgba;
    };
    EXPECT_EQ(imageOf(m[0].specularGlossinessTexture), (std::vector<uint8_t>{10, 20, 30, 255}))
        << "a Standard material has no roughness";
    EXPECT_EQ(imageOf(m[4].specularGlossinessTexture), rgba);
    EXPECT_EQ(m[2].baseColorTexture.texture, -1);
}

TEST_F(MaterialFileTest, ATextureThatIsNotThereOrNoImageIsAnError) {
    MaterialOverrides missing = must(read(R"({"materials": {"glass": {"textures": {"baseColor": "no.png"}}}})"));
    const auto loaded = loadTextures(missing, scene_);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::NotFound);
    EXPECT_THAT(loaded.error().message, HasSubstr("no.png"));
    must(writeFile(temp_ + "text.png", "hello"));
    MaterialOverrides damaged = must(read(R"({"materials": {"glass": {"textures": {"baseColor": "text.png"}}}})"));
    ASSERT_FALSE(loadTextures(damaged, scene_));
    EXPECT_THAT(loadTextures(damaged, scene_).error().message, HasSubstr("text.png"));
}

TEST_F(MaterialFileTest, MistakesAreOneLineWithMaterialAndField) {
    EXPECT_THAT(errorOf("{\"materials\": {"), HasSubstr("line 1"));
    EXPECT_THAT(errorOf("[]"), HasSubstr("object"));
    EXPECT_THAT(errorOf(R"({"floor": {}})"), HasSubstr("floor is unknown"));
    EXPECT_THAT(errorOf(R"({"material": {}})"), HasSubstr("did you mean 'materials'?"));
    EXPECT_THAT(errorOf(R"({"materials": {"glas": {}}})"), HasSubstr("did you mean 'glass'?"));
    EXPECT_THAT(errorOf(R"({"materials": {"#5": {}}})"), HasSubstr("#5 is no material: the scene has 5"));
    EXPECT_THAT(errorOf(R"({"materials": {"glass": 1}})"), HasSubstr("glass must be an object"));
    const auto fieldError = [&](std::string_view field) {
        return errorOf(fmt::format(R"({{"materials": {{"glass": {{{}}}}}}})", field));
    };
    EXPECT_EQ(fieldError(R"("roughnes": 1)"), "glass.roughnes is unknown; did you mean 'roughness'?");
    EXPECT_EQ(fieldError(R"("xyzzy": 1)"), "glass.xyzzy is unknown");
    EXPECT_EQ(fieldError(R"("roughness": 1.5)"), "glass.roughness must be a number from 0 to 1");
    EXPECT_EQ(fieldError(R"("roughness": "1")"), "glass.roughness must be a number from 0 to 1");
    EXPECT_EQ(fieldError(R"("ior": 0.5)"), "glass.ior must be a number from 1 to 100");
    EXPECT_EQ(fieldError(R"("baseColor": [1, 1])"), "glass.baseColor must be three numbers from 0 to 1");
    EXPECT_EQ(fieldError(R"("baseColor": [1, 1, -1])"), "glass.baseColor must be three numbers from 0 to 1");
    EXPECT_EQ(fieldError(R"("planar": 1)"), "glass.planar must be true or false");
    EXPECT_EQ(fieldError(R"("refraction": "ball")"),
              R"(glass.refraction must be "byShape", "none", "sphere", "plane" or "thin")");
    EXPECT_THAT(fieldError(R"("kind": "Standard")"), HasSubstr("glass.kind must be"));
    EXPECT_EQ(fieldError(R"("kind": "standard", "metallic": 1)"),
              "glass.metallic does not exist in a material of kind standard");
    EXPECT_EQ(fieldError(R"("textures": {"bascolor": "a.png"})"),
              "glass.textures.bascolor is unknown; did you mean 'baseColor'?");
    EXPECT_THAT(fieldError(R"("textures": {"baseColor": 3})"), HasSubstr("glass.textures.baseColor must be the path"));
    EXPECT_THAT(fieldError(R"("textures": "a.png")"), HasSubstr("glass.textures must be an object"));
}

/// Every field and texture is in the guide, and nothing else is in its tables.
TEST_F(MaterialFileTest, TheGuideListsEveryField) {
    const std::string guide = must(readFile(GLINT_SOURCE_DIR "/docs/materials.md", 1u << 20));
    for (const MaterialField& field : materialFields())
        EXPECT_THAT(guide, HasSubstr(fmt::format("\n| `{}` |", field.name)));
    for (const MaterialTexture& texture : materialTextures())
        EXPECT_THAT(guide, HasSubstr(fmt::format("\n| `textures.{}` |", texture.name)));
    const size_t begin = guide.find("```json\n") + 8;
    ASSERT_LT(begin, guide.size());
    scene_.materials[0].name = "wet asphalt";
    for (const char* name : {"window", "wall mirror"})
        scene_.materials.emplace_back().name = name;
    const auto example = read(guide.substr(begin, guide.find("```", begin) - begin));
    EXPECT_TRUE(example) << example.error().message;
}

class MaterialJobTest : public testing::Test {
protected:
    static render::RenderJob jobOf(const std::string& materials) {
        render::RenderJob job;
        job.scene = "builtin:mirror";
        job.materials = materials;
        return job;
    }
};

TEST_F(MaterialJobTest, AnOptionNamesTheFileAndANoteSaysSo) {
    const test::TempFolder temp;
    const std::string file = temp + "mine.json";
    must(writeFile(file, R"({"materials": {"floor mirror": {"roughness": 0.5}}})"));
    const render::JobInputs plain = must(render::loadJobInputs(jobOf("")));
    const render::JobInputs changed = must(render::loadJobInputs(jobOf(file)));
    EXPECT_TRUE(plain.notes.empty());
    ASSERT_EQ(changed.notes.size(), 1u);
    EXPECT_THAT(changed.notes[0], HasSubstr("1 of the scene's"));
    EXPECT_EQ(plain.scene->materials[0].roughnessFactor, 0);
    EXPECT_EQ(changed.scene->materials[0].roughnessFactor, 0.5f);
    EXPECT_EQ(changed.fileMaterials[0].roughnessFactor, 0);
    EXPECT_NE(render::sceneHash(*plain.scene, plain.pose), render::sceneHash(*changed.scene, changed.pose))
        << "probes baked before do not fit";
    EXPECT_EQ(render::loadJobInputs(jobOf(temp + "none.json")).error().code, ErrorCode::NotFound);
}

TEST_F(MaterialJobTest, TheFileBesideTheSceneIsTakenUnlessRefused) {
    const test::TempFolder temp;
    render::RenderJob job;
    job.scene = temp + "room.gltf";
    must(writeFile(job.scene, R"({"asset": {"version": "2.0"}, "materials": [{"name": "a"}]})"));
    must(writeFile(job.scene + ".materials.json", R"({"materials": {"a": {"roughness": 0.5}}})"));
    EXPECT_EQ(must(render::loadJobInputs(job)).scene->materials[0].roughnessFactor, 0.5f);
    job.materials = "none";
    EXPECT_EQ(must(render::loadJobInputs(job)).scene->materials[0].roughnessFactor, 1);
    EXPECT_TRUE(must(render::loadJobInputs(job)).notes.empty());
}

TEST_F(MaterialJobTest, MaterialsCanBeSetAgainFromTheFilesOwn) {
    render::JobInputs inputs = must(render::loadJobInputs(jobOf("")));
    scene::MaterialOverrides overrides;
    overrides[0].kind = MaterialKind::Standard;
    render::setMaterials(inputs, overrides);
    EXPECT_TRUE(inputs.scene->materials[0].specularGlossiness);
    render::setMaterials(inputs, {});
    EXPECT_FALSE(inputs.scene->materials[0].specularGlossiness);
    EXPECT_EQ(inputs.scene->materials.size(), inputs.fileMaterials.size());
}

} // namespace material_file_test
} // namespace glint::scene
