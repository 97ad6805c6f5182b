// `resolve/lobe`: rough surfaces' answers from mirror rays become the means of the answers around over the surface's
// lobe (rough.cones).
#pragma once

#include "reflect/stage_list.hpp"

namespace glint::reflect {

class LobeMean {
public:
    /// True where rays take mirror directions, nothing else blurs them, and answers are not cut off at 1.
    static bool wanted(const Settings& settings);
    static constexpr std::string_view kName = "resolve/lobe";
    static constexpr Moment kMoment = Moment::AfterMarch;

    static Result<std::unique_ptr<LobeMean>> create(StageContext& stages);

    /// Compiles the passes and creates the images for the traced size. Errors: OutOfMemory.
    Result<void> make(const Settings& settings);
    /// Replaces the answers of rays that start on rough surfaces.
    void record(gpu::Frame& frame, const StageInputs& stage);

private:
    explicit LobeMean(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline take_;
    gpu::Pipeline shrink_;
    gpu::Pipeline mean_;
    gpu::Image lights_; ///< RGBA16F with mips: radiance * weight, weight
    gpu::Image places_; ///< RGBA16F with mips: shaders/resolve/lobe_take.comp
};

} // namespace glint::reflect
