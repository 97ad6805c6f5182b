// For each pixel: whether the source that won was the best one.
#pragma once

#include "lab/tests/image/source_pictures.hpp"

namespace glint::test {

struct Regret {
    /// For the pixels of one winner where another source answers too, alone.
    struct Instead {
        size_t pixels = 0;
        double error = 0;  ///< bytes: of the image
        double itsOwn = 0; ///< bytes: with that source instead
        size_t better = 0; ///< pixels where that error is noticeably less
    };
    struct Winner {
        size_t pixels = 0;
        double error = 0;  ///< bytes: of the image, on its pixels
        double regret = 0; ///< bytes: minus the error of the best of all candidates
        std::array<Instead, kMeasured> instead{};
    };
    std::array<Winner, kMeasured> winners{};
    Winner all;
    double best = 0; ///< fraction of all pixels where none is noticeably better
};

/// A source is a candidate where it answered alone: its image there contains only its own radiance.
constexpr float kAlone = 0.99f;

inline Regret regretOf(const SourcePictures& pictures) {
    Regret out;
    for (size_t i = 0; i < pictures.pixels(); ++i) {
        if (!pictures.reflective[i])
            continue;
        const double error = meanDifference(pictures.whole.rgb[i], pictures.reference[i]);
        const double noticeable = kNoticeable + pictures.noise[i];
        Regret::Winner& won = out.winners[winner(pictures.whole.shares[i])];
        double least = error;
        for (size_t source = 0; source < kMeasured; ++source) {
            const SourcePicture& alone = pictures.alone[source];
            if (alone.shares[i][source] < kAlone || &won == &out.winners[source])
                continue;
            const double itsOwn = meanDifference(alone.rgb[i], pictures.reference[i]);
            Regret::Instead& instead = won.instead[source];
            instead.pixels += 1;
            instead.error += error;
            instead.itsOwn += itsOwn;
            instead.better += error - itsOwn > noticeable ? 1 : 0;
            least = std::min(least, itsOwn);
        }
        for (Regret::Winner* counted : {&won, &out.all}) {
            counted->pixels += 1;
            counted->error += error;
            counted->regret += error - least;
        }
        out.best += error - least <= noticeable ? 1 : 0;
    }
    const auto mean = [](double& sum, size_t count) { sum /= static_cast<double>(std::max<size_t>(count, 1)); };
    mean(out.best, out.all.pixels);
    mean(out.all.error, out.all.pixels);
    mean(out.all.regret, out.all.pixels);
    for (Regret::Winner& won : out.winners) {
        mean(won.error, won.pixels);
        mean(won.regret, won.pixels);
        for (Regret::Instead& instead : won.instead) {
            mean(instead.error, instead.pixels);
            mean(instead.itsOwn, instead.pixels);
        }
    }
    return out;
}

} // namespace glint::test
