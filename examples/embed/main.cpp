// SPDX-License-Identifier: MIT
// Reflections in a renderer that is not Glint's. Everything here that is not in the namespace glint is what a host has
// anyway: a Vulkan device (host.hpp), a G-buffer (renderer.hpp), a command buffer. Glint's part is marked 1 to 5.
//
//   embed [FOLDER]     writes before.ppm and after.ppm
#include "host.hpp"
#include "renderer.hpp"

#include <glint/glint.hpp>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

// ---------------------------------------------------------------- the host's display and queue

float fromHalf(uint16_t half) {
    const int exponent = half >> 10 & 31, fraction = half & 1023;
    const float value = exponent > 0 ? std::ldexp(1024.0f + static_cast<float>(fraction), exponent - 25)
                                     : std::ldexp(static_cast<float>(fraction), -24);
    return (half & 0x8000) != 0 ? -value : value;
}

/// Tone maps linear RGBA pixels and writes them as a PPM file.
template <class Pixels>
void write(const std::string& path, const Picture& picture, const Pixels& pixels) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << picture.width << " " << picture.height << "\n255\n";
    for (size_t i = 0; i < size_t{4} * picture.width * picture.height; ++i) {
        if (i % 4 == 3)
            continue; // PPM has no alpha
        const float c = pixels(i);
        const float mapped = c * (2.51f * c + 0.03f) / (c * (2.43f * c + 0.59f) + 0.14f); // Narkowicz' fit of ACES
        file.put(static_cast<char>(std::pow(std::clamp(mapped, 0.0f, 1.0f), 1 / 2.2f) * 255 + 0.5f));
    }
    if (!file.flush())
        fail(path + ": cannot be written");
}

/// The host reads `buffer` after the commands are done.
void copyToBuffer(VkCommandBuffer commands, const glint::HostImage& image, VkBuffer buffer) {
    const VkBufferImageCopy region = wholeImage(image);
    changeLayout(commands, image, image.layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    vkCmdCopyImageToBuffer(commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &region);
    changeLayout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.layout);
    VkMemoryBarrier2 toCpu = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    toCpu.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    toCpu.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    toCpu.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    toCpu.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &toCpu;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void submitAndWait(const Host& host) {
    check(vkEndCommandBuffer(host.commands), "vkEndCommandBuffer");
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &host.commands;
    check(vkQueueSubmit(host.queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(host.queue), "vkQueueWaitIdle");
}

// ---------------------------------------------------------------- one frame

int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    Host host; // 1, in host.hpp; outlives everything of Glint's
    const Picture picture = render(960, 540);

    VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(host.commands, &begin), "vkBeginCommandBuffer");

    // 2. Once: Glint borrows the device, and makes the pipelines and images for one size of picture.
    auto context = glint::Context::adopt(
        {host.instance, host.physicalDevice, host.device, host.queueFamily, vkGetInstanceProcAddr});
    if (!context)
        fail(context.error().message);
    glint::ReflectionsDesc desc;
    desc.width = picture.width;
    desc.height = picture.height;
    desc.settings.screen.thickness = 0.3f; // metres; every setting: include/glint/settings_list.hpp
    auto reflections = glint::Reflections::create(*context, desc);
    if (!reflections)
        fail(reflections.error().message);

    // 3. The G-buffer, and in which of its conventions it is not like Glint's own. That depth is not reversed and ends
    //    at a far plane needs no word: Glint sees it in View::viewToClip.
    const auto upload = [&](VkFormat format, const auto& pixels) {
        return host.upload(format, picture.width, picture.height, pixels.data(), pixels.size() * sizeof(pixels[0]));
    };
    glint::GBuffer gbuffer;
    // A view of the depth aspect alone. Only queues that draw may copy into depth images: elsewhere a float image.
    gbuffer.depth = upload(host.draws ? VK_FORMAT_D32_SFLOAT_S8_UINT : VK_FORMAT_R32_SFLOAT, picture.depth);
    gbuffer.normal = upload(VK_FORMAT_R16G16B16A16_UNORM, picture.normal);
    gbuffer.material = upload(VK_FORMAT_R8G8B8A8_UNORM, picture.material);
    gbuffer.litRadiance = upload(VK_FORMAT_R32G32B32A32_SFLOAT, picture.lit);
    gbuffer.fallbackSpecular = upload(VK_FORMAT_R32G32B32A32_SFLOAT, picture.skySpecular);
    gbuffer.conventions.clipYDown = true;
    gbuffer.conventions.normalSpace = glint::NormalSpace::View;
    gbuffer.conventions.normalEncoding = glint::NormalEncoding::Unorm;
    gbuffer.conventions.roughness = glint::RoughnessKind::Smoothness; // in alpha, as by default
    if (auto set = reflections->setInputs(gbuffer); !set)
        fail(set.error().message);

    // 4. Each frame: Glint records its passes. What it returns is an image of its own, ready for sampling; here it is
    //    copied instead, for there is no screen.
    glint::View view;
    view.worldToView = picture.worldToView;
    view.viewToClip = picture.viewToClip;
    const glint::HostImage reflected = reflections->record(host.commands, view);

    void* readback = nullptr;
    const size_t size = size_t{8} * picture.width * picture.height; // RGBA16F
    const VkBuffer buffer = host.createBuffer(size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &readback);
    copyToBuffer(host.commands, reflected, buffer);
    submitAndWait(host);

    // 5. Whenever the host likes: what Glint's passes cost on the GPU.
    std::printf("%s, on a queue that %s\n", context->deviceName().c_str(), host.draws ? "draws" : "only computes");
    for (const glint::PassTime& pass : reflections->passTimes())
        std::printf("%-22s %8.3f ms\n", pass.name.c_str(), pass.milliseconds);

    std::vector<uint16_t> after(size / sizeof(uint16_t));
    std::memcpy(after.data(), readback, size);
    write(folder + "/before.ppm", picture, [&](size_t i) { return picture.lit[i]; });
    write(folder + "/after.ppm", picture, [&](size_t i) { return fromHalf(after[i]); });
    for (const auto& mirrored : {picture.inPool, picture.inMirror})
        std::printf("pixel %u,%u of after.ppm must show the colour of %u,%u\n", mirrored[0], mirrored[1],
                    picture.glowing[0], picture.glowing[1]);
    return 0;
}
