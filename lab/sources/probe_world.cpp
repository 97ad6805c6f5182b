#include "lab/sources/probe_world.hpp"

#include "base/log.hpp"
#include "gpu/cube_prefilter.hpp"
#include "lab/sources/scene_hash.hpp"

#include <cstring>
#include <filesystem>

namespace glint::render {
namespace {

constexpr std::string_view kAuto = "auto";

Result<ProbeSet> readFitting(const std::string& path, const JobInputs& inputs, const RenderJob& job) {
    GLINT_TRY(set, readProbes(path));
    GLINT_CHECK(checkProbesFit(set, sceneHash(*inputs.scene, inputs.pose), lightHash(inputs, job.settings.render),
                               job.scene, path));
    return set;
}

Result<ProbeSet> readOrBake(gpu::Context& context, Context& library, Renderer& renderer, const JobInputs& inputs,
                            const RenderJob& job) {
    if (job.probes != kAuto)
        return readFitting(job.probes, inputs, job);
    const std::string beside = probeFileFor(job.scene);
    std::error_code ignored;
    if (std::filesystem::exists(beside, ignored)) {
        Result<ProbeSet> read = readFitting(beside, inputs, job);
        if (read)
            return read;
        log::warning("{}; for this picture they are baked now", read.error().message);
    }
    return bakeProbes(context, library, renderer, inputs, job.settings.render, job.scene, {});
}

Result<gpu::Image> uploadCube(gpu::Context& context, const BakedProbe& baked) {
    const uint32_t mips = gpu::cubeMips(baked.faceSize, gpu::kLastFilteredFace);
    GLINT_TRY(cube, gpu::Image::create(context, {"probes/cube", VK_FORMAT_R16G16B16A16_SFLOAT, baked.faceSize,
                                                 baked.faceSize, mips, 6, gpu::ImageShape::Cube,
                                                 VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    const size_t bytes = baked.texels.size() * sizeof(uint64_t);
    GLINT_TRY(staging, gpu::Buffer::create(context, {"probes/staging", bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                     gpu::BufferHome::Upload}));
    std::memcpy(staging.mapped(), baked.texels.data(), bytes);
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(context, commands);
        size_t offset = 0;
        for (uint32_t mip = 0; mip < mips; ++mip)
            for (uint32_t face = 0; face < 6; ++face) {
                frame.copyFromBuffer(staging, offset, cube, mip, face);
                offset += size_t{baked.faceSize >> mip} * (baked.faceSize >> mip) * sizeof(uint64_t);
            }
        frame.hand(cube, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }));
    return cube;
}

} // namespace

std::string probeFileFor(const std::string& scene) {
    constexpr std::string_view kBuiltin = "builtin:";
    return (scene.starts_with(kBuiltin) ? scene.substr(kBuiltin.size()) : scene) + ".probes";
}

Result<ProbeWorld> ProbeWorld::create(gpu::Context& context, Context& library, Renderer& renderer,
                                      const JobInputs& inputs, const RenderJob& job) {
    GLINT_TRY(set, readOrBake(context, library, renderer, inputs, job));
    return upload(context, library, set);
}

Result<ProbeWorld> ProbeWorld::upload(gpu::Context& context, Context& library, const ProbeSet& set) {
    std::vector<gpu::Image> cubes;
    std::vector<Probe> list;
    for (const BakedProbe& baked : set.probes) {
        GLINT_TRY(cube, uploadCube(context, baked));
        Probe probe = baked.probe;
        probe.cube = {cube.handle(), cube.view(), cube.desc().format, cube.width(), cube.height()};
        probe.mips = cube.desc().mips;
        probe.prefiltered = true;
        list.push_back(probe);
        cubes.push_back(std::move(cube));
    }
    GLINT_TRY(probes, Probes::create(library, {list}));
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) { probes.record(commands); }));
    ProbeWorld world(std::move(probes));
    world.cubes_ = std::move(cubes);
    return world;
}

} // namespace glint::render
