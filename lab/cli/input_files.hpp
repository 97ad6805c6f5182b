// The contents of the files that a scene is made of, so that figures of an earlier state of them are not taken for
// those of this one.
#pragma once

#include "base/result.hpp"
#include "lab/job/render_job.hpp"

#include <map>
#include <string>

namespace glint::cli {

/// Reads each file once, however many jobs name it.
class InputFiles {
public:
    /// Returns a hash of each file's contents by its name: the scene, its camera, environment, materials and probes,
    /// and the files beside them that they name. Errors: NotFound, Io, for a file that the job itself names.
    Result<std::map<std::string, std::string>> of(const render::RenderJob& job);
    /// Returns the same of one file.
    Result<std::map<std::string, std::string>> of(const std::string& file);

private:
    using Hashes = std::map<std::string, std::string>;
    Result<void> add(const std::string& file, Hashes& hashes);
    std::map<std::string, Hashes> known_; ///< by the file named
};

} // namespace glint::cli
