// The materials as the viewer's panel changes them.
#include "lab/view/command_line.hpp"
#include "lab/view/materials_model.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace glint::view {
namespace materials_model_test {

using scene::FieldValue;
using scene::MaterialKind;
using test::must;
using testing::HasSubstr;
using testing::Not;

size_t fieldOf(std::string_view name, MaterialKind kind = MaterialKind::MetallicRoughness) {
    const auto fields = scene::materialFields();
    const auto found = std::ranges::find_if(fields, [&](const scene::MaterialField& field) {
        return field.name == name && (field.kinds & scene::kindBit(kind)) != 0;
    });
    return static_cast<size_t>(found - fields.begin());
}

class MaterialsModelTest : public testing::Test {
protected:
    static MaterialsModel open(const std::string& materials = "none") {
        render::RenderJob job;
        job.scene = "builtin:mirror";
        job.materials = materials;
        return {must(render::loadJobInputs(job)), "mirror.materials.json"};
    }

    const test::TempFolder temp_;
    MaterialsModel model_ = open();
    const size_t roughness_ = fieldOf("roughness");
};

TEST_F(MaterialsModelTest, ValuesAreTheFilesUntilTheyAreSet) {
    EXPECT_EQ(model_.name(0), "floor mirror");
    EXPECT_EQ(model_.value(0, roughness_).x, 0);
    EXPECT_FALSE(model_.changed(0, roughness_));
    model_.set(0, roughness_, FieldValue(0.5f));
    EXPECT_EQ(model_.value(0, roughness_).x, 0.5f);
    EXPECT_TRUE(model_.changed(0, roughness_));
    EXPECT_TRUE(model_.changed(0));
    EXPECT_FALSE(model_.changed(1));
    EXPECT_TRUE(model_.unsaved());
    const uint64_t version = model_.version();
    model_.reset(0, roughness_);
    EXPECT_NE(model_.version(), version);
    EXPECT_EQ(model_.value(0, roughness_).x, 0);
    EXPECT_TRUE(model_.overrides().empty()) << "nothing is left of it";
}

TEST_F(MaterialsModelTest, AKindHasItsOwnFields) {
    const auto has = [&](std::string_view name, MaterialKind kind) {
        return model_.has(0, scene::materialFields()[fieldOf(name, kind)]);
    };
    EXPECT_TRUE(has("metallic", MaterialKind::MetallicRoughness));
    EXPECT_FALSE(has("specularColor", MaterialKind::Standard));
    model_.setKind(0, MaterialKind::Standard);
    EXPECT_FALSE(has("metallic", MaterialKind::MetallicRoughness));
    EXPECT_TRUE(has("specularColor", MaterialKind::Standard));
    EXPECT_EQ(model_.value(0, fieldOf("specularColor", MaterialKind::Standard)), FieldValue(1));
    model_.setKind(0, MaterialKind::MetallicRoughness);
    EXPECT_TRUE(model_.overrides().empty()) << "the kind of the file";
}

TEST_F(MaterialsModelTest, WhatIsSavedIsReadAgain) {
    model_.setKind(0, MaterialKind::Standard);
    model_.set(1, roughness_, FieldValue(0.1f));
    const std::string file = temp_ + "mine.json";
    must(model_.save(file));
    EXPECT_FALSE(model_.unsaved());
    EXPECT_EQ(model_.savedFile(), file);
    const MaterialsModel again = open(file);
    EXPECT_EQ(again.kind(0), MaterialKind::Standard);
    EXPECT_EQ(again.value(1, roughness_).x, 0.1f);
    EXPECT_EQ(again.version(), 0u);
    EXPECT_FALSE(again.unsaved());
    model_.reset(0);
    EXPECT_FALSE(model_.save(temp_ + "no/such/folder.json"));
    EXPECT_TRUE(model_.unsaved());
}

TEST_F(MaterialsModelTest, TheCommandLineNamesTheFile) {
    ViewerState state(SettingsModel({}, {}));
    state.scene = "builtin:mirror";
    render::RenderJob job;
    job.scene = state.scene;
    EXPECT_THAT(commandLine(state, job, {}), Not(HasSubstr("--materials")));
    job.materials = "some.json";
    EXPECT_THAT(commandLine(state, job, {}), HasSubstr(" --materials some.json "));
    state.materials = model_;
    must(state.materials.save(temp_ + "mine.json"));
    EXPECT_THAT(commandLine(state, job, {}), HasSubstr(" --materials " + (temp_ + "mine.json") + " "));
}

} // namespace materials_model_test
} // namespace glint::view
