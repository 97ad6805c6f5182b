// The source `planar`: computes the reflections of flat mirrors from the host's mirrored views.
#pragma once

#include "glint/settings.hpp"
#include "reflect/planar/planar.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"
#include "shared/planar.h"

namespace glint::reflect {

/// Inputs from the frame.
struct PlanarInputs {
    FrameInputs frame;
    Prepared prepared;
    EarlierAnswers earlier;
};

/// Created when a host first provides mirrors.
class PlanarSource {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<PlanarSource>> create(StageContext& stages);

    /// `planar` must outlive the frames. Creates the pipeline for it. Errors: OutOfMemory.
    Result<void> setPlanar(PlanarState& planar);
    bool hasMirrors() const { return planar_ && planar_->count() > 0; }
    PlanarState* planar() const { return planar_; }

    /// `before`: the sources that are asked before this one.
    static shared::PlanarConstants constants(const Settings& settings, uint32_t before);
    void record(gpu::Frame& frame, const PlanarInputs& inputs);

    gpu::Image& answer() { return answer_; }

private:
    explicit PlanarSource(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline reflect_;
    PlanarState* planar_ = nullptr;
    gpu::Buffer records_;
    gpu::Image answer_; ///< RGBA16F: radiance, weight [0, 1]
};

} // namespace glint::reflect
