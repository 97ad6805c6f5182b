#include "lab/cli/config_option.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <cctype>

namespace glint::cli {
namespace {

bool isFile(std::string_view text) {
    return text.ends_with(".json");
}

bool isBase(std::string_view text) {
    const std::vector<std::string_view> presets = presetNames();
    return isFile(text) || std::ranges::find(presets, text) != presets.end();
}

/// Length of the preset or file name at the start of `text`, up to a + or comma; file names may contain these. 0: none.
size_t baseLength(std::string_view text) {
    for (size_t i = 1; i <= text.size() && text[i - 1] != '='; ++i)
        if ((i == text.size() || text[i] == ',' || text[i] == '+') && isBase(text.substr(0, i)))
            return i;
    return 0;
}

std::vector<std::string> parts(std::string_view text) {
    std::vector<std::string> result;
    while (true) {
        const size_t comma = text.find(',');
        result.emplace_back(text.substr(0, comma));
        if (comma == text.npos)
            return result;
        text.remove_prefix(comma + 1);
    }
}

} // namespace

const char* const kConfigHelp = "Settings: a preset, a .json file, KEY=VALUE,KEY=VALUE or PRESET+KEY=VALUE,...";

Result<render::SettingsRequest> readConfig(std::string_view text) {
    render::SettingsRequest request;
    const std::string_view base = text.substr(0, baseLength(text));
    if (base.empty() && text.find('=') == text.npos) {
        const std::vector<std::string_view> presets = presetNames();
        return invalidArgument("--config {}: no preset of this name and no .json file; presets: {}", printable(text),
                               joinText(std::vector<std::string>(presets.begin(), presets.end()), ", "));
    }
    (isFile(base) ? request.file : request.preset) = base;
    if (base.size() == text.size())
        return request;
    for (std::string& assignment : parts(text.substr(base.empty() ? 0 : base.size() + 1))) {
        const size_t equals = assignment.find('=');
        if (equals == assignment.npos || equals == 0)
            return invalidArgument("--config {}: '{}' is no KEY=VALUE", printable(text), printable(assignment));
        request.assignments.push_back(std::move(assignment));
    }
    return request;
}

Result<render::RenderJob> makeConfigJob(const RenderOptions& options, const std::string& scene,
                                        const std::string& config) {
    GLINT_TRY(request, readConfig(config));
    request.assignments.insert(request.assignments.begin(), options.settings.assignments.begin(),
                               options.settings.assignments.end());
    RenderOptions one = options;
    one.scene = scene;
    one.frames = 1;
    one.settings = std::move(request);
    auto job = makeRenderJob(one);
    if (!job && job.error().message.starts_with("--set "))
        return makeError(job.error().code, "--config {}: {}", printable(config), job.error().message.substr(6));
    if (job && job->settings.render.display.antialias == render::Antialias::Accumulate)
        return invalidArgument("--config {}: display.antialias accumulate is for glint render and glint view; what "
                               "compares settings measures single frames: none, fxaa or msaa4",
                               printable(config));
    return job;
}

uint32_t defaultReferenceFrames(const render::ProgramSettings& settings) {
    return settings.reflections.rays.enabled && settings.reflections.rays.accumulate ? 16 : 1;
}

std::string configFileName(size_t index, std::string_view config) {
    std::string name;
    for (const char c : config.substr(0, 40))
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
    return fmt::format("{}-{}", index + 1, name);
}

} // namespace glint::cli
