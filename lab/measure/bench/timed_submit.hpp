// Submits commands on their own and measures wall time, which is also valid where a device's timestamps are not.
#pragma once

#include "gpu/context.hpp"

namespace glint::measure {

struct SubmitTimes {
    double recordMs = 0; ///< CPU time of recording the commands
    double wallMs = 0;   ///< submitting the commands and waiting for their completion
};

/// Errors: DeviceLost.
Result<SubmitTimes> timedSubmit(gpu::Context& context, const std::function<void(VkCommandBuffer)>& record);

} // namespace glint::measure
