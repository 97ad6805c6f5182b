#include "lab/tune/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace glint::tune {

bool dominates(const Figures& a, const Figures& b) {
    return a.cost <= b.cost && a.error <= b.error && a != b;
}

std::vector<size_t> paretoFront(std::span<const Figures> points) {
    std::vector<size_t> order;
    for (size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error))
            order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](size_t i) { return std::tuple(points[i].cost, points[i].error); });
    std::vector<size_t> front;
    for (const size_t i : order)
        if (front.empty() || points[i].error < points[front.back()].error)
            front.push_back(i);
    return front;
}

std::vector<size_t> paretoFrontThrough(std::span<const Figures> points, size_t chosen) {
    std::vector<Figures> others(points.begin(), points.end());
    for (size_t i = 0; i < others.size(); ++i)
        if (i != chosen && (points[i] == points[chosen] || dominates(points[i], points[chosen])))
            others[i] = {kInfinite, kInfinite};
    return paretoFront(others);
}

bool meets(const Figures& figures, const Target& target) {
    return target.mostCost ? figures.cost <= *target.mostCost : figures.error <= *target.mostError;
}

std::vector<size_t> byPreference(std::span<const Figures> points, const Target& target) {
    std::vector<size_t> order(points.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::stable_sort(order, {}, [&](size_t i) {
        const bool met = meets(points[i], target);
        const double bound = target.mostCost ? points[i].cost : points[i].error;
        const double free = target.mostCost ? points[i].error : points[i].cost;
        return std::tuple(met ? 0 : 1, met ? free : bound, met ? bound : free);
    });
    return order;
}

bool holdsUp(const Figures& held, const Figures& heldStart, const Target& target) {
    return held.cost <= std::max(heldStart.cost, target.mostCost.value_or(0)) &&
           held.error <= std::max(heldStart.error, target.mostError.value_or(0));
}

} // namespace glint::tune
