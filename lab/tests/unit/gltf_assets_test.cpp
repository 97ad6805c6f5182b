// The Khronos sample models: all of them are read, and variants of one model are the same surface.
#include "lab/scene/gltf/gltf.hpp"
#include "lab/scene/pose.hpp"
#include "lab/tests/support/assets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace gltf_assets_test {

namespace fs = std::filesystem;
using scene::Geometry;
using scene::Pose;
using scene::Scene;

std::vector<std::string> allModels() {
    std::vector<std::string> models;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(assetsFolder(), error))
        if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
            models.push_back(entry.path().string());
    std::sort(models.begin(), models.end());
    return models;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What the renderer relies on.
void expectSound(const Geometry& geometry) {
    const size_t vertices = geometry.positions.size();
    for (const uint32_t index : geometry.indices)
        ASSERT_LT(index, vertices);
    ASSERT_TRUE(geometry.normals.empty() || geometry.normals.size() == vertices);
    ASSERT_TRUE(geometry.tangents.empty() || geometry.tangents.size() == vertices);
    for (size_t i = 0; i < vertices; ++i)
        ASSERT_TRUE(isFinite(geometry.positions[i]));
    for (const glm::vec3& normal : geometry.normals)
        ASSERT_NEAR(glm::length(normal), 1, 1e-4);
    for (const glm::vec4& tangent : geometry.tangents) {
        ASSERT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-4);
        ASSERT_EQ(std::abs(tangent.w), 1);
    }
}

TEST(SampleModels, AllAreReadButTheOneThatCannotBe) {
    GLINT_NEED_ASSET(folder, "models");
    size_t read = 0;
    for (const std::string& model : allModels()) {
        const auto scene = scene::readGltf(model);
        if (fs::path(model).filename() == "IridescenceSuzanne.glb") {
            ASSERT_FALSE(scene);
            EXPECT_EQ(scene.error().code, ErrorCode::Unsupported);
            EXPECT_EQ(scene.error().message,
                      "IridescenceSuzanne.glb: requires KHR_materials_iridescence, which Glint does not support");
            continue;
        }
        ASSERT_TRUE(scene) << model << ": " << scene.error().message;
        for (const double time : {0.0, 0.7}) {
            const auto pose = scene::pose(*scene, time);
            ASSERT_TRUE(pose) << model;
            EXPECT_FALSE(pose->items.empty()) << model;
            EXPECT_FALSE(pose->boundsWS.empty()) << model;
            for (const scene::DrawItem& item : pose->items)
                if (time == 0 || item.geometry->positions.size() < 20000)
                    expectSound(*item.geometry);
            ASSERT_FALSE(testing::Test::HasFatalFailure()) << model;
        }
        ++read;
    }
    EXPECT_GE(read, 60u);
}

/// Sums over a surface that tell shapes, normals and texture coordinates apart, whatever the order of its vertices.
struct Surface {
    size_t triangles = 0;
    double area = 0;
    double volume = 0; ///< signed
    double facing = 0; ///< area where vertex normals agree with the triangles
    glm::dvec2 uv = glm::dvec2(0);
};

Surface measure(const Scene& scene, double time) {
    const auto pose = scene::pose(scene, time);
    EXPECT_TRUE(pose);
    Surface sum;
    for (const scene::DrawItem& item : pose->items) {
        const Geometry& geometry = *item.geometry;
        const glm::mat3 normalToWorld = glm::transpose(glm::inverse(glm::mat3(item.localToWorld)));
        glm::mat3 uvTransform(1);
        if (item.material >= 0)
            uvTransform = scene.materials[size_t(item.material)].baseColorTexture.uvTransform;
        for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
            glm::dvec3 p[3], n(0);
            glm::dvec2 uv(0);
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t index = geometry.indices[i + k];
                p[k] = glm::dvec3(item.localToWorld * glm::vec4(geometry.positions[index], 1));
                n += glm::dvec3(glm::normalize(normalToWorld * geometry.normals[index])) / 3.0;
                if (!geometry.uvs[0].empty())
                    uv += glm::dvec2(uvTransform * glm::vec3(geometry.uvs[0][index], 1)) / 3.0;
            }
            const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]) / 2.0;
            sum.area += glm::length(cross);
            sum.volume += glm::dot(p[0], cross) / 3.0;
            sum.facing += glm::dot(cross, n);
            sum.uv += uv * glm::length(cross);
            ++sum.triangles;
        }
    }
    return sum;
}

struct Variants {
    const char* plain;
    const char* other;
    double tolerance; ///< of the sums, relative to the area: what quantization may lose
};

std::ostream& operator<<(std::ostream& out, const Variants& variants) {
    return out << variants.other;
}

class SameSurface : public testing::TestWithParam<Variants> {};

TEST_P(SameSurface, AtSeveralTimes) {
    GLINT_NEED_ASSET(plainPath, GetParam().plain);
    GLINT_NEED_ASSET(otherPath, GetParam().other);
    const auto plainScene = scene::readGltf(plainPath);
    const auto otherScene = scene::readGltf(otherPath);
    ASSERT_TRUE(plainScene);
    ASSERT_TRUE(otherScene);
    for (const double time : {0.0, 0.3, 1.1, 2.0}) {
        const Surface plain = measure(*plainScene, time);
        const Surface other = measure(*otherScene, time);
        const double tolerance = GetParam().tolerance * plain.area;
        EXPECT_EQ(other.triangles, plain.triangles);
        EXPECT_NEAR(other.area, plain.area, tolerance);
        EXPECT_NEAR(other.volume, plain.volume, tolerance);
        EXPECT_NEAR(other.facing, plain.facing, tolerance);
        EXPECT_NEAR(other.uv.x, plain.uv.x, tolerance);
        EXPECT_NEAR(other.uv.y, plain.uv.y, tolerance);
        if (plainScene->animations.empty())
            break;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Models, SameSurface,
    testing::Values(Variants{"models/Suzanne/glTF/Suzanne.gltf", "models/Suzanne/glTF-Draco/Suzanne.glb", 2e-3},
                    Variants{"models/Suzanne/glTF/Suzanne.gltf", "models/Suzanne/glTF-Quantized/Suzanne.glb", 2e-3},
                    Variants{"models/Suzanne/glTF/Suzanne.gltf", "models/Suzanne/glTF-Meshopt/Suzanne.glb", 2e-3},
                    Variants{"models/Box/glTF-Binary/Box.glb", "models/Box/glTF-Draco/Box.gltf", 1e-3},
                    Variants{"models/Box/glTF-Binary/Box.glb", "models/Box/glTF-Embedded/Box.gltf", 1e-6},
                    Variants{"models/Box/glTF-Binary/Box.glb", "models/BoxInterleaved/glTF-Binary/BoxInterleaved.glb",
                             1e-6},
                    Variants{"models/MorphPrimitivesTest/glTF-Binary/MorphPrimitivesTest.glb",
                             "models/MorphPrimitivesTest/glTF-Draco/MorphPrimitivesTest.gltf", 2e-3},
                    Variants{"models/AnimatedMorphCube/glTF-Binary/AnimatedMorphCube.glb",
                             "models/AnimatedMorphCube/glTF-Quantized/AnimatedMorphCube.gltf", 2e-3}));

/// Simplification dropped triangles without area, so only the area and the extent can be compared.
TEST(SampleModels, MeshoptSpheresHaveTheSameExtent) {
    GLINT_NEED_ASSET(plainPath, "models/MetalRoughSpheresNoTextures/glTF-Binary/MetalRoughSpheresNoTextures.glb");
    GLINT_NEED_ASSET(otherPath, "models/MetalRoughSpheresNoTextures/glTF-Meshopt/MetalRoughSpheresNoTextures.glb");
    const auto plain = scene::readGltf(plainPath);
    const auto other = scene::readGltf(otherPath);
    ASSERT_TRUE(plain && other);
    EXPECT_EQ(other->materials.size(), plain->materials.size());
    const scene::Bounds a = scene::pose(*plain, 0)->boundsWS;
    const scene::Bounds b = scene::pose(*other, 0)->boundsWS;
    const float tolerance = 2e-3f * glm::distance(a.min, a.max);
    EXPECT_NEAR(glm::distance(a.min, b.min), 0, tolerance);
    EXPECT_NEAR(glm::distance(a.max, b.max), 0, tolerance);
}

TEST(SampleModels, CamerasAndLightsAreFound) {
    GLINT_NEED_ASSET(cameras, "models/Cameras/glTF/Cameras.gltf");
    const auto scene = scene::readGltf(cameras);
    ASSERT_TRUE(scene);
    const auto pose = scene::pose(*scene, 0);
    ASSERT_EQ(pose->cameras.size(), 2u);
    EXPECT_FALSE(pose->cameras[0].orthographic);
    EXPECT_TRUE(pose->cameras[1].orthographic);
    EXPECT_NEAR(pose->cameras[0].viewToWorld[3].z, 3, 1e-6);

    GLINT_NEED_ASSET(lamp, "models/LightsPunctualLamp/glTF/LightsPunctualLamp.gltf");
    const auto lights = scene::readGltf(lamp);
    ASSERT_TRUE(lights);
    EXPECT_EQ(scene::pose(*lights, 0)->lights.size(), 5u);
}

TEST(SampleModels, InstancesAndScenes) {
    GLINT_NEED_ASSET(instancing, "models/SimpleInstancing/glTF-Binary/SimpleInstancing.glb");
    EXPECT_EQ(scene::pose(*scene::readGltf(instancing), 0)->items.size(), 125u);
    GLINT_NEED_ASSET(several, "models/MultipleScenes/glTF-Embedded/MultipleScenes.gltf");
    const auto scene = scene::readGltf(several);
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->scenes.size(), 2u);
    EXPECT_NE(scene::pose(*scene, 0, 0)->items[0].node, scene::pose(*scene, 0, 1)->items[0].node);
}

} // namespace gltf_assets_test
} // namespace glint::test
