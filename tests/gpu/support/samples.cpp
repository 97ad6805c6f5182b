#include "gpu/support/samples.hpp"

#include "gpu/pass.hpp"

namespace glint::test {

gpu::Image makeSamples(gpu::Context& context, const char* name, VkFormat format, uint32_t width, uint32_t height,
                       const std::function<glm::vec4(uint32_t, uint32_t, uint32_t)>& texel) {
    std::vector<glm::vec4> texels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t sample = 0; sample < kSamples; ++sample)
            for (uint32_t x = 0; x < width; ++x)
                texels.push_back(texel(x, y, sample));
    gpu::Image source = uploadTestImage(context, "test/samples/source", VK_FORMAT_R32G32B32A32_SFLOAT, width * kSamples,
                                        height, bytesOf(texels));
    gpu::Image image =
        must(gpu::Image::create(context, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, kSamples}));
    struct {
        uint32_t index;
        uint32_t width;
    } which = {0, width};
    gpu::RasterDesc desc;
    desc.vertexShader = "fullscreen.vert";
    desc.fragmentShader = "one_sample.frag";
    desc.pushSize = sizeof(which);
    desc.colorFormats = {format};
    desc.samples = kSamples;
    const gpu::Pipeline pipeline = must(gpu::Pipeline::raster(context, desc));
    must(context.submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(context, commands);
        frame.pass(pipeline)
            .read("source", source, gpu::SamplerKind::NearestClamp)
            .color(image)
            .draw([&](gpu::Draws& d) {
                for (; which.index < kSamples; ++which.index)
                    d.push(which).draw(3);
            });
        frame.hand(image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }));
    return image;
}

} // namespace glint::test
