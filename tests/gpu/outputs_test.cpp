// Images of the host for Glint's results, and what the returned image promises.
#include "gpu/pass.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <list>

namespace glint::test {
namespace outputs_test {

using testing::AllOf;
using testing::HasSubstr;

constexpr uint32_t kWidth = 80;
constexpr uint32_t kHeight = 45;
constexpr VkFormat kHalf = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkImageUsageFlags kUsage =
    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

class OutputsTest : public LibraryTest {
protected:
    /// An image of the host, filled with a value that no frame has, in the layout that the host keeps it in.
    HostImage makeOutput(VkImageLayout layout, VkFormat format = kHalf,
                         VkImageUsageFlags usage = kUsage | VK_IMAGE_USAGE_TRANSFER_DST_BIT) {
        gpu::Image& image = images_.emplace_back(must(
            gpu::Image::create(gpu(), {"test/output", format, kWidth, kHeight, 1, 1, gpu::ImageShape::Flat, usage})));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.clear(image, {.float32 = {77, 77, 77, 77}});
            frame.hand(image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, layout});
        });
        HostImage host = asHostImage(image);
        host.layout = layout;
        return host;
    }
    /// What the host draws over its image, which it leaves in `image`'s layout.
    static void drawOver(const HostImage& image, const glm::vec3& color) {
        gpu::ResourceState state;
        state.layout = image.layout;
        gpu::Image borrowed = gpu::Image::borrow(
            image.image, image.view,
            {"test/drawn", image.format, image.width, image.height, 1, 1, gpu::ImageShape::Flat, 0}, state);
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.clear(borrowed, {.float32 = {color.r, color.g, color.b, 1}});
            frame.hand(borrowed, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, image.layout});
        });
    }
    static HostImage record(Reflections& reflections, const View& view) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = reflections.record(commands, view); });
        return image;
    }
    static Settings previousSettings() {
        Settings settings = plainSettings();
        settings.screen.colorSource = ColorSource::Previous;
        return settings;
    }
    static bool ran(Reflections& reflections, const char* pass) {
        const std::vector<PassTime> times = reflections.passTimes();
        return std::ranges::any_of(times, [&](const PassTime& time) { return time.name == pass; });
    }
    static Reflections make(const Settings& settings) {
        ReflectionsDesc desc = {kWidth, kHeight, settings};
        desc.views = desc.transparentLayers = true;
        desc.framesInFlight = 1;
        return must(Reflections::create(library(), desc));
    }
    View view(double x = 0) const {
        SyntheticCamera camera = camera_;
        camera.position.x += x;
        return camera.view(kWidth, kHeight);
    }

    SyntheticCamera camera_;
    /// Partly reflecting, with a fallback that the reflections replace.
    const SyntheticGBuffer host_ = SyntheticGBuffer::render(
        gpu(),
        [](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto hit = floorAndWall()(origin, direction);
            if (hit && hit->f0.x > 0) {
                hit->f0 = glm::vec3(0.5f, 0.25f, 0.75f);
                hit->radiance = glm::vec3(3, 2, 1);
            }
            return hit;
        },
        camera_, kWidth, kHeight);
    std::list<gpu::Image> images_;
};

TEST_F(OutputsTest, TheReturnedImageIsTheSameInEveryFrame) {
    for (const Settings& settings : {plainSettings(), previousSettings()}) {
        Reflections made = make(settings);
        must(made.setInputs(host_.gbuffer));
        const HostImage first = record(made, view());
        for (int frame = 1; frame < 5; ++frame) {
            // What a host with a static descriptor shows is this frame's image.
            drawOver(first, glm::vec3(static_cast<float>(frame)));
            const HostImage image = record(made, view(0.1 * frame));
            EXPECT_EQ(image.image, first.image) << frame;
            EXPECT_EQ(image.view, first.view) << frame;
            EXPECT_EQ(image.layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
            const float wall = download(gpu(), host_.gbuffer.litRadiance)[0]; // in the top row, where nothing reflects
            EXPECT_NEAR(download(gpu(), first)[0], wall, 0x1p-10f * wall) << frame;
        }
    }
}

TEST_F(OutputsTest, TheHostsImageGetsTheBitsOfGlints) {
    for (const Settings& settings : {plainSettings(), previousSettings()})
        for (const VkImageLayout layout : {VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}) {
            Reflections own = make(settings);
            Reflections hosts = make(settings);
            const HostImage output = makeOutput(layout);
            must(own.setInputs(host_.gbuffer));
            must(hosts.setInputs(host_.gbuffer));
            must(hosts.setOutputs({.composite = output}));
            for (int frame = 0; frame < 4; ++frame) {
                const HostImage wanted = record(own, view(0.1 * frame));
                const HostImage got = record(hosts, view(0.1 * frame));
                EXPECT_EQ(got.image, output.image);
                EXPECT_EQ(got.view, output.view);
                EXPECT_EQ(got.layout, layout);
                EXPECT_EQ(download(gpu(), output), download(gpu(), wanted)) << frame;
                HostImage view; // of the frame, whose reflections are read again
                run([&](VkCommandBuffer commands) { view = must(hosts.recordView(commands, "reflection")); });
                EXPECT_TRUE(std::ranges::any_of(download(gpu(), view), [](float value) { return value > 1; }));
            }
            must(hosts.setOutputs({})); // and back to Glint's own
            const HostImage again = record(hosts, view());
            EXPECT_NE(again.image, output.image);
            EXPECT_EQ(again.layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        }
}

TEST_F(OutputsTest, PreviousColoursShowWhatTheHostDrewOverItsImage) {
    Reflections made = make(previousSettings());
    // Nothing that Glint does with it needs TRANSFER_SRC.
    const HostImage output =
        makeOutput(VK_IMAGE_LAYOUT_GENERAL, kHalf,
                   VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    must(made.setInputs(host_.gbuffer));
    must(made.setOutputs({.composite = output}));
    record(made, view());
    drawOver(output, {0, 42, 0});
    record(made, view());
    HostImage reflection;
    run([&](VkCommandBuffer commands) { reflection = must(made.recordView(commands, "reflection")); });
    const std::vector<float> texels = download(gpu(), reflection);
    size_t green = 0;
    for (size_t i = 0; i < texels.size(); i += 4)
        green += texels[i] == 0 && texels[i + 1] == 42 && texels[i + 2] == 0;
    EXPECT_GT(green, 300u);
}

TEST_F(OutputsTest, ReflectionsAloneLetTheHostComposite) {
    Settings settings = plainSettings();
    settings.reflect.fresnel = false; // the response is F0
    const gpu::Image fallback =
        uploadTestImage(gpu(), "test/fallback", VK_FORMAT_R32G32B32A32_SFLOAT, kWidth, kHeight,
                        bytesOf(std::vector<glm::vec4>(size_t{kWidth} * kHeight, glm::vec4(0.5f, 0.25f, 0.125f, 0))));
    GBuffer gbuffer = host_.gbuffer;
    gbuffer.fallbackSpecular = asHostImage(fallback);

    Reflections whole = make(settings);
    must(whole.setInputs(gbuffer));
    const std::vector<float> wanted = download(gpu(), record(whole, view()));

    Reflections made = make(settings);
    const HostImage output = makeOutput(VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    must(made.setInputs(gbuffer));
    must(made.setOutputs({.reflection = output}));
    EXPECT_EQ(record(made, view()).image, output.image);
    EXPECT_FALSE(ran(made, "composite/composite"));
    EXPECT_TRUE(ran(made, "hierarchy/combine"));

    const std::vector<float> reflection = download(gpu(), output);
    const std::vector<float> lit = download(gpu(), gbuffer.litRadiance);
    const std::vector<float> material = download(gpu(), gbuffer.material);
    const std::vector<float> replaced = download(gpu(), gbuffer.fallbackSpecular);
    size_t reflecting = 0;
    for (size_t i = 0; i < lit.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) {
            const double f0 = material[i + c];
            const double weight = f0 > 0 ? reflection[i + 3] : 0;
            const double out = lit[i + c] - weight * replaced[i + c] + f0 * reflection[i + c];
            ASSERT_NEAR(wanted[i + c], std::max(out, 0.0), 0x1p-10 * std::abs(out) + 1e-3) << i;
            reflecting += weight > 0.99 && c == 0;
        }
    EXPECT_GT(reflecting, 300u);
}

TEST_F(OutputsTest, WithoutAReaderNoImageHoldsTheReflectionsAlone) {
    const auto environment = TestEnvironment::make(gpu(), 16, 1, [](const glm::dvec3& direction, uint32_t) {
        return glm::vec3(1.5f + static_cast<float>(direction.y));
    });
    for (const CompositeModel model : {CompositeModel::Physical, CompositeModel::Lerp}) {
        Settings settings = plainSettings();
        settings.sky.enabled = true;
        settings.composite.model = model;
        Reflections shown = make(settings);
        ReflectionsDesc desc = {kWidth, kHeight, settings};
        desc.framesInFlight = 1;
        Reflections made = must(Reflections::create(library(), desc));
        must(shown.setInputs(host_.gbuffer, environment.map));
        must(made.setInputs(host_.gbuffer, environment.map));
        const std::vector<float> wanted = download(gpu(), record(shown, view()));
        EXPECT_TRUE(ran(shown, "hierarchy/combine"));
        // The same but for the rounding of the image between the two passes.
        const auto check = [&](const char* when) {
            const std::vector<float> found = download(gpu(), record(made, view()));
            for (size_t i = 0; i < wanted.size(); ++i)
                ASSERT_NEAR(found[i], wanted[i], 0x1p-9 * std::abs(wanted[i])) << when << ", value " << i;
        };
        check("at first");
        EXPECT_TRUE(ran(made, "composite/combined"));
        EXPECT_FALSE(ran(made, "hierarchy/combine") || ran(made, "composite/composite"));
        must(made.setOutputs({.reflection = makeOutput(VK_IMAGE_LAYOUT_GENERAL)}));
        record(made, view());
        EXPECT_TRUE(ran(made, "hierarchy/combine"));
        must(made.setOutputs(
            {.composite = makeOutput(VK_IMAGE_LAYOUT_GENERAL), .reflection = makeOutput(VK_IMAGE_LAYOUT_GENERAL)}));
        check("beside the host's image of the reflections");
        EXPECT_TRUE(ran(made, "hierarchy/combine") && ran(made, "composite/composite"));
        must(made.setOutputs({}));
        check("in the end");
        EXPECT_TRUE(ran(made, "composite/combined"));
    }
}

TEST_F(OutputsTest, BothAtOnce) {
    Reflections own = make(plainSettings());
    Reflections made = make(plainSettings());
    const Outputs outputs = {makeOutput(VK_IMAGE_LAYOUT_GENERAL), makeOutput(VK_IMAGE_LAYOUT_GENERAL)};
    must(own.setInputs(host_.gbuffer));
    must(made.setInputs(host_.gbuffer));
    must(made.setOutputs(outputs));
    EXPECT_EQ(record(made, view()).image, outputs.composite.image);
    EXPECT_EQ(download(gpu(), outputs.composite), download(gpu(), record(own, view())));
    must(own.setOutputs({.reflection = outputs.composite}));
    record(own, view());
    EXPECT_EQ(download(gpu(), outputs.reflection), download(gpu(), outputs.composite));
}

TEST_F(OutputsTest, WithEverySourceOffTheHostsImagesAreStillWritten) {
    Settings settings = plainSettings();
    settings.screen.enabled = false;
    Reflections made = make(settings);
    const Outputs outputs = {makeOutput(VK_IMAGE_LAYOUT_GENERAL), makeOutput(VK_IMAGE_LAYOUT_GENERAL)};
    must(made.setInputs(host_.gbuffer));
    must(made.setOutputs(outputs));
    EXPECT_EQ(record(made, view()).image, outputs.composite.image);
    const std::vector<float> lit = download(gpu(), host_.gbuffer.litRadiance);
    const std::vector<float> composite = download(gpu(), outputs.composite);
    for (size_t i = 0; i < lit.size(); ++i)
        ASSERT_NEAR(composite[i], lit[i], 0x1p-10f * lit[i]) << "as a half";
    EXPECT_EQ(download(gpu(), outputs.reflection), std::vector<float>(lit.size(), 0));
}

TEST_F(OutputsTest, MistakesAreOneErrorEach) {
    Reflections made = make(plainSettings());
    must(made.setInputs(host_.gbuffer));
    const HostImage right = makeOutput(VK_IMAGE_LAYOUT_GENERAL);
    const auto refuses = [&](auto matcher, auto change) {
        Outputs outputs = {.composite = right};
        change(outputs);
        const Result<void> result = made.setOutputs(outputs);
        ASSERT_FALSE(result);
        EXPECT_THAT(result.error().message, matcher);
    };
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("79x45"), HasSubstr("80x45")),
            [](Outputs& o) { o.composite.width = 79; });
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("no view")), [](Outputs& o) { o.composite.view = {}; });
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("layout")),
            [](Outputs& o) { o.composite.layout = VK_IMAGE_LAYOUT_UNDEFINED; });
    refuses(AllOf(HasSubstr("`reflection`"), HasSubstr("R16G16B16A16_SFLOAT")),
            [&](Outputs& o) { o.reflection = makeOutput(VK_IMAGE_LAYOUT_GENERAL, VK_FORMAT_R32G32B32A32_SFLOAT); });
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("STORAGE")),
            [](Outputs& o) { o.composite.usage = VK_IMAGE_USAGE_SAMPLED_BIT; });
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("2 mips")), [](Outputs& o) { o.composite.mips = 2; });
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("4 samples")), [](Outputs& o) { o.composite.samples = 4; });
    refuses(HasSubstr("one image"), [](Outputs& o) { o.reflection = o.composite; });
    // An image is input or output.
    GBuffer aliased = host_.gbuffer;
    aliased.fallbackSpecular = right;
    must(made.setInputs(aliased));
    refuses(AllOf(HasSubstr("`composite`"), HasSubstr("`fallbackSpecular`")), [](Outputs&) {});
    must(made.setInputs(host_.gbuffer));
    must(made.setOutputs({.composite = right}));
    const Result<void> inputs = made.setInputs(aliased);
    ASSERT_FALSE(inputs);
    EXPECT_THAT(inputs.error().message, HasSubstr("`fallbackSpecular`"));
    // The previous frame's image with reflections is none that `reflection` alone could give.
    must(made.setOutputs({.reflection = right}));
    const Result<void> settings = made.setSettings(previousSettings());
    ASSERT_FALSE(settings);
    EXPECT_THAT(settings.error().message, AllOf(HasSubstr("colorSource"), HasSubstr("`composite`")));
    must(made.setOutputs({}));
    must(made.setSettings(previousSettings()));
    refuses(HasSubstr("colorSource"), [](Outputs& o) { std::swap(o.composite, o.reflection); });
}

} // namespace outputs_test
} // namespace glint::test
