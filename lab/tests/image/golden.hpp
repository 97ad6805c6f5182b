// Goldens: images that a person checked once and that later images are compared with.
#pragma once

#include "lab/measure/figures/image_error.hpp"
#include "lab/tests/image/image_case.hpp"

#include <optional>
#include <string>

namespace glint::test {

struct GoldenPlaces {
    std::string goldens;  ///< folder of NAME.png
    std::string failures; ///< folder for failures: NAME.actual.png, NAME.golden.png, NAME.flip.png
};

struct Verdict {
    bool good = false;
    std::string message;            ///< what was measured; what to do after a failure
    std::optional<double> meanFlip; ///< set if there was a golden of the same size
};

/// Holds `actual` against its golden, and leaves in `failures` what helps to see why it does not match; what an earlier
/// run left there goes.
/// `software`  the picture comes from the driver that owns the goldens; others are held against Tolerance::meanFlip
Verdict compareWithGolden(const ImageCase& imageCase, const measure::DisplayPicture& actual, const GoldenPlaces& places,
                          bool software);

/// Makes `actual` the golden. Errors: Io.
Result<void> writeGolden(const ImageCase& imageCase, const measure::DisplayPicture& actual, const GoldenPlaces& places);

} // namespace glint::test
