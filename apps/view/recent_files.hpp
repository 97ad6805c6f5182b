// What was opened lately, remembered from one start of the program to the next.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

/// A file with a name a line, the newest first. Where it cannot be read or written, the list lasts as long as the
/// program: nobody is told of it.
class RecentFiles {
public:
    static constexpr size_t kMost = 12;

    RecentFiles() = default;
    explicit RecentFiles(std::string file);
    /// $XDG_STATE_HOME/glint/recent, by default ~/.local/state/glint/recent; empty: there is no home.
    static std::string usualFile();

    /// Puts it first. A path is made absolute: the next start may be from another folder.
    void add(const std::string& opened);
    const std::vector<std::string>& list() const { return list_; }

private:
    std::vector<std::string> read() const;

    std::string file_;
    std::vector<std::string> list_;
};

/// "builtin:hall": no file, however it looks.
inline bool isBuiltin(std::string_view name) {
    return name.starts_with("builtin:");
}

} // namespace glint::view
