// SPDX-License-Identifier: MIT
// Reflections in a renderer that is not Glint's, in C. Everything here whose name does not begin with glint is what a
// host has anyway: a Vulkan device (host.h), a G-buffer (renderer.h), a command buffer. Glint's part is marked 1 to 5.
//
//   embed_c [FOLDER]     writes before.ppm and after.ppm, the same files as examples/embed
#include "host.h"
#include "renderer.h"

// ---------------------------------------------------------------- the host's display and queue

static float fromHalf(uint16_t half) {
    const int exponent = half >> 10 & 31, fraction = half & 1023;
    const float value = exponent > 0 ? ldexpf(1024.0f + (float)fraction, exponent - 25) : ldexpf((float)fraction, -24);
    return (half & 0x8000) != 0 ? -value : value;
}

// Tone maps linear RGBA pixels, floats or else halves, and writes them as a PPM file.
static void writePicture(const char* folder, const char* name, const Picture* picture, const float* floats,
                         const uint16_t* halves) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* file = fopen(path, "wb");
    if (!file)
        fail("a picture cannot be written: does the folder exist?");
    fprintf(file, "P6\n%u %u\n255\n", picture->width, picture->height);
    for (size_t i = 0; i < (size_t)4 * picture->width * picture->height; ++i) {
        if (i % 4 == 3)
            continue; // PPM has no alpha
        const float c = floats ? floats[i] : fromHalf(halves[i]);
        const float mapped = c * (2.51f * c + 0.03f) / (c * (2.43f * c + 0.59f) + 0.14f); // Narkowicz' fit of ACES
        fputc((int)(powf(clamp(mapped, 0, 1), 1 / 2.2f) * 255 + 0.5f), file);
    }
    if (ferror(file) != 0 || fclose(file) != 0)
        fail("a picture cannot be written: is the disk full?");
}

// The host reads `buffer` after the commands are done.
static void copyToBuffer(VkCommandBuffer commands, const GlintImage* image, VkBuffer buffer) {
    const VkBufferImageCopy region = wholeImage(image);
    changeLayout(commands, image, image->layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    vkCmdCopyImageToBuffer(commands, image->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &region);
    changeLayout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image->layout);
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

static void submitAndWait(const Host* host) {
    check(vkEndCommandBuffer(host->commands), "vkEndCommandBuffer");
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &host->commands;
    check(vkQueueSubmit(host->queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(host->queue), "vkQueueWaitIdle");
}

// ---------------------------------------------------------------- one frame

// 3. The G-buffer, and in which of its conventions it is not like Glint's own.
static void setGBuffer(GlintReflections* reflections, Host* host, const Picture* picture) {
    const uint32_t width = picture->width, height = picture->height;
    const size_t pixels = (size_t)width * height;
    // A view of the depth aspect alone. Only queues that draw may copy into depth images: elsewhere a float image.
    const GlintImage depth = upload(host, host->draws ? VK_FORMAT_D32_SFLOAT_S8_UINT : VK_FORMAT_R32_SFLOAT, width,
                                    height, picture->depth, pixels * sizeof(float));
    const GlintImage normal =
        upload(host, VK_FORMAT_R16G16B16A16_UNORM, width, height, picture->normal, pixels * 4 * sizeof(uint16_t));
    const GlintImage material = upload(host, VK_FORMAT_R8G8B8A8_UNORM, width, height, picture->material, pixels * 4);
    const GlintImage lit =
        upload(host, VK_FORMAT_R32G32B32A32_SFLOAT, width, height, picture->lit, pixels * 4 * sizeof(float));
    const GlintImage skySpecular =
        upload(host, VK_FORMAT_R32G32B32A32_SFLOAT, width, height, picture->skySpecular, pixels * 4 * sizeof(float));
    GlintConventions conventions;
    glint_conventions_init(&conventions, sizeof conventions);
    conventions.clipYDown = VK_TRUE;
    conventions.normalSpace = GLINT_NORMAL_SPACE_VIEW;
    conventions.normalEncoding = GLINT_NORMAL_ENCODING_UNORM;
    conventions.roughness = GLINT_ROUGHNESS_SMOOTHNESS; // in alpha, as by default
    GlintGBuffer gbuffer;
    glint_gbuffer_init(&gbuffer, sizeof gbuffer);
    gbuffer.depth = &depth;
    gbuffer.normal = &normal;
    gbuffer.material = &material;
    gbuffer.litRadiance = &lit;
    gbuffer.fallbackSpecular = &skySpecular;
    gbuffer.conventions = &conventions;
    checkGlint(glint_reflections_set_inputs(reflections, &gbuffer, NULL));
}

int main(int argc, char** argv) {
    const char* folder = argc > 1 ? argv[1] : ".";
    Host host;
    createHost(&host); // 1, in host.h; outlives everything of Glint's
    Picture picture = render(960, 540);
    const size_t pixels = (size_t)picture.width * picture.height;

    VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(host.commands, &begin), "vkBeginCommandBuffer");

    // 2. Once: Glint borrows the device, and makes the pipelines and images for one size of picture.
    GlintContextDesc device;
    glint_context_desc_init(&device, sizeof device);
    device.instance = host.instance;
    device.physicalDevice = host.physicalDevice;
    device.device = host.device;
    device.queueFamily = host.queueFamily;
    device.getInstanceProcAddr = vkGetInstanceProcAddr;
    GlintContext* context = NULL;
    checkGlint(glint_context_adopt(&device, GLINT_C_ABI, &context));
    GlintSettings* settings = NULL;
    checkGlint(glint_settings_create(&settings));
    checkGlint(glint_settings_set(settings, "screen.thickness", "0.3", NULL)); // metres; docs/settings.md has them all
    GlintReflectionsDesc desc;
    glint_reflections_desc_init(&desc, sizeof desc);
    desc.width = picture.width;
    desc.height = picture.height;
    desc.settings = settings;
    GlintReflections* reflections = NULL;
    checkGlint(glint_reflections_create(context, &desc, &reflections));
    glint_settings_destroy(settings);
    setGBuffer(reflections, &host, &picture); // 3, above
    // 4. Each frame: Glint records its passes. What it returns is an image of its own, ready for sampling; here it is
    //    copied instead, for there is no screen.
    GlintView view;
    glint_view_init(&view, sizeof view);
    memcpy(view.worldToView, picture.worldToView, sizeof view.worldToView);
    memcpy(view.viewToClip, picture.viewToClip, sizeof view.viewToClip);
    GlintImage reflected;
    glint_image_init(&reflected, sizeof reflected);
    checkGlint(glint_reflections_record(reflections, host.commands, &view, &reflected));

    void* readback = NULL;
    const size_t size = pixels * 8; // RGBA16F
    const VkBuffer buffer = createBuffer(&host, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &readback);
    copyToBuffer(host.commands, &reflected, buffer);
    submitAndWait(&host);

    // 5. Whenever the host likes: what Glint's passes cost on the GPU.
    printf("%s, on a queue that %s\n", glint_context_device_name(context), host.draws ? "draws" : "only computes");
    const uint32_t passes = glint_reflections_read_pass_times(reflections);
    for (uint32_t i = 0; i < passes; ++i)
        printf("%-22s %8.3f ms\n", glint_reflections_pass_name(reflections, i),
               glint_reflections_pass_milliseconds(reflections, i));

    writePicture(folder, "before.ppm", &picture, picture.lit, NULL);
    writePicture(folder, "after.ppm", &picture, NULL, readback);

    glint_reflections_destroy(reflections);
    glint_context_destroy(context);
    freePicture(&picture);
    destroyHost(&host);
    return 0;
}
