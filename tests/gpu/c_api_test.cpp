// The C interface beside the C++ interface: the same calls give the same bits, with every source.
#include "c_api/struct_reading.hpp"
#include "gpu/support/host_shading.hpp"
#include "gpu/support/host_structures.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <gmock/gmock.h>

#include <array>
#include <deque>
#include <optional>

namespace glint::test {
namespace c_api_test {

using c_api::toC;
using testing::HasSubstr;
using testing::StartsWith;

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 40;

void must(GlintResult result) {
    if (result != GLINT_SUCCESS)
        throw std::runtime_error(glint_last_error());
}

template <class C>
C initialized(void (*init)(C*, uint32_t)) {
    C c;
    init(&c, sizeof c);
    return c;
}

/// Structs of a C host that point to each other; pointers into a deque stay valid.
struct HostStructs {
    std::deque<GlintImage> images;
    std::deque<GlintMaterialChannel> channels;
    GlintConventions conventions;

    const GlintImage* image(const HostImage& image) { return image ? &images.emplace_back(toC(image)) : nullptr; }
    const GlintMaterialChannel* channel(const MaterialChannel& channel) {
        GlintMaterialChannel& c = channels.emplace_back(toC(channel));
        c.image = image(channel.image);
        return &c;
    }
    GlintGBuffer gbuffer(const GBuffer& gbuffer) {
        GlintGBuffer c = toC(gbuffer);
        c.depth = image(gbuffer.depth);
        c.normal = image(gbuffer.normal);
        c.material = image(gbuffer.material);
        c.roughness = channel(gbuffer.roughness);
        c.metallic = channel(gbuffer.metallic);
        c.specular = channel(gbuffer.specular);
        c.occlusion = channel(gbuffer.occlusion);
        c.f90 = channel(gbuffer.f90);
        c.coat = channel(gbuffer.coat);
        c.coatRoughness = channel(gbuffer.coatRoughness);
        c.coatNormal = image(gbuffer.coatNormal);
        c.litRadiance = image(gbuffer.litRadiance);
        c.fallbackSpecular = image(gbuffer.fallbackSpecular);
        conventions = toC(gbuffer.conventions);
        c.conventions = &conventions;
        return c;
    }
    GlintEnvironmentMap environment(const EnvironmentMap& map) {
        GlintEnvironmentMap c = toC(map);
        c.cube = image(map.cube);
        c.diffuse = image(map.diffuse);
        return c;
    }
};

/// What every source answers with in C++, for EverySourceGivesTheBitsOfCpp.
struct SourcesOfCpp {
    SurfaceScene::World world;
    Probe probe = {};
    PlanarMirror mirror = {{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1}, 0};
    PlanarPicture picture = {};
    std::optional<Probes> probes = {};
    std::optional<PlanarMirrors> mirrors = {};
};

/// The same in C.
struct SourcesOfC {
    GlintRayScene* rays = nullptr;
    GlintSurfaceTable* table = nullptr;
    GlintProbes* probes = nullptr;
    GlintPlanarMirrors* mirrors = nullptr;

    void destroy() {
        glint_planar_mirrors_destroy(mirrors);
        glint_probes_destroy(probes);
        glint_surface_table_destroy(table);
        glint_ray_scene_destroy(rays);
        *this = {};
    }
};

class CApiTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        const gpu::AdoptedDevice handles = gpu().handles();
        device_ = initialized(glint_context_desc_init);
        device_.instance = handles.instance;
        device_.physicalDevice = handles.physicalDevice;
        device_.device = handles.device;
        device_.queueFamily = handles.queueFamily;
        device_.getInstanceProcAddr = handles.getInstanceProcAddr;
        device_.rayQuery = handles.rayQuery ? VK_TRUE : VK_FALSE;
        must(glint_context_adopt(&device_, GLINT_C_ABI, &context_));
        must(glint_settings_create(&settings_));
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.2f));
        scene_.addQuad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, emitting({1, 0.5f, 0.25f}));
        scene_.addQuad({3, -3, 6}, {-6, 0, 0}, {0, 6, 0}, emitting({0.25f, 0.5f, 1}));
        environment_ = TestEnvironment::make(gpu(), 8, 4, [](const glm::dvec3& direction, uint32_t) {
            return glm::vec3(0.5f + 0.4f * static_cast<float>(direction.y));
        });
        gbuffer_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
    }
    void TearDown() override {
        glint_reflections_destroy(reflections_);
        sources_.destroy();
        glint_settings_destroy(settings_);
        glint_context_destroy(context_);
        LibraryTest::TearDown();
    }

    void setAll(const Settings& settings) {
        const std::string json = toJson(settings);
        must(glint_settings_from_json(settings_, json.data(), json.size(), "the test", nullptr));
    }
    void create(const Settings& settings, bool transparentLayers = false) {
        setAll(settings);
        GlintReflectionsDesc desc = initialized(glint_reflections_desc_init);
        desc.width = kWidth;
        desc.height = kHeight;
        desc.settings = settings_;
        desc.statistics = desc.views = VK_TRUE;
        desc.transparentLayers = transparentLayers ? VK_TRUE : VK_FALSE;
        desc.inspection = inspection_ ? VK_TRUE : VK_FALSE;
        desc.inputCheck = inputCheck_ ? VK_TRUE : VK_FALSE;
        desc.framesInFlight = 1;
        must(glint_reflections_create(context_, &desc, &reflections_));
    }
    void setInputs(const GBuffer& gbuffer, const EnvironmentMap& environment) {
        HostStructs structs;
        const GlintGBuffer images = structs.gbuffer(gbuffer);
        const GlintEnvironmentMap map = structs.environment(environment);
        must(glint_reflections_set_inputs(reflections_, &images, &map));
    }
    View view(uint32_t frame) const {
        View view = camera_.view(kWidth, kHeight);
        view.frameIndex = frame;
        return view;
    }
    HostImage recordC(VkCommandBuffer commands, uint32_t frame) {
        const GlintView camera = toC(view(frame));
        GlintImage result = initialized(glint_image_init);
        must(glint_reflections_record(reflections_, commands, &camera, &result));
        return test::must(c_api::readStruct<HostImage>(&result));
    }
    std::vector<float> frameOfC(uint32_t frame) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = recordC(commands, frame); });
        return download(gpu(), image);
    }
    std::vector<float> viewOfC(const char* name) {
        GlintImage image = initialized(glint_image_init);
        run([&](VkCommandBuffer commands) {
            must(glint_reflections_record_view(reflections_, commands, name, &image));
        });
        return download(gpu(), test::must(c_api::readStruct<HostImage>(&image)));
    }

    Reflections reflectionsOfCpp(const Settings& settings, SourcesOfCpp& sources) {
        sources.probe.cube = environment_.map.cube;
        sources.probe.influence.halfExtents = sources.probe.proxyVolume.halfExtents = {3, 3, 3};
        sources.probes = test::must(Probes::create(library(), {{&sources.probe, 1}, 16}));
        sources.mirrors =
            test::must(PlanarMirrors::create(library(), {.mirrors = {&sources.mirror, 1}, .width = 32, .height = 20}));
        // Which radiance a mirror shows does not matter here, only that both show the same.
        sources.picture.radiance = gbuffer_.gbuffer.litRadiance;
        sources.picture.depth = gbuffer_.gbuffer.depth;
        sources.picture.view = mirroredView(view(1), sources.mirror);
        Reflections cpp = LibraryTest::reflections(kWidth, kHeight, settings);
        test::must(cpp.setInputs(gbuffer_.gbuffer, environment_.map));
        test::must(cpp.setRays(sources.world.rays, sources.world.surfaces));
        test::must(cpp.setProbes(*sources.probes));
        test::must(cpp.setPlanar(*sources.mirrors));
        run([&](VkCommandBuffer commands) {
            sources.world.rays.record(commands);
            sources.world.surfaces.record(commands);
            sources.probes->record(commands);
            test::must(sources.mirrors->record(commands, 0, sources.picture));
        });
        return cpp;
    }

    void createSourcesOfC(const SourcesOfCpp& cpp) {
        createRaysOfC(cpp.world);
        HostStructs structs;
        GlintProbe probe = toC(cpp.probe);
        probe.cube = structs.image(cpp.probe.cube);
        GlintProbesDesc probesDesc = initialized(glint_probes_desc_init);
        probesDesc.probes = &probe;
        probesDesc.probeCount = 1;
        probesDesc.faceSize = 16;
        must(glint_probes_create(context_, &probesDesc, &sources_.probes));
        const GlintPlanarMirror mirror = toC(cpp.mirror);
        GlintPlanarMirrorsDesc mirrorsDesc = initialized(glint_planar_mirrors_desc_init);
        mirrorsDesc.mirrors = &mirror;
        mirrorsDesc.mirrorCount = 1;
        mirrorsDesc.width = 32;
        mirrorsDesc.height = 20;
        must(glint_planar_mirrors_create(context_, &mirrorsDesc, &sources_.mirrors));
    }

    /// The streams of vertices are the buffers of `world`.
    void createRaysOfC(const SurfaceScene::World& world) {
        std::vector<GlintRayMesh> rayMeshes;
        std::vector<GlintSurfaceMesh> meshes;
        std::vector<GlintSurfaceMaterial> materials;
        std::vector<GlintRayInstance> rayInstances;
        std::vector<GlintSurfaceInstance> instances;
        auto buffer = world.buffers.begin();
        for (const TestMesh& mesh : scene_.triangles.meshes) {
            GlintRayMesh& rayMesh = rayMeshes.emplace_back(initialized(glint_ray_mesh_init));
            rayMesh.positions = &mesh.positions.front().x;
            rayMesh.vertexCount = static_cast<uint32_t>(mesh.positions.size());
            rayMesh.indices = mesh.indices.data();
            rayMesh.indexCount = static_cast<uint32_t>(mesh.indices.size());
            GlintSurfaceMesh& surface = meshes.emplace_back(initialized(glint_surface_mesh_init));
            surface.positions = {(buffer++)->address(), sizeof(glm::vec3), 0};
            surface.indices = (buffer++)->address();
            const auto i = static_cast<uint32_t>(instances.size());
            rayInstances.push_back(toC(scene_.triangles.instances[i]));
            materials.push_back(toC(scene_.materials[i]));
            instances.push_back(toC(SurfaceInstance{i, i, kIdentity}));
        }
        GlintRaySceneDesc rayDesc = initialized(glint_ray_scene_desc_init);
        rayDesc.meshes = rayMeshes.data();
        rayDesc.meshCount = static_cast<uint32_t>(rayMeshes.size());
        rayDesc.instances = rayInstances.data();
        rayDesc.instanceCount = static_cast<uint32_t>(rayInstances.size());
        rayDesc.backend = GLINT_RAY_BACKEND_BVH;
        must(glint_ray_scene_create(context_, &rayDesc, &sources_.rays));
        EXPECT_EQ(glint_ray_scene_backend(sources_.rays), GLINT_RAY_BACKEND_BVH);
        GlintSurfaceTableDesc tableDesc = initialized(glint_surface_table_desc_init);
        tableDesc.materials = materials.data();
        tableDesc.materialCount = static_cast<uint32_t>(materials.size());
        tableDesc.meshes = meshes.data();
        tableDesc.meshCount = static_cast<uint32_t>(meshes.size());
        tableDesc.instances = instances.data();
        tableDesc.instanceCount = static_cast<uint32_t>(instances.size());
        must(glint_surface_table_create(context_, &tableDesc, &sources_.table));
        expectUpdatesOfC(tableDesc);
    }

    /// Updates with the values that the table has, and beyond its end.
    void expectUpdatesOfC(const GlintSurfaceTableDesc& desc) {
        GlintSurfaceTable* const table = sources_.table;
        must(glint_surface_table_update_instances(table, 1, desc.instances + 1, 1));
        must(glint_surface_table_update_materials(table, 1, desc.materials + 1, 1));
        EXPECT_EQ(glint_surface_table_update_instances(table, desc.instanceCount, desc.instances, 1),
                  GLINT_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(glint_surface_table_update_materials(table, desc.materialCount, desc.materials, 1),
                  GLINT_ERROR_INVALID_ARGUMENT);
    }

    void recordSourcesOfC(const SourcesOfCpp& cpp) {
        HostStructs structs;
        const GlintView camera = toC(view(1));
        const GlintPlanarMirror mirror = toC(cpp.mirror);
        GlintView mirrored = initialized(glint_view_init);
        must(glint_mirrored_view(&camera, &mirror, &mirrored));
        GlintPlanarPicture picture = initialized(glint_planar_picture_init);
        picture.radiance = structs.image(cpp.picture.radiance);
        picture.depth = structs.image(cpp.picture.depth);
        picture.view = &mirrored;
        run([&](VkCommandBuffer commands) {
            glint_ray_scene_record(sources_.rays, commands);
            glint_surface_table_record(sources_.table, commands);
            glint_probes_record(sources_.probes, commands);
            must(glint_planar_mirrors_record(sources_.mirrors, commands, 0, &picture));
        });
    }

    void expectFrameOfCpp(Reflections& cpp, uint32_t frame) {
        const Picture expected = trace(cpp, view(frame));
        EXPECT_EQ(frameOfC(frame), expected.composite) << frame;
        EXPECT_EQ(viewOfC("reflection"), expected.reflection);
        EXPECT_EQ(viewOfC("outcome"), expected.outcomeColor);
        GlintStatistics statistics = initialized(glint_statistics_init);
        must(glint_reflections_statistics(reflections_, &statistics));
        EXPECT_EQ(statistics.rays, expected.statistics.rays);
        EXPECT_EQ(statistics.sceneRays, expected.statistics.scene.rays);
        EXPECT_GT(statistics.sceneRays, 0u);
        ASSERT_EQ(statistics.outcomeCount, expected.statistics.outcomes.size());
        for (uint32_t i = 0; i < statistics.outcomeCount; ++i) {
            EXPECT_EQ(statistics.outcomes[i].name, expected.statistics.outcomes[i].name);
            EXPECT_EQ(statistics.outcomes[i].count, expected.statistics.outcomes[i].count);
        }
        ASSERT_EQ(glint_reflections_read_pass_times(reflections_), expected.passTimes.size());
        for (uint32_t i = 0; i < expected.passTimes.size(); ++i)
            EXPECT_EQ(glint_reflections_pass_name(reflections_, i), expected.passTimes[i].name);
    }

    GlintContextDesc device_ = {};
    GlintContext* context_ = nullptr;
    GlintSettings* settings_ = nullptr;
    GlintReflections* reflections_ = nullptr;
    SourcesOfC sources_;
    bool inspection_ = false; ///< of `create`
    bool inputCheck_ = false;
    SurfaceScene scene_;
    SyntheticCamera camera_ = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
    TestEnvironment environment_;
    SyntheticGBuffer gbuffer_;
};

TEST_F(CApiTest, EverySourceGivesTheBitsOfCpp) {
    Settings settings;
    settings.rays.enabled = true;
    settings.rays.backend = RayBackend::Bvh;
    settings.probes.enabled = true;
    settings.planar.enabled = true;
    SourcesOfCpp sources = {.world = scene_.build(gpu(), library(), RayBackend::Bvh)};
    Reflections cpp = reflectionsOfCpp(settings, sources);
    createSourcesOfC(sources);
    create(settings);
    setInputs(gbuffer_.gbuffer, environment_.map);
    must(glint_reflections_set_rays(reflections_, sources_.rays, sources_.table));
    must(glint_reflections_set_probes(reflections_, sources_.probes));
    must(glint_reflections_set_planar(reflections_, sources_.mirrors));
    recordSourcesOfC(sources);
    for (uint32_t frame = 1; frame <= 2; ++frame)
        expectFrameOfCpp(cpp, frame);
    // Each source took part: with one source fewer the frame is another.
    const std::vector<float> all = frameOfC(3);
    for (const char* source : {"rays.enabled", "probes.enabled", "planar.enabled"}) {
        must(glint_settings_set(settings_, source, "false", nullptr));
        must(glint_reflections_set_settings(reflections_, settings_));
        EXPECT_NE(frameOfC(3), all) << source;
        must(glint_settings_set(settings_, source, "true", nullptr));
    }

    GlintImage cube = initialized(glint_image_init);
    uint32_t mips = 0;
    must(glint_probes_cube(sources_.probes, 0, &cube, &mips));
    EXPECT_EQ(mips, sources.probes->cubeMips(0));
    EXPECT_EQ(cube.width, 16u);
    EXPECT_EQ(glint_probes_cube(sources_.probes, 1, &cube, &mips), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_planar_mirrors_skip(sources_.mirrors, 1), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST_F(CApiTest, AnInspectedPixelIsThatOfCpp) {
    ReflectionsDesc desc = {kWidth, kHeight};
    desc.inspection = true;
    desc.framesInFlight = 1;
    Reflections cpp = test::must(Reflections::create(library(), desc));
    test::must(cpp.setInputs(gbuffer_.gbuffer, environment_.map));
    inspection_ = true;
    create({});
    setInputs(gbuffer_.gbuffer, environment_.map);
    GlintRayInspection found = initialized(glint_ray_inspection_init);
    size_t samples = 0;
    for (const glm::uvec2 pixel : {glm::uvec2(kWidth / 2, kHeight - 4), glm::uvec2(kWidth / 3, kHeight - 9)}) {
        run([&](VkCommandBuffer commands) {
            cpp.record(commands, view(1));
            test::must(cpp.recordInspection(commands, pixel.x, pixel.y));
            recordC(commands, 1);
            must(glint_reflections_record_inspection(reflections_, commands, pixel.x, pixel.y));
        });
        const RayInspection expected = cpp.inspection();
        must(glint_reflections_inspection(reflections_, &found));
        EXPECT_EQ(found.pixel[0], expected.pixel[0]);
        EXPECT_EQ(found.pixel[1], expected.pixel[1]);
        EXPECT_EQ(found.outcome, expected.outcome);
        EXPECT_EQ(found.traced != 0, expected.traced);
        EXPECT_EQ(found.depth, expected.depth);
        EXPECT_EQ(found.lookups, expected.lookups);
        EXPECT_EQ(found.end.positionWS[2], expected.end.positionWS[2]);
        EXPECT_EQ(found.composite[1], expected.composite[1]);
        EXPECT_EQ(found.hasHitPixel != 0, expected.hitPixel.has_value());
        ASSERT_EQ(found.sampleCount, expected.samples.size());
        for (uint32_t i = 0; i < found.sampleCount; ++i) {
            EXPECT_EQ(found.samples[i].rayDepth, expected.samples[i].rayDepth);
            EXPECT_EQ(found.samples[i].decision, expected.samples[i].decision);
            EXPECT_EQ(std::isnan(found.samples[i].slabEndDepth), !expected.samples[i].slabEndDepth.has_value());
        }
        samples += found.sampleCount;
        ASSERT_EQ(found.fadeCount, expected.fades.size());
        for (uint32_t i = 0; i < found.fadeCount; ++i)
            EXPECT_EQ(found.fades[i].name, expected.fades[i].name);
        ASSERT_EQ(found.sourceCount, expected.sources.size());
        for (uint32_t i = 0; i < found.sourceCount; ++i) {
            EXPECT_EQ(found.sources[i].name, expected.sources[i].name);
            EXPECT_EQ(found.sources[i].weight, expected.sources[i].weight);
        }
    }
    EXPECT_GT(samples, 0u) << "a ray was traced";
    run([&](VkCommandBuffer commands) {
        EXPECT_EQ(glint_reflections_record_inspection(reflections_, commands, kWidth, 0), GLINT_ERROR_INVALID_ARGUMENT);
    });
    glint_reflections_destroy(reflections_);
    inspection_ = false;
    create({});
    EXPECT_EQ(glint_reflections_inspection(reflections_, &found), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_THAT(glint_last_error(), HasSubstr("GlintReflectionsDesc::inspection"));
}

TEST_F(CApiTest, MemoryIsReportedByName) {
    create({});
    GlintMemoryReport report = initialized(glint_memory_report_init);
    must(glint_context_memory(context_, &report));
    ASSERT_GT(report.useCount, 5u);
    uint64_t sum = 0;
    bool surface = false;
    for (uint32_t i = 0; i < report.useCount; ++i) {
        sum += report.uses[i].bytes;
        surface = surface || report.uses[i].name == std::string_view("glint/surface");
        EXPECT_GT(report.uses[i].count, 0u);
    }
    EXPECT_EQ(sum, report.bytes);
    EXPECT_TRUE(surface);
    EXPECT_GE(report.taken, report.bytes);
}

TEST_F(CApiTest, WrongDeclarationsAreNamed) {
    inputCheck_ = true;
    create({});
    GBuffer wrong = gbuffer_.gbuffer;
    wrong.conventions.clipYDown = true;
    setInputs(wrong, {});
    GlintKnownPlane floor = initialized(glint_known_plane_init);
    EXPECT_EQ(floor.normalWS[1], 1);
    run([&](VkCommandBuffer commands) {
        recordC(commands, 1);
        must(glint_reflections_record_input_check(reflections_, commands, nullptr));
        must(glint_reflections_record_input_check(reflections_, commands, &floor));
        floor.normalWS[1] = 3;
        EXPECT_EQ(glint_reflections_record_input_check(reflections_, commands, &floor), GLINT_ERROR_INVALID_ARGUMENT);
    });
    GlintInputCheck check = initialized(glint_input_check_init);
    must(glint_reflections_input_check(reflections_, &check));
    EXPECT_GT(check.tested, 50u);
    EXPECT_LT(check.normalsAgree, 0.5);
    ASSERT_GT(check.findingCount, 0u);
    EXPECT_THAT(glint_reflections_input_finding(reflections_, 0), HasSubstr("clipYDown false, not true as declared"));
    EXPECT_EQ(glint_reflections_input_finding(reflections_, check.findingCount), nullptr);
    bool noted = false;
    for (uint32_t i = 0, count = glint_reflections_read_notes(reflections_); i < count; ++i)
        noted = noted || glint_reflections_note(reflections_, i) ==
                             std::string_view(glint_reflections_input_finding(reflections_, 0));
    EXPECT_TRUE(noted);
}

TEST_F(CApiTest, LayersGiveTheBitsOfCpp) {
    TransparentLayer layer;
    layer.depth = gbuffer_.gbuffer.depth;
    layer.normal = gbuffer_.gbuffer.normal;
    layer.material = gbuffer_.gbuffer.material;
    layer.radiance = layer.transmittance = layer.absorption = layer.body = gbuffer_.gbuffer.litRadiance;
    ReflectionsDesc desc = {kWidth, kHeight};
    desc.transparentLayers = desc.views = true;
    desc.framesInFlight = 1;
    Reflections cpp = test::must(Reflections::create(library(), desc));
    test::must(cpp.setInputs(gbuffer_.gbuffer, environment_.map));
    create({}, true);
    setInputs(gbuffer_.gbuffer, environment_.map);
    HostStructs structs;
    GlintTransparentLayer c = initialized(glint_transparent_layer_init);
    c.depth = structs.image(layer.depth);
    c.normal = structs.image(layer.normal);
    c.material = structs.image(layer.material);
    c.radiance = c.transmittance = c.absorption = c.body = structs.image(layer.radiance);

    HostImage expected;
    HostImage result;
    run([&](VkCommandBuffer commands) {
        expected = test::must(cpp.recordLayer(commands, layer, cpp.record(commands, view(1))));
        GlintImage image = toC(recordC(commands, 1));
        must(glint_reflections_record_layer(reflections_, commands, &c, &image, &image));
        result = test::must(c_api::readStruct<HostImage>(&image));
    });
    EXPECT_EQ(download(gpu(), result), download(gpu(), expected));
}

TEST_F(CApiTest, AHostMayShadeHitsItself) {
    GlintRayMesh mesh = initialized(glint_ray_mesh_init);
    const TestMesh& triangles = scene_.triangles.meshes[2];
    mesh.positions = &triangles.positions.front().x;
    mesh.vertexCount = static_cast<uint32_t>(triangles.positions.size());
    mesh.indices = triangles.indices.data();
    mesh.indexCount = static_cast<uint32_t>(triangles.indices.size());
    GlintRayInstance instance = initialized(glint_ray_instance_init);
    GlintRaySceneDesc desc = initialized(glint_ray_scene_desc_init);
    desc.meshes = &mesh;
    desc.instances = &instance;
    desc.meshCount = desc.instanceCount = 1;
    desc.backend = GLINT_RAY_BACKEND_BVH;
    GlintRayScene* scene = nullptr;
    must(glint_ray_scene_create(context_, &desc, &scene));
    Settings settings;
    settings.rays.enabled = true;
    settings.rays.backend = RayBackend::Bvh;
    create(settings);
    setInputs(gbuffer_.gbuffer, environment_.map);
    struct Seen {
        int calls = 0;
        GlintRayHits hits = {};
        GlintImage answer = {};
        VkCommandBuffer commands = VK_NULL_HANDLE;
    } seen;
    must(glint_reflections_set_shaded_rays(
        reflections_, scene,
        [](void* user, VkCommandBuffer commands, const GlintRayHits* hits) {
            auto* to = static_cast<Seen*>(user);
            ++to->calls;
            to->hits = *hits;
            to->answer = *hits->answer;
            to->commands = commands;
        },
        &seen));
    run([&](VkCommandBuffer commands) {
        glint_ray_scene_record(scene, commands);
        recordC(commands, 1);
        EXPECT_EQ(seen.commands, commands);
    });
    EXPECT_EQ(seen.calls, 1);
    EXPECT_EQ(seen.hits.size, sizeof seen.hits);
    EXPECT_NE(seen.hits.arguments, VkBuffer(VK_NULL_HANDLE));
    EXPECT_NE(seen.hits.hits, VkBuffer(VK_NULL_HANDLE));
    EXPECT_EQ(seen.hits.hitsSize % sizeof(GlintRayHit), 0u);
    EXPECT_EQ(seen.answer.format, VK_FORMAT_R16G16B16A16_SFLOAT);
    EXPECT_EQ(seen.answer.layout, VK_IMAGE_LAYOUT_GENERAL);
    GlintRaySceneTimes times = initialized(glint_ray_scene_times_init);
    must(glint_ray_scene_times(scene, &times));
    EXPECT_GT(times.cpuBuildMs, 0);
    glint_ray_scene_release_staging(scene);
    must(glint_ray_scene_set_instances(scene, &instance, 1));
    must(glint_ray_scene_update_instances(scene, 0, &instance, 1));
    EXPECT_EQ(glint_ray_scene_update_instances(scene, 1, &instance, 1), GLINT_ERROR_INVALID_ARGUMENT);
    const std::array<GlintRayInstance, 2> two = {instance, instance};
    EXPECT_EQ(glint_ray_scene_set_instances(scene, two.data(), 2), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_ray_scene_deform(scene, 0, mesh.positions, mesh.vertexCount, 12), GLINT_ERROR_INVALID_ARGUMENT)
        << "the mesh does not deform";
    glint_reflections_destroy(reflections_);
    reflections_ = nullptr;
    glint_ray_scene_destroy(scene);
}

TEST_F(CApiTest, AHostsAccelerationStructureGivesTheHitsOfItsTriangles) {
    if (!gpu().rayQuery())
        GTEST_SKIP() << "no ray queries on " << gpu().info().name;
    const HostShading shading(gpu());
    Settings settings;
    settings.screen.enabled = false;
    settings.rays.enabled = true;
    SurfaceScene::World world = scene_.build(gpu(), library(), RayBackend::Query);
    Reflections cpp = LibraryTest::reflections(kWidth, kHeight, settings);
    test::must(cpp.setInputs(gbuffer_.gbuffer, environment_.map));
    test::must(cpp.setRays(world.rays,
                           [&](VkCommandBuffer commands, const RayHits& hits) { shading.record(commands, hits); }));
    const std::vector<RayInstance>& instances = scene_.triangles.instances;
    RayTracingHost host(gpu(), scene_.triangles);
    host.addTop(RayTracingHost::reversed(instances));
    host.addTop(RayTracingHost::reversed(instances));
    run([&](VkCommandBuffer commands) {
        host.buildAll(commands);
        world.rays.record(commands);
    });
    const Picture expected = LibraryTest::trace(cpp, view(1));
    EXPECT_GT(expected.counted("hit"), 100u);

    GlintHostAccelerationStructure top = initialized(glint_host_acceleration_structure_init);
    GlintRayScene* scene = nullptr;
    EXPECT_EQ(glint_ray_scene_adopt(context_, &top, &scene), GLINT_ERROR_INVALID_ARGUMENT) << "it is null";
    EXPECT_EQ(scene, nullptr);
    const std::vector<uint32_t> triangleCounts(instances.size(), 2);
    top.topLevel = host.top(0);
    top.instanceCount = static_cast<uint32_t>(instances.size());
    top.numbering = GLINT_INSTANCE_NUMBERING_CUSTOM_INDEX;
    top.triangleCounts = triangleCounts.data();
    must(glint_ray_scene_adopt(context_, &top, &scene));
    EXPECT_EQ(glint_ray_scene_backend(scene), GLINT_RAY_BACKEND_QUERY);
    create(settings);
    setInputs(gbuffer_.gbuffer, environment_.map);
    must(glint_reflections_set_shaded_rays(
        reflections_, scene,
        [](void* user, VkCommandBuffer commands, const GlintRayHits* hits) {
            RayHits read = {hits->arguments, hits->hits, hits->hitsSize, {}};
            read.answer.view = hits->answer->view;
            read.answer.layout = hits->answer->layout;
            static_cast<const HostShading*>(user)->record(commands, read);
        },
        const_cast<HostShading*>(&shading)));
    EXPECT_EQ(frameOfC(1), expected.composite);
    top.topLevel = host.top(1);
    must(glint_ray_scene_set_acceleration_structure(scene, &top));
    top.topLevel = VK_NULL_HANDLE;
    EXPECT_EQ(glint_ray_scene_set_acceleration_structure(scene, &top), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_ray_scene_set_instances(scene, nullptr, 0), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_THAT(glint_last_error(), StartsWith("setInstances: the ray scene is the host's acceleration structure"));
    glint_reflections_destroy(reflections_);
    reflections_ = nullptr;
    glint_ray_scene_destroy(scene);
}

TEST_F(CApiTest, OutputsSizesNotesAndNames) {
    create({});
    HostImage before;
    run([&](VkCommandBuffer commands) { before = recordC(commands, 1); });
    EXPECT_FALSE(before) << "no inputs yet";
    ASSERT_EQ(glint_reflections_read_notes(reflections_), 1u);
    EXPECT_THAT(glint_reflections_note(reflections_, 0), HasSubstr("setInputs"));
    EXPECT_EQ(glint_reflections_note(reflections_, 1), nullptr);

    setInputs(gbuffer_.gbuffer, {});
    const std::vector<float> expected = frameOfC(1);
    gpu::Image image = test::must(gpu::Image::create(
        gpu(), {"test/output", VK_FORMAT_R16G16B16A16_SFLOAT, kWidth, kHeight, 1, 1, gpu::ImageShape::Flat,
                VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    run([&](VkCommandBuffer commands) {
        gpu::Frame(gpu(), commands)
            .hand(image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    });
    HostStructs structs;
    GlintOutputs outputs = initialized(glint_outputs_init);
    outputs.composite = structs.image(asHostImage(image));
    must(glint_reflections_set_outputs(reflections_, &outputs));
    must(glint_reflections_set_settings(reflections_, settings_));
    HostImage result;
    run([&](VkCommandBuffer commands) { result = recordC(commands, 1); });
    EXPECT_EQ(result.image, image.handle());

    const uint32_t images = glint_reflections_read_pass_images(reflections_);
    ASSERT_GT(images, 3u);
    EXPECT_FALSE(viewOfC(glint_reflections_pass_image(reflections_, images - 1)).empty());
    EXPECT_EQ(glint_reflections_pass_image(reflections_, images), nullptr);
    ASSERT_EQ(glint_view_name_count(), Reflections::viewNames().size());
    EXPECT_EQ(glint_view_name(0), Reflections::viewNames()[0]);
    EXPECT_EQ(glint_view_name(glint_view_name_count()), nullptr);

    must(glint_reflections_resize(reflections_, kWidth / 2, kHeight));
    EXPECT_EQ(glint_reflections_resize(reflections_, 0, kHeight), GLINT_ERROR_INVALID_ARGUMENT);
    must(glint_reflections_resize(reflections_, kWidth, kHeight));
    outputs.composite = nullptr;
    must(glint_reflections_set_outputs(reflections_, &outputs));
    setInputs(gbuffer_.gbuffer, {});
    EXPECT_EQ(frameOfC(1), expected);
}

TEST_F(CApiTest, MistakesAreErrors) {
    GlintContext* none = context_;
    EXPECT_EQ(glint_context_adopt(&device_, GLINT_C_ABI + 1, &none), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_THAT(glint_last_error(), HasSubstr("compile it again"));
    EXPECT_EQ(none, nullptr);
    GlintContextDesc broken = device_;
    broken.device = VK_NULL_HANDLE;
    EXPECT_EQ(glint_context_adopt(&broken, GLINT_C_ABI, &none), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_context_adopt(nullptr, GLINT_C_ABI, &none), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_version(), GLINT_VERSION);
    EXPECT_EQ(glint_context_device_name(context_), library().deviceName());
    EXPECT_EQ(glint_context_driver(context_), library().driver());

    create({});
    GlintReflectionsDesc desc = initialized(glint_reflections_desc_init);
    GlintReflections* nothing = reflections_;
    EXPECT_EQ(glint_reflections_create(context_, &desc, &nothing), GLINT_ERROR_INVALID_ARGUMENT) << "no size";
    EXPECT_EQ(nothing, nullptr);
    HostStructs structs;
    GlintGBuffer images = structs.gbuffer(gbuffer_.gbuffer);
    images.normal = nullptr;
    EXPECT_EQ(glint_reflections_set_inputs(reflections_, &images, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_THAT(glint_last_error(), HasSubstr("normal"));
    GlintImage unset = {};
    images.normal = &unset;
    EXPECT_EQ(glint_reflections_set_inputs(reflections_, &images, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_THAT(glint_last_error(), StartsWith("GlintGBuffer::normal: GlintImage::size is 0"));
    setInputs(gbuffer_.gbuffer, {});
    run([&](VkCommandBuffer commands) {
        GlintView camera = toC(view(1));
        GlintImage result = initialized(glint_image_init);
        camera.size = 1;
        EXPECT_EQ(glint_reflections_record(reflections_, commands, &camera, &result), GLINT_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(result.image, VkImage(VK_NULL_HANDLE));
        EXPECT_EQ(glint_reflections_record(nullptr, commands, &camera, &result), GLINT_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(glint_reflections_record_view(reflections_, commands, "no such view", &result),
                  GLINT_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(glint_reflections_record_view(reflections_, commands, "normal", &unset),
                  GLINT_ERROR_INVALID_ARGUMENT);
    });
    EXPECT_EQ(glint_reflections_set_rays(reflections_, nullptr, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_THAT(glint_last_error(), HasSubstr("scene is null"));
    EXPECT_EQ(glint_reflections_set_planar(reflections_, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_reflections_set_probes(reflections_, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_reflections_read_notes(nullptr), 0u);
    EXPECT_EQ(glint_reflections_pass_milliseconds(reflections_, 99), 0);
}

} // namespace c_api_test
} // namespace glint::test
