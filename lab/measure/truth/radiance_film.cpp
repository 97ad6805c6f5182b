#include "lab/measure/truth/radiance_film.hpp"

#include <glm/gtc/packing.hpp>

namespace glint::measure {

void RadianceFilm::add(const Radiance& frame) {
    std::vector<uint16_t>& halves = frames_.emplace_back();
    halves.reserve(frame->size());
    for (const float value : *frame)
        halves.push_back(glm::packHalf1x16(value));
}

Radiance RadianceFilm::frame(size_t index) const {
    auto values = std::make_shared<std::vector<float>>();
    values->reserve(frames_[index].size());
    for (const uint16_t half : frames_[index])
        values->push_back(glm::unpackHalf1x16(half));
    return values;
}

} // namespace glint::measure
