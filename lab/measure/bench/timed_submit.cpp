#include "lab/measure/bench/timed_submit.hpp"

#include <chrono>

namespace glint::measure {

Result<SubmitTimes> timedSubmit(gpu::Context& context, const std::function<void(VkCommandBuffer)>& record) {
    using Clock = std::chrono::steady_clock;
    using Milliseconds = std::chrono::duration<double, std::milli>;
    SubmitTimes times;
    const Clock::time_point start = Clock::now();
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        const Clock::time_point recording = Clock::now();
        record(commands);
        times.recordMs = Milliseconds(Clock::now() - recording).count();
    }));
    times.wallMs = Milliseconds(Clock::now() - start).count() - times.recordMs;
    return times;
}

} // namespace glint::measure
