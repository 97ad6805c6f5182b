#include "lab/measure/motion/sequence_reference.hpp"

#include "base/hash.hpp"

namespace glint::measure {
namespace {

/// A hash of all that changes from frame to frame.
uint64_t momentHash(const render::ReflectionSession& session) {
    Hash hash;
    hash.value(session.view().worldToClip);
    const scene::Pose& pose = session.inputs().pose;
    for (const scene::DrawItem& item : pose.items)
        hash.value(item.localToWorld);
    for (const auto& geometry : pose.deformed)
        hash.list(geometry->positions);
    for (const scene::PosedLight& light : pose.lights)
        hash.value(light.positionWS).value(light.directionWS);
    return hash.result();
}

} // namespace

Result<void> SequenceReference::add(render::ReflectionSession& session) {
    const auto [moment, isNew] = known_.try_emplace(momentHash(session), known_.size());
    moments_.push_back(moment->second);
    return isNew ? render(session) : Result<void>();
}

Result<void> SequenceReference::render(render::ReflectionSession& session) {
    for (size_t seed = 0; seed < 2; ++seed) {
        session.restartAccumulation(seeds_[seed]);
        for (uint32_t i = 0; i < frames_; ++i) {
            render::FrameRequest plan;
            // Transparent surfaces are blended over the last one only.
            plan.draw = (seed == 0 && i == 0) || i + 1 == frames_;
            const auto index = static_cast<uint32_t>(moments_.size()) * frames_ + i;
            GLINT_TRY(times, session.renderFrame(index, plan));
        }
        for (size_t signal = 0; signal < kSignals; ++signal) {
            GLINT_TRY(view, session.readView(kSignalViews[signal]));
            films_[signal][seed].add(radianceOf(view.rgba));
        }
    }
    return {};
}

std::array<Radiance, 2> SequenceReference::frame(Signal signal, size_t index) const {
    const auto& films = films_[static_cast<size_t>(signal)];
    return {films[0].frame(moments_[index]), films[1].frame(moments_[index])};
}

} // namespace glint::measure
