// The host's back-face depth as the library converts it.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/prepare/frame_block.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <bit>

namespace glint::test {
namespace back_faces_test {

constexpr uint32_t kWidth = 32;
constexpr uint32_t kHeight = 18;

class BackFacesTest : public LibraryTest {
protected:
    static gpu::Image backDepth(const SyntheticCamera& camera, uint32_t width, uint32_t height) {
        std::vector<float> depth;
        for (uint32_t i = 0; i < width * height; ++i)
            depth.push_back(i % 3 == 0 ? 0.0f : static_cast<float>(camera.deviceDepth(2 + i * 0.01)));
        return uploadTestImage(gpu(), "test/backDepth", VK_FORMAT_R32_SFLOAT, width, height, bytesOf(depth));
    }
    static Settings backfaceSettings() {
        Settings settings = plainSettings();
        settings.screen.thicknessMode = ThicknessMode::Backface;
        return settings;
    }
};

TEST_F(BackFacesTest, MayHaveAnySizeAndComeAndGo) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight, backfaceSettings());
    GBuffer gbuffer = host.gbuffer;
    must(made.setInputs(gbuffer));
    const auto missing = [&] {
        return std::any_of(made.notes().begin(), made.notes().end(),
                           [](const std::string& note) { return note.starts_with("no backDepth"); });
    };
    EXPECT_TRUE(missing());
    trace(made, camera.view(kWidth, kHeight));
    for (const glm::uvec2 size : {glm::uvec2(kWidth, kHeight), glm::uvec2(1, 1), glm::uvec2(50, 3)}) {
        const gpu::Image back = backDepth(camera, size.x, size.y);
        gbuffer.backDepth = asHostImage(back);
        must(made.setInputs(gbuffer));
        EXPECT_FALSE(missing());
        trace(made, camera.view(kWidth, kHeight));
        must(made.setSettings(plainSettings()));
        trace(made, camera.view(kWidth, kHeight));
        must(made.setSettings(backfaceSettings()));
        trace(made, camera.view(kWidth, kHeight));
    }
    gbuffer.backDepth.width = 0;
    const Result<void> empty = made.setInputs(gbuffer);
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().message.find("backDepth"), std::string::npos);
    gbuffer.backDepth = {};
    must(made.setInputs(gbuffer));
    EXPECT_TRUE(missing());
    trace(made, camera.view(kWidth, kHeight));
    must(made.setSettings(plainSettings()));
    EXPECT_FALSE(missing());
}

/// An image with one texel per pixel is read in place. One with nine has the same in the middle of each, and is
/// prepared.
TEST_F(BackFacesTest, OneTexelAPixelSaysWhatThePreparedImageSays) {
    const SyntheticCamera camera;
    Stage stage = floorAndWall(); // rays pass behind the cards, or end in them
    for (int i = 0; i < 4; ++i)
        stage.cards.push_back({.low = {i - 2.0, 0.1}, .high = {i - 1.6, 0.8}, .z = -0.5 * i});
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), stage, camera, kWidth, kHeight);
    const auto backs = [&](uint32_t texels) { // as many a side of a pixel
        std::vector<float> depth;
        for (uint32_t y = 0; y < kHeight * texels; ++y)
            for (uint32_t x = 0; x < kWidth * texels; ++x) {
                const uint32_t pixel = y / texels * kWidth + x / texels;
                const bool known = pixel % 5 != 0;
                depth.push_back(known ? static_cast<float>(camera.deviceDepth(2 + pixel % 97 * 0.05)) : 0.0f);
            }
        return uploadTestImage(gpu(), "test/backDepth", VK_FORMAT_R32_SFLOAT, kWidth * texels, kHeight * texels,
                               bytesOf(depth));
    };
    const gpu::Image one = backs(1);
    const gpu::Image nine = backs(3);
    for (const March march : {March::Hiz, March::Linear, March::Adaptive})
        for (const bool half : {false, true}) {
            Settings settings = plainSettings(march);
            settings.screen.thicknessMode = ThicknessMode::Backface;
            settings.gbuffer.depthFormat = half ? DepthFormat::Half : DepthFormat::Float;
            const auto picture = [&](const gpu::Image* back) {
                Reflections made = reflections(kWidth, kHeight, settings);
                GBuffer gbuffer = host.gbuffer;
                if (back)
                    gbuffer.backDepth = asHostImage(*back);
                must(made.setInputs(gbuffer));
                return trace(made, camera.view(kWidth, kHeight));
            };
            const Picture inPlace = picture(&one);
            const Picture prepared = picture(&nine);
            const auto prepares = [](const Picture& of) {
                return std::ranges::count(of.passTimes, "prepare/back_faces", &PassTime::name);
            };
            EXPECT_EQ(prepares(inPlace), 0);
            EXPECT_EQ(prepares(prepared), 1);
            EXPECT_EQ(inPlace.hitUV, prepared.hitUV);
            EXPECT_EQ(inPlace.outcomeColor, prepared.outcomeColor);
            EXPECT_EQ(inPlace.lookups, prepared.lookups);
            EXPECT_NE(inPlace.outcomeColor, picture(nullptr).outcomeColor) << "back faces make no difference";
        }
}

/// shaders/prepare/back_faces alone. Depths are viewZ in metres; 0 is the background.
struct BackDepths {
    glm::ivec2 size = {};
    std::vector<float> viewZ;
    glm::ivec2 backSize = {};
    std::vector<float> backs;
    /// Coverage of a host with several samples a pixel; empty: one sample.
    std::vector<float> coverage;
    std::vector<float> secondZ; ///< the pixel's other surface; 0: the background
};

class PreparedBackFacesTest : public GpuTest {
protected:
    static std::vector<float> prepare(const BackDepths& in) {
        shared::FrameConstants constants = {};
        constants.size = in.size;
        constants.invSize = 1.0f / constants.size;
        constants.depthScale = 1;
        constants.flags = shared::kInputLinearDepth;
        if (!in.coverage.empty())
            constants.flags |= shared::kInputResolved | shared::kInputSamples;
        gpu::Buffer frameConstants =
            must(gpu::uploadBuffer(gpu(), "test/frame", std::vector{reflect::FrameBlockValues{constants, {}}},
                                   VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
        const auto image = [](const char* name, VkFormat format, glm::ivec2 size, const auto& texels) {
            return uploadTestImage(gpu(), name, format, static_cast<uint32_t>(size.x), static_cast<uint32_t>(size.y),
                                   bytesOf(texels));
        };
        std::vector<float> front = in.viewZ;
        for (float& z : front)
            z = z > 0 ? z : shared::kBackgroundZ;
        std::vector<glm::vec4> material(front.size(), glm::vec4(1));
        std::vector<glm::uvec4> second(front.size(), glm::uvec4(0));
        for (size_t i = 0; i < in.coverage.size(); ++i) {
            const bool shows = in.secondZ[i] > 0; // lib/edge.glsl: coverage and viewZ
            material[i].a = in.coverage[i];
            second[i].y = glm::packHalf2x16({0, shows ? 1 - in.coverage[i] : 0});
            second[i].z = std::bit_cast<uint32_t>(shows ? in.secondZ[i] : shared::kBackgroundZ);
        }
        gpu::Image viewZ = image("test/viewZ", VK_FORMAT_R32_SFLOAT, in.size, front);
        gpu::Image backs = image("test/backDepth", VK_FORMAT_R32_SFLOAT, in.backSize, in.backs);
        gpu::Image materials = image("test/material", VK_FORMAT_R32G32B32A32_SFLOAT, in.size, material);
        gpu::Image edge = image("test/edge", VK_FORMAT_R32G32B32A32_UINT, in.size, second);
        gpu::Image out = must(gpu::Image::create(
            gpu(), {"test/backViewZ", VK_FORMAT_R32_SFLOAT, static_cast<uint32_t>(in.size.x),
                    static_cast<uint32_t>(in.size.y), 1, 1, gpu::ImageShape::Flat,
                    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"prepare/back_faces", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline)
                .read("frame", frameConstants)
                .read("backDepth", backs)
                .read("viewZ", viewZ)
                .read("resolvedMaterial", materials)
                .read("edge", edge)
                .write("backViewZ", out)
                .dispatch(static_cast<uint32_t>(in.size.x), static_cast<uint32_t>(in.size.y));
        });
        std::vector<float> result;
        const std::vector<float> texels = must(gpu::downloadImageAsFloats(gpu(), out));
        for (size_t i = 0; i < texels.size(); i += 4)
            result.push_back(texels[i]);
        return result;
    }
};

constexpr float kUnknown = shared::kBackgroundZ;

TEST_F(PreparedBackFacesTest, aPixelsOwnTexelSpeaksForIt) {
    // A body, a sheet, an open surface (a back face before the front, or none), the background.
    const BackDepths in = {{5, 1}, {2, 2, 2, 2, 0}, {5, 1}, {2.5f, 1.999f, 1.5f, 0, 3}, {}, {}};
    EXPECT_EQ(prepare(in), (std::vector<float>{2.5f, 2, kUnknown, kUnknown, kUnknown}));
}

TEST_F(PreparedBackFacesTest, coarseTexelsSpeakForWhatTheyShow) {
    // A body from 2 to 2.5 m, to the left of an edge; to its right a wall from 6 to 7 m, a sheet without a back, or the
    // background.
    struct Right {
        float front, back;
    };
    const glm::ivec2 size = {37, 5};
    for (const Right right : {Right{6, 7}, Right{6, 0}, Right{0, 0}})
        for (const int divisor : {2, 3, 4, 9})
            for (int edge = 1; edge < size.x; ++edge) {
                BackDepths in;
                in.size = size;
                in.backSize = (size + divisor - 1) / divisor;
                for (int i = 0; i < size.x * size.y; ++i)
                    in.viewZ.push_back(i % size.x < edge ? 2 : right.front);
                for (int i = 0; i < in.backSize.x * in.backSize.y; ++i) {
                    const double x = (i % in.backSize.x + 0.5) / in.backSize.x * size.x;
                    in.backs.push_back(x < edge ? 2.5f : right.back);
                }
                const std::vector<float> back = prepare(in);
                int known = 0;
                for (int i = 0; i < size.x * size.y; ++i) {
                    const float own = i % size.x < edge ? 2.5f : right.back > 0 ? right.back : kUnknown;
                    const float found = back[static_cast<size_t>(i)];
                    ASSERT_TRUE(found == own || found == kUnknown)
                        << found << " at " << i % size.x << ", edge at " << edge << ", divisor " << divisor;
                    known += found == own;
                }
                if (edge > divisor && edge < size.x - divisor) {
                    EXPECT_EQ(known, size.x * size.y) << "edge at " << edge << ", divisor " << divisor;
                }
            }
}

TEST_F(PreparedBackFacesTest, atEdgesTheCentreDoesNotSpeakForTheSurface) {
    // Pixels of a body with the wall's back face at their centres: the pixel beside them knows the body's back. A wire
    // of one pixel has no such neighbour. Where two faces of one body share a pixel, its centre shows that body in any
    // case.
    const BackDepths in = {{7, 1},
                           {2, 2, 6, 6, 2, 6, 2},
                           {7, 1},
                           {2.5f, 7, 7, 7, 7, 7, 2.6f},
                           {1, 0.5f, 1, 1, 0.5f, 1, 0.5f},
                           {0, 6, 0, 0, 0, 0, 2.05f}};
    EXPECT_EQ(prepare(in), (std::vector<float>{2.5f, 2.5f, 7, 7, kUnknown, 7, 2.6f}));
}

} // namespace back_faces_test
} // namespace glint::test
