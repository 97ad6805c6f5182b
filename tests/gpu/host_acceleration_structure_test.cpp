// RayScene::adopt: a host's own top level gives the pictures that its triangles give, and nothing else changes.
#include "gpu/support/frames_in_flight.hpp"
#include "gpu/support/host_shading.hpp"
#include "gpu/support/host_structures.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>

namespace glint::test {
namespace host_acceleration_structure_test {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 48;
constexpr uint32_t kTurned = 3;   ///< shows rays its back, which they pass
constexpr uint32_t kCard = 4;     ///< the instance that moves, and its mesh, which deforms
constexpr uint32_t kVeil = 6;     ///< covers half of what is behind it
constexpr uint32_t kMirrored = 8; ///< the second one of its mesh
constexpr uint32_t kFrames = 8;
constexpr uint8_t kRareMask = 2; ///< of kMirrored

class HostAccelerationStructureTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        if (!gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
        makeScene();
        gbuffer_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
        environment_ = TestEnvironment::make(gpu(), 8, 4, [](const glm::dvec3& direction, uint32_t) {
            return glm::vec3(0.1f + 0.05f * static_cast<float>(direction.y));
        });
    }

    /// A mirror floor that shows surfaces of every kind.
    void makeScene() {
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -9}, whiteMetal(0.05f));
        scene_.addQuad({-4, 0, -5}, {8, 0, 0}, {0, 5, 0}, emitting({0.2f, 0.4f, 0.6f}));
        // Of one side: from the front, then from the back, where rays pass.
        scene_.addQuad({-2.6f, 0.4f, -2}, {0.8f, 0, 0}, {0, 0.8f, 0}, emitting({1, 0.3f, 0.1f}));
        scene_.addQuad({-0.9f, 0.5f, -1.8f}, {-0.8f, 0, 0}, {0, 0.8f, 0}, emitting({5, 5, 5}));
        scene_.addQuad({-0.5f, 0.6f, -2.2f}, {0.7f, 0, 0}, {0, 0.7f, 0}, emitting({0.1f, 1.5f, 0.2f}));
        SurfaceMaterial leaf = emitting({0.9f, 0.9f, 0.1f});
        leaf.alpha = SurfaceAlpha::Mask;
        scene_.addQuad({0.4f, 0.5f, -1.9f}, {0.9f, 0, 0}, {0, 0.9f, 0}, leaf);
        SurfaceMaterial veil = emitting({0.3f, 0, 0.5f});
        veil.alpha = SurfaceAlpha::Blend;
        veil.baseColorFactor[3] = 0.5f;
        scene_.addQuad({-0.3f, 0.2f, -1.5f}, {0.8f, 0, 0}, {0, 0.7f, 0}, veil);
        SurfaceMaterial glass = whiteMetal(0);
        glass.metallicFactor = 0;
        glass.baseColorFactor = {0.3f, 0.9f, 0.9f, 1};
        glass.transmissionFactor = 1;
        scene_.addQuad({1.5f, 0.2f, -1.6f}, {0.8f, 0, 0}, {0, 1.2f, 0}, glass);
        TestScene& triangles = scene_.triangles;
        for (glm::vec3 corner : triangles.meshes[5].positions) // holes on one side
            triangles.meshes[5].colors.emplace_back(1, 1, 1, corner.x > 0.8f ? 1 : 0);
        triangles.instances[2].doubleSided = triangles.instances[3].doubleSided = false;
        triangles.meshes[kCard].deforms = true;
        // The first card again, turned to a mirror image.
        RayInstance mirrored = triangles.instances[2];
        mirrored.localToWorld = toMatrix4(glm::dmat4(-1.5, 0, 0, 0, 0, 1.2, 0, 0, 0, 0, 1, 0, -1.5, 0, -0.5, 1));
        mirrored.mask = kRareMask;
        mirrored.doubleSided = true;
        triangles.instances.push_back(mirrored);
        scene_.materials.push_back(emitting({0.7f, 0.7f, 1.4f}));
    }

    static Settings raySettings() {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.samples = 2;
        settings.rays.bounces = 2;
        settings.reflect.maxRoughness = 1;
        return settings;
    }

    uint32_t instanceCount() const { return static_cast<uint32_t>(scene_.triangles.instances.size()); }
    HostAccelerationStructure declared(const RayTracingHost& host, size_t top,
                                       InstanceNumbering numbering = InstanceNumbering::TopLevelIndex) const {
        return {.topLevel = host.top(top), .instanceCount = instanceCount(), .numbering = numbering};
    }

    Picture look(RayScene& rays, SurfaceTable& surfaces, const Settings& settings) {
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(gbuffer_.gbuffer, environment_.map));
        must(made.setRays(rays, surfaces));
        run([&](VkCommandBuffer commands) {
            rays.record(commands);
            surfaces.record(commands);
        });
        return trace(made, camera_.view(kWidth, kHeight));
    }
    Picture look(SurfaceTable& surfaces, const HostAccelerationStructure& host, const Settings& settings) {
        RayScene rays = must(RayScene::adopt(library(), host));
        EXPECT_EQ(rays.backend(), RayBackend::Query);
        return look(rays, surfaces, settings);
    }

    static void expectSame(const Picture& a, const Picture& b) {
        EXPECT_EQ(a.composite, b.composite);
        EXPECT_EQ(a.reflection, b.reflection);
        EXPECT_EQ(a.weight, b.weight);
        EXPECT_EQ(a.hitDistance, b.hitDistance);
        EXPECT_EQ(a.lookups, b.lookups);
        EXPECT_EQ(a.outcomeColor, b.outcomeColor);
        EXPECT_EQ(a.statistics.scene.rays, b.statistics.scene.rays);
    }

    /// Frames in which the card moves. `depth` frames are in flight, each with a top level of its own; 0: one frame of
    /// Glint's own scene.
    std::vector<std::vector<uint16_t>> play(uint32_t depth, const Settings& settings,
                                            InstanceNumbering numbering = InstanceNumbering::TopLevelIndex) {
        const auto listed =
            numbering == InstanceNumbering::CustomIndex ? RayTracingHost::reversed : RayTracingHost::inOrder;
        SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
        RayTracingHost host(gpu(), scene_.triangles);
        for (uint32_t i = 0; i < depth; ++i)
            host.addTop(listed(scene_.triangles.instances));
        std::optional<RayScene> adopted;
        if (depth > 0) {
            run([&](VkCommandBuffer commands) { host.buildBottoms(commands); });
            adopted = must(RayScene::adopt(library(), declared(host, 0, numbering)));
        }
        RayScene& rays = adopted ? *adopted : world.rays;
        ReflectionsDesc desc = {kWidth, kHeight, settings, true, true};
        desc.framesInFlight = 3;
        Reflections made = must(Reflections::create(library(), desc));
        must(made.setInputs(gbuffer_.gbuffer, environment_.map));
        must(made.setRays(rays, world.surfaces));
        std::deque<Recording> inFlight;
        std::deque<Snapshot> pictures;
        for (uint32_t frame = 0; frame < kFrames; ++frame) {
            if (inFlight.size() == std::max(depth, 1u)) {
                inFlight.front().wait();
                inFlight.pop_front();
            }
            std::vector<RayInstance> instances = scene_.triangles.instances;
            instances[kCard].localToWorld[13] = 0.1f * static_cast<float>(frame);
            std::vector<SurfaceInstance> surfaces;
            for (uint32_t i = 0; i < instances.size(); ++i)
                surfaces.push_back({instances[i].mesh, i, instances[i].localToWorld});
            must(world.surfaces.setInstances(surfaces));
            if (depth > 0) {
                host.setInstances(frame % depth, listed(instances));
                must(rays.setAccelerationStructure(declared(host, frame % depth, numbering)));
            } else {
                must(rays.setInstances(instances));
            }
            Snapshot& picture = pictures.emplace_back(gpu(), kWidth, kHeight);
            View view = camera_.view(kWidth, kHeight);
            view.frameIndex = frame;
            inFlight.emplace_back(gpu(), [&](VkCommandBuffer commands) {
                if (depth > 0)
                    host.buildTop(commands, frame % depth);
                rays.record(commands);
                world.surfaces.record(commands);
                picture.record(commands, made.record(commands, view).image);
            });
            inFlight.back().submit();
        }
        inFlight.clear();
        std::vector<std::vector<uint16_t>> out;
        for (const Snapshot& picture : pictures)
            out.push_back(picture.texels());
        return out;
    }

    SurfaceScene scene_;
    SyntheticCamera camera_ = {.position = {0, 1.1, 2.5}, .target = {0, 0.1, -1}};
    SyntheticGBuffer gbuffer_;
    TestEnvironment environment_;
};

/// The mask of each instance in turn is 0: every kind of surface is in the picture, and the host's masks count.
TEST_F(HostAccelerationStructureTest, ShowsWhatTheTrianglesShow) {
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    const Picture own = look(world.rays, world.surfaces, raySettings());
    EXPECT_GT(own.counted("hit"), 500u);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    for (uint32_t i = 1; i < instanceCount(); ++i) {
        std::vector<RayInstance> fewer = scene_.triangles.instances;
        fewer[i].mask = 0;
        host.addTop(RayTracingHost::inOrder(fewer));
    }
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    expectSame(look(world.surfaces, declared(host, 0), raySettings()), own);
    for (uint32_t i = 1; i < instanceCount(); ++i) {
        const bool same = look(world.surfaces, declared(host, i), raySettings()).composite == own.composite;
        EXPECT_EQ(same, i == kTurned) << "without instance " << i;
    }
}

TEST_F(HostAccelerationStructureTest, MasksAndHolesFollowTheSettings) {
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    const Picture whole = look(world.rays, world.surfaces, raySettings());
    Settings masked = raySettings();
    masked.rays.cullMask = 0xff - kRareMask;
    Settings solid = raySettings();
    solid.rays.alphaTest = false;
    solid.rays.transparents = 0;
    Settings mirrors = raySettings();
    mirrors.rays.lobe = RayLobe::Mirror;
    for (const Settings& settings : {masked, solid, mirrors}) {
        const Picture own = look(world.rays, world.surfaces, settings);
        EXPECT_NE(own.composite, whole.composite);
        expectSame(look(world.surfaces, declared(host, 0), settings), own);
    }
}

TEST_F(HostAccelerationStructureTest, CustomIndicesNumberInstancesInAnyOrder) {
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::reversed(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    const Picture own = look(world.rays, world.surfaces, raySettings());
    EXPECT_NE(look(world.surfaces, declared(host, 0), raySettings()).composite, own.composite) << "in their order";
    expectSame(look(world.surfaces, declared(host, 0, InstanceNumbering::CustomIndex), raySettings()), own);
}

/// Three bottom levels of several geometries, whose opacity is theirs, not their instances'.
TEST_F(HostAccelerationStructureTest, GeometriesAreNumberedFromTheCustomIndexOn) {
    scene_.triangles.instances.pop_back(); // the mesh that has two instances
    scene_.materials.pop_back();
    scene_.triangles.instances[2].doubleSided = scene_.triangles.instances[3].doubleSided = true; // as all
    scene_.triangles.meshes[kCard].deforms = false;
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    std::vector<std::vector<RayTracingHost::Geometry>> bottoms;
    std::vector<RayTracingHost::Instance> instances;
    uint32_t first = 0;
    for (const uint32_t count : {2u, 1u, 5u}) {
        std::vector<RayTracingHost::Geometry>& geometries = bottoms.emplace_back();
        for (uint32_t i = first; i < first + count; ++i)
            geometries.push_back({&scene_.triangles.meshes[i], scene_.triangles.instances[i].opaque});
        RayTracingHost::Instance instance = {{}, first, false};
        instance.placed.mesh = static_cast<uint32_t>(bottoms.size() - 1);
        instances.push_back(instance);
        first += count;
    }
    ASSERT_EQ(first, instanceCount());
    std::swap(instances[0], instances[2]);
    RayTracingHost host(gpu(), bottoms);
    host.addTop(instances);
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    expectSame(look(world.surfaces, declared(host, 0, InstanceNumbering::CustomIndex), raySettings()),
               look(world.rays, world.surfaces, raySettings()));
}

TEST_F(HostAccelerationStructureTest, HitsForTheHostToShadeHaveItsNumbers) {
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::reversed(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) {
        host.buildAll(commands);
        world.rays.record(commands);
    });
    const HostShading shading(gpu());
    const auto shaded = [&](RayScene& rays) {
        Reflections made = reflections(kWidth, kHeight, raySettings());
        must(made.setInputs(gbuffer_.gbuffer, environment_.map));
        must(
            made.setRays(rays, [&](VkCommandBuffer commands, const RayHits& hits) { shading.record(commands, hits); }));
        return trace(made, camera_.view(kWidth, kHeight));
    };
    RayScene adopted = must(RayScene::adopt(library(), declared(host, 0, InstanceNumbering::CustomIndex)));
    expectSame(shaded(adopted), shaded(world.rays));
}

TEST_F(HostAccelerationStructureTest, MeshesThatDeformAreRefittedByTheHost) {
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    RayScene adopted = must(RayScene::adopt(library(), declared(host, 0)));
    const Picture before = look(world.rays, world.surfaces, raySettings());
    std::vector<glm::vec3> moved = scene_.triangles.meshes[kCard].positions;
    for (glm::vec3& position : moved)
        position += glm::vec3(0.1f, 0.2f * position.x, 0.3f);
    // The table keeps the old vertices: both doors show the same, which is enough here.
    must(world.rays.deform(kCard, &moved.front().x, static_cast<uint32_t>(moved.size())));
    host.move(kCard, moved);
    run([&](VkCommandBuffer commands) {
        host.refitBottom(commands, kCard);
        host.buildTop(commands, 0);
    });
    const Picture own = look(world.rays, world.surfaces, raySettings());
    EXPECT_NE(own.composite, before.composite);
    expectSame(look(adopted, world.surfaces, raySettings()), own);
}

/// Lamps are sampled where the host declares its triangles. Without, paths alone find them: the same mean.
TEST_F(HostAccelerationStructureTest, LampsAreSampledByDeclaredTriangles) {
    Settings settings = raySettings();
    settings.rays.sampleLights = true;
    settings.rays.samples = 64;
    scene_.materials[0].roughnessFactor = 0.4f;
    gbuffer_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    const Picture own = look(world.rays, world.surfaces, settings);
    std::vector<uint32_t> counts;
    for (const RayInstance& instance : scene_.triangles.instances)
        counts.push_back(static_cast<uint32_t>(scene_.triangles.meshes[instance.mesh].indices.size() / 3));
    HostAccelerationStructure declaration = declared(host, 0);
    declaration.triangleCounts = counts;
    expectSame(look(world.surfaces, declaration, settings), own);
    const Picture paths = look(world.surfaces, declared(host, 0), settings);
    EXPECT_NE(paths.composite, own.composite);
    const auto mean = [](const Picture& picture) {
        double sum = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            sum += picture.color(i).g;
        return sum / static_cast<double>(picture.pixels());
    };
    EXPECT_NEAR(mean(paths) / mean(own), 1, 0.02);
}

/// After the screen, answers whose way crosses the box of what transmits light are traced again.
TEST_F(HostAccelerationStructureTest, TransparentSurfacesAreWhereTheHostDeclaresThem) {
    Settings settings = raySettings();
    settings.screen.enabled = true;
    settings.rays.bounces = 1;
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    const Picture own = look(world.rays, world.surfaces, settings);
    rays::Bounds box;
    for (const uint32_t i : {kVeil, kVeil + 1})
        box.add(world.rays.scene().instanceBounds(i));
    HostAccelerationStructure declaration = declared(host, 0);
    declaration.transparentLowWS = {box.low.x, box.low.y, box.low.z};
    declaration.transparentHighWS = {box.high.x, box.high.y, box.high.z};
    expectSame(look(world.surfaces, declaration, settings), own);
    const Picture anywhere = look(world.surfaces, declared(host, 0), settings);
    EXPECT_GT(own.statistics.scene.fromScreen + own.statistics.scene.reusedLight, 0u);
    EXPECT_GT(anywhere.statistics.scene.replaced, own.statistics.scene.replaced) << "undeclared, they may be anywhere";
}

TEST_F(HostAccelerationStructureTest, EachFrameInFlightHasItsOwnTopLevel) {
    const std::vector<std::vector<uint16_t>> own = play(0, raySettings());
    EXPECT_NE(own[2], own[3]) << "the card moves";
    for (const uint32_t depth : {1u, 2u, 3u}) {
        const std::vector<std::vector<uint16_t>> adopted = play(depth, raySettings());
        for (size_t frame = 0; frame < own.size(); ++frame)
            EXPECT_EQ(adopted[frame], own[frame]) << "frame " << frame << ", " << depth << " in flight";
    }
}

/// What the denoiser follows by the numbers of instances is the same.
TEST_F(HostAccelerationStructureTest, TheDenoiserFollowsWhatMoves) {
    Settings settings = raySettings();
    settings.rays.samples = 1;
    settings.denoise.enabled = true;
    settings.denoise.hitMotion = true;
    settings.denoise.antilag = Antilag::Gradient;
    scene_.materials[0].roughnessFactor = 0.3f;
    gbuffer_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
    EXPECT_EQ(play(2, settings, InstanceNumbering::CustomIndex), play(0, settings));
}

/// Recorded with one top level, submitted after another has replaced it.
TEST_F(HostAccelerationStructureTest, ARecordedFrameKeepsItsTopLevel) {
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    RayTracingHost host(gpu(), scene_.triangles);
    std::vector<RayInstance> moved = scene_.triangles.instances;
    moved[kCard].localToWorld[13] = 0.5f;
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    host.addTop(RayTracingHost::inOrder(moved));
    run([&](VkCommandBuffer commands) {
        host.buildAll(commands);
        world.surfaces.record(commands);
    });
    RayScene rays = must(RayScene::adopt(library(), declared(host, 0)));
    Reflections made = must(Reflections::create(library(), {kWidth, kHeight, raySettings()}));
    must(made.setInputs(gbuffer_.gbuffer, environment_.map));
    must(made.setRays(rays, world.surfaces));
    std::deque<Snapshot> pictures;
    const auto record = [&](size_t top) {
        must(rays.setAccelerationStructure(declared(host, top)));
        Snapshot& picture = pictures.emplace_back(gpu(), kWidth, kHeight);
        return Recording(gpu(), [&](VkCommandBuffer commands) {
            picture.record(commands, made.record(commands, camera_.view(kWidth, kHeight)).image);
        });
    };
    {
        Recording alone = record(0);
        alone.submit();
    }
    {
        Recording first = record(0);
        Recording second = record(1);
        first.submit();
        second.submit();
    }
    EXPECT_EQ(pictures[1].texels(), pictures[0].texels());
    EXPECT_NE(pictures[2].texels(), pictures[0].texels());
}

TEST_F(HostAccelerationStructureTest, TakesNoMemoryAndRecordsNothing) {
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    run([&](VkCommandBuffer commands) { host.buildAll(commands); });
    const uint64_t before = library().memory().bytes;
    RayScene rays = must(RayScene::adopt(library(), declared(host, 0)));
    EXPECT_EQ(library().memory().bytes, before);
    rays.record(VK_NULL_HANDLE); // no command buffer is touched
    rays.releaseStaging();
    EXPECT_EQ(rays.times().cpuBuildMs, 0);
    EXPECT_EQ(rays.times().gpuUpdateMs, 0);
}

TEST_F(HostAccelerationStructureTest, MistakesAreErrorsOfOneLine) {
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::inOrder(scene_.triangles.instances));
    const auto expectError = [](const auto& result, std::string_view part) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::InvalidArgument);
        EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
        EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
    };
    const HostAccelerationStructure good = declared(host, 0);
    HostAccelerationStructure bad = good;
    bad.topLevel = VK_NULL_HANDLE;
    expectError(RayScene::adopt(library(), bad), "is null");
    bad = good;
    bad.instanceCount = 1u << 24;
    expectError(RayScene::adopt(library(), bad), "at most 16777215");
    bad = good;
    const std::vector<uint32_t> counts(3, 1);
    bad.triangleCounts = counts;
    expectError(RayScene::adopt(library(), bad), "triangle counts of 3");
    for (const float wrong : {2e18f, std::numeric_limits<float>::quiet_NaN(), -1e18f}) {
        bad = good;
        bad.transparentLowWS[1] = 0;
        bad.transparentHighWS[1] = wrong;
        expectError(RayScene::adopt(library(), bad), "on axis 1");
    }

    RayScene rays = must(RayScene::adopt(library(), good));
    expectError(rays.setInstances(scene_.triangles.instances), "setInstances: the ray scene is the host's");
    expectError(rays.updateInstances(0, scene_.triangles.instances), "updateInstances: the ray scene is the host's");
    const std::vector<glm::vec3>& positions = scene_.triangles.meshes[kCard].positions;
    expectError(rays.deform(kCard, &positions.front().x, static_cast<uint32_t>(positions.size())),
                "deform: the ray scene is the host's");
    bad = good;
    bad.numbering = InstanceNumbering::CustomIndex;
    expectError(rays.setAccelerationStructure(bad), "numbering");
    bad = good;
    bad.topLevel = VK_NULL_HANDLE;
    expectError(rays.setAccelerationStructure(bad), "is null");
    EXPECT_TRUE(rays.setAccelerationStructure(good));

    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    expectError(world.rays.setAccelerationStructure(good), "made of triangles");
    Settings settings = raySettings();
    settings.rays.backend = RayBackend::Bvh;
    Reflections made = reflections(kWidth, kHeight, settings);
    expectError(made.setRays(rays, world.surfaces), "rays.backend is bvh");
}

} // namespace host_acceleration_structure_test
} // namespace glint::test
