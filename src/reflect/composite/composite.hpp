// `composite`: replaces the fallback specular in the host's lit image by the reflections.
#pragma once

#include "reflect/hierarchy/hierarchy.hpp"
#include "reflect/stage.hpp"
#include "reflect/stages.hpp"
#include "shared/trace_constants.h"

namespace glint::reflect {

struct CompositeImages {
    gpu::Image& rayRecord;      ///< the outcomes of the pixels' rays, for debug colours
    gpu::Image& composite;      ///< RGBA16F, written
    gpu::Image* coat = nullptr; ///< what clear coats reflect (CoatLobe::record); null: there are none
};

class Composite {
public:
    static Result<Composite> create(StageContext& stages);
    /// Compiles what `record` needs, or with `combines` what `recordCombined` needs. Errors: Unsupported.
    Result<void> make(bool combines);

    shared::CompositeConstants constants() const;
    void record(gpu::Frame& frame, const HierarchyInputs& inputs, const Reflected& reflected,
                const CompositeImages& images);
    /// Combines the sources' answers in the same pass, in place of Hierarchy::combine: no image holds the reflections
    /// alone. For hosts with one sample a pixel.
    /// `rayTiles`: RayLister::tiles, read with kTraceListedOnly.
    void recordCombined(gpu::Frame& frame, const HierarchyInputs& inputs, const Hierarchy& sources,
                        gpu::Buffer& rayTiles, const CompositeImages& images);

private:
    explicit Composite(StageContext& stages) : stages_(&stages) {}
    static void bind(gpu::Pass& pass, const HierarchyInputs& inputs, const CompositeImages& images);

    StageContext* stages_;
    gpu::Pipeline pass_;
    gpu::Pipeline combinedPass_;
    gpu::Pipeline coatedPass_;
};

} // namespace glint::reflect
