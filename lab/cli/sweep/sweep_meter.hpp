// Measures the jobs of a sweep on a device, one after another. The figures of a job are the same whatever was measured
// before it.
#pragma once

#include "lab/cli/sweep/sweep_folder.hpp"

#include <memory>
#include <optional>

namespace glint::cli {

class SweepMeter {
public:
    /// `device`, `validate`  as RenderJob's
    SweepMeter(const SweepFolder& folder, std::string program, std::string device, bool validate)
        : folder_(folder), program_(std::move(program)), device_(std::move(device)), validate_(validate) {}

    /// Creates the device. Errors: those of gpu::Context::create.
    Result<void> open();

    /// Requires `open`. Takes the job's reference from the folder, or draws it and writes it there. Errors: those of
    /// the scene's readers and the device; Unsupported for messages of the validation layer; Io.
    Result<SweepResult> measure(const SweepJob& job);
    /// Draws a reference, unless the folder has it. Returns true if it was drawn. Errors: as `measure`.
    Result<bool> makeReference(const SweepReferenceJob& reference);

private:
    Result<void> reopenIfLost(const Error& error);
    Result<SweepResult> measured(const SweepJob& job);
    Result<void> openView(const measure::ComparedConfig& config, const std::string& view);
    Result<measure::ReferenceImages> referenceImages(const SweepReferenceJob& reference);
    Result<void> useReference(const SweepReferenceJob& reference);
    Result<void> measureStill(const SweepJob& job, SweepResult& result);
    Result<void> measureMotion(const SweepJob& job, SweepResult& result);
    Result<void> checkMessages() const;

    const SweepFolder& folder_;
    std::string program_, device_;
    bool validate_;
    std::unique_ptr<gpu::Context> context_;
    std::string openView_; ///< SweepJob::view of `view_`
    std::optional<measure::ComparedView> view_;
    std::string reference_; ///< name of the one that `view_` compares with
    std::vector<uint8_t> referenceDisplayed_;
};

} // namespace glint::cli
