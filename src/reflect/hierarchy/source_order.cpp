#include "reflect/hierarchy/source_order.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace glint::reflect {

SourceOrder::SourceOrder(const Settings& settings) {
    const OrderSettings& places = settings.order;
    const std::array<int, shared::kSourceCount> placeOf = {places.screen, places.rays, places.planar, places.probes,
                                                           places.sky};
    std::iota(sources_.begin(), sources_.end(), 0u);
    // Not stable_sort, which allocates: this is called while recording.
    std::ranges::sort(sources_, {}, [&](uint32_t source) { return std::pair(placeOf[source], source); });
}

uint32_t SourceOrder::packed() const {
    uint32_t packed = ~0u; // 15: none
    for (uint32_t i = 0; i < sources_.size(); ++i)
        packed = (packed & ~(15u << (4 * i))) | sources_[i] << (4 * i);
    return packed;
}

uint32_t SourceOrder::before(uint32_t source) const {
    uint32_t before = 0;
    for (const uint32_t other : *this) {
        if (other == source)
            break;
        before |= 1u << other;
    }
    return before;
}

} // namespace glint::reflect
