// RayScene: both back ends find what an oracle finds that tries every triangle in double precision.
#include "gpu/support/ray_test.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <random>

namespace glint::test {
namespace {

class RaySceneTest : public GpuTest, public testing::WithParamInterface<RayBackend> {
protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (GetParam() == RayBackend::Query && !gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
    }
    std::unique_ptr<rays::Scene> build(const TestScene& scene, uint32_t maxInstances = 0) {
        return scene.build(gpu(), GetParam(), maxInstances);
    }
    std::vector<TestHit> trace(const TestScene& scene, const std::vector<TestRay>& rays) {
        return traceRays(gpu(), *build(scene), rays);
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, RaySceneTest, testing::Values(RayBackend::Query, RayBackend::Bvh),
                         [](const auto& backend) { return backend.param == RayBackend::Query ? "query" : "bvh"; });

/// One triangle that faces +Z.
TestScene oneTriangle() {
    TestScene scene;
    scene.meshes.emplace_back().addTriangle({-1, -1, -2}, {3, -1, -2}, {-1, 3, -2});
    scene.instances.emplace_back();
    return scene;
}

TEST_P(RaySceneTest, oneTriangleIsMetWhereItIs) {
    const std::vector<TestHit> hits =
        trace(oneTriangle(), {{}, {.originWS = {5, 0, 0}}, {.originWS = {1, 0, -4}, .directionWS = {0, 0, 2}}});
    ASSERT_TRUE(hits[0].met());
    EXPECT_EQ(hits[0].instance, 0u);
    EXPECT_EQ(hits[0].primitive, 0u);
    EXPECT_NEAR(hits[0].distance, 2, 1e-6);
    EXPECT_NEAR(hits[0].barycentrics.x, 0.25, 1e-6);
    EXPECT_NEAR(hits[0].barycentrics.y, 0.25, 1e-6);
    EXPECT_TRUE(hits[0].frontFace);
    EXPECT_EQ(hits[0].occluded, 1u);
    EXPECT_FALSE(hits[1].met());
    EXPECT_EQ(hits[1].occluded, 0u);
    ASSERT_TRUE(hits[2].met());
    EXPECT_NEAR(hits[2].distance, 1, 1e-6) << "in lengths of the direction";
    EXPECT_FALSE(hits[2].frontFace);
}

/// Triangles of all sizes about the origin, several meshes, instances moved, turned, squeezed and mirrored.
TestScene randomScene(uint32_t seed, float scale) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto point = [&](float size) { return glm::vec3(unit(random), unit(random), unit(random)) * size; };
    TestScene scene;
    for (int m = 0; m < 4; ++m) {
        TestMesh& mesh = scene.meshes.emplace_back();
        const int triangles = m == 0 ? 1 : 40 * m * m;
        for (int t = 0; t < triangles; ++t) {
            const glm::vec3 center = point(scale);
            const float size = scale * std::exp2(3 * unit(random) - 4);
            mesh.addTriangle(center + point(size), center + point(size), center + point(size));
        }
    }
    for (uint32_t i = 0; i < 23; ++i) {
        RayInstance instance;
        instance.mesh = i % 4;
        glm::mat4 matrix(1);
        for (int column = 0; column < 3; ++column)
            matrix[column] = glm::vec4(point(0.5f), 0);
        for (int axis = 0; axis < 3; ++axis)
            matrix[axis][axis] += unit(random) > 0 ? 1.0f : -1.0f;
        matrix[3] = glm::vec4(point(4 * scale), 1);
        std::copy_n(glm::value_ptr(matrix), 16, instance.localToWorld.begin());
        instance.mask = static_cast<uint8_t>(1u << i % 3);
        instance.opaque = i % 2 == 0;
        instance.doubleSided = i % 5 < 2;
        scene.instances.push_back(instance);
    }
    return scene;
}

std::vector<TestRay> randomRays(uint32_t seed, size_t count, float scale) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto point = [&](float size) { return glm::vec3(unit(random), unit(random), unit(random)) * size; };
    std::vector<TestRay> rays(count);
    for (size_t i = 0; i < count; ++i) {
        TestRay& ray = rays[i];
        ray.originWS = point(6 * scale);
        ray.directionWS = i % 3 == 0 ? point(scale) : glm::normalize(point(4 * scale) - ray.originWS);
        if (i % 7 == 0) // along the axes
            ray.directionWS = glm::vec3(i % 2, i % 2 ? 0 : -1, 0);
        ray.mask = i % 4 == 0 ? 0xff : 1u << i % 3;
        ray.flags = i % 5 == 0 ? shared::kRayAllOpaque : i % 5 < 3 ? shared::kRayCullBackFaces : 0;
        if (i % 6 == 0) {
            ray.tMin = scale;
            ray.tMax = 5 * scale;
        }
    }
    return rays;
}

/// How many rays the back end answers differently than the oracle, those left out that pass so close to an edge, or to
/// the ends of the range, that single precision may decide either way.
struct Disagreement {
    size_t judged = 0;
    size_t met = 0;
    size_t wrong = 0;
    std::string first;
};
Disagreement disagreement(const TestScene& scene, const std::vector<TestRay>& rays, const std::vector<TestHit>& hits) {
    Disagreement result;
    for (size_t i = 0; i < rays.size(); ++i) {
        TestRay wider = rays[i];
        wider.tMin *= 1 - 1e-5f;
        wider.tMax *= 1 + 1e-5f;
        const std::vector<ExactHit> all = exactHits(scene, wider);
        const auto isDoubtful = [&](const ExactHit& hit) {
            const double first = 1 - hit.barycentrics.x - hit.barycentrics.y;
            return hit.edge < 1e-4 || std::abs(first - 0.5) < 1e-4 ||
                   hit.distance < static_cast<double>(rays[i].tMin) * (1 + 1e-5) ||
                   hit.distance > static_cast<double>(rays[i].tMax) * (1 - 1e-5);
        };
        const bool two = all.size() > 1 && all[1].distance < all[0].distance * (1 + 1e-5);
        if (two || (!all.empty() && isDoubtful(all[0])))
            continue;
        ++result.judged;
        const TestHit& hit = hits[i];
        bool right = hit.met() == !all.empty() && (hit.occluded != 0) == !all.empty();
        if (right && hit.met()) {
            ++result.met;
            const ExactHit& exact = all[0];
            right = hit.instance == exact.instance && hit.primitive == exact.primitive &&
                    std::abs(static_cast<double>(hit.distance) - exact.distance) <= 1e-4 * exact.distance &&
                    glm::distance(glm::dvec2(hit.barycentrics), exact.barycentrics) < 1e-2 &&
                    (hit.frontFace != 0) == exact.frontFace;
        }
        if (!right && result.wrong++ == 0)
            result.first =
                "ray " + std::to_string(i) + ": distance " + std::to_string(hit.distance) + " instance " +
                std::to_string(int(hit.instance)) + " primitive " + std::to_string(hit.primitive) +
                (all.empty() ? ", there is nothing"
                             : ", there is " + std::to_string(all[0].distance) + " instance " +
                                   std::to_string(all[0].instance) + " primitive " + std::to_string(all[0].primitive));
    }
    return result;
}

TEST_P(RaySceneTest, randomScenesAreAnsweredAsByTheOracle) {
    for (const float scale : {1.0f, 1e-3f, 1e3f}) {
        const TestScene scene = randomScene(7, scale);
        const std::vector<TestRay> rays = randomRays(8, 4000, scale);
        const Disagreement result = disagreement(scene, rays, trace(scene, rays));
        EXPECT_GT(result.judged, rays.size() * 9 / 10) << "scale " << scale;
        EXPECT_GT(result.met, rays.size() / 10) << "scale " << scale;
        EXPECT_EQ(result.wrong, 0u) << "scale " << scale << ", of " << result.judged << ": " << result.first;
    }
}

} // namespace
} // namespace glint::test
