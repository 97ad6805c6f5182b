// `trace/transparents`: a second march, among the host's transparent surfaces (screen.transparents). Each ray keeps the
// nearer of its two hits, so solid surfaces that the camera sees through glass are found as without it.
#pragma once

#include "reflect/prepare/depth_pyramid.hpp"
#include "reflect/stage_list.hpp"

namespace glint::reflect {

class TransparentTrace {
public:
    static Result<std::unique_ptr<TransparentTrace>> create(StageContext& stages);

    /// True if the settings ask for it. Hits take their colour from the previous frame, the only one that shows
    /// transparent surfaces.
    static bool wanted(const Settings& settings);
    static constexpr std::string_view kName = "trace/transparents";
    static constexpr Moment kMoment = Moment::AfterMarch;

    /// Compiles and creates what these settings need for the first time. Errors: OutOfMemory.
    Result<void> make(const Settings& settings);

    void clear(gpu::Frame& frame);
    /// Follows the rays that the marcher of the settings has traced. Nothing to do unless a host provides transparent
    /// surfaces and there is a previous frame, without which no colour of theirs is known.
    void record(gpu::Frame& frame, const StageInputs& stage);

private:
    explicit TransparentTrace(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline surfacePass_;
    gpu::Pipeline backFacesPass_;
    std::vector<gpu::Pipeline> marchers_; ///< in the order of techniques(); created when settings first select them
    gpu::Image viewZ_;                    ///< R32F: of the nearest transparent surface in front; kBackgroundZ: none
    gpu::Image surface_;                  ///< RG32UI
    gpu::Image backViewZ_;                ///< R32F: their backs; kBackgroundZ: not known
    std::unique_ptr<DepthPyramid> pyramid_;
};

} // namespace glint::reflect
