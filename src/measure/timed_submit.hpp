// Commands run by themselves, with the clock that also means something where a device's timestamps do not.
#pragma once

#include "gpu/context.hpp"

namespace glint::measure {

struct SubmitTimes {
    double recordMs = 0; ///< the CPU's: writing the commands
    double wallMs = 0;   ///< submitting them and waiting until they have run
};

/// Errors: DeviceLost.
Result<SubmitTimes> timedSubmit(gpu::Context& context, const std::function<void(VkCommandBuffer)>& record);

} // namespace glint::measure
