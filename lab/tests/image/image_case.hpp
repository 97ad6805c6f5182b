// What an image test renders and how near its golden it must come: a small JSON file, in the command line's words.
//
//     {"description": "for people", "scene": "builtin:hall", "camera": "three-quarter", "environment": "sky",
//      "size": [320, 180], "time": 0, "frames": 1, "seed": 0, "preset": "balanced", "set": ["screen.step=4"],
//      "view": "composite", "tolerance": {"maxAbsDiff": 0.02, "failingFraction": 0.001, "meanFlip": 0.05}}
//
// "scene" and "size" must be there. Where "scene", "camera" or "environment" begin with "assets:", the rest is a path
// in the assets folder, which not every machine has.
#pragma once

#include "lab/cli/render/render_options.hpp"

#include <string>

namespace glint::test {

struct Tolerance {
    double maxAbsDiff = 0.02;       ///< a pixel fails if one of its channels differs by more, [0, 1]
    double failingFraction = 0.001; ///< of the pixels may fail
    double meanFlip = 0.05;         ///< replaces both on drivers other than the software driver that made the goldens
};

struct ImageCase {
    std::string name; ///< the file's, without .json; also the test's and the golden's
    cli::RenderOptions options;
    Tolerance tolerance;
    bool needsAssets = false;
};

/// `assets`  folder that "assets:" stands for
/// Errors: NotFound, Io; InvalidInput names the file and the key that is unknown, missing or of another type.
Result<ImageCase> readImageCase(const std::string& path, const std::string& assets);

/// The equivalent command line, to try a case by hand.
std::string commandOf(const ImageCase& imageCase);

} // namespace glint::test
