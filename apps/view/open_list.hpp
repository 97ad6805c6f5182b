// What can be opened from here: files of a folder, what was opened lately, and scenes that the program brings along.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

struct OpenEntry {
    enum class Kind { Recent, Folder, File, Builtin };
    Kind kind = Kind::File;
    std::string name; ///< as it is shown
    std::string path; ///< what to open, or to enter
};

/// `folder`  absolute; one that cannot be read has no entries but the way out
/// `filter`  parts of a name (fuzzyScore), the best first; empty: everything, recent ones first, folders before files;
/// a
///           path (with a slash) is what it says
std::vector<OpenEntry> openEntries(const std::string& folder, std::string_view filter,
                                   std::span<const std::string> recent);

/// What the panel that opens files has on it.
struct OpenPanel {
    bool shown = false;
    bool begins = false; ///< in this frame
    std::string folder;  ///< empty: the current one
    std::string text;
    int choice = 0;
    bool scroll = false;            ///< to the choice
    std::vector<OpenEntry> entries; ///< of `listed`
    std::string listed;
};

/// Can the viewer open a file with this name's ending?
bool isOpenable(std::string_view name);

} // namespace glint::view
