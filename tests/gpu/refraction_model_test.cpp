// shaders/lib/refraction.glsl against Snell's law in double precision, at both surfaces of each body.
#include "gpu/support/gpu_test.hpp"
#include "shared/refraction.h"

#include <glm/gtc/constants.hpp>

#include <cstring>
#include <random>

namespace glint::test {
namespace refraction_model_test {

/// Layout of tests/gpu/shaders/refraction.comp.
struct Item {
    glm::vec3 normal;
    glm::vec3 toEye;
    uint32_t model;
    float ior;
    float thickness;
    glm::vec3 exit = {};
    glm::vec3 direction = {};
    float pathLength = 0;
    uint32_t isTotal = 0;
    uint32_t inner = 0;
};

/// Direction of light behind a surface whose normal `n` faces it; zero for total reflection. `eta`: index before over
/// index behind.
glm::dvec3 snell(const glm::dvec3& d, const glm::dvec3& n, double eta) {
    const double cosine = -glm::dot(d, n);
    const double sine2 = eta * eta * (1 - cosine * cosine);
    return sine2 > 1 ? glm::dvec3(0) : eta * d + (eta * cosine - std::sqrt(1 - sine2)) * n;
}

struct Expected {
    glm::dvec3 exit;
    glm::dvec3 direction;
    double pathLength = 0;
    bool isTotal = false;
};

/// SURVEY of HDRP's models: in at a point of a sphere of diameter `t`, or of a plate of thickness `t`, and out.
Expected oracle(const Item& item) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(item.normal));
    const glm::dvec3 d = -glm::normalize(glm::dvec3(item.toEye));
    const double t = item.model == shared::kRefractionThin ? 0.005 : double(item.thickness);
    if (item.model == shared::kRefractionStraight || t <= 0)
        return {{}, d, 0, false};
    const glm::dvec3 inside = snell(d, n, 1 / double(item.ior));
    if (inside == glm::dvec3(0))
        return {{}, d - 2 * glm::dot(d, n) * n, 0, true};
    const glm::dvec3 center = -n * (t / 2);
    glm::dvec3 ray = inside;
    glm::dvec3 at(0);
    Expected expected;
    for (uint32_t i = 0;; ++i) {
        glm::dvec3 inward; // normal where the ray meets the surface from inside
        double way = 0;
        if (item.model == shared::kRefractionSphere) {
            way = -2 * glm::dot(ray, at - center); // second intersection with the sphere, behind the start
            inward = glm::normalize(center - (at + ray * way));
        } else {
            way = t / std::abs(glm::dot(n, ray));
            inward = glm::dot(n, ray) < 0 ? n : -n;
        }
        at += ray * way;
        expected.pathLength += way;
        if (i == item.inner) {
            expected.exit = at;
            expected.direction = snell(ray, inward, item.ior);
            return expected;
        }
        ray -= 2 * glm::dot(ray, inward) * inward;
    }
}

class RefractionModelTest : public GpuTest {
protected:
    static std::vector<Item> evaluate(std::vector<Item> list) {
        gpu::Buffer buffer = must(gpu::uploadBuffer(
            gpu(), "test/refraction", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"refraction", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline).readWrite("items", buffer).dispatch(static_cast<uint32_t>(list.size()));
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
        std::memcpy(list.data(), bytes.data(), list.size() * sizeof(Item));
        return list;
    }
    static glm::vec3 at(double degrees) {
        return glm::vec3(glm::dvec3(std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))));
    }
};

TEST_F(RefractionModelTest, LightGoesAsSnellSays) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    std::normal_distribution<float> axis;
    std::vector<Item> list;
    while (list.size() < 4000) {
        const glm::vec3 n = glm::normalize(glm::vec3(axis(random), axis(random), axis(random)));
        const glm::vec3 v = glm::normalize(glm::vec3(axis(random), axis(random), axis(random)));
        if (glm::dot(n, v) < 0.02f)
            continue;
        const auto model = static_cast<uint32_t>(list.size() % 4);
        // Indices below 1 too, as for bubbles; not where the refracted ray grazes, since rounding may turn such a ray.
        const float ior = 0.5f + 2 * unit(random);
        const double sine = std::sqrt(1 - double(glm::dot(n, v)) * double(glm::dot(n, v))) / double(ior);
        if (std::abs(sine - 1) < 1e-3)
            continue;
        Item item = {n, v, model, ior, 0.001f + 3 * unit(random)};
        item.inner = static_cast<uint32_t>(list.size() / 4 % 4);
        list.push_back(item);
    }
    size_t total = 0;
    for (const Item& got : evaluate(list)) {
        const Expected expected = oracle(got);
        const double slack = 4e-5 * (1 + expected.pathLength);
        EXPECT_EQ(got.isTotal != 0, expected.isTotal);
        EXPECT_LT(glm::distance(glm::dvec3(got.direction), expected.direction), 2e-4) << got.model << " " << got.ior;
        EXPECT_LT(glm::distance(glm::dvec3(got.exit), expected.exit), slack * 5) << got.model << " " << got.ior;
        EXPECT_NEAR(got.pathLength, expected.pathLength, slack * 5);
        EXPECT_NEAR(glm::length(got.direction), 1, 1e-5);
        total += expected.isTotal;
    }
    EXPECT_GT(total, 100u);
}

TEST_F(RefractionModelTest, NothingIsBentByWhatIsNotThere) {
    for (const uint32_t model : {shared::kRefractionSphere, shared::kRefractionPlane, shared::kRefractionStraight}) {
        const std::vector<Item> got = evaluate({{at(0), at(70), model, 1, 0.5f},   // index of air
                                                {at(0), at(70), model, 1.5f, 0},   // without thickness
                                                {at(0), at(70), model, 0, 0.5f}}); // infinite index: a mirror
        for (const Item& item : got) {
            EXPECT_LT(glm::distance(item.direction, -at(70)), 1e-6);
            EXPECT_EQ(item.isTotal, 0u);
        }
        EXPECT_EQ(got[1].exit, glm::vec3(0));
        EXPECT_EQ(got[1].pathLength, 0);
    }
}

TEST_F(RefractionModelTest, APaneIsFiveMillimetresWhateverItsMaterialSays) {
    for (const float thickness : {0.f, 0.3f}) {
        const std::vector<Item> got = evaluate({{at(0), at(60), shared::kRefractionThin, 1.5f, thickness}});
        EXPECT_NEAR(got[0].pathLength, 0.005 / std::sqrt(1 - 0.75 / 2.25), 1e-6);
    }
}

TEST_F(RefractionModelTest, ABubbleReflectsTotallyFromItsAngleOn) {
    const double critical = glm::degrees(std::asin(0.75));
    const std::vector<Item> got = evaluate({{at(0), at(critical - 0.5), shared::kRefractionPlane, 0.75f, 0.1f},
                                            {at(0), at(critical + 0.5), shared::kRefractionPlane, 0.75f, 0.1f}});
    EXPECT_EQ(got[0].isTotal, 0u);
    ASSERT_EQ(got[1].isTotal, 1u);
    EXPECT_LT(glm::distance(got[1].direction, at(-(critical + 0.5))), 1e-5);
}

/// Normal maps turn normals away from the eye: the result is a direction into the body in any case.
TEST_F(RefractionModelTest, NormalsThatLookAwayDoNoHarm) {
    for (const float degrees : {89.99f, 90.f, 95.f, 135.f, 180.f})
        for (const uint32_t model : {shared::kRefractionSphere, shared::kRefractionPlane, shared::kRefractionThin})
            for (const Item& item : evaluate({{at(0), at(degrees), model, 1.5f, 0.3f}})) {
                EXPECT_NEAR(glm::length(item.direction), 1, 1e-4) << degrees << " " << model;
                EXPECT_TRUE(std::isfinite(item.pathLength) && item.pathLength >= 0) << degrees << " " << model;
            }
}

} // namespace refraction_model_test
} // namespace glint::test
