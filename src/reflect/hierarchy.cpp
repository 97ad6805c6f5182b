#include "reflect/hierarchy.hpp"

#include <algorithm>

namespace glint::reflect {

SourceOrder sourceOrder(const Settings& settings) {
    const OrderSettings& places = settings.order;
    const std::array<int, shared::kSourceCount> placeOf = {places.screen, places.rays, places.planar, places.probes,
                                                           places.sky};
    SourceOrder order = {shared::kSourceScreen, shared::kSourceRays, shared::kSourcePlanar, shared::kSourceProbes,
                         shared::kSourceSky};
    std::ranges::stable_sort(order, {}, [&](uint32_t source) { return placeOf[source]; });
    return order;
}

uint32_t packOrder(const SourceOrder& order) {
    uint32_t packed = 0;
    for (size_t i = 0; i < order.size(); ++i)
        packed |= order[i] << (4 * i);
    return packed;
}

uint32_t sourcesBefore(const SourceOrder& order, uint32_t source) {
    uint32_t before = 0;
    for (size_t i = 0; i < order.size() && order[i] != source; ++i)
        before |= 1u << order[i];
    return before;
}

} // namespace glint::reflect
