// The files that a command reads and those that it writes: no output may replace an input or another output.
#pragma once

#include "lab/cli/render/render_options.hpp"

#include <span>
#include <string>
#include <vector>

namespace glint::cli {

/// A file, and what the user called it by: "--camera", "GBUFFER".
struct NamedFile {
    std::string option;
    std::string path;

    bool operator==(const NamedFile&) const = default;
};

/// Returns the files that the options name to be read, and those beside the scene that are read without being named.
/// Files that these files name (textures) are left out. A name that is no file, such as that of a camera in the scene,
/// does no harm: checkOutputs compares with files that exist.
std::vector<NamedFile> inputFiles(const RenderOptions& options);

/// Adds the settings files of --config.
void addConfigFiles(const std::vector<std::string>& configs, std::vector<NamedFile>& inputs);

/// Returns what --output and --stats of one rendered image write.
std::vector<NamedFile> outputFiles(const RenderOptions& options);

/// To be called before any work. Equal outputs are one: a file that is written again for each frame of a sequence.
/// Empty paths and streams (namesStream) are no files. Errors: InvalidArgument names both options if an output is the
/// same file as an input or as another output, links followed.
Result<void> checkOutputs(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs);

} // namespace glint::cli
