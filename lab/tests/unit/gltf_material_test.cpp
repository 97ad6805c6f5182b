// Materials, their extensions, textures and samplers.
#include "lab/tests/support/assets.hpp"
#include "lab/tests/support/gltf_builder.hpp"
#include "lab/tests/support/png_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace glint::test {
namespace gltf_material_test {

using scene::AlphaMode;
using scene::Material;
using testing::HasSubstr;

Material readMaterial(const Json& material) {
    GltfBuilder builder;
    builder.json["textures"] = Json::array({Json::object(), Json::object()});
    builder.json["materials"] = Json::array({material});
    const auto scene = builder.read();
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? scene->materials[0] : Material();
}

std::string materialError(const Json& material) {
    GltfBuilder builder;
    builder.json["materials"] = Json::array({material});
    return builder.readError();
}

Material readExtension(const std::string& name, const Json& extension) {
    return readMaterial({{"extensions", {{name, extension}}}});
}

TEST(GltfMaterial, ExtrasMayNamePlanarMirrors) {
    EXPECT_FALSE(readMaterial(Json::object()).planarMirror);
    for (const bool wanted : {true, false})
        EXPECT_EQ(readMaterial({{"extras", {{"glint", {{"planar", wanted}}}}}}).planarMirror, wanted);
    for (const Json& extras :
         {Json("words"), Json(3), Json::array({1}), Json{{"glint", 7}}, Json{{"other", {{"planar", true}}}}})
        EXPECT_FALSE(readMaterial({{"extras", extras}}).planarMirror) << extras; // somebody else's
    EXPECT_EQ(materialError({{"extras", {{"glint", {{"planar", "yes"}}}}}}),
              "test.glb: materials[0].extras.glint.planar must be true or false");
}

TEST(GltfMaterial, ExtrasNameTheShapeOfRefraction) {
    EXPECT_EQ(readMaterial(Json::object()).refraction, scene::RefractionShape::ByShape);
    const auto read = [](const char* name) {
        return readMaterial({{"extras", {{"glint", {{"refraction", name}}}}}}).refraction;
    };
    EXPECT_EQ(read("none"), scene::RefractionShape::None);
    EXPECT_EQ(read("sphere"), scene::RefractionShape::Sphere);
    EXPECT_EQ(read("plane"), scene::RefractionShape::Plane);
    EXPECT_EQ(read("thin"), scene::RefractionShape::Thin);
    EXPECT_EQ(
        materialError({{"extras", {{"glint", {{"refraction", "box"}}}}}}),
        "test.glb: materials[0].extras.glint.refraction is \"box\", which is none of none, sphere, plane and thin");
}

TEST(GltfMaterial, DefaultsAreTheSpecifications) {
    const Material material = readMaterial(Json::object());
    EXPECT_EQ(material.alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(material.alphaCutoff, 0.5f);
    EXPECT_EQ(material.baseColorFactor, glm::vec4(1));
    EXPECT_EQ(material.metallicFactor, 1);
    EXPECT_EQ(material.roughnessFactor, 1);
    EXPECT_EQ(material.emissiveFactor, glm::vec3(0));
    EXPECT_EQ(material.ior, 1.5f);
    EXPECT_EQ(material.specularFactor, 1);
    EXPECT_TRUE(std::isinf(material.attenuationDistance));
    EXPECT_EQ(material.baseColorTexture.texture, -1);
    EXPECT_FALSE(material.unlit || material.doubleSided || material.specularGlossiness);
}

TEST(GltfMaterial, Core) {
    const Material material = readMaterial(Json::parse(R"({
        "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true, "emissiveFactor": [0.5, 0, 1],
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0, "roughnessFactor": 0.5,
                                 "baseColorTexture": {"index": 1, "texCoord": 1}},
        "normalTexture": {"index": 0, "scale": -2}, "occlusionTexture": {"index": 0, "strength": 0.75}})"));
    EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(material.alphaCutoff, 0.25f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.emissiveFactor, glm::vec3(0.5f, 0, 1));
    EXPECT_EQ(material.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.baseColorTexture.texture, 1);
    EXPECT_EQ(material.baseColorTexture.texCoord, 1u);
    EXPECT_EQ(material.normalScale, -2);
    EXPECT_EQ(material.occlusionStrength, 0.75f);
    EXPECT_EQ(readMaterial({{"alphaMode", "BLEND"}}).alphaMode, AlphaMode::Blend);
}

TEST(GltfMaterial, FactorsAreMovedIntoTheirRange) {
    const Material material =
        readMaterial({{"pbrMetallicRoughness", {{"roughnessFactor", 1.0000001}, {"metallicFactor", -1}}}});
    EXPECT_EQ(material.roughnessFactor, 1);
    EXPECT_EQ(material.metallicFactor, 0);
}

TEST(GltfMaterial, Mistakes) {
    EXPECT_THAT(materialError({{"alphaMode", "GLASS"}}), HasSubstr("materials[0].alphaMode is \"GLASS\""));
    EXPECT_EQ(materialError({{"normalTexture", {{"index", 0}}}}),
              "test.glb: materials[0].normalTexture.index is 0 but the file has 0 textures");
    EXPECT_EQ(materialError({{"normalTexture", Json::object()}}),
              "test.glb: materials[0].normalTexture.index is missing");
    EXPECT_EQ(materialError({{"emissiveFactor", {1, 2}}}), "test.glb: materials[0].emissiveFactor must be 3 numbers");
    EXPECT_EQ(materialError({{"alphaCutoff", "0.5"}}),
              "test.glb: materials[0].alphaCutoff must be a number within the range of a float");
    EXPECT_EQ(materialError({{"alphaCutoff", 1e60}}),
              "test.glb: materials[0].alphaCutoff must be a number within the range of a float");
    EXPECT_EQ(materialError({{"doubleSided", 1}}), "test.glb: materials[0].doubleSided must be true or false");
}

TEST(GltfMaterial, Extensions) {
    EXPECT_TRUE(readExtension("KHR_materials_unlit", Json::object()).unlit);
    EXPECT_EQ(readExtension("KHR_materials_ior", {{"ior", 1.33}}).ior, 1.33f);
    EXPECT_EQ(readExtension("KHR_materials_ior", {{"ior", 0}}).ior, 0);

    const Material specular = readExtension(
        "KHR_materials_specular",
        {{"specularFactor", 0.5}, {"specularColorFactor", {2, 1, 0}}, {"specularColorTexture", {{"index", 1}}}});
    EXPECT_EQ(specular.specularFactor, 0.5f);
    EXPECT_EQ(specular.specularColorFactor, glm::vec3(2, 1, 0));
    EXPECT_EQ(specular.specularColorTexture.texture, 1);

    EXPECT_EQ(readExtension("KHR_materials_transmission", {{"transmissionFactor", 0.75}}).transmissionFactor, 0.75f);
    EXPECT_EQ(readExtension("KHR_materials_dispersion", {{"dispersion", 0.36}}).dispersion, 0.36f);
    EXPECT_EQ(readExtension("KHR_materials_ior", {{"ior", 1.33}}).dispersion, 0);
    const Material volume =
        readExtension("KHR_materials_volume",
                      {{"thicknessFactor", 2}, {"attenuationDistance", 3}, {"attenuationColor", {0.5, 1, 1}}});
    EXPECT_EQ(volume.thicknessFactor, 2);
    EXPECT_EQ(volume.attenuationDistance, 3);
    EXPECT_EQ(volume.attenuationColor, glm::vec3(0.5f, 1, 1));

    const Material clearcoat =
        readExtension("KHR_materials_clearcoat", {{"clearcoatFactor", 1},
                                                  {"clearcoatRoughnessFactor", 0.25},
                                                  {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.5}}}});
    EXPECT_EQ(clearcoat.clearcoatFactor, 1);
    EXPECT_EQ(clearcoat.clearcoatRoughnessFactor, 0.25f);
    EXPECT_EQ(clearcoat.clearcoatNormalTexture.texture, 0);
    EXPECT_EQ(clearcoat.clearcoatNormalScale, 0.5f);

    const Material old = readExtension("KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {1, 0, 0, 1}},
                                                                               {"specularFactor", {0, 1, 0}},
                                                                               {"glossinessFactor", 0.5},
                                                                               {"diffuseTexture", {{"index", 1}}}});
    EXPECT_TRUE(old.specularGlossiness);
    EXPECT_EQ(old.baseColorFactor, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(old.baseColorTexture.texture, 1);
    EXPECT_EQ(old.specularGlossinessFactor, glm::vec3(0, 1, 0));
    EXPECT_EQ(old.glossinessFactor, 0.5f);

    const Material bright =
        readMaterial({{"emissiveFactor", {1, 0.5, 0}},
                      {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 10}}}}}});
    EXPECT_EQ(bright.emissiveFactor, glm::vec3(10, 5, 0));
}

glm::vec2 transformed(const Json& transform, const glm::vec2& uv) {
    const Material material =
        readMaterial({{"normalTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}});
    return glm::vec2(material.normalTexture.uvTransform * glm::vec3(uv, 1));
}

void expectNear(const glm::vec2& actual, const glm::vec2& expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-6);
    EXPECT_NEAR(actual.y, expected.y, 1e-6);
}

TEST(GltfTextureTransform, ByHand) {
    expectNear(transformed(Json::object(), {0.25f, 0.5f}), {0.25f, 0.5f});
    expectNear(transformed({{"offset", {0.5, -1}}}, {0.25f, 0.5f}), {0.75f, -0.5f});
    expectNear(transformed({{"scale", {2, 3}}}, {0.25f, 0.5f}), {0.5f, 1.5f});
    // A quarter turn: counter-clockwise in the picture, where v points down.
    expectNear(transformed({{"rotation", std::acos(0.0)}}, {1, 0}), {0, -1});
    expectNear(transformed({{"rotation", std::acos(0.0)}}, {0, 1}), {1, 0});
    // Scaled, then turned, then moved: (1, 0) -> (2, 0) -> (0, -2) -> (0.5, -1.5).
    expectNear(transformed({{"scale", {2, 3}}, {"rotation", std::acos(0.0)}, {"offset", {0.5, 0.5}}}, {1, 0}),
               {0.5f, -1.5f});
}

TEST(GltfTextureTransform, TexCoordIsOverridden) {
    const Json transform = {{"texCoord", 1}};
    const Material material = readMaterial(
        {{"normalTexture", {{"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}});
    EXPECT_EQ(material.normalTexture.texCoord, 1u);
}

TEST(GltfTextureTransform, AgreesWithTheMarkersOfTheTestModel) {
    // In Khronos' TextureTransformTest the arrow's tip lies at 45 degrees in the picture and must appear at the green
    // marker, a node of the model.
    GLINT_NEED_ASSET(path, "models/TextureTransformTest/glTF/TextureTransformTest.gltf");
    const auto scene = scene::readGltf(path);
    ASSERT_TRUE(scene);
    const auto nodeNamed = [&](const std::string& name) -> const scene::Node& {
        for (const scene::Node& node : scene->nodes)
            if (node.name == name)
                return node;
        ADD_FAILURE() << name;
        return scene->nodes[0];
    };
    const scene::Node& marker = nodeNamed("Rotation - Correct");
    const glm::vec2 markerUV(marker.translation.x + 0.5f, 0.5f - marker.translation.y);
    for (const Material& material : scene->materials) {
        if (material.name != "Rotation")
            continue;
        const glm::vec2 source = glm::vec2(material.baseColorTexture.uvTransform * glm::vec3(markerUV, 1));
        EXPECT_NEAR(source.x, source.y, 1e-4);
    }
}

TEST(GltfTextures, SamplersAndSharedImages) {
    GltfBuilder builder;
    const int view = builder.addView(pngFile(1, 1, 8, 2, {0, 1, 2, 3}));
    builder.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    builder.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9985}, {"wrapS", 33071}, {"wrapT", 33648}},
                                Json::object()};
    builder.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 0}, {"sampler", 1}}, {{"source", 0}}};
    const auto scene = builder.read();
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->images.size(), 1u);
    const scene::Sampler& sampler = scene->textures[0].sampler;
    EXPECT_EQ(sampler.magFilter, scene::Filter::Nearest);
    EXPECT_EQ(sampler.minFilter, scene::Filter::Linear);
    EXPECT_EQ(sampler.mipFilter, scene::MipFilter::Nearest);
    EXPECT_EQ(sampler.wrapU, scene::Wrap::ClampToEdge);
    EXPECT_EQ(sampler.wrapV, scene::Wrap::MirroredRepeat);
    EXPECT_EQ(scene->textures[1].sampler, scene::Sampler());
    EXPECT_EQ(scene->textures[2].image, 0);
    builder.json["samplers"][0]["wrapS"] = 1;
    EXPECT_THAT(builder.readError(), HasSubstr("samplers[0].wrapS is 1"));
}

TEST(GltfTextures, WebPIsPreferredAndBasisuIsWhite) {
    GltfBuilder builder;
    const int bad = builder.addView<uint8_t>({1, 2, 3});
    const int good = builder.addView(pngFile(1, 1, 8, 2, {0, 1, 2, 3}));
    builder.json["images"] = {{{"bufferView", bad}}, {{"bufferView", good}}};
    builder.json["extensionsRequired"] = {"KHR_texture_basisu", "EXT_texture_webp"};
    builder.json["textures"] = {{{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}},
                                {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
    const auto scene = builder.read();
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->textures[0].image, 0);
    EXPECT_EQ(scene->textures[1].image, -1);
}

TEST(GltfTextures, UnusedImagesAreNotDecoded) {
    GltfBuilder builder;
    builder.json["images"] = {{{"bufferView", builder.addView<uint8_t>({1, 2, 3})}}};
    EXPECT_EQ(builder.readError(), "read without error");
    builder.json["textures"] = {{{"source", 0}}};
    EXPECT_EQ(builder.readError(), "test.glb: images[0]: is no PNG, JPEG or WebP image");
}

} // namespace gltf_material_test
} // namespace glint::test
