// Debug views: intermediate results of a frame's passes as images (ReflectionsDesc::views).
#pragma once

#include "reflect/denoise/denoiser.hpp"
#include "reflect/hierarchy/hierarchy.hpp"
#include "reflect/refraction/refraction.hpp"
#include "reflect/stage.hpp"

namespace glint::reflect {

struct ViewInputs {
    HierarchyInputs hierarchy;
    Hierarchy& sources;
    gpu::Image& screenAnswer;
    gpu::Image& rayRecord;                  ///< outcomes of the pixels' rays
    Refraction* refraction;                 ///< null: no layers
    std::optional<DenoiserHistory> history; ///< empty: nothing was denoised
};

class Views {
public:
    static bool wanted(const PlanInputs& inputs) { return inputs.views; }
    static Result<std::unique_ptr<Views>> create(StageContext& stages);

    /// `view`: index in kViewNames. The image is RGBA32F.
    gpu::Image& record(gpu::Frame& frame, const ViewInputs& inputs, uint32_t view);
    /// An image that a pass wrote, as it is.
    gpu::Image& show(gpu::Frame& frame, gpu::Image& written);
    void rehearse(gpu::Frame& frame, const ViewInputs& inputs);

private:
    explicit Views(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline pass_;
    gpu::Pipeline show_;
    gpu::Pipeline showIntegers_;
    gpu::Image image_;
};

} // namespace glint::reflect
