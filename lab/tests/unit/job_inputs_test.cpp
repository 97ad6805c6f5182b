// What `SCENE`, `--camera`, `--size` and `--env` stand for.
#include "lab/job/job_inputs.hpp"

#include "base/file.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace glint::render {
namespace job_inputs_test {

TEST(JobInputs, ABuiltinSceneHasItsFirstCameraAndItsEnvironment) {
    const auto inputs = loadJobInputs({.scene = "builtin:exact"});
    ASSERT_TRUE(inputs.ok()) << inputs.error().message;
    EXPECT_EQ(inputs->camera.name, inputs->pose.cameras.front().name);
    EXPECT_EQ(inputs->width, 1280u);
    EXPECT_EQ(inputs->height, 720u);
    EXPECT_EQ(inputs->environment, EnvironmentKind::None);
    EXPECT_FALSE(inputs->pose.items.empty());
}

TEST(JobInputs, CamerasAreFoundByNameIndexOrFile) {
    const std::string name = loadJobInputs({.scene = "builtin:mirror"})->camera.name;
    EXPECT_EQ(loadJobInputs({.scene = "builtin:mirror", .camera = name})->camera.name, name);
    EXPECT_EQ(loadJobInputs({.scene = "builtin:mirror", .camera = "0"})->camera.name, name);

    const test::TempFolder temp;
    const std::string file = temp + "camera.json";
    ASSERT_TRUE(writeFile(file, R"({"position":[0,1,3],"target":[0,0,0],"fovY":50,"width":320,"height":200})").ok());
    const auto fromFile = loadJobInputs({.scene = "builtin:mirror", .camera = file});
    ASSERT_TRUE(fromFile.ok()) << fromFile.error().message;
    EXPECT_EQ(fromFile->width, 320u);
    EXPECT_EQ(fromFile->height, 200u);
    const auto sized = loadJobInputs({.scene = "builtin:mirror", .camera = file, .width = 64, .height = 32});
    EXPECT_EQ(sized->width, 64u); // --size is stronger than the camera's own size
}

TEST(JobInputs, AnUnknownCameraListsThoseOfTheScene) {
    for (const std::string camera : {"99", "front door", "none.json"}) {
        const auto inputs = loadJobInputs({.scene = "builtin:mirror", .camera = camera});
        ASSERT_FALSE(inputs.ok()) << camera;
        EXPECT_EQ(inputs.error().message.substr(0, 10 + camera.size()), "--camera " + camera + ":");
        EXPECT_NE(inputs.error().message.find("0 '"), std::string::npos);
    }
}

TEST(JobInputs, EnvironmentsAreSkyNoneOrAFile) {
    EXPECT_EQ(loadJobInputs({.scene = "builtin:exact", .environment = "sky"})->environment, EnvironmentKind::Sky);
    const test::TempFolder temp;
    const std::string file = temp + "environment.hdr";
    ASSERT_TRUE(writeFile(file, "#?RADIANCE\n\n-Y 1 +X 1\n\x80\x80\x80\x81").ok());
    const auto inputs = loadJobInputs({.scene = "builtin:exact", .environment = file});
    ASSERT_TRUE(inputs.ok()) << inputs.error().message;
    EXPECT_EQ(inputs->environment, EnvironmentKind::Image);
    EXPECT_EQ(inputs->environmentImage.rgb.at(0), glm::vec3(1));
    std::filesystem::remove(file);
    EXPECT_EQ(loadJobInputs({.scene = "builtin:exact", .environment = file}).error().code, ErrorCode::NotFound);
}

TEST(JobInputs, ScenesThatAreNotThereAreErrors) {
    EXPECT_EQ(loadJobInputs({.scene = "builtin:hell"}).error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(loadJobInputs({.scene = "/no/such/scene.glb"}).error().code, ErrorCode::NotFound);
}

} // namespace job_inputs_test
} // namespace glint::render
