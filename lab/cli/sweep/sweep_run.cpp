#include "lab/cli/sweep/sweep_run.hpp"

#include "base/log.hpp"
#include "base/text.hpp"

#include <algorithm>

namespace glint::cli {

std::vector<const SweepJob*> pendingJobs(const SweepFolder& folder, std::span<const SweepJob> jobs,
                                         const Shard& shard) {
    const std::set<std::string> failures = folder.failures();
    std::vector<const SweepJob*> pending;
    for (size_t i = 0; i < jobs.size(); ++i)
        if (shard.has(i) && !folder.readResult(jobs[i].description))
            pending.push_back(&jobs[i]);
    std::ranges::stable_partition(pending, [&](const SweepJob* job) { return !failures.contains(job->name); });
    return pending;
}

Result<SweepFailures> runSweepJobs(const SweepFolder& folder, std::span<const SweepJob* const> jobs,
                                   const MeasureSweepJob& measure,
                                   const std::function<void(size_t, const SweepJob&)>& progress) {
    SweepFailures failures;
    for (size_t i = 0; i < jobs.size(); ++i) {
        const SweepJob& job = *jobs[i];
        if (progress)
            progress(i, job);
        // A process that is killed now leaves this record, which says that the job was running.
        GLINT_CHECK(folder.writeFailure(job.name, "its process ended before the job did"));
        auto result = measure(job);
        if (result) {
            GLINT_CHECK(folder.writeResult(*result));
            folder.removeFailure(job.name);
            continue;
        }
        const std::string& message = result.error().message;
        GLINT_CHECK(folder.writeFailure(job.name, message));
        log::warning("job {} ({}) failed: {}", job.name, printable(job.title(), 200), printable(message, 500));
        if (failures.count++ == 0)
            failures.first = fmt::format("{}: {}", printable(job.title(), 200), printable(message, 500));
    }
    return failures;
}

std::vector<std::shared_ptr<const SweepReferenceJob>> sweepReferences(std::span<const SweepJob> jobs) {
    std::vector<std::shared_ptr<const SweepReferenceJob>> references;
    std::set<std::string> names;
    for (const SweepJob& job : jobs)
        if (job.reference && names.insert(job.reference->name).second)
            references.push_back(job.reference);
    return references;
}

} // namespace glint::cli
