// Both ray back ends against Embree on whole scenes: of the rays that start on a surface or in the open, at most one in
// ten thousand may be answered differently (hit against miss, or distance by more than 1e-4 of it).
#include "lab/measure/truth/ray_oracle.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/gltf/gltf.hpp"
#include "lab/tests/support/assets.hpp"
#include "tests/gpu/support/ray_test.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <iostream>
#include <random>
#include <unordered_map>

namespace glint::test {
namespace rays_test {

constexpr size_t kRays = 60000;

/// The pose as a host hands it over: a mesh for each geometry, an instance for each item that the oracle sees.
TestScene rayScene(const scene::Scene& scene, const scene::Pose& pose) {
    TestScene out;
    std::unordered_map<const scene::Geometry*, uint32_t> meshes;
    for (const scene::DrawItem& item : pose.items) {
        const scene::Material material =
            item.material < 0 ? scene::Material{} : scene.materials[static_cast<size_t>(item.material)];
        const bool transmits = material.transmissionFactor > 0 && !material.unlit && !material.specularGlossiness;
        if (item.geometry->topology != scene::Topology::Triangles || material.alphaMode == scene::AlphaMode::Blend ||
            transmits)
            continue;
        const auto [place, added] = meshes.try_emplace(item.geometry, static_cast<uint32_t>(out.meshes.size()));
        if (added)
            out.meshes.push_back({item.geometry->positions, item.geometry->indices});
        RayInstance instance;
        instance.mesh = place->second;
        std::copy_n(glm::value_ptr(item.localToWorld), 16, instance.localToWorld.begin());
        instance.doubleSided = material.doubleSided;
        out.instances.push_back(instance);
    }
    return out;
}

/// Half of them from anywhere in the scene's box, half on from where the oracle says such a ray ends.
std::vector<TestRay> raysThrough(const measure::RayOracle& oracle, const scene::Bounds& bounds) {
    std::mt19937 random(42);
    std::uniform_real_distribution<float> unit(0, 1);
    std::normal_distribution<float> normal;
    const float size = glm::length(bounds.max - bounds.min);
    const auto direction = [&] { return glm::normalize(glm::vec3(normal(random), normal(random), normal(random))); };
    std::vector<TestRay> rays;
    while (rays.size() < kRays) {
        TestRay ray;
        ray.originWS = glm::mix(bounds.min, bounds.max, glm::vec3(unit(random), unit(random), unit(random)));
        ray.directionWS = direction();
        ray.tMin = 1e-4f * size;
        ray.flags = shared::kRayCullBackFaces;
        rays.push_back(ray);
        const auto hit = oracle.trace(ray.originWS, ray.directionWS, static_cast<double>(ray.tMin));
        if (!hit)
            continue;
        ray.originWS = glm::vec3(hit->positionWS);
        ray.directionWS = direction();
        if (glm::dot(glm::dvec3(ray.directionWS), hit->geometricNormalWS) < 0)
            ray.directionWS = -ray.directionWS;
        rays.push_back(ray);
    }
    return rays;
}

class RaysTest : public GpuTest {
protected:
    void expectEmbreesHits(scene::Scene scene, const char* name) {
        for (scene::Material& material : scene.materials) // holes are tested where the hook is
            if (material.alphaMode == scene::AlphaMode::Mask)
                material.alphaMode = scene::AlphaMode::Opaque;
        const scene::Pose pose = must(scene::pose(scene, 0));
        const measure::RayOracle oracle = must(measure::RayOracle::create(scene, pose));
        const TestScene hostScene = rayScene(scene, pose);
        const std::vector<TestRay> rays = raysThrough(oracle, pose.boundsWS);
        std::vector<std::optional<measure::OracleHit>> truths;
        size_t met = 0;
        for (const TestRay& ray : rays) {
            truths.push_back(oracle.trace(ray.originWS, ray.directionWS, static_cast<double>(ray.tMin)));
            met += truths.back() ? 1 : 0;
        }
        EXPECT_GT(met, rays.size() / 4);
        size_t triangles = 0;
        for (const TestMesh& mesh : hostScene.meshes)
            triangles += mesh.indices.size() / 3;

        for (const RayBackend backend : {RayBackend::Query, RayBackend::Bvh}) {
            const bool query = backend == RayBackend::Query;
            if (query && !gpu().rayQuery())
                continue;
            SCOPED_TRACE(query ? "query" : "bvh");
            const std::unique_ptr<rays::Scene> built = hostScene.build(gpu(), backend);
            traceRays(gpu(), *built, rays); // a driver may compile when a shader first runs
            double milliseconds = 0;
            const std::vector<TestHit> hits = traceRays(gpu(), *built, rays, &milliseconds);
            size_t differ = 0;
            size_t occlusions = 0;
            for (size_t i = 0; i < rays.size(); ++i) {
                // A driver's rays are moved into an instance's space as it likes: Mesa's lavapipe loses four bits of
                // the origin there, which is much of the distance to what is near.
                const double lost = query ? 0x1p-20 * glm::length(glm::dvec3(rays[i].originWS)) : 0;
                const double distance = static_cast<double>(hits[i].distance);
                if (hits[i].met() != truths[i].has_value() ||
                    (truths[i] && std::abs(distance - truths[i]->distance) > 1e-4 * truths[i]->distance + lost))
                    ++differ;
                occlusions += (hits[i].occluded != 0) == hits[i].met() ? 0 : 1;
            }
            const RaySceneTimes times = built->times();
            std::cout << name << ", " << (query ? "query" : "bvh") << ": " << triangles << " triangles, "
                      << hostScene.instances.size() << " instances; " << differ << " of " << rays.size()
                      << " rays differ; tracing " << milliseconds << " ms, CPU build " << times.cpuBuildMs
                      << " ms, GPU build " << times.gpuBuildMs << " ms\n";
            EXPECT_LE(differ, rays.size() / 10000);
            EXPECT_EQ(occlusions, 0u) << "any hit and nearest hit disagree on whether there is one";
        }
    }
};

TEST_F(RaysTest, theHallIsHitAsByEmbree) {
    expectEmbreesHits(must(scene::builtinScene("hall")), "hall");
}

TEST_F(RaysTest, aGltfSceneIsHitAsByEmbree) {
    GLINT_NEED_ASSET(path, "scenes/stage1.glb");
    expectEmbreesHits(must(scene::readGltf(path)), "stage1");
}

TEST_F(RaysTest, aMillionTrianglesAreHitAsByEmbree) {
    using namespace scene::builtin;
    SceneBuilder builder("million");
    const int material = builder.material(dielectric("stone", glm::vec3(1), 1));
    scene::Geometry ground = plane({50, 50}, 500, 500);
    for (glm::vec3& p : ground.positions)
        p.y += 0.7f * std::sin(0.9f * p.x) * std::cos(1.3f * p.z) + 0.05f * std::sin(17 * p.x + 11 * p.z);
    builder.add("ground", std::move(ground), material);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (int i = 0; i < 50; ++i) { // geometry of its own each
        scene::Geometry ball = sphere(1, 100, 60);
        const float scale = 1 + 0.8f * unit(random);
        builder.add(
            "ball", std::move(ball), material,
            {.position = {40 * unit(random), 3 + 2 * unit(random), 40 * unit(random)}, .scale = glm::vec3(scale)});
    }
    expectEmbreesHits(builder.take(), "million");
}

} // namespace rays_test
} // namespace glint::test
