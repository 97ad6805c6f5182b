// One frame in the conventions of every kind of host must produce the same image.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <algorithm>

namespace glint::test {
namespace host_conventions_test {

constexpr uint32_t kWidth = 96;
constexpr uint32_t kHeight = 54;

/// A host's conventions for the frame.
struct Style {
    std::string name;
    bool reversed = true;
    bool infinite = true;
    bool orthographic = false;
    bool jittered = false;
    Conventions conventions;
    uint32_t roughnessChannel = 3;
    bool smooth() const { return conventions.roughness == RoughnessKind::Smoothness; }
};

std::vector<Style> everyStyle() {
    std::vector<Style> styles;
    const auto add = [&](std::string name, auto change) {
        Style style;
        style.name = std::move(name);
        change(style);
        styles.push_back(style);
    };
    // The clip space: all combinations of its choices.
    for (int bits = 0; bits < 64; ++bits) {
        if ((bits & 32) && (bits & 2))
            continue;
        add("clip" + std::to_string(bits), [&](Style& style) {
            style.reversed = bits & 1;
            style.infinite = bits & 2;
            style.conventions.depthMinusOneToOne = bits & 4;
            style.conventions.clipYDown = bits & 8;
            style.conventions.handedness = bits & 16 ? Handedness::Left : Handedness::Right;
            style.orthographic = bits & 32;
        });
    }
    // All combinations of normals' space, encoding and handedness.
    for (int bits = 0; bits < 16; ++bits)
        add("normal" + std::to_string(bits), [&](Style& style) {
            style.conventions.normalSpace = bits & 1 ? NormalSpace::View : NormalSpace::World;
            style.conventions.handedness = bits & 2 ? Handedness::Left : Handedness::Right;
            style.conventions.normalEncoding = static_cast<NormalEncoding>(bits / 4);
        });
    for (uint32_t channel : {2u, 3u}) // another channel than alpha holds a part of F0 as well: scene() fits smoothness
        add("smoothness" + std::to_string(channel), [&](Style& style) {
            style.roughnessChannel = channel;
            style.conventions.roughness = RoughnessKind::Smoothness;
        });
    for (const bool left : {false, true})
        for (const bool orthographic : {false, true})
            add("linearDepth", [&](Style& style) {
                style.conventions.depth = DepthKind::LinearViewZ;
                // The z of the view space that the host has, in metres and in centimetres.
                style.conventions.linearDepthScale = (left ? 1.0f : -1.0f) * (orthographic ? 0.01f : 1.0f);
                style.conventions.handedness = left ? Handedness::Left : Handedness::Right;
                style.orthographic = orthographic;
                style.infinite = !orthographic;
            });
    add("positiveLinearDepth", [](Style& style) { style.conventions.depth = DepthKind::LinearViewZ; });
    add("allAtOnce", [](Style& style) {
        style.reversed = false;
        style.infinite = false;
        style.conventions = {DepthKind::Device,
                             true,
                             true,
                             Handedness::Left,
                             NormalSpace::View,
                             NormalEncoding::OctahedralUnorm,
                             MaterialKind::F0Roughness,
                             RoughnessKind::Smoothness};
        style.roughnessChannel = 2;
    });
    return styles;
}

SyntheticCamera cameraOf(const Style& style) {
    SyntheticCamera camera;
    if (style.orthographic) {
        camera.orthoHeight = 3;
        camera.far = 12;
    }
    return camera;
}

/// NDC depth = constant + slope * (perspective ? 1/viewZ : viewZ), through the planes of the style.
glm::dvec2 depthCurve(const Style& style, const SyntheticCamera& camera) {
    const double low = style.conventions.depthMinusOneToOne ? -1 : 0;
    const double atNear = style.reversed ? 1 : low;
    const double atFar = style.reversed ? low : 1;
    constexpr double kFar = 200;
    if (style.orthographic) {
        const double slope = (atFar - atNear) / (camera.far - camera.near);
        return {atNear - slope * camera.near, slope};
    }
    const double farInverse = style.infinite ? 0 : 1 / kFar;
    const double slope = (atNear - atFar) / (1 / camera.near - farInverse);
    return {atFar - slope * farInverse, slope};
}

View viewOf(const Style& style, const SyntheticCamera& camera) {
    const double z = style.conventions.handedness == Handedness::Left ? 1 : -1;
    glm::dmat4 toClip = camera.viewToClip(kWidth, kHeight);
    const glm::dvec2 curve = depthCurve(style, camera);
    if (style.orthographic) {
        toClip[2].z = z * curve.y;
        toClip[3].z = curve.x;
    } else {
        toClip[2].z = z * curve.x;
        toClip[2].w = z;
        toClip[3].z = curve.y;
    }
    glm::dmat4 toView = camera.worldToView();
    for (int column = 0; column < 4; ++column) {
        if (style.conventions.clipYDown)
            toClip[column].y = -toClip[column].y;
        if (z > 0)
            toView[column].z = -toView[column].z;
    }
    View view;
    view.worldToView = toMatrix4(toView);
    view.viewToClip = toMatrix4(toClip);
    return view;
}

/// Roughness rises across the floor; F0's blue channel has the same value, so that it can double as a smoothness
/// channel.
std::optional<SyntheticSurface> scene(const glm::dvec3& origin, const glm::dvec3& direction) {
    auto hit = floorAndWall()(origin, direction);
    if (hit && hit->f0.x > 0) {
        const double x = (origin + direction * hit->distance).x;
        hit->perceptualRoughness = static_cast<float>(glm::clamp(0.25 + 0.15 * x, 0.0, 1.0));
        hit->f0 = glm::vec3(1, 0.9f, 1 - hit->perceptualRoughness);
        hit->normalWS = glm::normalize(glm::dvec3(0.02, 1, 0.03)); // along no axis
    } else if (hit) {
        hit->perceptualRoughness = 1;
    }
    return hit;
}

SyntheticGBuffer write(gpu::Context& context, const Style& style, const SyntheticCamera& camera) {
    const Conventions& c = style.conventions;
    const glm::dmat3 worldToView(camera.worldToView());
    const glm::dvec2 curve = depthCurve(style, camera);
    std::vector<float> depth;
    std::vector<glm::vec4> normal;
    std::vector<glm::vec4> material;
    std::vector<glm::vec4> lit;
    const auto pixels = seen(scene, camera, kWidth, kHeight);
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const SyntheticSurface surface = pixels[i].value_or(SyntheticSurface{});
        const glm::dvec3 ray = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const double viewZ = -(worldToView * ray).z * surface.distance;
        double stored = curve.x + curve.y * (style.orthographic ? viewZ : 1 / viewZ);
        if (c.depthMinusOneToOne)
            stored = stored * 0.5 + 0.5;
        if (!pixels[i])
            stored = style.reversed ? 0 : 1;
        if (c.depth == DepthKind::LinearViewZ)
            stored = pixels[i] ? viewZ / static_cast<double>(c.linearDepthScale) : 0;
        depth.push_back(static_cast<float>(stored));

        glm::dvec3 n = surface.normalWS;
        if (c.normalSpace == NormalSpace::View) {
            n = worldToView * n;
            if (c.handedness == Handedness::Left)
                n.z = -n.z;
        }
        const bool octahedral =
            c.normalEncoding == NormalEncoding::Octahedral || c.normalEncoding == NormalEncoding::OctahedralUnorm;
        const bool unorm =
            c.normalEncoding == NormalEncoding::Unorm || c.normalEncoding == NormalEncoding::OctahedralUnorm;
        glm::vec4 encoded = octahedral ? glm::vec4(encodeOctahedral(n), 9, 9) : glm::vec4(glm::vec3(n), 9);
        if (unorm)
            encoded = encoded * 0.5f + 0.5f;
        normal.push_back(encoded);

        glm::vec4 m(surface.f0, 0.77f);
        m[static_cast<int>(style.roughnessChannel)] =
            style.smooth() ? 1 - surface.perceptualRoughness : surface.perceptualRoughness;
        material.push_back(m);
        lit.emplace_back(surface.radiance, 1.0f);
    }
    SyntheticGBuffer out;
    constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;
    out.depth = uploadTestImage(context, "test/depth", VK_FORMAT_R32_SFLOAT, kWidth, kHeight, bytesOf(depth));
    out.normal = uploadTestImage(context, "test/normal", kWide, kWidth, kHeight, bytesOf(normal));
    out.material = uploadTestImage(context, "test/material", kWide, kWidth, kHeight, bytesOf(material));
    out.litRadiance = uploadTestImage(context, "test/lit", kWide, kWidth, kHeight, bytesOf(lit));
    out.gbuffer.depth = asHostImage(out.depth);
    out.gbuffer.normal = asHostImage(out.normal);
    out.gbuffer.material = asHostImage(out.material);
    out.gbuffer.litRadiance = asHostImage(out.litRadiance);
    out.gbuffer.conventions = c;
    out.gbuffer.roughness.channel = style.roughnessChannel;
    return out;
}

class HostConventionsTest : public LibraryTest {
protected:
    static Picture trace(Reflections& reflections, const Style& style) {
        const SyntheticCamera camera = cameraOf(style);
        const SyntheticGBuffer host = write(gpu(), style, camera);
        must(reflections.setInputs(host.gbuffer));
        return LibraryTest::trace(reflections, viewOf(style, camera));
    }
};

TEST_F(HostConventionsTest, everyHostGetsThePictureOfGlintsOwnConventions) {
    Settings settings = plainSettings();
    settings.screen.thickness = 0.2f;
    Reflections made = reflections(kWidth, kHeight, settings);
    std::optional<Picture> perspective;
    std::optional<Picture> orthographic;
    for (const Style& style : everyStyle()) {
        std::optional<Picture>& reference = style.orthographic ? orthographic : perspective;
        if (!reference) {
            Style own;
            own.orthographic = style.orthographic;
            own.infinite = !style.orthographic;
            reference = trace(made, own);
            uint64_t hits = 0;
            for (size_t i = 0; i < reference->pixels(); ++i)
                hits += reference->hit(i);
            ASSERT_GT(hits, 700u);
        }
        const Picture picture = trace(made, style);
        size_t different = 0;
        double worstColor = 0;
        for (size_t i = 0; i < picture.pixels(); ++i) {
            if (picture.outcome(i) != reference->outcome(i)) {
                ++different;
                continue;
            }
            const bool sameHit = glm::length(picture.hitPX(i) - reference->hitPX(i)) < 0.5;
            const glm::dvec3 error = glm::abs(glm::dvec3(picture.color(i)) - glm::dvec3(reference->color(i)));
            // Colours have half precision (a step of 2^-7 at 10) and change by 0.2 from one pixel to the next.
            const double worst = std::max({error.x, error.y, error.z});
            worstColor = std::max(worstColor, sameHit ? worst : 0);
            different += !sameHit || worst > 0.25;
        }
        // Rounding of the host's stored depth may decide at silhouettes and on the border's pixels, but rarely.
        EXPECT_LE(different, picture.pixels() / 200) << style.name << ", worst colour error " << worstColor;
    }
}

TEST_F(HostConventionsTest, aWrongStatementIsSeen) {
    // The test above can fail: with each convention declared wrongly the image differs.
    Reflections made = reflections(kWidth, kHeight);
    Style right;
    const Picture reference = trace(made, right);
    const SyntheticCamera camera;
    const auto differs = [&](auto lie, const View& view) {
        const SyntheticGBuffer host = write(gpu(), right, camera);
        GBuffer gbuffer = host.gbuffer;
        lie(gbuffer);
        must(made.setInputs(gbuffer));
        const Picture picture = LibraryTest::trace(made, view);
        size_t different = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            different += picture.outcome(i) != reference.outcome(i) ||
                         glm::length(picture.hitPX(i) - reference.hitPX(i)) > 0.5 ||
                         std::abs(picture.weight[i * 4] - reference.weight[i * 4]) > 0.05f;
        return different > picture.pixels() / 20;
    };
    const View view = viewOf(right, camera);
    const auto differsBy = [&](auto lie) { return differs([&](GBuffer& g) { lie(g.conventions); }, view); };
    EXPECT_FALSE(differsBy([](Conventions&) {}));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.depth = DepthKind::LinearViewZ; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.depthMinusOneToOne = true; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.clipYDown = true; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.handedness = Handedness::Left; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.normalSpace = NormalSpace::View; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.normalEncoding = NormalEncoding::Signed; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.normalEncoding = NormalEncoding::OctahedralUnorm; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.roughness = RoughnessKind::Smoothness; }));
    EXPECT_TRUE(differsBy([](Conventions& c) { c.roughness = RoughnessKind::Alpha; }));
    EXPECT_TRUE(differs([](GBuffer& g) { g.roughness.channel = 0; }, view));
}

} // namespace host_conventions_test
} // namespace glint::test
