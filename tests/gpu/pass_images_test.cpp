// The images that a frame's passes write are views, each by its pass and its name there.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <algorithm>

namespace glint::test {
namespace {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 40;

class PassImagesTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        host_ = SyntheticGBuffer::render(gpu(), floorAndWall(), camera_, kWidth, kHeight);
    }

    SyntheticCamera camera_;
    SyntheticGBuffer host_;
};

TEST_F(PassImagesTest, WhatAPassWroteIsAView) {
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

} // namespace
} // namespace glint::test
