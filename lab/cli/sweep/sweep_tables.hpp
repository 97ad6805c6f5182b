// What a sweep found, as tables. Everything but the times is the same whoever ran the jobs, bit for bit.
#pragma once

#include "lab/cli/sweep/sweep_folder.hpp"

namespace glint::cli {

struct SweepRow {
    SweepJson description; ///< SweepJob::description
    std::optional<SweepResult> result;
    std::string failure; ///< why there is no result, where that is known
};

struct SweepTables {
    std::string program;
    std::string plan;
    std::vector<SweepRow> rows;           ///< all jobs of the list, in its order
    std::vector<std::string> figureNames; ///< of all results, sorted

    size_t missing() const;
    /// "NAME, DRIVER" of every device that made results, sorted.
    std::vector<std::string> devices() const;
};

/// Reads the results of the folder's list. Errors: as SweepFolder::readList.
Result<SweepTables> readSweepTables(const SweepFolder& folder);

/// {"format", "program", "devices": [text], "jobs": count, "missing": [name], "rows": [{"job", "kind", "scene",
/// "width", "height", "config", "seed", "figures": {name: value}}], "means": [{"kind", "scene", "width", "height",
/// "config", "seeds": count, "figures": {name: {"mean", "standardError"}}}]} A mean is over the seeds of one config;
/// its standard error is null for one seed.
SweepJson sweepTableJson(const SweepTables& tables);

/// A line for each result (RFC 4180), a column for each figure; empty where a job has not measured it.
std::string sweepTableCsv(const SweepTables& tables);

/// Job, machine, device, seconds of the job and milliseconds of the effect: not the same on every run.
std::string sweepTimesCsv(const SweepTables& tables);

/// One page with a chart of cost against error and a table for each scene. `table`  sweepTableJson
std::string sweepPage(const SweepJson& table, const std::string& plan);

/// Writes table.json, table.csv, times.csv and index.html into the folder. Errors: Io.
Result<void> writeSweepTables(const SweepFolder& folder, const SweepTables& tables);

} // namespace glint::cli
