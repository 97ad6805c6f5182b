#include "lab/cli/frames_option.hpp"

#include "base/text.hpp"
#include "lab/cli/sequence/sequence_files.hpp"

#include <vector>

namespace glint::cli {
namespace {

constexpr std::string_view kFrameEnding = ".exr";

/// The patterns; a colon separates two only behind .exr, since folders may have one in their name.
std::vector<std::string> patternsOf(std::string_view text) {
    const size_t colon = text.find(std::string(kFrameEnding) + ":");
    if (colon == text.npos)
        return {std::string(text)};
    const size_t length = colon + kFrameEnding.size();
    return {std::string(text.substr(0, length)), std::string(text.substr(length + 1))};
}

} // namespace

const char* const kFramesHelp = "frames=A/%04d.exr:B/%04d.exr, frames with two seeds that another program made";

bool namesFrames(std::string_view config) {
    return config.starts_with(kFramesPrefix);
}

Result<measure::StoredFrames> openFrames(std::string_view config, uint32_t frames) {
    const std::vector<std::string> patterns = patternsOf(config.substr(kFramesPrefix.size()));
    std::vector<std::vector<std::string>> files;
    for (const std::string& text : patterns) {
        const auto pattern = FramePattern::parse(text);
        if (!pattern || !text.ends_with(kFrameEnding))
            return invalidArgument("--config {}: expected {}A/%04d.exr, or {}A/%04d.exr:B/%04d.exr for two seeds, with "
                                   "one %d or %04d in each for the number of the frame",
                                   printable(config), kFramesPrefix, kFramesPrefix);
        std::vector<std::string>& paths = files.emplace_back();
        for (uint32_t frame = 0; frame < frames; ++frame)
            paths.push_back(pattern->path(frame));
    }
    if (patterns.front() == patterns.back() && patterns.size() == 2)
        return invalidArgument(
            "--config {}: both seeds are the same files, which hides all noise: name those of another "
            "seed, or state them once",
            printable(config));
    return measure::StoredFrames::open(std::move(files));
}

} // namespace glint::cli
