// What it takes to add a source: a row of the table with a pass of its own. This is a toy, a shader and a few lines
// here; no shader and no line of the library knows it (docs/architecture.md, "Adding a source").
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/test_shaders.hpp"
#include "reflect/composite/view_names.hpp"
#include "reflect/frame.hpp"

namespace glint::test {
namespace seams_test {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 40;

class SeamsTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        library().gpu().addShaders(gpu::shaders::test());
        host_ = SyntheticGBuffer::render(gpu(), floorAndWall(), camera_, kWidth, kHeight);
    }

    std::unique_ptr<reflect::FrameStages> makeFrame() {
        ReflectionsDesc desc = {kWidth, kHeight, plainSettings(), false, true};
        auto frame = must(reflect::FrameStages::create(library().gpu(), desc));
        must(frame->setInputs(host_.gbuffer, {}));
        return frame;
    }

    static gpu::Image makeImage(const char* name) {
        gpu::Image image;
        must(reflect::makeImage(library().gpu(), image, {name, VK_FORMAT_R16G16B16A16_SFLOAT, kWidth, kHeight}));
        return image;
    }

    std::vector<float> show(reflect::FrameStages& frame, std::string_view view) {
        run([&](VkCommandBuffer commands) { frame.record(commands, camera_.view(kWidth, kHeight)); });
        const auto number =
            static_cast<uint32_t>(std::ranges::find(reflect::kViewNames, view) - reflect::kViewNames.begin());
        gpu::Image* image = nullptr;
        run([&](VkCommandBuffer commands) { image = &frame.recordView(commands, number); });
        return download(gpu(), reflect::handOut(*image));
    }

    SyntheticCamera camera_;
    SyntheticGBuffer host_;
};

TEST_F(SeamsTest, ASourceIsARowOfTheTable) {
    const gpu::Pipeline pass = must(gpu::Pipeline::compute(library().gpu(), {"toy_source", 0, {}}));
    gpu::Image answer = makeImage("toy/answer");
    const auto without = makeFrame();
    const std::vector<float> screen = show(*without, "reflection");
    const std::vector<float> weight = show(*without, "weight");

    const auto frame = makeFrame();
    bool asked = false;
    bool takesPart = true;
    const uint32_t number =
        frame->addSource({"toy", [&] { return takesPart; },
                          [&](gpu::Frame& recording, const reflect::EarlierAnswers& before) {
                              EXPECT_EQ(before.before, 0u) << "it is asked first";
                              asked = true;
                              recording.pass(pass).write("answer", answer).dispatch(kWidth, kHeight);
                          },
                          [&] { return &answer; }});
    EXPECT_EQ(number, shared::kSourceCount);
    const std::vector<float> both = show(*frame, "reflection");
    EXPECT_TRUE(asked);
    size_t answered = 0;
    for (size_t i = 0; i < both.size(); i += 4) {
        if (both[i] == 0) // the background
            continue;
        ++answered;
        const float share = std::min(weight[i], 0.5f); // of the screen: what the toy leaves
        const glm::vec3 toy(1, 0.5f, 0.25f);
        for (size_t c = 0; c < 3; ++c) {
            const float color = weight[i] > 0 ? screen[i + c] / weight[i] : 0;
            ASSERT_NEAR(both[i + c], toy[static_cast<int>(c)] + share * color, 4e-3) << i / 4;
        }
    }
    EXPECT_GT(answered, kWidth * kHeight / 4u);

    takesPart = false;
    EXPECT_EQ(show(*frame, "reflection"), screen);
}

/// Any image that a pass wrote is a view, by its pass and its name there.
TEST_F(SeamsTest, WhatAPassWroteIsAView) {
    Reflections made = reflections(kWidth, kHeight, plainSettings());
    must(made.setInputs(host_.gbuffer));
    EXPECT_TRUE(made.passImages().empty());
    HostImage composite;
    run([&](VkCommandBuffer commands) { composite = made.record(commands, camera_.view(kWidth, kHeight)); });
    const std::vector<float> picture = download(gpu(), composite);
    const std::vector<std::string> images = made.passImages();
    for (const char* name : {"trace/hiz:radianceWeight", "prepare/classified:viewZ", "hierarchy/combine:weights"})
        EXPECT_NE(std::ranges::find(images, name), images.end()) << name;
    const auto shown = [&](std::string_view name) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = must(made.recordView(commands, name)); });
        return download(gpu(), image);
    };
    EXPECT_EQ(shown("composite/composite:composite"), picture);
    for (const std::string& name : images)
        shown(name); // the validation layer watches
    run([&](VkCommandBuffer commands) {
        const Result<HostImage> wrong = made.recordView(commands, "trace/hiz:radiance");
        ASSERT_FALSE(wrong);
        EXPECT_NE(wrong.error().message.find("trace/hiz:radianceWeight"), std::string::npos) << wrong.error().message;
    });
}

} // namespace seams_test
} // namespace glint::test
