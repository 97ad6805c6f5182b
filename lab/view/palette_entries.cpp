#include "lab/view/palette_entries.hpp"

#include "lab/view/fuzzy_search.hpp"
#include "lab/view/ssr_keys.hpp"

#include <algorithm>
#include <optional>

namespace glint::view {
namespace {

PaletteEntry entry(std::string name, std::string_view key) {
    return {std::move(name), nullptr, &settingOf(key)};
}

std::vector<PalettePage> makePages() {
    std::vector<PalettePage> pages(3);
    pages[0].title = "Commands";
    for (const ViewCommand& command : viewCommands())
        pages[0].entries.push_back({command.name, &command, nullptr});
    pages[1].title = "SSR";
    for (const SsrKey& key : kSsrKeys)
        pages[1].entries.push_back(entry(std::string(key.name), key.setting));
    pages[2].title = "SSR, more";
    pages[2].entries = {entry("Reflect Min", "reflect.threshold"), entry("SSR enabled", "screen.enabled"),
                        entry("March", "screen.march"), entry("Refinements", "adaptive.refinements"),
                        entry("Pixel spacing", "adaptive.pixelSpacing")};
    for (const std::span<const SettingInfo> table : render::allSettings())
        for (const SettingInfo& info : table) {
            const std::string group = info.key.substr(0, info.key.rfind('.'));
            if (pages.size() == 3 || pages.back().title != group)
                pages.push_back({group, {}});
            pages.back().entries.push_back({info.key, nullptr, &info});
        }
    return pages;
}

/// A setting's other names match too, with a slightly lower score.
std::optional<int> score(std::string_view text, const PaletteEntry& entry) {
    std::optional<int> best = fuzzyScore(text, entry.name);
    if (entry.setting)
        for (const SettingAlias& alias : entry.setting->aliases)
            if (const std::optional<int> other = fuzzyScore(text, alias.name))
                best = std::max(best, std::optional<int>(*other - 1));
    return best;
}

} // namespace

const std::vector<PalettePage>& palettePages() {
    static const std::vector<PalettePage> pages = makePages();
    return pages;
}

std::vector<PaletteEntry> searchPalette(std::string_view text) {
    std::vector<std::pair<int, PaletteEntry>> found;
    for (const PalettePage& page : palettePages())
        for (const PaletteEntry& entry : page.entries) {
            const std::optional<int> value = score(text, entry);
            if (!value)
                continue;
            const auto same = [&](const auto& other) { return entry.setting && other.second.setting == entry.setting; };
            const auto known = std::ranges::find_if(found, same); // listed under compute_ssr's name and its own
            if (known == found.end())
                found.emplace_back(*value, entry);
            else if (*value > known->first)
                *known = {*value, entry};
        }
    std::ranges::stable_sort(found, std::ranges::greater(), [](const auto& one) { return one.first; });
    std::vector<PaletteEntry> result;
    for (auto& [value, entry] : found)
        result.push_back(std::move(entry));
    return result;
}

} // namespace glint::view
