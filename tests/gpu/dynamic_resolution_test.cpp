// The extent in use changes from frame to frame (View::width, height): each frame is that of images of its size, and
// histories continue. And Reflections::resize.
#include "gpu/support/frames_in_flight.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/surface_scene.hpp"

#include <gmock/gmock.h>

#include <list>

namespace glint::test {
namespace dynamic_resolution_test {

using testing::HasSubstr;

constexpr glm::uvec2 kWhole = {112, 72};
/// From 50 to 100 %, up and down, odd and even.
constexpr glm::uvec2 kExtents[] = {{112, 72}, {56, 36}, {81, 53}, {112, 72}, {97, 61}, {60, 40}, {105, 71}};

class DynamicResolutionTest : public LibraryTest {
protected:
    /// A host's images for one frame.
    struct Host {
        std::list<gpu::Image> images;
        GBuffer gbuffer;
    };

    /// The image in the top left of a whole one; the rest is what such a host has there, anything.
    static HostImage within(Host& host, const HostImage& part, float rest) {
        const std::vector<float> texels = download(gpu(), part);
        std::vector<glm::vec4> whole(size_t{kWhole.x} * kWhole.y, glm::vec4(rest));
        for (uint32_t y = 0; y < part.height; ++y)
            for (uint32_t x = 0; x < part.width; ++x) {
                const float* texel = &texels[(size_t{y} * part.width + x) * 4];
                whole[size_t{y} * kWhole.x + x] = {texel[0], texel[1], texel[2], texel[3]};
            }
        return asHostImage(host.images.emplace_back(
            uploadTestImage(gpu(), "test/whole", VK_FORMAT_R32G32B32A32_SFLOAT, kWhole.x, kWhole.y, bytesOf(whole))));
    }
    /// The frame at this extent: in images of that size, and in the top left of whole ones.
    struct Drawn {
        Host alone;
        Host whole;
    };
    static Drawn draw(const SyntheticScene& scene, const SyntheticCamera& camera, glm::uvec2 extent) {
        Drawn drawn;
        SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), scene, camera, extent.x, extent.y);
        SyntheticGBuffer back = SyntheticGBuffer::render(gpu(), behind(scene), camera, extent.x, extent.y);
        drawn.alone.gbuffer = g.gbuffer;
        drawn.alone.gbuffer.backDepth = back.gbuffer.depth;
        drawn.whole.gbuffer.depth = within(drawn.whole, g.gbuffer.depth, 0.9f); // a surface close to the eye
        drawn.whole.gbuffer.normal = within(drawn.whole, g.gbuffer.normal, 0.3f);
        drawn.whole.gbuffer.material = within(drawn.whole, g.gbuffer.material, 0.7f);
        drawn.whole.gbuffer.litRadiance = within(drawn.whole, g.gbuffer.litRadiance, 999);
        drawn.whole.gbuffer.backDepth = within(drawn.whole, back.gbuffer.depth, 0.8f);
        for (gpu::Image* image : {&g.depth, &g.normal, &g.material, &g.litRadiance, &back.depth})
            drawn.alone.images.push_back(std::move(*image));
        return drawn;
    }
    /// A hand's breadth behind every surface.
    static SyntheticScene behind(const SyntheticScene& scene) {
        return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto hit = scene(origin, direction);
            if (hit)
                hit->distance += 0.1;
            return hit;
        };
    }
    static Reflections make(glm::uvec2 size, const Settings& settings) { return reflections(size.x, size.y, settings); }
    static View viewOf(const SyntheticCamera& camera, glm::uvec2 extent, uint32_t frame) {
        View view = camera.view(extent.x, extent.y);
        view.frameIndex = frame;
        view.width = extent.x;
        view.height = extent.y;
        return view;
    }
    /// The image's top left.
    static std::vector<float> used(const HostImage& image, glm::uvec2 extent) {
        const std::vector<float> whole = download(gpu(), image);
        std::vector<float> part;
        for (uint32_t y = 0; y < extent.y; ++y)
            part.insert(part.end(), whole.begin() + std::ptrdiff_t(y) * image.width * 4,
                        whole.begin() + (std::ptrdiff_t(y) * image.width + extent.x) * 4);
        return part;
    }
    static void expectSame(const std::vector<float>& found, const std::vector<float>& wanted, double tolerance) {
        ASSERT_EQ(found.size(), wanted.size());
        double most = 0;
        for (size_t i = 0; i < wanted.size(); ++i)
            most = std::max(most, std::abs(double(found[i]) - wanted[i]));
        EXPECT_LE(most, tolerance);
    }
    static HostImage record(Reflections& made, const View& view) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = made.record(commands, view); });
        return image;
    }
    static HostImage show(Reflections& made, const char* name) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = must(made.recordView(commands, name)); });
        return image;
    }

    SyntheticCamera camera_;
};

std::vector<std::pair<const char*, Settings>> withoutHistory() {
    std::vector<std::pair<const char*, Settings>> all;
    const auto add = [&](const char* name, auto change) {
        Settings settings;
        settings.fade.border = FadeBorder::None_;
        settings.denoise.enabled = false;
        settings.rough.cones = false;
        change(settings);
        all.emplace_back(name, settings);
    };
    add("hiz", [](Settings&) {});
    add("cones", [](Settings& s) { s.rough.cones = true; });
    add("linear", [](Settings& s) { s.screen.march = March::Linear; });
    add("adaptive", [](Settings& s) { s.screen.march = March::Adaptive; });
    add("back faces", [](Settings& s) { s.screen.thicknessMode = ThicknessMode::Backface; });
    add("three quarters of the rays", [](Settings& s) { s.screen.resolutionScale = 0.75f; });
    add("blur", [](Settings& s) {
        s.screen.resolutionScale = 0.5f;
        s.blur.strength = 0.3f;
        s.blur.downsample = 1;
    });
    add("rays", [](Settings& s) {
        s.rays.enabled = true;
        s.reflect.maxRoughness = 1;
    });
    return all;
}

TEST_F(DynamicResolutionTest, EachFrameIsThatOfImagesOfItsSize) {
    SurfaceScene scene;
    scene.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.2f));
    scene.addQuad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, emitting({1, 0.5f, 0.25f}));
    const SyntheticScene lit = SurfaceScene::seenBy(scene);
    SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
    run([&](VkCommandBuffer commands) {
        world.rays.record(commands);
        world.surfaces.record(commands);
    });
    camera_ = {.position = {0.3, 1, 4}, .target = {0, 0.3, 0}};
    for (const auto& [name, settings] : withoutHistory()) {
        // Places in an image are rounded, as fractions of its size, and filters' weights have eight bits or more.
        const double tolerance = settings.rough.cones ? 1.0 / 128 : 0;
        Reflections dynamic = make(kWhole, settings);
        if (settings.rays.enabled)
            must(dynamic.setRays(world.rays, world.surfaces));
        uint32_t frame = 0;
        for (const glm::uvec2 extent : kExtents) {
            SCOPED_TRACE(fmt::format("{}, {}x{}", name, extent.x, extent.y));
            const Drawn drawn = draw(lit, camera_, extent);
            Reflections alone = make(extent, settings);
            if (settings.rays.enabled)
                must(alone.setRays(world.rays, world.surfaces));
            must(alone.setInputs(drawn.alone.gbuffer));
            must(dynamic.setInputs(drawn.whole.gbuffer));
            const View view = viewOf(camera_, extent, ++frame);
            const std::vector<float> wanted = download(gpu(), record(alone, view));
            expectSame(used(record(dynamic, view), extent), wanted, tolerance);
            EXPECT_EQ(dynamic.statistics().rays, alone.statistics().rays);
            EXPECT_EQ(dynamic.statistics().scene.rays, alone.statistics().scene.rays);
            EXPECT_GT(alone.statistics().rays,
                      extent.x * extent.y / 20); // of a quarter of the pixels, at half resolution
            for (const char* shown : {"reflection", "outcome", "hitUV"}) {
                SCOPED_TRACE(shown);
                expectSame(used(show(dynamic, shown), extent), download(gpu(), show(alone, shown)), tolerance);
            }
        }
    }
}

/// As a host ships: without views and statistics passes store less, in images that other extents have used.
TEST_F(DynamicResolutionTest, EachFrameIsThatOfImagesOfItsSizeWithoutViews) {
    const auto makeBare = [](glm::uvec2 size) {
        Settings settings = plainSettings();
        settings.reflect.threshold = 0.5f; // the wall sends no rays
        ReflectionsDesc desc = {size.x, size.y, settings};
        desc.framesInFlight = 1;
        return must(Reflections::create(library(), desc));
    };
    Reflections dynamic = makeBare(kWhole);
    uint32_t frame = 0;
    for (const glm::uvec2 extent : kExtents) {
        SCOPED_TRACE(fmt::format("{}x{}", extent.x, extent.y));
        camera_.position.x = 0.1 * ++frame;
        const Drawn drawn = draw(floorAndWall(), camera_, extent);
        Reflections alone = makeBare(extent);
        must(alone.setInputs(drawn.alone.gbuffer));
        must(dynamic.setInputs(drawn.whole.gbuffer));
        const View view = viewOf(camera_, extent, frame);
        const std::vector<float> wanted = download(gpu(), record(alone, view));
        EXPECT_EQ(used(record(dynamic, view), extent), wanted);
        EXPECT_NE(wanted, download(gpu(), drawn.alone.gbuffer.litRadiance));
    }
}

TEST_F(DynamicResolutionTest, PreviousColoursAreThoseOfThePreviousExtent) {
    // The light changes from frame to frame, so that a reflection shows which frame it comes from; and where.
    const auto colored = [](float red) {
        return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto hit = floorAndWall()(origin, direction);
            if (hit && hit->f0.x == 0)
                hit->radiance.z = red;
            return hit;
        };
    };
    Settings settings = plainSettings();
    settings.screen.colorSource = ColorSource::Previous;
    Reflections made = make(kWhole, settings);
    uint32_t frame = 0;
    for (const glm::uvec2 extent : kExtents) {
        SCOPED_TRACE(fmt::format("frame {}, {}x{}", frame, extent.x, extent.y));
        camera_.position.x = 0.02 * frame;
        const Drawn drawn = draw(colored(float(frame)), camera_, extent);
        must(made.setInputs(drawn.whole.gbuffer));
        record(made, viewOf(camera_, extent, frame));
        const std::vector<float> reflection = used(show(made, "reflection"), extent);
        const std::vector<float> outcome = used(show(made, "outcome"), extent);
        size_t hits = 0;
        size_t fromBefore = 0;
        for (uint32_t i = 0; i < extent.x * extent.y; ++i) {
            if (!(outcome[i * 4] == 0 && outcome[i * 4 + 1] > 0 && outcome[i * 4 + 2] == 0)) // green: hit
                continue;
            // Where the mirror ray meets the wall; its colour is its place (scenes.hpp).
            const glm::dvec3 ray = camera_.rayThrough(i % extent.x, i / extent.x, extent.x, extent.y);
            const glm::dvec3 floor = camera_.position - ray * (camera_.position.y / ray.y);
            const glm::dvec3 mirrored = {ray.x, -ray.y, ray.z};
            const glm::dvec3 wall = floor + mirrored * ((-3 - floor.z) / mirrored.z);
            ++hits;
            const bool place = std::abs(reflection[i * 4] - (wall.x + 10)) < 0.15 &&
                               std::abs(reflection[i * 4 + 1] - (wall.y + 10)) < 0.15; // two pixels of the coarsest
            fromBefore += place && std::abs(reflection[i * 4 + 2] - (float(frame) - 1)) < 0.01; // resampling rounds
        }
        EXPECT_GT(hits, extent.x * extent.y / 10);
        if (frame > 0) {
            EXPECT_GT(fromBefore, hits * 9 / 10);
        }
        ++frame;
    }
}

TEST_F(DynamicResolutionTest, TheDenoisersMeansGrowOverChangingExtents) {
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.5f;
    Settings settings = plainSettings();
    settings.denoise.enabled = true;
    settings.reflect.maxRoughness = settings.reflect.roughnessFadeStart = 1;
    const auto meanFrames = [&](bool changes) {
        Reflections made = make(kWhole, settings);
        double mean = 0;
        for (uint32_t frame = 0; frame < 9; ++frame) {
            const glm::uvec2 extent = changes ? kExtents[frame % std::size(kExtents)] : kWhole;
            const Drawn drawn = draw(stage, camera_, extent);
            must(made.setInputs(drawn.whole.gbuffer));
            record(made, viewOf(camera_, extent, frame));
            const std::vector<float> meta = used(show(made, "denoise/accumulate:meta"), extent);
            double sum = 0;
            size_t pixels = 0;
            for (size_t i = 0; i < meta.size(); i += 4)
                if (meta[i] > 0) {
                    sum += meta[i];
                    ++pixels;
                }
            mean = sum / static_cast<double>(pixels);
            EXPECT_GT(pixels, extent.x * extent.y / 4);
        }
        return mean;
    };
    const double still = meanFrames(false);
    EXPECT_NEAR(still, 9, 0.5) << "nothing moves, so every frame counts";
    EXPECT_GT(meanFrames(true), 0.8 * still);
}

TEST_F(DynamicResolutionTest, AnExtentBeyondTheImagesIsANote) {
    Reflections made = make(kWhole, plainSettings());
    const Drawn drawn = draw(floorAndWall(), camera_, kWhole);
    must(made.setInputs(drawn.whole.gbuffer));
    const HostImage image = record(made, viewOf(camera_, {kWhole.x + 1, kWhole.y}, 0));
    EXPECT_EQ(image.image, drawn.whole.gbuffer.litRadiance.image);
    EXPECT_THAT(made.notes(), testing::Contains(HasSubstr("113x72 pixels of images of 112x72")));
}

// ---------------------------------------------------------------- resize

TEST_F(DynamicResolutionTest, ResizeKeepsPipelinesAndFramesInFlight) {
    Settings settings = plainSettings();
    settings.screen.colorSource = ColorSource::Previous;
    ReflectionsDesc desc = {kWhole.x, kWhole.y, settings};
    desc.framesInFlight = 2;
    Reflections made = must(Reflections::create(library(), desc));
    std::list<Drawn> drawn; // until the end: frames are in flight
    std::list<Recording> inFlight;
    const size_t pipelines = library().gpu().pipelines().size();
    uint32_t frame = 0;
    for (const glm::uvec2 size : kExtents) {
        drawn.push_back(draw(floorAndWall(), camera_, size));
        must(made.resize(size.x, size.y));
        EXPECT_EQ(made.record(VK_NULL_HANDLE, {}).image, VkImage(VK_NULL_HANDLE)) << "no inputs of that size yet";
        must(made.setInputs(drawn.back().alone.gbuffer));
        HostImage image;
        if (inFlight.size() == 2) {
            inFlight.front().wait();
            inFlight.pop_front();
        }
        inFlight.emplace_back(
            gpu(), [&](VkCommandBuffer commands) { image = made.record(commands, viewOf(camera_, size, ++frame)); });
        inFlight.back().submit();
        EXPECT_EQ(glm::uvec2(image.width, image.height), size);
    }
    EXPECT_EQ(library().gpu().pipelines().size(), pipelines);
    inFlight.clear(); // waits

    // The next frame at the last size is that of an object of its own.
    const glm::uvec2 size = kExtents[std::size(kExtents) - 1];
    must(made.resize(size.x, size.y));
    must(made.setInputs(drawn.back().alone.gbuffer));
    Reflections alone = make(size, settings);
    must(alone.setInputs(drawn.back().alone.gbuffer));
    EXPECT_EQ(download(gpu(), record(made, viewOf(camera_, size, 9))),
              download(gpu(), record(alone, viewOf(camera_, size, 9))));
    const Result<void> wrong = made.resize(0, 5);
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().message, HasSubstr("0x5"));
}

} // namespace dynamic_resolution_test
} // namespace glint::test
