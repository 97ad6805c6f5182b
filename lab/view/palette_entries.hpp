// The content of the command palette: pages, and one searchable list of all entries.
#pragma once

#include "lab/view/view_commands.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

/// A command, or a setting that is changed in place.
struct PaletteEntry {
    std::string name;
    const ViewCommand* command = nullptr;
    const SettingInfo* setting = nullptr; ///< for entries without a command
};

/// Page 1: commands. Page 2: compute_ssr's settings that have keys. Page 3: its other settings, "Reflect Min" first.
/// Then the groups of the settings table.
struct PalettePage {
    std::string title;
    std::vector<PaletteEntry> entries;
};
const std::vector<PalettePage>& palettePages();

/// Returns the entries of all pages that match `text` (fuzzyScore), the best first, without duplicates.
std::vector<PaletteEntry> searchPalette(std::string_view text);

} // namespace glint::view
