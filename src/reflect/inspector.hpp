// What it takes to trace one pixel's ray once more and to read what it did.
#pragma once

#include "glint/inspection.hpp"
#include "gpu/pass.hpp"
#include "reflect/stages.hpp"

namespace glint::reflect {

struct Inspector {
    gpu::Pipeline pixel;
    std::vector<gpu::Pipeline> trace; ///< in the order of techniques()
    gpu::Pipeline combine;
    Rays rays; ///< one at most
    gpu::Buffer log;
    gpu::Buffer readback;

    static Result<Inspector> create(gpu::Context& context);
    /// Of the readback. `screenEnabled`: screen.enabled of that frame.
    RayInspection read(bool screenEnabled) const;
};

} // namespace glint::reflect
