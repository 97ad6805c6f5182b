// The trees of lights that paths sample directly: sums, draws and densities, against double precision.
#include "gpu/support/brdf_oracle.hpp"
#include "gpu/support/library_test.hpp"

#include "shared/light_tree.h"

#include <cstring>
#include <numeric>
#include <random>

namespace glint::test {
namespace light_tree_test {

/// Layout of tests/gpu/shaders/light_draws.comp.
struct Draw {
    uint32_t leaf;
    float probability;
    float again;
    glm::vec3 directionWS;
    uint32_t leafOfDirection;
    float solidAngle;
};
struct DrawConstants {
    uint32_t firstGroup;
    uint32_t depth;
    uint32_t every;
};

uint32_t groupsAbove(uint32_t depth) {
    return ((1u << 2 * depth) - 1) / 3;
}

/// Solid angle of the rectangle between the corners `a` and `b` of the plane z = 1, seen from the origin.
double solidAngle(const glm::dvec2& a, const glm::dvec2& b) {
    const auto corner = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); };
    return corner(b.x, b.y) - corner(a.x, b.y) - corner(b.x, a.y) + corner(a.x, a.y);
}

class LightTreeTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        tree_ = must(gpu::Buffer::create(gpu(), {"test/lightTree", shared::kLightTreeGroups * sizeof(glm::vec4),
                                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                 gpu::BufferHome::Device}));
    }

    void addUp(const shared::LightTreeConstants& tree) {
        const gpu::Pipeline sums =
            must(gpu::Pipeline::compute(gpu(), {"rays/light_tree_sums", sizeof(shared::LightTreeConstants), {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(sums).readWrite("lightTree", tree_).push(tree).dispatch(shared::kLightTreeThreads);
        });
    }

    void fill(const std::vector<float>& leaves, uint32_t depth) {
        std::vector<float> padded = leaves;
        padded.resize((leaves.size() + 3) / 4 * 4, 0);
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.fill(tree_, 0x7fc00000); // NaN: nothing may be read that was not written
            frame.update(tree_, padded.data(), padded.size() * sizeof(float), groupsAbove(depth) * sizeof(glm::vec4));
        });
        addUp({0, depth, static_cast<uint32_t>(leaves.size()), 0});
    }

    void fill(TestEnvironment& environment) {
        const gpu::Pipeline leaves = must(gpu::Pipeline::compute(gpu(), {"rays/environment_leaves", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.fill(tree_, 0x7fc00000);
            frame.pass(leaves)
                .read("environment", environment.cube)
                .write("lightTree", tree_)
                .dispatch(shared::kEnvironmentLeaves);
        });
        addUp({0, shared::kEnvironmentDepth, shared::kEnvironmentLeaves, 1});
    }

    std::vector<Draw> draw(uint32_t depth, uint32_t count, bool every) {
        std::vector<Draw> list(count);
        gpu::Buffer buffer = must(gpu::uploadBuffer(
            gpu(), "test/draws", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"light_draws", sizeof(DrawConstants), {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline)
                .read("lightTree", tree_)
                .write("draws", buffer)
                .push(DrawConstants{0, depth, every ? 1u : 0u})
                .dispatch(count);
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
        std::memcpy(list.data(), bytes.data(), list.size() * sizeof(Draw));
        return list;
    }

    /// Pearson's statistic of `counts` as a number of standard deviations (Wilson and Hilferty 1931); bins with few
    /// expected draws are merged.
    static double sigmas(const std::vector<double>& shares, const std::vector<double>& counts, double draws) {
        double statistic = 0;
        double restExpected = 0;
        double restCounted = 0;
        double degrees = -1;
        for (size_t bin = 0; bin < shares.size(); ++bin) {
            const double expected = shares[bin] * draws;
            if (expected < 10) {
                restExpected += expected;
                restCounted += counts[bin];
                continue;
            }
            statistic += (counts[bin] - expected) * (counts[bin] - expected) / expected;
            degrees += 1;
        }
        if (restExpected >= 10) {
            statistic += (restCounted - restExpected) * (restCounted - restExpected) / restExpected;
            degrees += 1;
        } else if (restCounted > 10 * (restExpected + 1)) {
            return 1e9;
        }
        return (std::cbrt(statistic / degrees) - (1 - 2 / (9 * degrees))) / std::sqrt(2 / (9 * degrees));
    }

    gpu::Buffer tree_;
};

TEST_F(LightTreeTest, LightsAreDrawnByTheirWeights) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> exponent(-12, 3);
    for (const auto& [count, depth] : {std::pair{1u, 0u}, {4u, 0u}, {5u, 1u}, {17u, 2u}, {1000u, 4u}}) {
        std::vector<float> weights(count);
        for (size_t i = 0; i < count; ++i)
            weights[i] = count > 1 && i % 3 == 1 ? 0 : std::exp2(exponent(random));
        fill(weights, depth);
        const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
        constexpr uint32_t kDraws = 200000;
        std::vector<double> counts(count, 0.0);
        for (const Draw& drawn : draw(depth, kDraws, true)) {
            ASSERT_LT(drawn.leaf, count);
            ASSERT_NEAR(drawn.probability, double(weights[drawn.leaf]) / total, 1e-5 * drawn.probability);
            ASSERT_FLOAT_EQ(drawn.again, drawn.probability);
            ASSERT_GT(drawn.probability, 0);
            counts[drawn.leaf] += 1;
        }
        if (count == 1)
            continue;
        std::vector<double> shares(weights.begin(), weights.end());
        for (double& share : shares)
            share /= total;
        EXPECT_LT(sigmas(shares, counts, kDraws), 4) << count << " lights";
    }
}

TEST_F(LightTreeTest, NoWeightDrawsNothing) {
    fill(std::vector<float>(37, 0.0f), 2);
    for (const Draw& drawn : draw(2, 1000, true))
        ASSERT_EQ(drawn.probability, 0);
}

/// A sky with a bright horizon and a soft sun: the light above the mean is drawn, by its share.
TEST_F(LightTreeTest, DirectionsFollowTheEnvironmentsLightAboveItsMean) {
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.5, 0.6, -0.7));
    const auto radiance = [&](const glm::dvec3& direction) {
        return 0.2 + 20 * std::pow(1 - std::abs(direction.y), 4) + 300 * std::exp(100 * (glm::dot(direction, sun) - 1));
    };
    TestEnvironment environment = TestEnvironment::make(
        gpu(), 64, 1, [&](const glm::dvec3& d, uint32_t) { return glm::vec3(float(radiance(d))); });
    fill(environment);

    const std::vector<Draw> cells = draw(shared::kEnvironmentDepth, shared::kEnvironmentLeaves, false);
    double probability = 0;
    double sphere = 0;
    double mean = 0;
    size_t inAnother = 0;
    for (const Draw& cell : cells) {
        inAnother += cell.leafOfDirection != cell.leaf ? 1 : 0;
        probability += cell.probability;
        sphere += cell.solidAngle;
        mean += radiance(glm::normalize(glm::dvec3(cell.directionWS))) * cell.solidAngle / (4 * oracle::kPi);
    }
    // Rounding: 2^-22 of a face is 3e-5 of a cell, at each of four edges.
    EXPECT_LT(double(inAnother), 1.2e-4 * double(cells.size())) << "directions of a cell are found in another";
    EXPECT_NEAR(probability, 1, 1e-4) << "the densities are those of a distribution";
    EXPECT_NEAR(sphere, 4 * oracle::kPi, 1e-3);

    // By face, in 8 x 8 bins: Morton order keeps the cells of a bin together.
    const auto binOf = [](uint32_t leaf) { return size_t{leaf >> 10}; };
    std::vector<double> shares(6 * 64, 0.0);
    std::vector<double> above(6 * 64, 0.0);
    double allAbove = 0;
    for (const Draw& cell : cells) {
        const double light = radiance(glm::normalize(glm::dvec3(cell.directionWS)));
        shares[binOf(cell.leaf)] += cell.probability;
        above[binOf(cell.leaf)] += std::max(light - mean, 0.0) * cell.solidAngle;
        allAbove += std::max(light - mean, 0.0) * cell.solidAngle;
    }
    for (size_t bin = 0; bin < shares.size(); ++bin)
        EXPECT_NEAR(shares[bin], above[bin] / allAbove, 0.02 * above[bin] / allAbove + 1e-3) << "bin " << bin;

    constexpr uint32_t kDraws = 300000;
    std::vector<double> counts(6 * 64, 0.0);
    for (const Draw& drawn : draw(shared::kEnvironmentDepth, kDraws, true)) {
        ASSERT_GT(drawn.probability, 0);
        ASSERT_FLOAT_EQ(drawn.again, drawn.probability);
        counts[binOf(drawn.leaf)] += 1;
    }
    EXPECT_LT(sigmas(shares, counts, kDraws), 4);
}

TEST_F(LightTreeTest, ACellHasTheSolidAngleOfItsPartOfTheSphere) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3& d, uint32_t) { return glm::vec3(d.x > 0.9 ? 1 : 0); });
    fill(environment);
    const std::vector<Draw> cells = draw(shared::kEnvironmentDepth, shared::kEnvironmentLeaves, false);
    const auto coordinate = [](double p) { return std::floor((p + 1) / 2 * shared::kEnvironmentSide); };
    const auto edge = [](double cell) { return 2 * cell / shared::kEnvironmentSide - 1; };
    for (uint32_t leaf = 0; leaf < shared::kEnvironmentLeaves; leaf += 997) {
        // Each direction of the shader has one component of size 1, the others are the point of the face.
        const glm::dvec3 d(cells[leaf].directionWS);
        const glm::dvec2 p = std::abs(d.x) == 1 && leaf >> 16 < 2   ? glm::dvec2(d.y, d.z)
                             : std::abs(d.y) == 1 && leaf >> 16 < 4 ? glm::dvec2(d.x, d.z)
                                                                    : glm::dvec2(d.x, d.y);
        const glm::dvec2 low(edge(coordinate(p.x)), edge(coordinate(p.y)));
        const double exact = solidAngle(low, low + 2.0 / shared::kEnvironmentSide);
        EXPECT_NEAR(cells[leaf].solidAngle, exact, 0.02 * exact); // it changes by less over a cell
    }
}

TEST_F(LightTreeTest, UniformLightIsLeftToTheLobes) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(0.7f, 2, 0.3f); });
    fill(environment);
    for (const Draw& drawn : draw(shared::kEnvironmentDepth, 1000, true))
        ASSERT_EQ(drawn.probability, 0);
}

} // namespace light_tree_test
} // namespace glint::test
