// The files of `glint sequence --dump`: what a denoiser reads of every frame, as OpenEXR, and a description of it all.
#pragma once

#include "lab/measure/motion/denoiser_feed.hpp"
#include "lab/measure/motion/sequence.hpp"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <string>

namespace glint::cli {

/// DIR/seed-N/0000.exr has the layers of measure::feedLayers. DIR/seed-N/sequence.json is written last:
/// {"scene", "config", "seed", "width", "height", "fps", "jitter": [x, y], "conventions": {...},
///  "layers": [{"name", "channels", "unit", "meaning"}],
///  "frames": [{"index", "file", "seconds", "secondsSincePrevious", "worldToView", "viewToClip", "prevWorldToView",
///              "prevViewToClip"}],
///  "settings": {...}}
/// Matrices are lists of four rows.
class FeedFiles {
public:
    /// Errors: InvalidArgument names `--dump` if the plan has several configs, stored frames or settings that do not
    /// denoise; NotFound if there is no folder for DIR.
    static Result<FeedFiles> create(const std::string& folder, const measure::SequencePlan& plan);

    /// Errors of all: Io.
    Result<void> makeFolders() const;
    Result<void> write(const measure::SequenceViews& frame);
    Result<void> writeDescriptions(const measure::Sequence& sequence) const;

private:
    FeedFiles(std::string folder, const measure::SequencePlan& plan);
    std::string seedFolder(uint32_t seed) const;

    std::string folder_;
    std::vector<uint32_t> seeds_;
    std::map<uint32_t, std::vector<measure::SequenceMoment>> moments_; ///< by seed, then by frame
};

} // namespace glint::cli
