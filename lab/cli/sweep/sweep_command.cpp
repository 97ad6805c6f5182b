// glint sweep: a plan of many independent jobs, in shards that any number of machines run; and their results as tables.
#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/commands.hpp"
#include "lab/cli/program_identity.hpp"
#include "lab/cli/sweep/sweep_meter.hpp"
#include "lab/cli/sweep/sweep_run.hpp"
#include "lab/cli/sweep/sweep_tables.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace glint::cli {
namespace {

constexpr size_t kLongestPlan = size_t{1} << 26; ///< bytes
constexpr size_t kMostNamed = 10;                ///< missing jobs that the error names

struct SweepOptions {
    std::string plan;
    std::string out;
    std::string shard = "0/1";
    bool list = false;
    bool references = false;
    std::string merge;
    bool partial = false;
    bool mixed = false;
    std::string device;
    bool validate = false;
};

/// Options that one way of using the command has, and the other has not.
Result<void> checkUse(const SweepOptions& options) {
    if (!options.merge.empty()) {
        if (!options.plan.empty() || !options.out.empty() || options.list || options.references)
            return invalidArgument(
                "--merge takes neither a plan nor --out, --list or --references: the folder has all");
        return {};
    }
    if (options.plan.empty())
        return invalidArgument("give a plan, or --merge DIR");
    if (options.partial || options.mixed)
        return invalidArgument("--partial and --mixed go with --merge");
    if (options.out.empty() && !options.list)
        return invalidArgument("give --out DIR, the folder of the results, or --list");
    return {};
}

std::string stateOf(const SweepFolder& folder, const SweepJob& job) {
    if (folder.readResult(job.description))
        return "done";
    const std::string failure = folder.readFailure(job.name);
    return failure.empty() ? "to do" : "failed: " + failure;
}

/// A line for each job of the shard; with --out also whether it is done.
void listJobs(const SweepOptions& options, const std::vector<SweepJob>& jobs, const Shard& shard) {
    const SweepFolder folder(options.out);
    for (size_t i = 0; i < jobs.size(); ++i)
        if (shard.has(i))
            fmt::print("{}  {}{}\n", jobs[i].name, printable(jobs[i].title(), 300),
                       options.out.empty() ? "" : "  " + printable(stateOf(folder, jobs[i]), 300));
}

Error failed(const SweepFailures& failures, size_t jobs, std::string_view what) {
    return makeError(ErrorCode::Unsupported, "{} of {} {} failed; the first: {}; the same command tries them again",
                     failures.count, jobs, what, failures.first);
}

/// Draws those references of the shard that the folder does not have.
Result<void> drawReferences(const SweepOptions& options, const SweepFolder& folder, const std::vector<SweepJob>& jobs,
                            const Shard& shard) {
    const auto references = sweepReferences(jobs);
    std::vector<const SweepReferenceJob*> pending;
    for (size_t i = 0; i < references.size(); ++i)
        if (shard.has(i) && !folder.hasReference(references[i]->name))
            pending.push_back(references[i].get());
    SweepFailures failures;
    if (!pending.empty()) {
        SweepMeter meter(folder, programIdentity(), options.device, options.validate);
        GLINT_CHECK(meter.open());
        for (const SweepReferenceJob* reference : pending)
            if (auto drawn = meter.makeReference(*reference); !drawn && failures.count++ == 0)
                failures.first = fmt::format("{}: {}", printable(reference->config.job.scene),
                                             printable(drawn.error().message, 500));
    }
    fmt::print("{} references, {} of them in shard {}/{} drawn now\n", references.size(),
               pending.size() - failures.count, shard.index, shard.count);
    return failures.count == 0 ? Result<void>() : failed(failures, pending.size(), "references");
}

Result<void> runShard(const SweepOptions& options, const SweepFolder& folder, const std::string& program,
                      const std::vector<SweepJob>& jobs, const Shard& shard) {
    size_t own = 0;
    for (size_t i = 0; i < jobs.size(); ++i)
        own += shard.has(i) ? 1 : 0;
    const std::vector<const SweepJob*> pending = pendingJobs(folder, jobs, shard);
    SweepFailures failures;
    if (!pending.empty()) {
        SweepMeter meter(folder, program, options.device, options.validate);
        GLINT_CHECK(meter.open());
        const auto show = [&](size_t index, const SweepJob& job) {
            if (isatty(fileno(stderr)))
                fmt::print(stderr, "job {} of {}: {}\n", index + 1, pending.size(), printable(job.title(), 200));
        };
        GLINT_TRY(ended, runSweepJobs(
                             folder, pending, [&](const SweepJob& job) { return meter.measure(job); }, show));
        failures = std::move(ended);
    }
    fmt::print("shard {}/{}: {} jobs, {} done before, {} done now, {} failed\n", shard.index, shard.count, own,
               own - pending.size(), pending.size() - failures.count, failures.count);
    return failures.count == 0 ? Result<void>() : failed(failures, own, "jobs");
}

Result<void> runSweep(const SweepOptions& options) {
    GLINT_TRY(shard, readShard(options.shard));
    GLINT_TRY(text, readFile(options.plan, kLongestPlan));
    GLINT_TRY(plan, readSweepPlan(text, options.plan));
    const std::string program = programIdentity();
    GLINT_TRY(jobs, makeSweepJobs(plan, program, options.plan));
    if (options.list) {
        listJobs(options, jobs, shard);
        return {};
    }
    const SweepFolder folder(options.out);
    GLINT_CHECK(folder.create());
    GLINT_CHECK(folder.writeList(program, std::filesystem::path(options.plan).filename().string(), jobs));
    return options.references ? drawReferences(options, folder, jobs, shard)
                              : runShard(options, folder, program, jobs, shard);
}

/// "0123456789abcdef (hall, fast: not enough memory), ..."
std::string missingText(const SweepTables& tables) {
    std::vector<std::string> names;
    for (const SweepRow& row : tables.rows) {
        if (row.result)
            continue;
        if (names.size() == kMostNamed) {
            names.emplace_back("...");
            break;
        }
        const std::string name = row.description["name"].get<std::string>();
        names.push_back(row.failure.empty() ? name : fmt::format("{} ({})", name, printable(row.failure)));
    }
    return joinText(names, ", ");
}

Result<void> mergeSweep(const SweepOptions& options) {
    const SweepFolder folder(options.merge);
    GLINT_TRY(tables, readSweepTables(folder));
    const size_t missing = tables.missing();
    if (missing > 0 && !options.partial)
        return makeError(ErrorCode::Unsupported,
                         "{}: {} of {} jobs have no result: {}; run their shards again, or give --partial",
                         printable(options.merge), missing, tables.rows.size(), missingText(tables));
    if (missing == tables.rows.size())
        return makeError(ErrorCode::Unsupported, "{}: no job has a result", printable(options.merge));
    const std::vector<std::string> devices = tables.devices();
    if (devices.size() > 1 && !options.mixed)
        return makeError(ErrorCode::Unsupported,
                         "{}: results are of {} devices or drivers, whose bits differ: {}; give --mixed to put them "
                         "into one table",
                         printable(options.merge), devices.size(), printable(joinText(devices, "; "), 500));
    GLINT_CHECK(writeSweepTables(folder, tables));
    fmt::print("{} of {} jobs: {}/table.json, table.csv, times.csv, index.html\n", tables.rows.size() - missing,
               tables.rows.size(), options.merge);
    return {};
}

Result<void> sweep(const SweepOptions& options) {
    GLINT_CHECK(checkUse(options));
    return options.merge.empty() ? runSweep(options) : mergeSweep(options);
}

} // namespace

void addSweepCommand(CLI::App& program, Command& chosen) {
    const auto options = std::make_shared<SweepOptions>();
    CLI::App* const command =
        program.add_subcommand("sweep", "Run a plan of many jobs, in shards on many machines; tables of the results");
    command->add_option("PLAN", options->plan, "Scenes, sizes, settings and seeds: a JSON file (docs/sweep.md)");
    command->add_option("--out", options->out, "Folder of the results; jobs that it has are not run again");
    command->add_option("--shard", options->shard, "I/N: run every N-th job from number I on, 0 to N - 1")
        ->capture_default_str();
    command->add_flag("--list", options->list, "Print the jobs; with --out also which are done");
    command->add_flag("--references", options->references, "Only draw the references, before the jobs that share them");
    command->add_option("--merge", options->merge, "Make the tables and the page of this folder's results");
    command->add_flag("--partial", options->partial, "Merge although jobs are missing");
    command->add_flag("--mixed", options->mixed, "Merge results of different devices or drivers");
    command->add_option("--device", options->device, "Part of a device's name, or an index (glint devices)");
    command->add_flag("--validate", options->validate, "Fail on any message of the Vulkan validation layer");
    command->callback([&chosen, options] { chosen = [options] { return sweep(*options); }; });
}

} // namespace glint::cli
