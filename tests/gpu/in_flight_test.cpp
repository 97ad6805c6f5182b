// Several frames in flight; command buffers that are submitted late, in another order or never. A frame's image must
// not depend on when the frames before it ran, validation stays silent, and replaced objects are freed in time.
#include "gpu/memory.hpp"
#include "gpu/support/frames_in_flight.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <deque>

namespace glint::test {
namespace in_flight_test {

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 32;
constexpr uint32_t kInFlight = 3;

using Texels = std::vector<uint16_t>;

/// A glossy floor before a bright wall, with every source: screen with the previous frame's colours, rays, probes, sky.
class InFlightTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.3f));
        scene_.addQuad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, emitting({1, 0.5f, 0.25f}));
        environment_ = TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3& direction, uint32_t) {
            return glm::vec3(direction.x > 0 ? 1 : 0.1, direction.z > 0 ? 1 : 0.1, 0.5);
        });
        cube_ = TestEnvironment::make(gpu(), 16, 1, [](const auto&, uint32_t) { return glm::vec3(0.2f, 0.3f, 0.9f); });
        const SyntheticScene lit = SurfaceScene::seenBy(scene_);
        gbuffer_ = SyntheticGBuffer::render(gpu(), lit, camera_, kWidth, kHeight);
        const SyntheticScene dimmed = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto seen = lit(origin, direction);
            if (seen)
                seen->radiance *= 0.25f;
            return seen;
        };
        dimmed_ = SyntheticGBuffer::render(gpu(), dimmed, camera_, kWidth, kHeight);
    }

    static Settings settings() {
        Settings settings = plainSettings();
        settings.screen.colorSource = ColorSource::Previous;
        settings.rays.enabled = true;
        settings.probes.enabled = true;
        settings.reflect.maxRoughness = 1;
        return settings;
    }

    /// A library object and the objects that hosts record beside it.
    struct Host {
        SurfaceScene::World world;
        Probes probes;
        Reflections reflections;
    };

    Host makeHost(const Settings& settings, uint32_t framesInFlight = kInFlight) {
        SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Bvh);
        Probe probe;
        probe.cube = cube_.map.cube;
        probe.influence.halfExtents = probe.proxyVolume.halfExtents = {3, 3, 3};
        Probes probes = must(Probes::create(library(), {{&probe, 1}, 16}));
        ReflectionsDesc desc = {kWidth, kHeight, settings, true, true};
        desc.framesInFlight = framesInFlight;
        Host host = {std::move(world), std::move(probes), must(Reflections::create(library(), desc))};
        must(host.reflections.setInputs(gbuffer_.gbuffer, environment_.map));
        must(host.reflections.setRays(host.world.rays, host.world.surfaces));
        must(host.reflections.setProbes(host.probes));
        return host;
    }

    View view(uint32_t frame) const {
        SyntheticCamera camera = camera_;
        View view = camera.view(kWidth, kHeight);
        view.frameIndex = frame;
        return view;
    }

    /// Records a frame with all that a host records, and a snapshot of its image.
    Recording recordFrame(Host& host, uint32_t frame, Snapshot& picture) {
        must(host.reflections.setInputs((frame % 2 ? dimmed_ : gbuffer_).gbuffer, environment_.map)); // light blinks
        return Recording(gpu(), [&](VkCommandBuffer commands) {
            host.world.rays.record(commands);
            host.world.surfaces.record(commands);
            host.probes.record(commands);
            picture.record(commands, host.reflections.record(commands, view(frame)).image);
        });
    }

    static Settings changedAt(uint32_t frame, Settings settings) {
        settings.rays.accumulate = frame >= 4 && frame < 9;
        settings.rays.sampleLights = frame >= 2 && frame < 11;
        settings.screen.targetFormat = frame >= 6 ? TargetFormat::Rgba8 : TargetFormat::Rgba16f;
        settings.blur.strength = frame >= 7 ? 0.5f : 0;
        settings.denoise.enabled = frame == 3 || frame >= 10;
        return settings;
    }

    /// The images of twelve frames, with at most `depth` frames in flight; settings and the scene change between
    /// frames.
    std::vector<Texels> play(uint32_t depth) {
        Host host = makeHost(changedAt(0, settings()));
        std::deque<Recording> inFlight;
        std::deque<Snapshot> pictures;
        for (uint32_t frame = 0; frame < 12; ++frame) {
            if (inFlight.size() == depth) {
                inFlight.front().wait();
                inFlight.pop_front();
            }
            must(host.reflections.setSettings(changedAt(frame, settings())));
            if (frame == 5) // rebuilds that source's pipelines
                must(host.reflections.setRays(host.world.rays, host.world.surfaces));
            if (frame == 8)
                must(host.reflections.setProbes(host.probes));
            pictures.emplace_back(gpu(), kWidth, kHeight);
            inFlight.push_back(recordFrame(host, frame, pictures.back()));
            inFlight.back().submit();
        }
        inFlight.clear();
        std::vector<Texels> out;
        for (const Snapshot& picture : pictures)
            out.push_back(picture.texels());
        return out;
    }

    SurfaceScene scene_;
    TestEnvironment environment_;
    TestEnvironment cube_;
    SyntheticCamera camera_ = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
    SyntheticGBuffer gbuffer_;
    SyntheticGBuffer dimmed_; ///< in a quarter of the light
};

TEST_F(InFlightTest, TwoAndThreeFramesGiveTheBitsOfOne) {
    const std::vector<Texels> alone = play(1);
    EXPECT_NE(alone[2], alone[3]) << "the noise moves";
    for (uint32_t depth : {2u, 3u}) {
        const std::vector<Texels> several = play(depth);
        for (size_t frame = 0; frame < alone.size(); ++frame)
            EXPECT_EQ(several[frame], alone[frame]) << "frame " << frame << ", " << depth << " in flight";
    }
}

/// Without a history a frame is the same whatever frames came before it.
TEST_F(InFlightTest, WhatIsNeverSubmittedLeavesNoTrace) {
    Settings plain = settings();
    plain.screen.colorSource = ColorSource::Current;
    std::vector<Texels> wanted;
    {
        Host host = makeHost(plain);
        for (uint32_t frame = 0; frame < 6; ++frame) {
            Snapshot picture(gpu(), kWidth, kHeight);
            Recording recording = recordFrame(host, frame, picture);
            recording.submit();
            recording.wait();
            wanted.push_back(picture.texels());
        }
    }
    for (const uint32_t kept : {1u, 2u, 5u}) { // every such frame is submitted, the other frames are not
        Host host = makeHost(plain);
        for (uint32_t frame = 0; frame < 6; ++frame) {
            Snapshot picture(gpu(), kWidth, kHeight);
            Recording recording = recordFrame(host, frame, picture);
            if (frame % (kept + 1) != kept)
                continue;
            recording.submit();
            recording.wait();
            EXPECT_EQ(picture.texels(), wanted[frame]) << "frame " << frame << ", one of " << kept + 1;
        }
    }
}

TEST_F(InFlightTest, ADroppedFrameCostsItsHistoryAndNoMore) {
    Settings denoised = settings();
    denoised.screen.colorSource = ColorSource::Current;
    denoised.denoise.enabled = true;
    for (const Settings& kept : {settings(), denoised}) {
        const auto play = [&](std::vector<uint32_t> dropped) {
            Host host = makeHost(kept, 1);
            std::vector<Texels> pictures;
            for (uint32_t frame = 0; frame < 8; ++frame) {
                Snapshot picture(gpu(), kWidth, kHeight);
                Recording recording = recordFrame(host, frame, picture);
                const bool drop = std::ranges::find(dropped, frame) != dropped.end();
                if (!drop) {
                    recording.submit();
                    recording.wait();
                }
                pictures.push_back(drop ? Texels() : picture.texels());
            }
            return pictures;
        };
        const std::vector<Texels> whole = play({});
        const std::vector<Texels> missing = play({0, 4});
        const auto alone = [&](uint32_t frame) { // a first frame, without a history
            Host host = makeHost(kept, 1);
            Snapshot picture(gpu(), kWidth, kHeight);
            Recording recording = recordFrame(host, frame, picture);
            recording.submit();
            recording.wait();
            return picture.texels();
        };
        EXPECT_EQ(whole[0], alone(0));
        EXPECT_EQ(missing[1], alone(1));
        EXPECT_EQ(missing[5], alone(5)) << "the frame before was not drawn";
        EXPECT_NE(whole[5], alone(5));
        EXPECT_NE(missing[7], alone(7)) << "and then there is a history again";
    }
}

TEST_F(InFlightTest, SubmittedInAnotherOrder) {
    Settings plain = settings();
    plain.screen.colorSource = ColorSource::Current;
    const auto play = [&](const std::vector<uint32_t>& order) {
        Host host = makeHost(plain);
        std::deque<Snapshot> pictures;
        std::deque<Recording> recordings;
        for (uint32_t frame = 0; frame < 3; ++frame) {
            pictures.emplace_back(gpu(), kWidth, kHeight);
            recordings.push_back(recordFrame(host, frame, pictures.back()));
        }
        for (const uint32_t frame : order)
            recordings[frame].submit();
        recordings.clear();
        std::vector<Texels> out;
        for (const Snapshot& picture : pictures)
            out.push_back(picture.texels());
        return out;
    };
    const std::vector<Texels> straight = play({0, 1, 2});
    EXPECT_EQ(play({2, 1, 0}), straight);
    EXPECT_EQ(play({1, 2, 0}), straight);
}

TEST_F(InFlightTest, ViewsOfADroppedRecordingAreDrawnAgain) {
    Settings off = plainSettings();
    off.screen.enabled = false;
    Reflections made = reflections(kWidth, kHeight, off); // no work: views are prepared on request
    must(made.setInputs(gbuffer_.gbuffer));
    run([&](VkCommandBuffer commands) { made.record(commands, view(0)); });
    {
        Recording dropped(gpu(), [&](VkCommandBuffer commands) { must(made.recordView(commands, "depth")); });
    }
    HostImage depth;
    run([&](VkCommandBuffer commands) { depth = must(made.recordView(commands, "depth")); });
    const std::vector<float> texels = download(gpu(), depth);
    EXPECT_NEAR(texels[(size_t{kHeight - 1} * kWidth + kWidth / 2) * 4], 2, 1.5) << "the floor before the camera";
}

TEST_F(InFlightTest, WhatWasReplacedIsFreedInTime) {
    Settings without = settings();
    Settings with = without;
    with.rays.accumulate = true;
    Host host = makeHost(with);
    const auto frame = [&](uint32_t number) {
        run([&](VkCommandBuffer commands) {
            host.world.rays.record(commands);
            host.world.surfaces.record(commands);
            host.probes.record(commands);
            View here = view(number);
            here.frameNumber = number;
            host.reflections.record(commands, here);
        });
    };
    const auto bytes = [] { return gpu::allocatedBytes(library().gpu().allocator()); };
    frame(1);
    must(host.reflections.setSettings(without));
    const size_t before = bytes();
    frame(2);
    frame(3);
    EXPECT_EQ(bytes(), before) << "frame 1 may still be in flight";
    frame(4);
    EXPECT_LT(bytes(), before - kWidth * kHeight * 16) << "sums of 20 bytes a pixel";
    for (uint32_t toggle = 0; toggle < 40; ++toggle) {
        must(host.reflections.setSettings(toggle % 2 ? without : with));
        frame(5 + toggle);
    }
    for (uint32_t number = 45; number < 48; ++number)
        frame(number);
    EXPECT_LT(bytes(), before - kWidth * kHeight * 16);
}

} // namespace in_flight_test
} // namespace glint::test
