// The node tree, cameras, lights, skins, instances, animations: what is read and what is refused.
#include "lab/scene/pose.hpp"
#include "lab/tests/support/gltf_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace glint::test {
namespace gltf_node_test {

using scene::Scene;
using testing::HasSubstr;

std::string errorOf(const std::string& json) {
    GltfBuilder builder;
    builder.json.update(Json::parse(json));
    return builder.readError();
}

Scene read(const GltfBuilder& builder) {
    auto scene = builder.read();
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? std::move(*scene) : Scene();
}

TEST(GltfNodes, TreesThatAreNone) {
    EXPECT_EQ(errorOf(R"({"nodes":[{"children":[0]}]})"), "test.glb: nodes[0] is its own ancestor");
    EXPECT_EQ(errorOf(R"({"nodes":[{"children":[1]},{"children":[2]},{"children":[1]}]})"),
              "test.glb: nodes[1] has two parents, nodes 0 and 2");
    EXPECT_EQ(errorOf(R"({"nodes":[{"children":[1]},{"children":[0]},{}]})"), "test.glb: nodes[0] is its own ancestor");
    EXPECT_EQ(errorOf(R"({"nodes":[{"children":[1,1]},{}]})"), "test.glb: nodes[1] has two parents, nodes 0 and 0");
    EXPECT_THAT(errorOf(R"({"nodes":[{"children":[7]}]})"),
                HasSubstr("nodes[0].children[0] must be a whole number below 1"));
    EXPECT_EQ(errorOf(R"({"nodes":[{"children":[1]},{}],"scenes":[{"nodes":[1]}]})"),
              "test.glb: scenes[0].nodes names node 1, which is a child of node 0; scenes hold root nodes");
    EXPECT_EQ(errorOf(R"({"nodes":[{}],"scenes":[{"nodes":[0,0]}]})"), "test.glb: scenes[0].nodes names a node twice");
    EXPECT_THAT(errorOf(R"({"nodes":[{}],"scenes":[{"nodes":[1]}]})"), HasSubstr("below 1, the file's nodes"));
    EXPECT_THAT(errorOf(R"({"scenes":[{}],"scene":1})"), HasSubstr("scene is 1 but the file has 1 scenes"));
    EXPECT_THAT(errorOf(R"({"nodes":[{"mesh":0}]})"), HasSubstr("nodes[0].mesh is 0 but the file has 0 meshes"));
    EXPECT_THAT(errorOf(R"({"nodes":[{"matrix":[1,2]}]})"), HasSubstr("nodes[0].matrix must be 16 numbers"));
}

TEST(GltfNodes, AChainOfManyNodesIsWalked) {
    GltfBuilder builder;
    constexpr int kNodes = 50000;
    for (int i = 0; i + 1 < kNodes; ++i)
        builder.append("nodes", {{"children", {i + 1}}, {"translation", {0, 0, 1}}});
    builder.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    builder.append("nodes", {{"camera", 0}});
    builder.json["scenes"] = {{{"nodes", {0}}}};
    const Scene scene = read(builder);
    const auto pose = scene::pose(scene, 0);
    ASSERT_TRUE(pose);
    ASSERT_EQ(pose->cameras.size(), 1u);
    EXPECT_EQ(pose->cameras[0].viewToWorld[3].z, kNodes - 1);
}

TEST(GltfNodes, WithoutScenesAllRootsAreShown) {
    GltfBuilder builder;
    builder.json["nodes"] = Json::parse(R"([{"children":[1]},{},{}])");
    const Scene scene = read(builder);
    ASSERT_EQ(scene.scenes.size(), 1u);
    EXPECT_THAT(scene.scenes[0].nodes, testing::ElementsAre(0, 2));
}

TEST(GltfNodes, ScenesAreKeptApart) {
    GltfBuilder builder;
    builder.json["nodes"] = Json::parse(R"([{},{}])");
    builder.json["scenes"] = Json::parse(R"([{"nodes":[0]},{"nodes":[1,0],"name":"both"}])");
    builder.json["scene"] = 1;
    const Scene scene = read(builder);
    EXPECT_EQ(scene.defaultScene, 1);
    EXPECT_EQ(scene.scenes[1].name, "both");
    EXPECT_TRUE(scene::pose(scene, 0, 0));
    EXPECT_EQ(scene::pose(scene, 0, 2).error().message, "test.glb has no scene 2; it has 2");
}

TEST(GltfNodes, RotationsAreNormalized) {
    GltfBuilder builder;
    builder.json["nodes"] = Json::parse(R"([{"rotation":[0,0,0,2]},{"rotation":[0,0,0,0]}])");
    const Scene scene = read(builder);
    EXPECT_EQ(scene.nodes[0].rotation, glm::quat(1, 0, 0, 0));
    EXPECT_EQ(scene.nodes[1].rotation, glm::quat(1, 0, 0, 0));
}

TEST(GltfCameras, BothKinds) {
    GltfBuilder builder;
    builder.json["cameras"] = Json::parse(R"([
        {"name":"eye","type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"aspectRatio":2}},
        {"type":"orthographic","orthographic":{"xmag":4,"ymag":2,"znear":0,"zfar":9}}])");
    const Scene scene = read(builder);
    EXPECT_EQ(scene.cameras[0].name, "eye");
    EXPECT_EQ(scene.cameras[0].fovY, 0.5f);
    EXPECT_EQ(scene.cameras[0].aspectRatio, 2.0f);
    EXPECT_TRUE(std::isinf(scene.cameras[0].far));
    EXPECT_TRUE(scene.cameras[1].orthographic);
    EXPECT_EQ(scene.cameras[1].orthoHeight, 4);
    EXPECT_EQ(scene.cameras[1].aspectRatio, 2.0f);
    EXPECT_EQ(scene.cameras[1].far, 9);
}

TEST(GltfCameras, Mistakes) {
    EXPECT_THAT(errorOf(R"({"cameras":[{"type":"fisheye"}]})"), HasSubstr("cameras[0].type is \"fisheye\""));
    EXPECT_EQ(errorOf(R"({"cameras":[{"type":"perspective","perspective":{"yfov":1}}]})"),
              "test.glb: cameras[0].perspective.znear is missing");
    EXPECT_THAT(errorOf(R"({"cameras":[{"type":"perspective","perspective":{"yfov":4,"znear":1}}]})"),
                HasSubstr("yfov is 4 but must be below pi"));
    EXPECT_THAT(errorOf(R"({"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":2,"zfar":1}}]})"),
                HasSubstr("zfar 1 must be beyond znear 2"));
}

TEST(GltfLights, EveryType) {
    GltfBuilder builder;
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([
        {"type":"directional","intensity":3,"color":[1,0.5,0]},
        {"type":"point","range":7},
        {"type":"spot","spot":{"innerConeAngle":0.25,"outerConeAngle":0.5}},
        {"type":"spot"}])");
    builder.json["nodes"] = Json::parse(
        R"([{"rotation":[0,1,0,0],"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}}])");
    const Scene scene = read(builder);
    EXPECT_EQ(scene.lights[0].intensity, 3);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(scene.lights[1].range, 7);
    EXPECT_EQ(scene.lights[2].innerConeAngle, 0.25f);
    EXPECT_NEAR(scene.lights[3].outerConeAngle, 0.785398, 1e-6);
    const auto pose = scene::pose(scene, 0);
    ASSERT_EQ(pose->lights.size(), 1u);
    EXPECT_EQ(pose->lights[0].positionWS, glm::vec3(1, 2, 3));
    EXPECT_NEAR(pose->lights[0].directionWS.z, 1, 1e-6); // half a turn around Y
    builder.json["extensions"]["KHR_lights_punctual"]["lights"][0]["type"] = "area";
    EXPECT_THAT(builder.readError(), HasSubstr("lights[0].type is \"area\""));
}

/// A triangle bound to two joints, nodes 1 and 2; node 0 draws it.
GltfBuilder skinned() {
    GltfBuilder builder;
    Json& primitive = builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)}});
    Json& attributes = primitive["attributes"];
    attributes["JOINTS_0"] = builder.addAccessor<uint8_t>("VEC4", {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    attributes["WEIGHTS_0"] = builder.addAccessor<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0});
    builder.json["nodes"][0]["skin"] = 0;
    builder.append("nodes", {{"translation", {0, 0, 10}}});
    builder.append("nodes", {{"translation", {0, 20, 0}}});
    builder.json["skins"] = {{{"joints", {1, 2}}}};
    return builder;
}

TEST(GltfSkins, JointsInRange) {
    GltfBuilder builder = skinned();
    EXPECT_EQ(builder.readError(), "read without error");
    builder.json["skins"][0]["joints"] = {1};
    EXPECT_EQ(builder.readError(), "test.glb: nodes[0]: mesh 0 uses joint 1 but skin 0 has 1");
    builder.json["skins"][0]["joints"] = {1, 3};
    EXPECT_THAT(builder.readError(), HasSubstr("skins[0].joints[1] must be a whole number below 3"));
    builder.json["skins"][0]["joints"] = Json::array();
    EXPECT_EQ(builder.readError(), "test.glb: skins[0] has no joints");
}

TEST(GltfSkins, InverseBindMatricesFitTheJoints) {
    GltfBuilder builder = skinned();
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addAccessor("MAT4", std::vector<float>(16, 0.0f));
    EXPECT_THAT(builder.readError(), HasSubstr("has 1 matrices (accessor 3) for 2 joints"));
}

TEST(GltfSkins, KnownVertices) {
    GltfBuilder builder = skinned();
    builder.json["nodes"][0]["translation"] = {100, 100, 100}; // of no effect on a skinned mesh
    std::vector<float> matrices(32, 0.0f);
    for (int i = 0; i < 4; ++i)
        matrices[size_t(i) * 5] = matrices[16 + size_t(i) * 5] = 1;
    matrices[16 + 12] = -1; // joint 1: one metre to the left before all else
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addAccessor("MAT4", matrices);
    const Scene scene = read(builder);
    const auto pose = scene::pose(scene, 0);
    ASSERT_EQ(pose->items.size(), 1u);
    EXPECT_EQ(pose->items[0].localToWorld, glm::mat4(1));
    const auto& positions = pose->items[0].geometry->positions;
    EXPECT_EQ(positions[0], glm::vec3(0, 0, 10));
    EXPECT_EQ(positions[1], glm::vec3(0, 20, 0));
    EXPECT_EQ(positions[2], glm::vec3(-0.5f, 11, 5));
}

TEST(GltfInstancing, TransformsAreComposed) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)}});
    builder.json["nodes"][0]["translation"] = {10, 0, 0};
    const int translations = builder.addAccessor<float>("VEC3", {0, 1, 0, 0, 2, 0});
    const int rotations = builder.addAccessor<int8_t>("VEC4", {0, 0, 0, 127, 0, 0, 90, 90}, true);
    const int scales = builder.addAccessor<float>("VEC3", {1, 1, 1, 2, 2, 2});
    Json& attributes = builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes = {{"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}};
    const Scene scene = read(builder);
    const auto pose = scene::pose(scene, 0);
    ASSERT_EQ(pose->items.size(), 2u);
    EXPECT_EQ(pose->items[0].localToWorld * glm::vec4(1, 0, 0, 1), glm::vec4(11, 1, 0, 1));
    const glm::vec4 turned = pose->items[1].localToWorld * glm::vec4(1, 0, 0, 1); // a quarter around Z, doubled
    EXPECT_NEAR(turned.x, 10, 1e-5);
    EXPECT_NEAR(turned.y, 4, 1e-5);
    attributes["SCALE"] = builder.addAccessor<float>("VEC3", {1, 1, 1});
    EXPECT_THAT(builder.readError(), HasSubstr("accessors have 2 and 1 elements but must agree"));
}

TEST(GltfInstancing, ItemsCountAgainstTheLimit) {
    GltfBuilder builder;
    builder.addMesh({{"POSITION", builder.addAccessor("VEC3", kTriangle)}});
    for (int i = 0; i < 999; ++i)
        builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
    const int translations = builder.addAccessor("VEC3", std::vector<float>(3000, 0.0f));
    builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = translations;
    scene::GltfLimits limits;
    limits.sceneBytes = uint64_t(16) << 20; // a thousand primitives a thousand times would be 128 MB of items
    EXPECT_EQ(builder.readError(limits), "test.glb: nodes[0] takes the scene beyond 16 MiB, the limit");
}

GltfBuilder animated(const Json& sampler = Json::object()) {
    GltfBuilder builder;
    builder.json["nodes"] = Json::parse("[{}]");
    const int times = builder.addAccessor<float>("SCALAR", {1, 2});
    const int values = builder.addAccessor<float>("VEC3", {0, 0, 0, 2, 4, 6});
    Json whole = {{"input", times}, {"output", values}};
    whole.update(sampler);
    builder.json["animations"] = {
        {{"samplers", {whole}}, {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    return builder;
}

TEST(GltfAnimations, AreRead) {
    const Scene scene = read(animated());
    ASSERT_EQ(scene.animations.size(), 1u);
    ASSERT_EQ(scene.animations[0].channels.size(), 1u);
    EXPECT_THAT(scene.animations[0].channels[0].times, testing::ElementsAre(1, 2));
}

TEST(GltfAnimations, Mistakes) {
    EXPECT_EQ(animated({{"interpolation", "CUBICSPLINE"}}).readError(),
              "test.glb: animations[0].samplers[0]: 2 keys (accessor 0) need 18 numbers but accessor 1 has 6");
    EXPECT_THAT(animated({{"interpolation", "SMOOTH"}}).readError(), HasSubstr("interpolation is \"SMOOTH\""));
    EXPECT_THAT(animated({{"input", 9}}).readError(), HasSubstr("samplers[0].input is 9 but the file has 2 accessors"));

    GltfBuilder falling = animated();
    falling.json["animations"][0]["samplers"][0]["input"] = falling.addAccessor<float>("SCALAR", {2, 1});
    EXPECT_EQ(falling.readError(), "test.glb: accessor 2: the times of an animation must rise");

    GltfBuilder infinite = animated();
    infinite.json["animations"][0]["samplers"][0]["input"] =
        infinite.addAccessor<float>("SCALAR", {1, std::numeric_limits<float>::quiet_NaN()});
    EXPECT_THAT(infinite.readError(), HasSubstr("accessor 2: an animation's value is not finite"));

    GltfBuilder noSampler = animated();
    noSampler.json["animations"][0]["channels"][0]["sampler"] = 1;
    EXPECT_THAT(noSampler.readError(), HasSubstr("channels[0].sampler is 1"));
}

TEST(GltfAnimations, ChannelsThatAreLeftOut) {
    for (const char* target :
         {R"({"path":"translation"})", R"({"node":0,"path":"pointer"})", R"({"node":0,"path":"weights"})"}) {
        GltfBuilder builder = animated();
        builder.json["animations"][0]["channels"][0]["target"] = Json::parse(target);
        EXPECT_TRUE(read(builder).animations[0].channels.empty()) << target;
    }
    GltfBuilder builder = animated();
    builder.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_TRUE(read(builder).animations[0].channels.empty());
}

} // namespace gltf_node_test
} // namespace glint::test
