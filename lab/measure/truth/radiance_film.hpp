// The frames of a sequence in little memory: as half floats, which is how a frame computes radiance.
#pragma once

#include "lab/measure/motion/motion_frame.hpp"

#include <cstdint>
#include <vector>

namespace glint::measure {

class RadianceFilm {
public:
    void add(const Radiance& frame);
    Radiance frame(size_t index) const;
    size_t size() const { return frames_.size(); }

private:
    std::vector<std::vector<uint16_t>> frames_;
};

} // namespace glint::measure
