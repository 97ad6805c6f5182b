// Points in the plane of cost and error: which are dominated, and which one meets a target.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace glint::tune {

/// A cost or error that nothing is worse than: unknown, or not to be chosen.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Smaller is better in both.
struct Figures {
    double cost = 0;
    double error = 0;

    bool operator==(const Figures&) const = default;
};

/// True if `a` is nowhere worse than `b` and somewhere better.
bool dominates(const Figures& a, const Figures& b);

/// Indices of the points that no other point dominates, by rising cost; of equal points the first alone. Points with a
/// figure that is not finite are never among them.
std::vector<size_t> paretoFront(std::span<const Figures> points);

/// The same, through the point `chosen`: points at least as good as it in both figures are left out, so it is one of
/// the indices.
std::vector<size_t> paretoFrontThrough(std::span<const Figures> points, size_t chosen);

/// What the user asked for: exactly one is set.
struct Target {
    std::optional<double> mostCost;
    std::optional<double> mostError;
};

bool meets(const Figures& figures, const Target& target);

/// Indices of all points, the best for the target first: those that meet it, by the figure that the target leaves free;
/// then the others, by how far they miss it. Ties go to the other figure, then to the order given.
std::vector<size_t> byPreference(std::span<const Figures> points, const Target& target);

/// Decides on views that the search has not seen: the point costs no more, and shows no more error, than the start does
/// there or than the target allows.
bool holdsUp(const Figures& held, const Figures& heldStart, const Target& target);

} // namespace glint::tune
