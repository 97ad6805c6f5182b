// The table of all passes, docs/passes.md: what each reads and writes, and which frames run it.
#pragma once

#include "gpu/pass_log.hpp"

#include <glm/glm.hpp>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace glint::test {

/// Frames that are alike in what they run: their name in the table, and what was recorded for them at two sizes.
struct LoggedFrames {
    std::string name;
    bool isPreset = false;
    std::array<gpu::PassLog, 2> logs;
};

class PassTable {
public:
    /// `sizes`  pixels of the two logs' frames
    explicit PassTable(std::array<glm::uvec2, 2> sizes) : sizes_(sizes) {}

    void add(const LoggedFrames& frames);
    /// Every shader that ran.
    const std::set<std::string>& shaders() const { return shaders_; }
    /// Returns docs/passes.md.
    std::string page() const;

private:
    /// One image or buffer of a pass: at most so many bytes in any frame.
    struct Bound {
        std::string resource;
        bool reads = false;
        bool writes = false;
        bool isImage = false;
        std::array<uint64_t, 2> bytes = {0, 0}; ///< by size
    };
    struct Row {
        std::string name;
        std::set<std::string> shaders; ///< others than `name`
        std::vector<Bound> bound;
        std::vector<std::string> presets;
        std::vector<std::string> otherwise; ///< other frames that ran it
    };

    Row& rowAfter(size_t& place, const std::string& name);
    void addUse(Row& row, const gpu::PassLog::Use& use, size_t size);
    std::string boundText(const Row& row, bool writes) const;
    std::string bytesText(const Bound& bound) const;
    std::string runsText(const Row& row) const;

    std::array<glm::uvec2, 2> sizes_;
    std::vector<Row> rows_;
    std::set<std::string> shaders_;
    size_t presets_ = 0;
};

} // namespace glint::test
