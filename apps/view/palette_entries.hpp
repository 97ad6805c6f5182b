// What the command palette offers: pages to leaf through, and one list of everything to search.
#pragma once

#include "view_commands.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

/// A command, or a setting that is changed on the spot.
struct PaletteEntry {
    std::string name;
    const ViewCommand* command = nullptr;
    const SettingInfo* setting = nullptr; ///< where there is no command
};

/// 1: what to do. 2: compute_ssr's settings that have keys. 3: the rest of them, "Reflect Min" first. Then the table's
/// groups.
struct PalettePage {
    std::string title;
    std::vector<PaletteEntry> entries;
};
const std::vector<PalettePage>& palettePages();

/// Those entries of all pages that answer to `text` (fuzzyScore), the best first, each once.
std::vector<PaletteEntry> searchPalette(std::string_view text);

} // namespace glint::view
