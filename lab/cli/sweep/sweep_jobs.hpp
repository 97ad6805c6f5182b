// The jobs of a sweep: what each of them renders, its name, and which shard runs it.
#pragma once

#include "lab/cli/sweep/sweep_plan.hpp"
#include "lab/measure/motion/sequence.hpp"
#include "lab/measure/truth/comparison.hpp"

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

using SweepJson = nlohmann::ordered_json;

/// A reference picture, which jobs share. Its name depends on all that its bits depend on, as a job's does.
struct SweepReferenceJob {
    std::string name;
    measure::ComparedConfig config;
    std::string view; ///< as SweepJob::view
};

struct SweepJob {
    /// Sixteen hexadecimal digits, a hash of everything that the figures depend on but the machine: the program, the
    /// scene's files, every setting, sizes and counts.
    std::string name;
    /// {"name", "kind": "still" or "motion", "scene", "size": text, "config", "seed"}
    SweepJson description;
    measure::ComparedConfig config;
    /// What a session is opened with: jobs with one view share the session.
    std::string view;
    uint32_t frames = 0; ///< to time, of a still
    bool hits = false;
    std::shared_ptr<const SweepReferenceJob> reference;  ///< of a still; null: none
    std::shared_ptr<const measure::SequencePlan> motion; ///< without its configs; null: a still

    /// "hall, 640x360, fast, seed 0"
    std::string title() const;
};

/// Every combination of the plan, in the order scene, size, kind, config, seed. `program`  programIdentity; `planName`
/// for messages. Errors: InvalidInput, InvalidArgument, NotFound for settings and files of the plan, which it names.
Result<std::vector<SweepJob>> makeSweepJobs(const SweepPlan& plan, const std::string& program,
                                            const std::string& planName);

/// The shard `index` of `count`: the entries index, index + count, index + 2 count ...
struct Shard {
    uint32_t index = 0;
    uint32_t count = 1;

    bool has(size_t entry) const { return entry % count == index; }
};

/// Reads "0/4", the first of four; the last is "3/4". Errors: InvalidArgument.
Result<Shard> readShard(const std::string& text);

} // namespace glint::cli
