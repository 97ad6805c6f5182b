// shaders/lib: packed values unpack within the bounds that the files state. Oracle: double precision here.
#include "gpu/support/gpu_test.hpp"

#include "shared/outcome.h"

#include <glm/gtc/constants.hpp>

#include <cstring>
#include <random>

namespace glint::test {
namespace packing_test {

/// Layout of tests/gpu/shaders/packing.comp.
struct Packed {
    glm::vec4 direction;
    glm::vec4 decoded;
    glm::vec4 unpacked;
    glm::vec4 ray;
    glm::vec4 rayOut;
    glm::uvec4 counts;
    glm::vec4 sent;
    glm::vec2 real;
    glm::ivec2 whole;
};

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / glm::pi<double>();
}

class PackingTest : public GpuTest {
protected:
    static const std::vector<Packed>& items() {
        static const std::vector<Packed> all = runPacking();
        return all;
    }

private:
    static std::vector<Packed> runPacking() {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> unit(0, 1);
        std::normal_distribution<float> normal;
        std::vector<Packed> list;
        const auto add = [&](glm::vec3 direction) {
            Packed item = {};
            item.direction = glm::vec4(glm::vec3(glm::normalize(glm::dvec3(direction))), unit(random));
            const float distances[] = {0, 1e-3f, unit(random) * 10, unit(random) * 60000, 65504, 1e6f, INFINITY};
            item.ray = {unit(random), unit(random), distances[random() % std::size(distances)], unit(random)};
            item.counts = {random() % 6000, random() % shared::kOutcomeCount, 0, 0};
            const float wholes[] = {0, -1, 1, 1279.5f, -0.25f, 4194303.5f, -4194303.5f, std::nextafter(720.0f, 0.0f)};
            item.real = {wholes[random() % std::size(wholes)],
                         std::ldexp(normal(random), static_cast<int>(random() % 20))};
            list.push_back(item);
        };
        // The axes, the diagonals and the folds of the octahedron.
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (x || y || z)
                        for (const float tilt : {0.0f, 1e-6f, -1e-6f})
                            add(glm::vec3(x, y, z) + glm::vec3(tilt, -tilt, tilt));
        while (list.size() < 20000)
            add({normal(random), normal(random), normal(random)});
        list[0].ray = {0, 0, 0, 0};
        list[0].direction.w = 0;
        list[1].ray = {1, 1, 1, 1};
        list[1].direction.w = 1;

        gpu::Buffer buffer = must(gpu::uploadBuffer(
            gpu(), "test/packed", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        const gpu::Pipeline packing = must(gpu::Pipeline::compute(gpu(), {"packing", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(packing).readWrite("items", buffer).dispatch(static_cast<uint32_t>(list.size()));
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
        std::memcpy(list.data(), bytes.data(), bytes.size());
        return list;
    }
};

TEST_F(PackingTest, theWholeNumberBelowComesFromTheBits) {
    for (const Packed& item : items()) {
        ASSERT_EQ(item.whole.x, static_cast<int>(std::floor(item.real.x))) << item.real.x;
        ASSERT_EQ(item.whole.y, static_cast<int>(std::floor(item.real.y))) << item.real.y;
    }
}

TEST_F(PackingTest, aSentRayKeepsItsDirectionAndItsEnd) {
    // Half a step of 16 bits in two coordinates of the octahedron moves its point by sqrt(6) times that at most, and
    // the direction by sqrt(3) times more where the octahedron is nearest to its centre.
    const double most = 0.5 / 32767 * std::sqrt(6.0) * std::sqrt(3.0) * 180 / glm::pi<double>();
    for (const Packed& item : items()) {
        ASSERT_LE(degreesBetween(glm::vec3(item.direction), glm::vec3(item.sent)), most);
        ASSERT_EQ(item.sent.w, item.ray.x);
    }
}

TEST_F(PackingTest, octahedronInFullPrecisionIsExactToRounding) {
    for (const Packed& item : items())
        ASSERT_LT(degreesBetween(glm::vec3(item.direction), glm::vec3(item.decoded)), 5e-5)
            << item.direction.x << " " << item.direction.y << " " << item.direction.z;
}

TEST_F(PackingTest, packedNormalsAreUnitAndWithinFourThousandthsOfADegree) {
    double worst = 0;
    for (const Packed& item : items()) {
        worst = std::max(worst, degreesBetween(glm::vec3(item.direction), glm::vec3(item.unpacked)));
        ASSERT_NEAR(glm::length(glm::dvec3(item.unpacked)), 1, 1e-6);
    }
    EXPECT_LT(worst, 0.004);
    EXPECT_GT(worst, 0.001) << "sixteen bits cannot do better: something is not packed at all";
}

TEST_F(PackingTest, roughnessAndReflectivityKeepSixteenBits) {
    for (const Packed& item : items()) {
        ASSERT_NEAR(item.unpacked.w, item.direction.w, 0.5 / 65535 + 1e-7);
        ASSERT_NEAR(item.rayOut.w, item.ray.w, 0.5 / 65535 + 1e-7);
    }
    EXPECT_EQ(items()[0].unpacked.w, 0) << "0 and 1 are exact: a mirror stays a mirror";
    EXPECT_EQ(items()[1].unpacked.w, 1);
    EXPECT_EQ(items()[1].rayOut.w, 1);
}

TEST_F(PackingTest, rayRecordsKeepWhatTheySay) {
    for (const Packed& item : items()) {
        ASSERT_NEAR(item.rayOut.x, item.ray.x, 0.5 / 65535 + 1e-7);
        ASSERT_NEAR(item.rayOut.y, item.ray.y, 0.5 / 65535 + 1e-7);
        const double distance = std::min(item.ray.z, 65504.0f);
        ASSERT_NEAR(item.rayOut.z, distance, distance / 1024 + 6e-8) << "a half has 11 bits";
        ASSERT_EQ(item.counts.z, std::min(item.counts.x, shared::kMaxLookups));
        ASSERT_EQ(item.counts.w, item.counts.y);
        ASSERT_EQ(item.decoded.w, 1) << "whether it passed behind something";
    }
}

} // namespace packing_test
} // namespace glint::test
