#include "lab/cli/sequence/motion_option.hpp"

#include "base/text.hpp"
#include "lab/cli/config_option.hpp"

#include <algorithm>

namespace glint::cli {

std::string pathHelp() {
    const std::vector<std::string> moves(scene::cameraMoves().begin(), scene::cameraMoves().end());
    return "Movement of the camera: " + joinText(moves, ", ") + ", or a path file (.json)";
}

Result<measure::SequencePath> readPath(const std::string& text) {
    measure::SequencePath path;
    const auto moves = scene::cameraMoves();
    const auto move = std::ranges::find(moves, text);
    if (move != moves.end()) {
        path.move = static_cast<scene::CameraMove>(move - moves.begin());
    } else if (text.ends_with(".json")) {
        GLINT_TRY(keys, scene::readPathFile(text));
        path.keys = std::move(keys);
    } else {
        const std::vector<std::string> names(moves.begin(), moves.end());
        return invalidArgument("--path {}: expected {} or a .json file", printable(text), joinText(names, ", "));
    }
    return path;
}

Result<uint32_t> motionReferenceFrames(const render::ProgramSettings& settings, std::string_view config,
                                       int64_t samples) {
    const RaysSettings& rays = settings.reflections.rays;
    const auto perFrame = static_cast<int64_t>(rays.samples);
    const auto frames = static_cast<uint32_t>((samples + perFrame - 1) / perFrame);
    if (frames > 1 && !(rays.enabled && rays.accumulate))
        return invalidArgument("--reference {}: {} samples need rays.enabled and rays.accumulate; it has {} per frame",
                               printable(config), samples, perFrame);
    return frames;
}

Result<measure::ComparedConfig> motionReference(const RenderOptions& options, const std::string& config,
                                                int64_t samples) {
    GLINT_TRY(job, makeConfigJob(options, options.scene, config));
    GLINT_TRY(frames, motionReferenceFrames(job.settings, config, samples));
    job.frames = frames;
    return measure::ComparedConfig{config, std::move(job)};
}

} // namespace glint::cli
