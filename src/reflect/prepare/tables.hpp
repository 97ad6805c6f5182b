// Data created once and read by every frame: the table of specular reflectance, noise, and substitutes for absent
// inputs.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

class Tables {
public:
    static Result<Tables> create(gpu::Context& context);

    /// Creates the noise for directions, if missing. The first call in a process takes about 100 ms. Errors:
    /// OutOfMemory.
    Result<void> makeNoise(gpu::Context& context);

    /// Fills what earlier frames have not filled.
    void record(gpu::Frame& frame, gpu::Progress& progress);
    StandIns standIns() { return {dfg_, black_, blackCube_, noProbes_, blueNoise_ ? blueNoise_ : noProbes_}; }

private:
    gpu::Pipeline makeDfg_;
    gpu::Image dfg_;
    gpu::Image black_;
    gpu::Image blackCube_;
    gpu::Buffer noProbes_;
    gpu::Buffer blueNoise_; ///< absent until settings need it
    gpu::Standing filled_;
    gpu::Standing noiseFilled_;
};

} // namespace glint::reflect
