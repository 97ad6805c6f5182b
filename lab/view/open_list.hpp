// Lists what can be opened: files of a folder, recently opened files, and built-in scenes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

struct OpenEntry {
    enum class Kind { Recent, Folder, File, Builtin };
    Kind kind = Kind::File;
    std::string name; ///< the displayed name
    std::string path; ///< the path to open, or the folder to enter
};

/// `folder`  absolute; an unreadable folder has only the entry of its parent
/// `filter`  parts of a name (fuzzyScore), the best match first; empty: all entries, recent ones first, folders before
///           files; text with a slash is used as a path
std::vector<OpenEntry> openEntries(const std::string& folder, std::string_view filter,
                                   std::span<const std::string> recent);

/// State of the panel that opens files.
struct OpenPanel {
    bool shown = false;
    bool begins = false; ///< the panel opens in this frame
    std::string folder;  ///< empty: the current folder
    std::string text;
    int choice = 0;
    bool scroll = false;            ///< scroll to the selected entry
    std::vector<OpenEntry> entries; ///< entries of `listed`
    std::string listed;
};

/// True if the viewer can open a file with this name's extension.
bool isOpenable(std::string_view name);

} // namespace glint::view
