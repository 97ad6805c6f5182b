#include "lab/view/command_line.hpp"

#include <fmt/format.h>

namespace glint::view {
namespace {

std::string shellWord(const std::string& text) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=,+-";
    if (!text.empty() && text.find_first_not_of(kPlain) == text.npos)
        return text;
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

} // namespace

bool cameraIsLost(const ViewerState& state, const std::optional<SavedCamera>& saved) {
    return state.camera.moved() && !(saved && sameCamera(saved->camera, state.camera.camera()));
}

std::string commandLine(const ViewerState& state, const render::RenderJob& job,
                        const std::optional<SavedCamera>& saved) {
    std::string text = "glint render " + shellWord(state.scene);
    if (state.camera.moved())
        text += cameraIsLost(state, saved) ? "" : " --camera " + shellWord(saved->path);
    else if (!job.camera.empty() && state.cameraIndex < 0)
        text += " --camera " + shellWord(job.camera);
    else if (state.cameraIndex > 0)
        text += fmt::format(" --camera {}", state.cameraIndex);
    if (!state.materials.savedFile().empty() && state.materials.savedFile() != render::materialFileFor(job.scene))
        text += " --materials " + shellWord(state.materials.savedFile());
    else if (!job.materials.empty() && state.materials.savedFile().empty())
        text += " --materials " + shellWord(job.materials);
    if (!job.environment.empty())
        text += " --env " + shellWord(job.environment);
    if (!job.probes.empty())
        text += " --probes " + shellWord(job.probes);
    if (job.planar != render::MirrorSearch::None)
        text += fmt::format(" --planar {}", render::kMirrorSearchNames[static_cast<size_t>(job.planar)]);
    text += fmt::format(" --size {}x{}", state.width, state.height);
    if (state.animation.seconds != 0)
        text += fmt::format(" --time {}", state.animation.seconds);
    if (state.frames > 1)
        text += fmt::format(" --frames {}", state.frames);
    if (job.seed != 0)
        text += fmt::format(" --seed {}", job.seed);
    if (state.view != "composite")
        text += " --view " + state.view;
    return text + " " + state.settings.options() + " -o picture.png";
}

} // namespace glint::view
