// screen.transparents: screen rays that meet the host's transparent surfaces.
#include "gpu/support/drawn_layer.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

namespace glint::test {
namespace transparent_trace_test {

constexpr uint32_t kWidth = 121;
constexpr uint32_t kHeight = 67;

/// A mirror floor before a red wall, and between them a green card that is a layer, not in the G-buffer.
class TransparentTraceTest : public LibraryTest {
protected:
    const Card card_ = {.low = {-0.6, 0.3}, .high = {0.6, 1.2}, .z = -1};
    const Card wall_ = {.z = -3};
    const SyntheticCamera camera_;

    SyntheticGBuffer g_ = SyntheticGBuffer::render(gpu(), litBy(floorAndWall(), {1, 0, 0}), camera_, kWidth, kHeight);
    DrawnLayer layer_ = DrawnLayer::draw(gpu(), layer(), camera_, kWidth, kHeight);

    LayerScene layer() const {
        return [card = card_](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<LayerSurface> {
            const std::optional<double> t = card.distance(origin, direction);
            if (!t)
                return std::nullopt;
            LayerSurface s;
            s.distance = *t;
            s.radiance = {0, 1, 0, 1};
            s.transmittance = glm::vec4(0);
            return s;
        };
    }

    static Settings settings(March march) {
        Settings settings = plainSettings(march);
        settings.screen.colorSource = ColorSource::Previous;
        settings.screen.transparents = true;
        return settings;
    }

    Reflections make(const Settings& settings) {
        ReflectionsDesc desc = {kWidth, kHeight, settings};
        desc.transparentLayers = desc.views = desc.statistics = true;
        Reflections made = must(Reflections::create(library(), desc));
        GBuffer gbuffer = g_.gbuffer;
        gbuffer.transparentDepth = layer_.layer.depth;
        must(made.setInputs(gbuffer));
        return made;
    }
    /// As many frames as it takes until one has a history: the images to read are cleared first, and that is known only
    /// when frames have been executed.
    static void drawFrames(Reflections& made, const SyntheticCamera& camera, const TransparentLayer& layer) {
        for (int i = 0; i < 3; ++i)
            run([&](VkCommandBuffer commands) {
                const HostImage picture = made.record(commands, camera.view(kWidth, kHeight));
                must(made.recordLayer(commands, layer, picture));
            });
    }
    /// A frame whose previous one shows the layer.
    Picture next(const Settings& settings) {
        Reflections made = make(settings);
        drawFrames(made, camera_, layer_.layer);
        return trace(made, camera_.view(kWidth, kHeight));
    }

    struct Counts {
        size_t card = 0; ///< pixels whose mirror ray hits the card where the camera sees it
        size_t cardGreen = 0;
        size_t wall = 0; ///< whose ray passes the card and hits the wall, by the card's border apart
        size_t wallRed = 0;
    };
    Counts count(const Picture& picture) const {
        Counts counts;
        for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
            const glm::dvec3 eye = camera_.originThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const glm::dvec3 d = camera_.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const auto seen = floorAndWall()(eye, d);
            if (!seen || seen->f0.x == 0)
                continue;
            const glm::dvec3 start = eye + d * seen->distance;
            const glm::dvec3 mirrored = {d.x, -d.y, d.z};
            Card larger = card_;
            larger.low -= 0.05;
            larger.high += 0.05;
            Card smaller = card_;
            smaller.low += 0.05;
            smaller.high -= 0.05;
            const glm::vec3 got(picture.reflection[i * 4], picture.reflection[i * 4 + 1],
                                picture.reflection[i * 4 + 2]);
            const auto shows = [&](const glm::dvec3& hit) {
                const glm::dvec2 px = camera_.project(hit, kWidth, kHeight);
                return px.x > 1 && px.y > 1 && px.x < kWidth - 1 && px.y < kHeight - 1;
            };
            if (const auto t = smaller.distance(start, mirrored); t && shows(start + mirrored * *t)) {
                ++counts.card;
                counts.cardGreen += glm::length(got - glm::vec3(0, 1, 0)) < 0.1f;
            } else if (const auto w = wall_.distance(start, mirrored);
                       w && !larger.distance(start, mirrored) && shows(start + mirrored * *w)) {
                ++counts.wall;
                counts.wallRed += glm::length(got - glm::vec3(1, 0, 0)) < 0.1f;
            }
        }
        return counts;
    }
};

TEST_F(TransparentTraceTest, mirrorsShowTransparentSurfaces) {
    for (const March march : {March::Hiz, March::Linear, March::Adaptive}) {
        SCOPED_TRACE(static_cast<int>(march));
        const Counts counts = count(next(settings(march)));
        EXPECT_GT(counts.card, 200u);
        EXPECT_GE(counts.cardGreen, counts.card * 98 / 100);
        EXPECT_GT(counts.wall, 500u);
        // Some of these see wall that the card hides from the camera: it is red all the same.
        EXPECT_GE(counts.wallRed, counts.wall * 98 / 100);
    }
}

/// The backs of transparent surfaces are prepared even where those of the others are read in place.
TEST_F(TransparentTraceTest, backFacesOfOneTexelAPixelAreThoseOfNine) {
    const auto withBacks = [&](uint32_t texels, bool deep) { // `texels` a side of a pixel
        const double back = deep ? 9 : 4.2;                  // metres: as deep as the scene, or hardly behind the card
        const std::vector<float> depth(size_t{kWidth} * texels * kHeight * texels,
                                       static_cast<float>(camera_.deviceDepth(back)));
        const gpu::Image image = uploadTestImage(gpu(), "test/backDepth", VK_FORMAT_R32_SFLOAT, kWidth * texels,
                                                 kHeight * texels, bytesOf(depth));
        Settings backs = settings(March::Hiz);
        backs.screen.thicknessMode = ThicknessMode::Backface;
        backs.screen.backfaceTransparents = true;
        Reflections made = make(backs);
        GBuffer gbuffer = g_.gbuffer;
        gbuffer.transparentDepth = layer_.layer.depth;
        gbuffer.backDepth = asHostImage(image);
        must(made.setInputs(gbuffer));
        drawFrames(made, camera_, layer_.layer);
        return trace(made, camera_.view(kWidth, kHeight));
    };
    const Picture deep = withBacks(1, true);
    EXPECT_EQ(deep.outcomeColor, withBacks(3, true).outcomeColor);
    EXPECT_EQ(deep.reflection, withBacks(3, true).reflection);
    EXPECT_NE(deep.outcomeColor, withBacks(1, false).outcomeColor) << "backs make no difference";
}

TEST_F(TransparentTraceTest, withoutItRaysPassThrough) {
    Settings off = settings(March::Hiz);
    off.screen.transparents = false;
    EXPECT_EQ(count(next(off)).cardGreen, 0u);
    EXPECT_GE(count(next(off)).wallRed, count(next(off)).wall * 98 / 100) << "the wall, not the layer before it";

    // Only the previous frame shows layers.
    Settings current = settings(March::Hiz);
    current.screen.colorSource = ColorSource::Current;
    EXPECT_EQ(count(next(current)).cardGreen, 0u);
    EXPECT_THAT(make(current).notes(), testing::Contains(testing::HasSubstr("screen.colorSource current")));
    EXPECT_THAT(make(settings(March::Hiz)).notes(), testing::Not(testing::Contains(testing::HasSubstr("transparent"))));
    Reflections blind = make(settings(March::Hiz));
    must(blind.setInputs(g_.gbuffer));
    EXPECT_THAT(blind.notes(), testing::Contains(testing::HasSubstr("no transparentDepth")));
    EXPECT_EQ(count(trace(blind, camera_.view(kWidth, kHeight))).cardGreen, 0u);
}

TEST_F(TransparentTraceTest, theFirstFrameAndFramesAfterACutHaveNone) {
    Reflections made = make(settings(March::Hiz));
    EXPECT_EQ(count(trace(made, camera_.view(kWidth, kHeight))).cardGreen, 0u);
    drawFrames(made, camera_, layer_.layer);
    EXPECT_GT(count(trace(made, camera_.view(kWidth, kHeight))).cardGreen, 200u);
    View cut = camera_.view(kWidth, kHeight);
    cut.cut = true;
    EXPECT_EQ(count(trace(made, cut)).cardGreen, 0u);
}

TEST_F(TransparentTraceTest, aDepthThatDoesNotFitIsSaid) {
    Reflections made = make(settings(March::Hiz));
    GBuffer gbuffer = g_.gbuffer;
    gbuffer.transparentDepth = layer_.layer.depth;
    gbuffer.transparentDepth.width /= 2;
    const Result<void> small = made.setInputs(gbuffer);
    ASSERT_FALSE(small);
    EXPECT_THAT(small.error().message,
                testing::AllOf(testing::HasSubstr("transparentDepth"), testing::HasSubstr("60x67")));
    gbuffer.transparentDepth = layer_.layer.depth;
    gbuffer.transparentDepth.samples = 4;
    const Result<void> many = made.setInputs(gbuffer);
    ASSERT_FALSE(many);
    EXPECT_THAT(many.error().message, testing::HasSubstr("transparentDepth"));
}

TEST_F(TransparentTraceTest, coloursAreFoundAgainWhenTheCameraMoves) {
    SyntheticCamera before = camera_;
    before.position += glm::dvec3(0.15, 0.05, 0.1);
    Reflections made = make(settings(March::Hiz));
    const SyntheticGBuffer first =
        SyntheticGBuffer::render(gpu(), litBy(floorAndWall(), {1, 0, 0}), before, kWidth, kHeight);
    const DrawnLayer layerBefore = DrawnLayer::draw(gpu(), layer(), before, kWidth, kHeight);
    GBuffer gbuffer = first.gbuffer;
    gbuffer.transparentDepth = layerBefore.layer.depth;
    must(made.setInputs(gbuffer));
    drawFrames(made, before, layerBefore.layer);
    gbuffer = g_.gbuffer;
    gbuffer.transparentDepth = layer_.layer.depth;
    must(made.setInputs(gbuffer));
    const Counts counts = count(trace(made, camera_.view(kWidth, kHeight)));
    EXPECT_GE(counts.cardGreen, counts.card * 95 / 100);
    EXPECT_GE(counts.wallRed, counts.wall * 95 / 100);
}

} // namespace transparent_trace_test
} // namespace glint::test
