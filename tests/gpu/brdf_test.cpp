// shaders/lib/brdf.glsl and dfg.glsl against double precision, implemented here from the papers.
#include "gpu/support/brdf_oracle.hpp"
#include "gpu/support/gpu_test.hpp"

#include <cstring>
#include <random>

namespace glint::test {
namespace brdf_test {

/// Layout of tests/gpu/shaders/brdf.comp.
struct Item {
    glm::vec4 cosines;
    glm::vec4 surface;
    glm::vec4 terms;
    glm::vec2 dfg;
};

class BrdfTest : public GpuTest {
protected:
    static std::vector<Item> evaluate(std::vector<Item> list) {
        gpu::Buffer buffer = must(gpu::uploadBuffer(
            gpu(), "test/brdf", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"brdf", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline).readWrite("items", buffer).dispatch(static_cast<uint32_t>(list.size()));
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
        std::memcpy(list.data(), bytes.data(), list.size() * sizeof(Item));
        return list;
    }

    static Item item(float NoV, float NoL, float NoH, float VoH, float f0, float perceptualRoughness) {
        return {{NoV, NoL, NoH, VoH}, {f0, 1, perceptualRoughness, 0}, {}, {}};
    }
};

TEST_F(BrdfTest, TermsAreThePapersFormulas) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.001f, 1);
    std::vector<Item> list;
    for (const float roughness : {0.045f, 0.1f, 0.5f, 1.0f})
        list.push_back(item(1, 1, 1, 1, 0.04f, roughness));
    while (list.size() < 2000)
        list.push_back(
            item(unit(random), unit(random), unit(random), unit(random), unit(random), 0.045f + 0.955f * unit(random)));
    for (const Item& got : evaluate(list)) {
        const double alpha = double(got.surface.z) * double(got.surface.z);
        const double d = oracle::ggx(got.cosines.z, alpha);
        // 1 - NoH^2 cancels near NoH = 1: in floats its error is 1e-7 of alpha^2's scale.
        const double cancellation = 1 + 3e-7 / (alpha * alpha + 1 - double(got.cosines.z) * double(got.cosines.z));
        EXPECT_NEAR(got.terms.x, d, d * (2e-5 + 4 * (cancellation - 1))) << got.cosines.z << " " << alpha;
        const double v = oracle::smithVisibility(got.cosines.x, got.cosines.y, alpha);
        EXPECT_NEAR(got.terms.y, v, v * 1e-4);
        const double f = oracle::schlick(got.surface.x, 1, got.cosines.w);
        EXPECT_NEAR(got.terms.z, f, 1e-5);
    }
}

TEST_F(BrdfTest, SplitSumIsTheIntegral) {
    std::vector<Item> list;
    for (const float NoV : {0.02f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f})
        for (const float roughness : {0.05f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f})
            list.push_back(item(NoV, 1, 1, 1, 0.04f, roughness));
    for (const Item& got : evaluate(list)) {
        const glm::dvec2 expected = oracle::splitSum(got.cosines.x, got.surface.z);
        EXPECT_NEAR(got.dfg.x, expected.x, 0.003) << "NoV " << got.cosines.x << ", roughness " << got.surface.z;
        EXPECT_NEAR(got.dfg.y, expected.y, 0.003) << "NoV " << got.cosines.x << ", roughness " << got.surface.z;
    }
}

} // namespace brdf_test
} // namespace glint::test
