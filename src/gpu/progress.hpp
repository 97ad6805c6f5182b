// Tracks which recordings the GPU has executed, by marks that the GPU writes. A host may drop a recorded command buffer
// or submit it late, so a recording counts as executed only once its mark is present. Queries never wait.
#pragma once

#include "gpu/resources.hpp"

#include <array>

namespace glint::gpu {

class Frame;

/// The recordings of one object, in recording order.
class Progress {
public:
    /// `framesInFlight`: a mark counts once the host's frame number is this many frames past its own. The host then
    /// guarantees that the GPU has finished, so the result does not depend on timing. 0: a mark counts as soon as it is
    /// seen. Errors: OutOfMemory.
    static Result<Progress> create(Context& context, const char* name, uint32_t framesInFlight = 0);

    /// Begins a recording. `frame`: the host's frame number, which never decreases.
    void begin(uint64_t frame = 0);
    /// Writes the mark; must be the last command of the recording.
    void end(Frame& frame);

    uint32_t recording() const { return recording_; } ///< number of the current recording, from 1
    bool isExecuted(uint32_t recording) const;

private:
    static constexpr uint32_t kKept = 256; ///< recordings whose marks are kept

    Buffer marks_;
    std::array<uint64_t, kKept> frames_ = {}; ///< the host's frame number of each recording
    uint32_t framesInFlight_ = 0;
    uint64_t frame_ = 0;
    uint32_t recording_ = 0;
};

/// Work that later recordings depend on, such as an upload or a table. It is recorded in every recording until the GPU
/// is known to have executed it once, so executing it twice must be harmless.
class Standing {
public:
    /// `asked`: the work is requested from the start.
    explicit Standing(bool asked = true) : done_(!asked) {}
    /// Requests the work (again): earlier executions no longer count.
    void ask() { count_ = 0, done_ = false; }
    /// True if the current recording must contain the work.
    bool isNeeded(const Progress& progress);
    /// Notes that the current recording contains the work.
    void recorded(const Progress& progress);
    bool isDone() const { return done_; }

private:
    std::array<uint32_t, 8> recordings_ = {}; ///< the newest recordings that contain the work
    uint32_t count_ = 0;
    bool done_;
};

} // namespace glint::gpu
