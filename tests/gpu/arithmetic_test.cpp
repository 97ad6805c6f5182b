// How the device does the arithmetic that Vulkan leaves to it. Recorded for every device; where the shaders were
// rewritten to compute as GPUs may (gpu/embed/gpu_arithmetic.hpp, the build for sanitizers), they do.
#include "gpu/support/library_test.hpp"

#include <glm/gtc/packing.hpp>

#include <cmath>
#include <cstring>
#include <random>

namespace glint::test {
namespace arithmetic_test {

struct Operands {
    float x, y, z;
    float again[3] = {x, y, z};
    float one = 1;
};
struct Results {
    float mixed, fused, exact, quotient;
};

class ArithmeticTest : public GpuTest {
protected:
    void compute(const std::vector<Operands>& list) {
        const auto count = static_cast<uint32_t>(list.size());
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"arithmetic", 0, {}}));
        gpu::Buffer operands =
            must(gpu::uploadBuffer(gpu(), "test/operands", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
        gpu::Buffer results = must(gpu::Buffer::create(
            gpu(), {"test/results", list.size() * sizeof(Results),
                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::BufferHome::Device}));
        gpu::Image halves = must(gpu::Image::create(
            gpu(), {"test/halves", VK_FORMAT_R16G16B16A16_SFLOAT, count, 1, 1, 1, gpu::ImageShape::Flat,
                    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
        gpu::Buffer texels = must(gpu::Buffer::create(
            gpu(), {"test/texels", list.size() * 8, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline)
                .read("operands", operands)
                .write("results", results)
                .write("halves", halves)
                .dispatch(count);
            frame.copyToBuffer(halves, 0, 0, texels);
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), results));
        results_.resize(list.size());
        std::memcpy(results_.data(), bytes.data(), bytes.size());
        halves_.resize(list.size() * 4);
        std::memcpy(halves_.data(), texels.mapped(), list.size() * 8);
    }

    std::vector<Results> results_;
    std::vector<uint16_t> halves_;
};

TEST_F(ArithmeticTest, rewrittenShadersComputeAsGpusMay) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.5f, 2);
    std::vector<Operands> list = {{1e30f, 2, 1}}; // mix
    for (int i = 1; i < 1000; ++i) {
        const float x = unit(random);
        const float y = unit(random);
        list.push_back({x, y, -(x * y)}); // fused, the sum is what the product's rounding lost
    }
    compute(list);
    size_t fused = 0, below = 0, down = 0, up = 0;
    for (size_t i = 1; i < list.size(); ++i) {
        fused += results_[i].fused != 0;
        below += results_[i].quotient < 1;
        EXPECT_EQ(results_[i].exact, 0) << "not contracted, on any device";
        EXPECT_NEAR(results_[i].quotient, 1, 5e-7);
        const float x = list[i].x;
        const float stored = glm::unpackHalf1x16(halves_[i * 4]);
        EXPECT_LE(std::abs(stored - x), std::ldexp(x, -10));
        const bool nearest = glm::packHalf1x16(x) == halves_[i * 4];
        down += !nearest && stored < x;
        up += !nearest && stored > x;
    }
    RecordProperty("mixed", fmt::format("{}", results_[0].mixed));
    RecordProperty("fused", fmt::format("{} of {}", fused, list.size() - 1));
    RecordProperty("quotientsBelow1", fmt::format("{}", below));
    RecordProperty("halvesNotNearest", fmt::format("{} down, {} up", down, up));
    fmt::print(
        "mix(1e30, 2, 1) = {}; fused {}, x / x below 1 {}, halves rounded away from the nearest: {} down, {} up, of "
        "{}\n",
        results_[0].mixed, fused, below, down, up, list.size() - 1);
#ifdef GLINT_GPU_ARITHMETIC
    EXPECT_EQ(results_[0].mixed, 0);
    EXPECT_GT(below, 10u);
#endif
}

} // namespace arithmetic_test
} // namespace glint::test
