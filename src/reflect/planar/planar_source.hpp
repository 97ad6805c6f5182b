// The source `planar`: what a host's pictures from behind flat mirrors answer for the pixels of these.
#pragma once

#include "glint/settings.hpp"
#include "reflect/planar/planar.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

/// What the source reads of the frame.
struct PlanarInputs {
    gpu::Buffer& frameConstants;
    const shared::FrameConstants& constants; ///< what is in them
    Prepared& prepared;
    EarlierAnswers earlier;
};

/// Made when a host first hands mirrors over.
class PlanarSource {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<PlanarSource>> create(gpu::Context& context, uint32_t width, uint32_t height);

    /// `planar` must outlive the frames. Makes the pipeline for it. Errors: OutOfMemory.
    Result<void> setPlanar(PlanarState& planar);
    bool hasMirrors() const { return planar_ && planar_->count() > 0; }

    void record(gpu::Frame& frame, const Settings& settings, const PlanarInputs& inputs);

    gpu::Image& answer() { return answer_; }

private:
    explicit PlanarSource(gpu::Context& context) : context_(context) {}

    gpu::Context& context_;
    gpu::Pipeline reflect_;
    PlanarState* planar_ = nullptr;
    gpu::Buffer records_;
    gpu::Image answer_; ///< RGBA16F: radiance, weight [0, 1]
};

} // namespace glint::reflect
