// What the last frame of a session did, as its cost is counted (work_cost.hpp).
#pragma once

#include "lab/session/reflection_session.hpp"
#include "lab/tune/work_cost.hpp"

namespace glint::tune {

/// Counts the pixels whose lobe is wider than a mirror's. Errors: DeviceLost.
Result<RoughShare> roughShare(render::ReflectionSession& session);

/// `settings`  in force; referred to by the result
/// `times`     of the session's last frame
/// `drawn`     that frame's plan drew the host's passes
/// `rough`     roughShare
FrameWork frameWork(const Settings& settings, const render::ReflectionSession& session, const render::FrameTimes& times,
                    bool drawn, const RoughShare& rough);

} // namespace glint::tune
