#include "lab/cli/machine_info.hpp"

#include <sys/utsname.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <thread>

namespace glint::cli {
namespace {

/// The value of the first line of a file that begins with `key`, without spaces and quotes around it.
std::string valueIn(const char* file, const std::string& key, char separator) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        const size_t at = line.find(separator);
        if (!line.starts_with(key) || at == line.npos)
            continue;
        const size_t first = line.find_first_not_of(" \t\"", at + 1), last = line.find_last_not_of(" \t\"");
        return first == line.npos ? std::string() : line.substr(first, last - first + 1);
    }
    return {};
}

std::string systemText() {
    std::string text = valueIn("/etc/os-release", "PRETTY_NAME", '=');
    utsname names = {};
    if (uname(&names) == 0)
        text += (text.empty() ? "" : ", ") + std::string(names.sysname) + " " + names.release + " " + names.machine;
    return text;
}

} // namespace

nlohmann::ordered_json machineJson() {
    return {{"system", systemText()},
            {"processor", valueIn("/proc/cpuinfo", "model name", ':')},
            {"threads", std::thread::hardware_concurrency()}};
}

} // namespace glint::cli
