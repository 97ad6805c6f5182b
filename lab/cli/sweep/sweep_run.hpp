// Runs the jobs of a sweep that its folder has no result of.
#pragma once

#include "lab/cli/sweep/sweep_folder.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace glint::cli {

/// Returns the shard's jobs without a result, in order. Those that failed before, or whose process ended in the middle
/// of them, come last: a job that takes the process with it holds up no other one.
std::vector<const SweepJob*> pendingJobs(const SweepFolder& folder, std::span<const SweepJob> jobs, const Shard& shard);

struct SweepFailures {
    size_t count = 0;
    std::string first; ///< title and message of the first one
};

using MeasureSweepJob = std::function<Result<SweepResult>(const SweepJob&)>;

/// Runs one job after another and writes each result at once. A job that fails is recorded and the next one begins.
/// `progress`  is called before each job with its number, from 0; may be empty. Errors: Io if the folder cannot be
/// written.
Result<SweepFailures> runSweepJobs(const SweepFolder& folder, std::span<const SweepJob* const> jobs,
                                   const MeasureSweepJob& measure,
                                   const std::function<void(size_t, const SweepJob&)>& progress = {});

/// The references that jobs share, each once, in the order of the jobs.
std::vector<std::shared_ptr<const SweepReferenceJob>> sweepReferences(std::span<const SweepJob> jobs);

} // namespace glint::cli
