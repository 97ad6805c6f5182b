#include "lab/view/recent_files.hpp"

#include "base/file.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace glint::view {
namespace {

namespace fs = std::filesystem;

constexpr size_t kLongestList = 1 << 16; ///< bytes

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

} // namespace

std::string RecentFiles::usualFile() {
    const std::string state = variable("XDG_STATE_HOME"), home = variable("HOME");
    if (fs::path(state).is_absolute()) // relative ones are invalid (XDG Base Directory Specification 0.8)
        return state + "/glint/recent";
    return home.empty() ? std::string() : home + "/.local/state/glint/recent";
}

RecentFiles::RecentFiles(std::string file) : file_(std::move(file)), list_(read()) {}

std::vector<std::string> RecentFiles::read() const {
    std::vector<std::string> names;
    const auto text = file_.empty() ? Result<std::string>(std::string()) : readFile(file_, kLongestList);
    std::string_view rest = text ? std::string_view(*text) : std::string_view();
    while (!rest.empty() && names.size() < kMost) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        if (!line.empty() && std::ranges::find(names, line) == names.end())
            names.emplace_back(line);
    }
    return names;
}

void RecentFiles::add(const std::string& opened) {
    std::error_code error;
    const std::string name = isBuiltin(opened) ? opened : fs::absolute(opened, error).lexically_normal().string();
    if (error || name.empty() || name.find('\n') != name.npos)
        return;
    if (!file_.empty())
        if (std::vector<std::string> now = read(); !now.empty()) // another window may have opened something meanwhile
            list_ = std::move(now);
    std::erase(list_, name);
    list_.insert(list_.begin(), name);
    list_.resize(std::min(list_.size(), kMost));
    if (file_.empty())
        return;
    fs::create_directories(fs::path(file_).parent_path(), error);
    if (!error)
        (void)writeFile(file_, joinText(list_, "\n") + "\n");
}

} // namespace glint::view
