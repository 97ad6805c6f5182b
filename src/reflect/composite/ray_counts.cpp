#include "reflect/composite/ray_counts.hpp"

#include "reflect/trace/outcomes.hpp"
#include "shared/outcome.h"
#include "shared/trace_constants.h"

#include <cstring>

namespace glint::reflect {

Result<std::unique_ptr<RayCounts>> RayCounts::create(StageContext& stages) {
    std::unique_ptr<RayCounts> counts(new RayCounts);
    GLINT_TRY(pass, gpu::Pipeline::compute(stages.gpu, {"composite/statistics", 0, {}}));
    GLINT_TRY(buffer,
              gpu::Buffer::create(stages.gpu, {"glint/statistics", sizeof(shared::RayStatistics),
                                               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                                   VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                               gpu::BufferHome::Device}));
    GLINT_TRY(readback, gpu::Buffer::create(stages.gpu, {"glint/statisticsReadback", sizeof(shared::RayStatistics),
                                                         VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
    counts->pass_ = std::move(pass);
    counts->counts_ = std::move(buffer);
    counts->readback_ = std::move(readback);
    std::memset(counts->readback_.mapped(), 0, counts->readback_.size()); // nothing is counted yet
    return counts;
}

void RayCounts::record(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& rayRecord, uint32_t width,
                       uint32_t height, const std::function<void(gpu::Buffer&)>& addMore) {
    frame.fill(counts_, 0);
    const auto groups = [](uint32_t pixels) { return (pixels + shared::kCountedSquare - 1) / shared::kCountedSquare; };
    frame.pass(pass_)
        .read("frame", inputs.constants)
        .read("rayRecord", rayRecord)
        .readWrite("statistics", counts_)
        .dispatch(groups(width) * pass_.localSize()[0], groups(height) * pass_.localSize()[1]);
    addMore(counts_);
    frame.copyBuffer(counts_, readback_);
}

Statistics RayCounts::read() const {
    Statistics result;
    shared::RayStatistics counts;
    std::memcpy(&counts, readback_.mapped(), sizeof(counts));
    for (uint32_t outcome = 0; outcome < shared::kOutcomeCount; ++outcome) {
        result.outcomes.push_back({kOutcomeNames[outcome], counts.outcomes[outcome]});
        if (isTraced(outcome))
            result.rays += counts.outcomes[outcome];
    }
    uint64_t sum = 0;
    for (uint64_t bin = 0; bin <= shared::kMaxLookups; ++bin)
        sum += bin * counts.lookups[bin];
    result.lookupsMean = result.rays ? static_cast<double>(sum) / static_cast<double>(result.rays) : 0;
    uint64_t below = 0;
    for (uint32_t bin = 0; bin <= shared::kMaxLookups && below * 100 < result.rays * 95; ++bin) {
        below += counts.lookups[bin];
        result.lookups95 = bin;
    }
    const auto wide = [](const uint32_t words[2]) { return words[0] | uint64_t{words[1]} << 32; };
    result.scene = {counts.scenePixels, wide(counts.sceneRays), counts.fromScreen, counts.replaced,
                    wide(counts.reusedLight)};
    return result;
}

} // namespace glint::reflect
