// Traces one pixel's ray again and reads a log of its steps (ReflectionsDesc::inspection).
#pragma once

#include "glint/inspection.hpp"
#include "reflect/hierarchy/hierarchy.hpp"
#include "reflect/stage.hpp"
#include "reflect/trace/technique.hpp"

namespace glint::reflect {

struct InspectorInputs {
    TraceInputs trace; ///< of the frame; its rays and log are unused
    TraceTarget target;
    HierarchyInputs hierarchy;
    Hierarchy& sources;
    gpu::Image& rayRecord; ///< outcomes of the pixels' rays
    gpu::Image& composite; ///< the frame's image
};

/// Bytes of a ray's log.
extern const size_t kRayLogSize;
/// Decodes a ray's log: a shared::RayLogHeader and samples, kRayLogSize bytes. `screenEnabled`: screen.enabled of its
/// frame. `nameOfSource`: name by source number.
RayInspection readRayLog(const std::byte* log, bool screenEnabled,
                         const std::function<std::string_view(uint32_t)>& nameOfSource);

class Inspector {
public:
    static bool wanted(const PlanInputs& inputs) { return inputs.inspection; }
    static Result<std::unique_ptr<Inspector>> create(StageContext& stages);

    void rehearse(gpu::Frame& frame, const InspectorInputs& inputs);
    /// Traces the pixel's ray again, with the frame's settings and images, and logs its steps.
    void record(gpu::Frame& frame, const InspectorInputs& inputs, uint32_t x, uint32_t y) {
        record(frame, inputs, x, y, techniqueFor(stages_.settings().screen.march));
    }
    /// Returns the log of the pixel recorded last, once the GPU has finished.
    RayInspection read(const Hierarchy& sources) const;

private:
    explicit Inspector(StageContext& stages) : stages_(stages) {}
    void record(gpu::Frame& frame, const InspectorInputs& inputs, uint32_t x, uint32_t y, const Technique& technique);

    StageContext& stages_;
    gpu::Pipeline pixel_;
    std::vector<gpu::Pipeline> marchers_; ///< in the order of techniques()
    gpu::Pipeline combine_;
    Rays rays_; ///< holds at most one ray
    gpu::Buffer log_;
    gpu::Buffer readback_;
};

} // namespace glint::reflect
