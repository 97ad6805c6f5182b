// A host's mistakes: each causes one clear error or note, and no crash.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace glint::test {
namespace host_mistakes_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 27;

std::string message(const Result<void>& result) {
    return result ? "" : result.error().message;
}

class HostMistakes : public LibraryTest {
protected:
    static SyntheticGBuffer host() {
        return SyntheticGBuffer::render(gpu(), floorAndWall(), SyntheticCamera(), kWidth, kHeight);
    }
    static View view() { return SyntheticCamera().view(kWidth, kHeight); }
    static HostImage record(Reflections& reflections, const View& view) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = reflections.record(commands, view); });
        return image;
    }
    static TestEnvironment environment(uint32_t size, uint32_t mips) {
        return TestEnvironment::make(gpu(), size, mips, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    }
    /// The notes about recording; notes about inputs are tested elsewhere.
    static std::vector<std::string> recordNotes(const Reflections& reflections) {
        std::vector<std::string> notes;
        for (const std::string& note : reflections.notes())
            if (note.find("nothing is recorded") != std::string::npos)
                notes.push_back(note);
        return notes;
    }
};

// ---------------------------------------------------------------- headers of another version

TEST_F(HostMistakes, headersOfAnotherMinorVersionAreRefused) {
    const gpu::AdoptedDevice handles = gpu().handles();
    const HostDevice device = {handles.instance,    handles.physicalDevice,      handles.device,
                               handles.queueFamily, handles.getInstanceProcAddr, handles.rayQuery};
    EXPECT_EQ(version(), GLINT_VERSION);
    EXPECT_TRUE(Context::adopt(device).ok());
    EXPECT_TRUE(Context::adopt(device, GLINT_VERSION + 1).ok()); // another patch version has the same interface
    for (const uint32_t headers : {GLINT_VERSION + 1000u, GLINT_VERSION + 1000000u, 0u}) {
        const auto adopted = Context::adopt(device, headers);
        ASSERT_FALSE(adopted.ok()) << headers;
        EXPECT_EQ(adopted.error().code, ErrorCode::InvalidArgument);
        EXPECT_THAT(adopted.error().message, HasSubstr("compile it again"));
    }
}

// ---------------------------------------------------------------- record, which cannot fail

TEST_F(HostMistakes, recordBeforeSetInputsIsANoteAndNoImage) {
    Reflections made = reflections(kWidth, kHeight);
    for (int frame = 0; frame < 3; ++frame)
        EXPECT_FALSE(record(made, view()));
    EXPECT_THAT(made.notes(), ElementsAre(HasSubstr("record before setInputs")));
    run([&](VkCommandBuffer commands) {
        EXPECT_FALSE(made.recordView(commands, "normal"));
        EXPECT_FALSE(made.recordInspection(commands, 1, 1));
    });
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    EXPECT_THAT(recordNotes(made), ElementsAre());
    EXPECT_GT(trace(made, view()).meanWeight(), 0.5) << "and then it works";
}

TEST_F(HostMistakes, aViewThatIsNoneIsANoteAndTheHostsOwnPicture) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    const Picture before = trace(made, view());
    const auto refuses = [&](const char* what, auto change) {
        must(made.setInputs(gbuffer.gbuffer)); // resets the notes given before
        View wrong = view();
        change(wrong);
        for (int frame = 0; frame < 2; ++frame)
            EXPECT_EQ(record(made, wrong).image, gbuffer.gbuffer.litRadiance.image) << what;
        EXPECT_THAT(recordNotes(made), ElementsAre(HasSubstr(what)));
        run([&](VkCommandBuffer commands) {
            const Result<HostImage> shown = made.recordView(commands, "normal");
            ASSERT_FALSE(shown);
            EXPECT_THAT(shown.error().message, HasSubstr("nothing was recorded"));
        });
    };
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    refuses("View::worldToView has a number that is not finite", [](View& v) { v.worldToView[13] = kNan; });
    refuses("View::viewToClip has a number that is not finite", [](View& v) { v.viewToClip[0] = kInfinity; });
    refuses("View::worldToView has the last row", [](View& v) { v.worldToView = {}; });
    refuses("View::worldToView has the last row (0, 0, 5, 1)", [](View& v) {
        v.worldToView = kIdentity; // transposed: rows where columns belong
        v.worldToView[11] = 5;
    });
    refuses("View::worldToView has no inverse",
            [](View& v) { v.worldToView[0] = v.worldToView[1] = v.worldToView[2] = 0; });
    refuses("View::viewToClip has no inverse", [](View& v) { v.viewToClip = {}; });
    refuses("View::viewToClip has no inverse", [](View& v) { v.viewToClip[14] = 0; });
    EXPECT_EQ(trace(made, view()).composite, before.composite) << "the next good frame is as ever";
}

TEST_F(HostMistakes, viewsOfEveryScaleAreTaken) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    View far = view();
    for (const int i : {12, 13, 14})
        far.worldToView[static_cast<size_t>(i)] = 1e7f;
    View narrow = view();
    narrow.viewToClip[14] = 1e-6f; // the near plane of a finger tip
    View wide = view();
    wide.viewToClip = kIdentity; // an orthographic picture of kilometres, off its centre
    wide.viewToClip[0] = wide.viewToClip[5] = 1e-5f;
    wide.viewToClip[10] = 1e-7f;
    wide.viewToClip[12] = 40;
    for (const View& good : {far, narrow, wide})
        EXPECT_NE(record(made, good).image, gbuffer.gbuffer.litRadiance.image);
    EXPECT_THAT(recordNotes(made), ElementsAre());
}

TEST_F(HostMistakes, noCommandBufferIsANote) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    EXPECT_EQ(made.record(VK_NULL_HANDLE, view()).image, gbuffer.gbuffer.litRadiance.image);
    EXPECT_THAT(recordNotes(made), ElementsAre(HasSubstr("without a command buffer")));
    record(made, view());
    const Result<HostImage> shown = made.recordView(VK_NULL_HANDLE, "normal");
    ASSERT_FALSE(shown);
    EXPECT_THAT(shown.error().message, HasSubstr("without a command buffer"));
}

// ---------------------------------------------------------------- images

constexpr HostImage GBuffer::*kImages[] = {&GBuffer::depth, &GBuffer::normal, &GBuffer::material,
                                           &GBuffer::litRadiance};

TEST_F(HostMistakes, formatsThatShadersCannotReadAsFloatsAreRefused) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer right = host();
    const auto error = [&](HostImage GBuffer::*member, VkFormat format) {
        GBuffer wrong = right.gbuffer;
        (wrong.*member).format = format;
        return message(made.setInputs(wrong));
    };
    for (HostImage GBuffer::*member : kImages) {
        EXPECT_THAT(error(member, VK_FORMAT_UNDEFINED), HasSubstr("VK_FORMAT_UNDEFINED"));
        for (const VkFormat format : {VK_FORMAT_R32_UINT, VK_FORMAT_R8G8B8A8_SINT, VK_FORMAT_A2B10G10R10_UINT_PACK32,
                                      VK_FORMAT_R16G16B16A16_UINT, VK_FORMAT_S8_UINT})
            EXPECT_THAT(error(member, format),
                        AllOf(HasSubstr("integer format"), HasSubstr(std::to_string(static_cast<int>(format)))));
        EXPECT_THAT(error(member, VK_FORMAT_R8G8B8A8_USCALED), HasSubstr("cannot sample"));
    }
    EXPECT_THAT(error(&GBuffer::litRadiance, VK_FORMAT_D32_SFLOAT),
                AllOf(HasSubstr("`litRadiance`"), HasSubstr("depth format")));
    EXPECT_EQ(message(made.setInputs(right.gbuffer)), "");
}

TEST_F(HostMistakes, whatTheHostStatesOfItsImagesIsHeldAgainstTheirUse) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer right = host();
    for (HostImage GBuffer::*member : kImages) {
        GBuffer wrong = right.gbuffer;
        (wrong.*member).usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
        EXPECT_THAT(message(made.setInputs(wrong)), HasSubstr("VK_IMAGE_USAGE_SAMPLED_BIT"));
        wrong = right.gbuffer;
        (wrong.*member).viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
        EXPECT_THAT(message(made.setInputs(wrong)), HasSubstr("VK_IMAGE_VIEW_TYPE_2D"));
        GBuffer silent = right.gbuffer;
        (silent.*member).usage = 0;
        (silent.*member).viewType.reset();
        EXPECT_EQ(message(made.setInputs(silent)), "") << "nothing need be stated";
    }
}

TEST_F(HostMistakes, anEnvironmentThatIsNoCubeIsRefused) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    const TestEnvironment right = environment(4, 2);
    const auto refuses = [&](const char* what, auto change) {
        EnvironmentMap wrong = right.map;
        change(wrong);
        EXPECT_THAT(message(made.setInputs(gbuffer.gbuffer, wrong)), AllOf(HasSubstr("environment"), HasSubstr(what)));
    };
    refuses("VK_IMAGE_VIEW_TYPE_CUBE", [&](EnvironmentMap& map) {
        map.cube = gbuffer.gbuffer.litRadiance;
        map.cube.width = map.cube.height = 32;
        map.mips = map.cube.mips = 1;
    });
    refuses("48x27", [&](EnvironmentMap& map) { map.cube = gbuffer.gbuffer.litRadiance; });
    refuses("0x0", [](EnvironmentMap& map) { map.cube.width = map.cube.height = 0; });
    refuses("4 mips: faces of 4 texels have 1 to 3", [](EnvironmentMap& map) { map.mips = 4; });
    refuses("3 mips, but its view shows 2", [](EnvironmentMap& map) { map.mips = 3; });
    refuses("integer format", [](EnvironmentMap& map) { map.cube.format = VK_FORMAT_R32G32B32A32_UINT; });
    refuses("SAMPLED", [](EnvironmentMap& map) { map.cube.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT; });
    refuses("diffuse", [&](EnvironmentMap& map) { map.diffuse = gbuffer.gbuffer.litRadiance; });
    EXPECT_EQ(message(made.setInputs(gbuffer.gbuffer, right.map)), "");
}

TEST_F(HostMistakes, probesAndMirrorsAreHeldToTheSame) {
    const TestEnvironment cube = environment(16, 1);
    const auto probeError = [&](auto change) {
        Probe probe;
        probe.cube = cube.map.cube;
        change(probe);
        const Result<Probes> made = Probes::create(library(), {.probes = {&probe, 1}});
        return made ? std::string() : made.error().message;
    };
    EXPECT_EQ(probeError([](Probe&) {}), "");
    EXPECT_THAT(probeError([](Probe& p) { p.cube.format = VK_FORMAT_R32_UINT; }), HasSubstr("probe 0"));
    EXPECT_THAT(probeError([](Probe& p) { p.mips = 6; }), HasSubstr("6 mips"));
    EXPECT_THAT(probeError([](Probe& p) { p.cube.viewType = VK_IMAGE_VIEW_TYPE_2D; }), HasSubstr("TYPE_CUBE"));

    const PlanarMirror mirror;
    PlanarMirrors mirrors = must(PlanarMirrors::create(library(), {{&mirror, 1}, kWidth, kHeight, {}}));
    const SyntheticGBuffer drawn = host();
    const PlanarPicture right = {drawn.gbuffer.litRadiance, drawn.gbuffer.depth, view()};
    const auto mirrorError = [&](auto change) {
        PlanarPicture picture = right;
        change(picture);
        std::string error;
        run([&](VkCommandBuffer commands) { error = message(mirrors.record(commands, 0, picture)); });
        return error;
    };
    EXPECT_EQ(mirrorError([](PlanarPicture&) {}), "");
    EXPECT_THAT(mirrorError([](PlanarPicture& p) { p.radiance.format = VK_FORMAT_R32_SINT; }), HasSubstr("integer"));
    EXPECT_THAT(mirrorError([](PlanarPicture& p) { p.depth.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT; }),
                AllOf(HasSubstr("mirror 0"), HasSubstr("`depth`"), HasSubstr("SAMPLED")));
    EXPECT_THAT(mirrorError([](PlanarPicture& p) { p.view.viewToClip = {}; }), HasSubstr("no inverse"));
}

// ---------------------------------------------------------------- order of destruction

TEST_F(HostMistakes, theContextMayBeDestroyedBeforeWhatWasMadeFromIt) {
    const gpu::AdoptedDevice handles = gpu().handles();
    std::optional<Context> context = must(Context::adopt(
        {handles.instance, handles.physicalDevice, handles.device, handles.queueFamily, handles.getInstanceProcAddr}));
    const SyntheticGBuffer gbuffer = host();
    const TestEnvironment cube = environment(16, 1);
    Probe probe;
    probe.cube = cube.map.cube;
    const PlanarMirror mirror;
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const uint32_t indices[3] = {0, 1, 2};
    const RayMesh mesh = {corners, 3, 12, indices};
    const RayInstance instance;
    const SurfaceMaterial material;
    ReflectionsDesc desc = {kWidth, kHeight, plainSettings()};
    desc.views = desc.transparentLayers = desc.inspection = desc.statistics = true;

    std::optional<Reflections> made = must(Reflections::create(*context, desc));
    std::optional<Probes> probes = must(Probes::create(*context, {.probes = {&probe, 1}}));
    std::optional<PlanarMirrors> mirrors = must(PlanarMirrors::create(*context, {{&mirror, 1}, kWidth, kHeight, {}}));
    std::optional<RayScene> scene = must(
        RayScene::create(*context, {.meshes = {&mesh, 1}, .instances = {&instance, 1}, .backend = RayBackend::Bvh}));
    std::optional<SurfaceTable> surfaces = must(SurfaceTable::create(*context, {.materials = {&material, 1}}));
    context.reset();
    must(made->setInputs(gbuffer.gbuffer, cube.map));
    run([&](VkCommandBuffer commands) {
        probes->record(commands);
        scene->record(commands);
        made->record(commands, view());
    });
    *made = must(Reflections::create(library(), desc)); // the old object is destroyed while it is assigned to
    probes.reset();
    mirrors.reset();
    scene.reset();
    surfaces.reset();
}

} // namespace host_mistakes_test
} // namespace glint::test
