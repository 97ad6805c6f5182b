// The reference of a sequence: every moment rendered to convergence with two seeds, and each different moment once.
#pragma once

#include "lab/measure/truth/radiance_film.hpp"
#include "lab/session/reflection_session.hpp"

#include <unordered_map>

namespace glint::measure {

/// The pictures that figures are made of.
enum class Signal : uint8_t {
    Reflection, ///< reflected radiance before the material's response, times its weight
    Composite,  ///< the frame
};
constexpr size_t kSignals = 2;
/// Names of the views, by Signal.
inline constexpr std::array<const char*, kSignals> kSignalViews = {"reflection", "composite"};

class SequenceReference {
public:
    /// `frames` rendered with each seed and averaged by the settings, >= 1.
    SequenceReference(std::array<uint32_t, 2> seeds, uint32_t frames) : seeds_(seeds), frames_(frames) {}

    /// Adds the next frame: what `session` shows with its present camera and pose.
    Result<void> add(render::ReflectionSession& session);
    std::array<Radiance, 2> frame(Signal signal, size_t index) const;

private:
    Result<void> render(render::ReflectionSession& session);

    std::array<uint32_t, 2> seeds_;
    uint32_t frames_;
    std::array<std::array<RadianceFilm, 2>, kSignals> films_; ///< by signal and seed
    std::vector<size_t> moments_;                             ///< by frame: its index in the films
    std::unordered_map<uint64_t, size_t> known_;              ///< moments by their hash
};

} // namespace glint::measure
