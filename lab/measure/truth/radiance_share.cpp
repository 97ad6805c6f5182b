#include "lab/measure/truth/radiance_share.hpp"

#include <cmath>
#include <limits>

namespace glint::measure {

ShareTerms shareTerms(double test, const std::array<double, 2>& now, const std::array<double, 2>& wrong) {
    constexpr double kRelative = 0.1, kAbsolute = 0.01; // radiance
    ShareTerms terms;
    for (size_t weigh = 0; weigh < 2; ++weigh) {
        const size_t measure = 1 - weigh;
        const double difference = wrong[weigh] - now[weigh];
        if (!(std::abs(difference) > kRelative * now[weigh] + kAbsolute))
            continue;
        terms.product += (test - now[measure]) * difference;
        terms.square += (wrong[measure] - now[measure]) * difference;
        terms.difference += difference * difference;
    }
    return terms;
}

Share ShareSeries::share() const {
    constexpr double kAgreement = 0.1; // of pure noise, the mean is 0
    ShareTerms sums;
    for (const ShareTerms& frame : frames_) {
        sums.product += frame.product;
        sums.square += frame.square;
        sums.difference += frame.difference;
    }
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (!(sums.difference > 0 && sums.square > kAgreement * sums.difference))
        return {kNone, kNone};
    const double share = sums.product / sums.square;
    double squares = 0; // Cochran 1977, "Sampling Techniques", section 6.4: the variance of a ratio of sums
    for (const ShareTerms& frame : frames_)
        squares += (frame.product - share * frame.square) * (frame.product - share * frame.square);
    return {share, std::sqrt(squares) / sums.square};
}

} // namespace glint::measure
