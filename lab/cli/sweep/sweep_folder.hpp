// The folder of a sweep: its list of jobs, a file for each result, the references. Any number of processes, on any
// machines that share the folder, may use it at once: every file is written under a name of its writer's own and then
// renamed, and whoever writes a file writes the same contents.
#pragma once

#include "base/result.hpp"
#include "lab/cli/sweep/sweep_jobs.hpp"
#include "lab/measure/truth/compared_view.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace glint::cli {

/// What a job found.
struct SweepResult {
    SweepJson description; ///< SweepJob::description
    std::string program;
    std::string device;
    std::string driver;
    uint32_t width = 0; ///< pixels
    uint32_t height = 0;
    SweepJson figures;              ///< names and numbers that are the same on every run
    std::vector<std::string> notes; ///< for the user, as `glint compare` prints them
    SweepJson run;                  ///< times and the machine's name, which are not
};

/// The jobs of the plan that was started last in a folder.
struct SweepList {
    std::string program;
    std::string plan;            ///< the plan's name, for messages
    std::vector<SweepJson> jobs; ///< SweepJob::description
};

class SweepFolder {
public:
    explicit SweepFolder(std::string path) : path_(std::move(path)) {}

    const std::string& path() const { return path_; }
    /// Makes the folders that do not exist. Errors: Io.
    Result<void> create() const;

    /// Writes the list, unless it is there already. Errors: Io.
    Result<void> writeList(const std::string& program, const std::string& plan, std::span<const SweepJob> jobs) const;
    /// Errors: NotFound if this is no folder of a sweep; InvalidInput if its list is damaged.
    Result<SweepList> readList() const;

    /// Errors: Io.
    Result<void> writeResult(const SweepResult& result) const;
    /// Returns nothing if the job has no result, or one that is damaged or another job's.
    std::optional<SweepResult> readResult(const SweepJson& description) const;

    /// States that a job has begun, or why it failed. Errors: Io.
    Result<void> writeFailure(const std::string& job, const std::string& message) const;
    void removeFailure(const std::string& job) const;
    /// Returns the jobs that failed, or whose process ended before they did.
    std::set<std::string> failures() const;
    /// Returns the message of writeFailure; empty if there is none.
    std::string readFailure(const std::string& job) const;

    /// Errors: Io.
    Result<void> writeReference(const std::string& name, const measure::ReferenceImages& images, uint32_t width,
                                uint32_t height) const;
    /// Returns nothing if the reference is absent or damaged. `images` are those that were written, bit for bit, with
    /// fourth components of 0.
    std::optional<measure::ReferenceImages> readReference(const std::string& name, uint32_t width,
                                                          uint32_t height) const;
    bool hasReference(const std::string& name) const;

private:
    std::string path_;
};

} // namespace glint::cli
