// The source `probes`: computes the answers of the host's probes for pixels with remaining weight.
#pragma once

#include "glint/settings.hpp"
#include "reflect/probes/probes.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

/// Inputs from the frame.
struct ProbesInputs {
    FrameInputs frame;
    Prepared prepared;
    EarlierAnswers earlier;
};

/// Returns the flags kProbes*, for every pass that samples probes.
uint32_t probeFlags(const Settings& settings);

/// Created when a host first provides probes.
class ProbesSource {
public:
    /// `probes` must outlive the frames. Errors: OutOfMemory.
    static Result<std::unique_ptr<ProbesSource>> create(StageContext& stages);

    /// Creates the pipeline for these probes. Errors: OutOfMemory.
    Result<void> setProbes(ProbesState& probes);
    bool hasProbes() const { return probes_ && probes_->count() > 0; }
    /// Returns the probes for other users; null if there are none.
    ProbesState* probes() const { return hasProbes() ? probes_ : nullptr; }

    void record(gpu::Frame& frame, const ProbesInputs& inputs);

    gpu::Image& answer() { return answer_; }

private:
    explicit ProbesSource(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline reflect_;
    ProbesState* probes_ = nullptr;
    gpu::Image answer_; ///< RGBA16F: radiance, weight [0, 1]
};

} // namespace glint::reflect
