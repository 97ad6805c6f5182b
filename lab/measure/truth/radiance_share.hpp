// The share of a wrong radiance in a tested one: of what was there before, say.
#pragma once

#include <array>
#include <vector>

namespace glint::measure {

/// Sums for the share `beta` in `test - now = beta (wrong - now)`, by least squares over values where the wrong
/// radiance differs. Both radiances have two estimates with independent noise: one selects the values and weighs them,
/// the other one is measured, so that noise neither selects itself nor dilutes the share (an instrumental variable:
/// Wright 1928, "The Tariff on Animal and Vegetable Oils", appendix B).
struct ShareTerms {
    double product = 0;    ///< of the tested difference and the weighing one
    double square = 0;     ///< of the two estimates of the wrong difference
    double difference = 0; ///< of the weighing estimate alone: shows if the difference is more than noise
};
ShareTerms shareTerms(double test, const std::array<double, 2>& now, const std::array<double, 2>& wrong);

/// NaN if the two estimates do not agree that there is a difference.
struct Share {
    double value = 0;
    double standardError = 0; ///< as if frames were independent
};

/// Frame by frame.
class ShareSeries {
public:
    void add(const ShareTerms& frame) { frames_.push_back(frame); }
    Share share() const;

private:
    std::vector<ShareTerms> frames_;
};

} // namespace glint::measure
