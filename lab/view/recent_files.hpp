// Recently opened files, stored between runs of the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

/// A file with one name per line, the newest first. If the file cannot be read or written, the list is kept only while
/// the program runs, without a message.
class RecentFiles {
public:
    static constexpr size_t kMost = 12;

    RecentFiles() = default;
    explicit RecentFiles(std::string file);
    /// Returns $XDG_STATE_HOME/glint/recent, by default ~/.local/state/glint/recent; empty if there is no home folder.
    static std::string usualFile();

    /// Adds an entry at the front. A path is made absolute, as the next run may start in another folder.
    void add(const std::string& opened);
    const std::vector<std::string>& list() const { return list_; }

private:
    std::vector<std::string> read() const;

    std::string file_;
    std::vector<std::string> list_;
};

/// True for "builtin:hall" and the like, which are never files.
inline bool isBuiltin(std::string_view name) {
    return name.starts_with("builtin:");
}

} // namespace glint::view
