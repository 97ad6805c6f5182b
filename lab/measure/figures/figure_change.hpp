// Compares a figure with its earlier value: better, worse, or a difference that its noise explains.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::measure {

/// A figure with its uncertainty.
struct Estimate {
    double value = 0;
    double standardError = 0; ///< 0: the figure has no noise
    double freedom = 0;       ///< degrees of freedom of `standardError`; 0 where it is 0

    /// The mean of independent measurements, such as those of several seeds; at least two. Equal values have no noise.
    static Estimate of(std::span<const double> values);
};

/// How a figure is to be read.
enum class FigureKind {
    Share, ///< [0, 1], higher is better: its changes are in percentage points
    Wrong, ///< [0, 1], lower is better: its changes are in percentage points
    Error, ///< >= 0, lower is better: its changes are in percent of the earlier value
    Time,  ///< as Error, and comparable on one device and driver only
};

/// "share", "wrong", "error" and "time", in the order of FigureKind.
std::span<const std::string_view> figureKindNames();

struct Figure {
    std::string scene;  ///< with its camera and size, if these are not the scene's own
    std::string config; ///< as the user wrote it
    std::string name;   ///< "hits.recall"
    FigureKind kind = FigureKind::Error;
    Estimate estimate;

    bool sameAs(const Figure& other) const {
        return scene == other.scene && config == other.config && name == other.name;
    }
};

enum class Verdict {
    Better,
    Worse,
    Noise, ///< the 95 % interval of the change contains 0
    Same,  ///< no noise, no change
};

/// Changes are positive where the figure has become worse.
struct FigureChange {
    Figure before;
    Figure now;
    double worse = 0; ///< percentage points or percent (FigureKind); infinite from an error of 0 to another
    double low = 0;   ///< the 95 % interval of `worse`
    double high = 0;
    Verdict verdict = Verdict::Same;

    /// All of the interval lies above the threshold: not noise, and larger than is allowed.
    bool exceeds(double threshold) const { return low > threshold; }
};

/// Welch's interval of the difference of two means.
FigureChange changeOf(const Figure& before, const Figure& now);

struct FigureChanges {
    std::vector<FigureChange> changes; ///< in the order of the new figures
    std::vector<Figure> added;         ///< without an earlier value
    std::vector<Figure> removed;       ///< without a new value
    size_t otherDevice = 0;            ///< times left out, as they are of another device
};

/// `sameDevice`  device and driver are those of the earlier figures; otherwise no times are compared
FigureChanges compareFigures(std::span<const Figure> before, std::span<const Figure> now, bool sameDevice);

/// The factor of the standard error in a two-sided 95 % interval with so many degrees of freedom, which are rounded
/// down, to 1 at least.
double studentFactor(double freedom);

} // namespace glint::measure
