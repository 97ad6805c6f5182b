#include "lab/cli/file_roles.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/config_option.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/job/job_inputs.hpp"
#include "lab/sources/probe_world.hpp"

#include <filesystem>
#include <unordered_map>

namespace glint::cli {

std::vector<NamedFile> inputFiles(const RenderOptions& options) {
    std::vector<NamedFile> files = {{"SCENE", options.scene}, {"--settings", options.settings.file}};
    files.push_back({"--camera", options.camera});
    if (options.environment != "sky" && options.environment != "none")
        files.push_back({"--env", options.environment});
    if (options.materials.empty())
        files.push_back({"the scene's file of materials", render::materialFileFor(options.scene)});
    else if (options.materials != render::kNoMaterials)
        files.push_back({"--materials", options.materials});
    files.push_back({"--probes", options.probes == "auto" ? render::probeFileFor(options.scene) : options.probes});
    return files;
}

void addConfigFiles(const std::vector<std::string>& configs, std::vector<NamedFile>& inputs) {
    for (const std::string& config : configs)
        if (const auto request = readConfig(config)) // what is no config is reported where it is read
            inputs.push_back({"--config", request->file});
}

std::vector<NamedFile> outputFiles(const RenderOptions& options) {
    std::vector<NamedFile> files = {{"-o", options.output}, {"--stats", options.statsFile}};
    const auto kind = pictureKind(options.output);
    if (kind && *kind == PictureKind::Png)
        for (size_t i = 1; i < options.views.size(); ++i)
            files.push_back({"--view", pathForView(options.output, options.views[i])});
    return files;
}

Result<void> checkOutputs(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs) {
    std::unordered_map<std::string, const NamedFile*> read, written;
    for (const NamedFile& input : inputs)
        if (std::error_code error; !input.path.empty() && std::filesystem::is_regular_file(input.path, error))
            read.try_emplace(fileIdentity(input.path), &input);
    for (const NamedFile& output : outputs) {
        if (output.path.empty() || namesStream(output.path))
            continue;
        const std::string identity = fileIdentity(output.path);
        if (const auto input = read.find(identity); input != read.end())
            return invalidArgument("{} {}: this is the file of {}, which would be replaced: write to another one",
                                   output.option, printable(output.path), input->second->option);
        const auto [other, isNew] = written.try_emplace(identity, &output);
        if (!isNew && *other->second != output)
            return invalidArgument("{} {}: this is the file of {} too: write to another one", output.option,
                                   printable(output.path), other->second->option);
    }
    return {};
}

} // namespace glint::cli
