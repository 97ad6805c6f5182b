#include "lab/view/open_list.hpp"

#include "lab/scene/builtin/builtin.hpp"
#include "lab/view/fuzzy_search.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace glint::view {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostEntries = 5000; ///< per folder

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// Returns folders, then files that can be opened, each by name, without hidden ones.
std::vector<OpenEntry> entriesOf(const std::string& folder) {
    std::vector<OpenEntry> entries;
    std::error_code error;
    for (fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && it != end && entries.size() < kMostEntries; it.increment(error)) {
        const std::string name = it->path().filename().string();
        std::error_code gone;
        const bool isFolder = it->is_directory(gone);
        if (gone || name.starts_with('.') || (!isFolder && !isOpenable(name)))
            continue;
        entries.push_back({isFolder ? OpenEntry::Kind::Folder : OpenEntry::Kind::File, isFolder ? name + "/" : name,
                           it->path().string()});
    }
    std::ranges::sort(entries, [](const OpenEntry& a, const OpenEntry& b) {
        return a.kind != b.kind ? a.kind < b.kind : lower(a.name) < lower(b.name);
    });
    return entries;
}

std::vector<OpenEntry> everything(const std::string& folder, std::span<const std::string> recent) {
    std::vector<OpenEntry> all;
    for (const std::string& name : recent)
        all.push_back({OpenEntry::Kind::Recent, name, name});
    const fs::path up = fs::path(folder).parent_path();
    if (up != fs::path(folder))
        all.push_back({OpenEntry::Kind::Folder, "../", up.string()});
    for (OpenEntry& entry : entriesOf(folder))
        all.push_back(std::move(entry));
    for (const scene::BuiltinInfo& info : scene::builtinScenes()) {
        const std::string name = "builtin:" + std::string(info.name);
        all.push_back({OpenEntry::Kind::Builtin, name, name});
    }
    return all;
}

/// Completes a typed path: entries of its folder that begin with its last part.
std::vector<OpenEntry> completions(const std::string& folder, std::string_view typed) {
    std::string text(typed);
    if (const char* const home = std::getenv("HOME"); home && text.starts_with("~/"))
        text = home + text.substr(1);
    const fs::path path = (fs::path(folder) / text).lexically_normal();
    std::vector<OpenEntry> found;
    for (OpenEntry& entry : entriesOf(path.parent_path().string()))
        if (lower(entry.name).starts_with(lower(path.filename().string())))
            found.push_back(std::move(entry));
    return found;
}

} // namespace

bool isOpenable(std::string_view name) {
    const std::string ending = lower(fs::path(name).extension().string());
    return ending == ".glb" || ending == ".gltf" || ending == ".hdr" || ending == ".exr" || ending == ".json";
}

std::vector<OpenEntry> openEntries(const std::string& folder, std::string_view filter,
                                   std::span<const std::string> recent) {
    if (filter.find('/') != filter.npos)
        return completions(folder, filter);
    std::vector<OpenEntry> all = everything(folder, recent);
    if (filter.empty())
        return all;
    std::vector<std::pair<int, OpenEntry>> scored;
    for (OpenEntry& entry : all)
        if (const std::optional<int> score = fuzzyScore(filter, entry.name))
            scored.emplace_back(*score, std::move(entry));
    std::ranges::stable_sort(scored, std::ranges::greater(), [](const auto& one) { return one.first; });
    std::vector<OpenEntry> found;
    for (auto& [score, entry] : scored)
        found.push_back(std::move(entry));
    return found;
}

} // namespace glint::view
