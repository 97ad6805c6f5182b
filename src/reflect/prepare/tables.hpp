// Data created once and read by every frame: the table of specular reflectance, and substitutes for absent inputs.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

class Tables {
public:
    static Result<Tables> create(gpu::Context& context);

    void record(gpu::Frame& frame);
    StandIns standIns() { return {dfg_, black_, blackCube_, noProbes_}; }

private:
    gpu::Pipeline makeDfg_;
    gpu::Image dfg_;
    gpu::Image black_;
    gpu::Image blackCube_;
    gpu::Buffer noProbes_;
};

} // namespace glint::reflect
