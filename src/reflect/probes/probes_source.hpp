// The source `probes`: what the host's probes answer for the pixels that the sources before left something of.
#pragma once

#include "glint/settings.hpp"
#include "reflect/probes/probes.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

/// What the source reads of the frame.
struct ProbesInputs {
    gpu::Buffer& frameConstants;
    Prepared& prepared;
    EarlierAnswers earlier;
};

/// kProbes*, for whoever looks probes up.
uint32_t probeFlags(const Settings& settings);

/// Made when a host first hands probes over.
class ProbesSource {
public:
    /// `probes` must outlive the frames. Errors: OutOfMemory.
    static Result<std::unique_ptr<ProbesSource>> create(gpu::Context& context, uint32_t width, uint32_t height);

    /// Makes the pipeline for these. Errors: OutOfMemory.
    Result<void> setProbes(ProbesState& probes);
    bool hasProbes() const { return probes_ && probes_->count() > 0; }
    /// For whoever else asks where they are; null without any.
    ProbesState* probes() const { return hasProbes() ? probes_ : nullptr; }

    void record(gpu::Frame& frame, const Settings& settings, const ProbesInputs& inputs);

    gpu::Image& answer() { return answer_; }

private:
    explicit ProbesSource(gpu::Context& context) : context_(context) {}

    gpu::Context& context_;
    gpu::Pipeline reflect_;
    ProbesState* probes_ = nullptr;
    gpu::Image answer_; ///< RGBA16F: radiance, weight [0, 1]
};

} // namespace glint::reflect
