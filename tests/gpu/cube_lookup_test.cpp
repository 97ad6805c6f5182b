// The accuracy that Glint may expect of a driver's cube map fetches: lab/notes/subgroups.md.
#include "gpu/support/library_test.hpp"

#include <cstring>
#include <random>

namespace glint::test {
namespace cube_lookup_test {

class CubeLookupTest : public LibraryTest {
protected:
    static std::vector<glm::vec4> lookUp(gpu::Image& cube, const std::vector<glm::vec3>& directions) {
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"cube_lookups", 0, {}}));
        gpu::Buffer list =
            must(gpu::uploadBuffer(gpu(), "test/directions", directions, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
        gpu::Buffer found = must(gpu::Buffer::create(
            gpu(), {"test/found", directions.size() * sizeof(glm::vec4),
                    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::BufferHome::Device}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline)
                .read("cube", cube)
                .read("directions", list)
                .write("found", found)
                .dispatch(static_cast<uint32_t>(directions.size()));
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), found));
        std::vector<glm::vec4> colors(directions.size());
        std::memcpy(colors.data(), bytes.data(), bytes.size());
        return colors;
    }
};

/// For each group of 64: the lanes whose result changes once lane `kCornerLane` samples a corner of the cube.
TEST_F(CubeLookupTest, neighboursAtACornerMoveNoMoreThanTheLastBits) {
    constexpr uint32_t kLanes = 64;
    constexpr uint32_t kCornerLane = 21;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0, 1);
    TestEnvironment environment = TestEnvironment::make(
        gpu(), 8, 1, [&](const auto&, uint32_t) { return glm::vec3(unit(random), unit(random), unit(random)); });
    std::vector<glm::vec3> inner; // more than half a texel off the edges of their face
    for (uint32_t i = 0; i < 64 * kLanes; ++i)
        inner.push_back(glm::normalize(glm::vec3(1.5f * unit(random) - 0.75f, 1.5f * unit(random) - 0.75f, 1)));
    std::vector<glm::vec3> besideCorner = inner;
    for (uint32_t i = kCornerLane; i < besideCorner.size(); i += kLanes)
        besideCorner[i] = glm::normalize(glm::vec3(0.97f, 0.95f, 1)); // three texels meet, not four
    const std::vector<glm::vec4> alone = lookUp(environment.cube, inner);
    const std::vector<glm::vec4> beside = lookUp(environment.cube, besideCorner);
    std::string lanes(kLanes, '.');
    double worst = 0;
    for (uint32_t i = 0; i < inner.size(); ++i) {
        if (i % kLanes == kCornerLane)
            continue;
        if (std::memcmp(&alone[i], &beside[i], sizeof(glm::vec4)) != 0)
            lanes[i % kLanes] = 'x';
        for (int channel = 0; channel < 3; ++channel)
            worst = std::max(worst, std::abs(double(alone[i][channel]) - beside[i][channel]));
    }
    RecordProperty("lanesThatDiffer", lanes);
    RecordProperty("worst", std::to_string(worst * 0x1p24) + " * 2^-24");
    EXPECT_LT(worst, 0x1p-12) << "half of the last bit of a half float";
}

} // namespace cube_lookup_test
} // namespace glint::test
