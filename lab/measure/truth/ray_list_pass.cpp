#include "lab/measure/truth/ray_list_pass.hpp"

#include "gpu/transfer.hpp"

#include <cstring>

namespace glint::measure {

Result<RayListPass> RayListPass::create(gpu::Context& context, RayBackend backend) {
    RayListPass pass(context);
    const char* const shader = backend == RayBackend::Query ? "measure/rays_query" : "measure/rays_bvh";
    GLINT_TRY(pipeline, gpu::Pipeline::compute(context, {shader, 0, {}}));
    pass.pipeline_ = std::move(pipeline);
    GLINT_TRY(timers, gpu::Timers::create(context));
    pass.timers_ = std::move(timers);
    return pass;
}

Result<void> RayListPass::setRays(const std::vector<ListedRay>& rays) {
    GLINT_TRY(list, gpu::uploadBuffer(*context_, "measure/rays", rays, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    rays_ = std::move(list);
    count_ = static_cast<uint32_t>(rays.size());
    GLINT_TRY(hits,
              gpu::Buffer::create(*context_, {"measure/hits", rays.size() * sizeof(ListedHit),
                                              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                              gpu::BufferHome::Device}));
    hits_ = std::move(hits);
    return {};
}

Result<ListTimes> RayListPass::trace(RayScene& scene) {
    GLINT_TRY(submitted, timedSubmit(*context_, [&](VkCommandBuffer commands) {
                  gpu::Frame frame(*context_, commands, timers_.get());
                  gpu::Pass pass = frame.pass(pipeline_);
                  scene.bind(pass);
                  pass.read("rays", rays_).write("hits", hits_).dispatch(count_);
              }));
    const std::vector<gpu::PassTime>& passes = timers_->latest();
    return ListTimes{passes.empty() ? 0 : passes.front().milliseconds, submitted.wallMs};
}

Result<std::vector<ListedHit>> RayListPass::hits() {
    GLINT_TRY(bytes, gpu::downloadBuffer(*context_, hits_));
    std::vector<ListedHit> hits(count_);
    std::memcpy(hits.data(), bytes.data(), bytes.size());
    return hits;
}

} // namespace glint::measure
