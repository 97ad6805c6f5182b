// The rule of sizes of the C interface's structs, numbers that are no value of an enum, and that no member is
// forgotten.
#include "c_api/struct_reading.hpp"

#include <gmock/gmock.h>

#include <cstring>

namespace glint::c_api {
namespace struct_reading_test {

using testing::AllOf;
using testing::HasSubstr;

template <class T>
std::string errorOf(const Result<T>& result) {
    return result ? "" : result.error().message;
}

template <class C>
C initialized(void (*init)(C*, uint32_t)) {
    C c;
    std::memset(&c, 0xab, sizeof c);
    init(&c, sizeof c);
    EXPECT_EQ(c.size, sizeof c);
    return c;
}

/// Gives every arithmetic member of a C++ struct a value that no other member has.
struct Numberer {
    int next = 101; // no default is among these numbers
    template <class C, class Cpp>
    void pair(const char* /*name*/, C& c, Cpp& cpp) {
        if constexpr (std::is_array_v<C>) {
            for (auto& element : c)
                element = static_cast<std::remove_reference_t<decltype(element)>>(next++);
        } else if constexpr (std::is_same_v<Cpp, bool>) {
            c = !cpp; // not the default
        } else if constexpr (std::is_enum_v<Cpp> && !std::is_same_v<C, Cpp>) {
            const auto other = cpp == Cpp() ? lastOf(cpp) : Cpp();
            c = static_cast<C>(other);
        } else if constexpr (std::is_arithmetic_v<C> && std::is_arithmetic_v<Cpp>) {
            c = static_cast<C>(next++);
        } else if constexpr (std::is_class_v<C>) {
            members(*this, c, cpp);
        }
    }
};

/// Every byte of the C struct is a member's or reserved: after numbering, reading and writing, all is as before.
template <class Cpp, class C>
void expectRoundTrip(void (*init)(C*, uint32_t), std::initializer_list<size_t> notMembers = {}) {
    C c = initialized(init);
    const C defaults = c;
    Cpp cpp;
    Numberer numberer;
    members(numberer, c, cpp);
    EXPECT_NE(std::memcmp(&c, &defaults, sizeof c), 0) << CStruct<Cpp>::kName;
    const Result<Cpp> read = readStruct<Cpp>(&c);
    ASSERT_TRUE(read.ok()) << read.error().message;
    const C again = toC(*read);
    EXPECT_EQ(std::memcmp(&c, &again, sizeof c), 0) << CStruct<Cpp>::kName;
    // A member that is in no list keeps its default, so each 4 bytes differ from the defaults, but for size and
    // reserved.
    const auto* now = reinterpret_cast<const unsigned char*>(&c);
    const auto* before = reinterpret_cast<const unsigned char*>(&defaults);
    for (size_t at = sizeof(uint32_t); at < sizeof c; at += sizeof(uint32_t)) {
        if (std::ranges::find(notMembers, at) != notMembers.end())
            continue;
        EXPECT_NE(std::memcmp(now + at, before + at, sizeof(uint32_t)), 0)
            << CStruct<Cpp>::kName << ": the member at byte " << at << " is in no list of members.hpp";
    }
}

TEST(CStructs, DefaultsAreThoseOfCpp) {
    const GlintImage image = initialized(glint_image_init);
    EXPECT_EQ(image.layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    EXPECT_EQ(image.stages, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT);
    EXPECT_EQ(image.samples, 1u);
    EXPECT_EQ(image.viewType, VK_IMAGE_VIEW_TYPE_MAX_ENUM);
    const GlintView view = initialized(glint_view_init);
    EXPECT_EQ(view.worldToView[0], 1);
    EXPECT_EQ(view.viewToClip[15], 1);
    EXPECT_EQ(initialized(glint_conventions_init).normalEncoding, GLINT_NORMAL_ENCODING_OCTAHEDRAL);
    EXPECT_EQ(initialized(glint_context_desc_init).demands, GLINT_DEVICE_DEMANDS_SOURCES);
    EXPECT_EQ(initialized(glint_surface_material_init).baseColorTexture.index, kNoSurfaceTexture);
    EXPECT_EQ(initialized(glint_probe_init).influence.rotation[3], 1);
    EXPECT_EQ(initialized(glint_ray_instance_init).mask, 0xffu);
    EXPECT_EQ(initialized(glint_reflections_desc_init).framesInFlight, 3u);
    const GBuffer gbuffer = *readStruct<GBuffer>([] {
        static GlintGBuffer empty = initialized(glint_gbuffer_init);
        return &empty;
    }());
    EXPECT_EQ(gbuffer.roughness.channel, 3u) << "an absent channel has the G-buffer's default";
    EXPECT_EQ(gbuffer.specular.bias, 0.5f);
}

TEST(CStructs, EveryMemberIsReadAndWritten) {
    expectRoundTrip<MaterialChannel>(glint_material_channel_init, {offsetof(GlintMaterialChannel, image),
                                                                   offsetof(GlintMaterialChannel, image) + 4});
    expectRoundTrip<Conventions>(glint_conventions_init);
    expectRoundTrip<View>(glint_view_init, {offsetof(GlintView, reserved), offsetof(GlintView, frameNumber) + 4});
    expectRoundTrip<RayInstance>(glint_ray_instance_init);
    expectRoundTrip<HostAccelerationStructure>(glint_host_acceleration_structure_init,
                                               {offsetof(GlintHostAccelerationStructure, topLevel),
                                                offsetof(GlintHostAccelerationStructure, topLevel) + 4,
                                                offsetof(GlintHostAccelerationStructure, triangleCounts),
                                                offsetof(GlintHostAccelerationStructure, triangleCounts) + 4,
                                                offsetof(GlintHostAccelerationStructure, reserved)});
    expectRoundTrip<SurfaceMaterial>(glint_surface_material_init);
    expectRoundTrip<SurfaceInstance>(glint_surface_instance_init);
    expectRoundTrip<SurfaceLight>(glint_surface_light_init);
    expectRoundTrip<PlanarMirror>(glint_planar_mirror_init);
    expectRoundTrip<RaySceneTimes>(glint_ray_scene_times_init,
                                   {4, 8, 16, 24, 32}); // the low words of small whole doubles are 0
    expectRoundTrip<Probe>(
        glint_probe_init, {offsetof(GlintProbe, cube), offsetof(GlintProbe, cube) + 4, offsetof(GlintProbe, reserved)});
}

TEST(CStructs, ImagesAndWhatPointsToThemAreRead) {
    GlintImage image = initialized(glint_image_init);
    image.image = reinterpret_cast<VkImage>(uintptr_t{1});
    image.view = reinterpret_cast<VkImageView>(uintptr_t{2});
    image.format = VK_FORMAT_R8G8B8A8_UNORM;
    image.width = 3;
    image.height = 4;
    image.layout = VK_IMAGE_LAYOUT_GENERAL;
    image.samples = 5;
    image.stages = 6;
    image.access = 7;
    image.usage = 8;
    image.mips = 9;
    image.viewType = VK_IMAGE_VIEW_TYPE_2D;
    const GlintImage again = toC(*readStruct<HostImage>(&image));
    EXPECT_EQ(std::memcmp(&image, &again, sizeof image), 0);

    GlintGBuffer gbuffer = initialized(glint_gbuffer_init);
    const GlintImage* GlintGBuffer::*const images[] = {
        &GlintGBuffer::depth,     &GlintGBuffer::normal,      &GlintGBuffer::material,
        &GlintGBuffer::baseColor, &GlintGBuffer::litRadiance, &GlintGBuffer::fallbackSpecular,
        &GlintGBuffer::motion,    &GlintGBuffer::backDepth,   &GlintGBuffer::transparentDepth};
    HostImage GBuffer::*const read[] = {&GBuffer::depth,     &GBuffer::normal,      &GBuffer::material,
                                        &GBuffer::baseColor, &GBuffer::litRadiance, &GBuffer::fallbackSpecular,
                                        &GBuffer::motion,    &GBuffer::backDepth,   &GBuffer::transparentDepth};
    for (size_t i = 0; i < std::size(images); ++i) {
        GlintGBuffer one = gbuffer;
        one.*images[i] = &image;
        const GBuffer cpp = *readStruct<GBuffer>(&one);
        for (size_t j = 0; j < std::size(read); ++j)
            EXPECT_EQ(static_cast<bool>(cpp.*read[j]), i == j) << i << " " << j;
    }
    GlintMaterialChannel channel = initialized(glint_material_channel_init);
    channel.image = &image;
    channel.channel = 2;
    gbuffer.roughness = &channel;
    const GBuffer cpp = *readStruct<GBuffer>(&gbuffer);
    EXPECT_EQ(cpp.roughness.image.image, image.image);
    EXPECT_EQ(cpp.roughness.channel, 2u);
}

TEST(CStructs, AnOlderHeaderLacksMembersWhichHaveTheirDefaults) {
    GlintConventions conventions = initialized(glint_conventions_init);
    conventions.depth = GLINT_DEPTH_LINEAR_VIEW_Z;
    conventions.linearDepthScale = 9;
    conventions.size = offsetof(GlintConventions, linearDepthScale);
    const Conventions read = *readStruct<Conventions>(&conventions);
    EXPECT_EQ(read.depth, DepthKind::LinearViewZ);
    EXPECT_EQ(read.linearDepthScale, 1) << "beyond the host's struct";

    GlintView mirrored;
    std::memset(&mirrored, 0x55, sizeof mirrored);
    mirrored.size = offsetof(GlintView, viewToClip);
    const GlintView view = initialized(glint_view_init);
    const GlintPlanarMirror mirror = initialized(glint_planar_mirror_init);
    EXPECT_EQ(glint_mirrored_view(&view, &mirror, &mirrored), GLINT_SUCCESS);
    EXPECT_EQ(mirrored.worldToView[15], 1);
    EXPECT_EQ(mirrored.reserved, 0x55555555u) << "nothing is written beyond the host's struct";
    EXPECT_EQ(mirrored.size, offsetof(GlintView, viewToClip));
}

TEST(CStructs, ANewerHeaderMayNotSetWhatTheLibraryLacks) {
    struct Newer {
        GlintOutputs outputs;
        uint64_t more;
    } newer = {initialized(glint_outputs_init), 0};
    newer.outputs.size = sizeof newer;
    EXPECT_TRUE(readStruct<Outputs>(&newer.outputs).ok());
    newer.more = 1;
    EXPECT_THAT(errorOf(readStruct<Outputs>(&newer.outputs)),
                AllOf(HasSubstr("GlintOutputs"), HasSubstr("does not have")));
}

TEST(CStructs, MistakesAreErrorsThatNameStructAndMember) {
    GlintView view = {};
    EXPECT_THAT(errorOf(readStruct<View>(&view)), HasSubstr("GlintView::size is 0"));
    view.size = 123456;
    EXPECT_THAT(errorOf(readStruct<View>(&view)), HasSubstr("GlintView::size is 123456"));
    EXPECT_THAT(errorOf(readStruct<View>(nullptr)), HasSubstr("GlintView is null"));

    GlintConventions conventions = initialized(glint_conventions_init);
    conventions.roughness = static_cast<GlintRoughnessKind>(3);
    EXPECT_THAT(errorOf(readStruct<Conventions>(&conventions)),
                HasSubstr("GlintConventions::roughness is 3: at most 2"));
    GlintGBuffer gbuffer = initialized(glint_gbuffer_init);
    gbuffer.conventions = &conventions;
    EXPECT_THAT(errorOf(readStruct<GBuffer>(&gbuffer)),
                HasSubstr("GlintGBuffer::conventions: GlintConventions::roughness is 3"));

    GlintRayInstance instances[2] = {initialized(glint_ray_instance_init), initialized(glint_ray_instance_init)};
    EXPECT_EQ(readArray<RayInstance>(instances, 2)->size(), 2u);
    instances[1].mask = 256;
    EXPECT_THAT(errorOf(readArray<RayInstance>(instances, 2)), HasSubstr("GlintRayInstance 1: GlintRayInstance::mask"));
    instances[1].size = 0;
    EXPECT_THAT(errorOf(readArray<RayInstance>(instances, 2)), HasSubstr("GlintRayInstance 1: size is 0"));
    EXPECT_THAT(errorOf(readArray<RayInstance>(nullptr, 2)), HasSubstr("null"));
    EXPECT_TRUE(readArray<RayInstance>(nullptr, 0)->empty());
}

TEST(CStructs, ElementsOfAnOlderHeaderLieCloser) {
    struct Older { // a GlintSurfaceInstance before localToWorld was appended
        uint32_t size, mesh, material;
    } older[3] = {{sizeof(Older), 1, 2}, {sizeof(Older), 3, 4}, {sizeof(Older), 5, 6}};
    const auto read =
        readArray<SurfaceInstance>(reinterpret_cast<const GlintSurfaceInstance*>(static_cast<void*>(older)), 3);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ((*read)[2].mesh, 5u);
    EXPECT_EQ((*read)[2].material, 6u);
    EXPECT_EQ((*read)[2].localToWorld, kIdentity);
}

TEST(CStructs, EnumsCountAsInCpp) {
    EXPECT_EQ(static_cast<int>(DeviceDemands::Screen), GLINT_DEVICE_DEMANDS_SCREEN);
    EXPECT_EQ(static_cast<int>(DeviceDemands::Sources), GLINT_DEVICE_DEMANDS_SOURCES);
    EXPECT_EQ(static_cast<int>(DepthKind::Device), GLINT_DEPTH_DEVICE);
    EXPECT_EQ(static_cast<int>(DepthKind::LinearViewZ), GLINT_DEPTH_LINEAR_VIEW_Z);
    EXPECT_EQ(static_cast<int>(Handedness::Right), GLINT_HANDEDNESS_RIGHT);
    EXPECT_EQ(static_cast<int>(Handedness::Left), GLINT_HANDEDNESS_LEFT);
    EXPECT_EQ(static_cast<int>(NormalSpace::World), GLINT_NORMAL_SPACE_WORLD);
    EXPECT_EQ(static_cast<int>(NormalSpace::View), GLINT_NORMAL_SPACE_VIEW);
    EXPECT_EQ(static_cast<int>(NormalEncoding::Signed), GLINT_NORMAL_ENCODING_SIGNED);
    EXPECT_EQ(static_cast<int>(NormalEncoding::Unorm), GLINT_NORMAL_ENCODING_UNORM);
    EXPECT_EQ(static_cast<int>(NormalEncoding::Octahedral), GLINT_NORMAL_ENCODING_OCTAHEDRAL);
    EXPECT_EQ(static_cast<int>(NormalEncoding::OctahedralUnorm), GLINT_NORMAL_ENCODING_OCTAHEDRAL_UNORM);
    EXPECT_EQ(static_cast<int>(MaterialKind::F0Roughness), GLINT_MATERIAL_F0_ROUGHNESS);
    EXPECT_EQ(static_cast<int>(MaterialKind::MetallicRoughness), GLINT_MATERIAL_METALLIC_ROUGHNESS);
    EXPECT_EQ(static_cast<int>(MaterialKind::SpecularGlossiness), GLINT_MATERIAL_SPECULAR_GLOSSINESS);
    EXPECT_EQ(static_cast<int>(MaterialKind::Standard), GLINT_MATERIAL_STANDARD);
    EXPECT_EQ(static_cast<int>(RoughnessKind::Perceptual), GLINT_ROUGHNESS_PERCEPTUAL);
    EXPECT_EQ(static_cast<int>(RoughnessKind::Alpha), GLINT_ROUGHNESS_ALPHA);
    EXPECT_EQ(static_cast<int>(RoughnessKind::Smoothness), GLINT_ROUGHNESS_SMOOTHNESS);
    EXPECT_EQ(static_cast<int>(RayBackend::Auto), GLINT_RAY_BACKEND_AUTO);
    EXPECT_EQ(static_cast<int>(RayBackend::Query), GLINT_RAY_BACKEND_QUERY);
    EXPECT_EQ(static_cast<int>(RayBackend::Bvh), GLINT_RAY_BACKEND_BVH);
    EXPECT_EQ(static_cast<int>(InstanceNumbering::TopLevelIndex), GLINT_INSTANCE_NUMBERING_TOP_LEVEL_INDEX);
    EXPECT_EQ(static_cast<int>(InstanceNumbering::CustomIndex), GLINT_INSTANCE_NUMBERING_CUSTOM_INDEX);
    EXPECT_EQ(static_cast<int>(SurfaceAlpha::Opaque), GLINT_SURFACE_ALPHA_OPAQUE);
    EXPECT_EQ(static_cast<int>(SurfaceAlpha::Mask), GLINT_SURFACE_ALPHA_MASK);
    EXPECT_EQ(static_cast<int>(SurfaceAlpha::Blend), GLINT_SURFACE_ALPHA_BLEND);
    EXPECT_EQ(static_cast<int>(SurfaceLightKind::Directional), GLINT_LIGHT_DIRECTIONAL);
    EXPECT_EQ(static_cast<int>(SurfaceLightKind::Point), GLINT_LIGHT_POINT);
    EXPECT_EQ(static_cast<int>(SurfaceLightKind::Spot), GLINT_LIGHT_SPOT);
    EXPECT_EQ(static_cast<int>(ProbeShape::Box), GLINT_PROBE_SHAPE_BOX);
    EXPECT_EQ(static_cast<int>(ProbeShape::Sphere), GLINT_PROBE_SHAPE_SPHERE);
    EXPECT_EQ(static_cast<int>(ProbeProxy::Infinite), GLINT_PROBE_PROXY_INFINITE);
    EXPECT_EQ(static_cast<int>(ProbeProxy::Box), GLINT_PROBE_PROXY_BOX);
    EXPECT_EQ(static_cast<int>(ProbeProxy::Sphere), GLINT_PROBE_PROXY_SPHERE);
    EXPECT_EQ(static_cast<int>(SettingType::Boolean), GLINT_SETTING_BOOLEAN);
    EXPECT_EQ(static_cast<int>(SettingType::Int), GLINT_SETTING_INT);
    EXPECT_EQ(static_cast<int>(SettingType::Float), GLINT_SETTING_FLOAT);
    EXPECT_EQ(static_cast<int>(SettingType::Enum), GLINT_SETTING_CHOICE);
    EXPECT_EQ(sizeof(GlintRayHit), sizeof(RayHit));
}

} // namespace struct_reading_test
} // namespace glint::c_api
