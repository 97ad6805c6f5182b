#include "lab/tests/image/image_case.hpp"

#include "base/file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace glint::test {
namespace {

using CaseJson = nlohmann::ordered_json;

constexpr size_t kLongestCase = 1 << 16; ///< bytes
constexpr std::string_view kAssets = "assets:";

/// Reads the file's keys one by one; the first invalid key is the error.
class CaseReader {
public:
    CaseReader(const std::string& path, const std::string& assets) : path_(path), assets_(assets) {
        case_.name = std::filesystem::path(path).stem().string();
    }

    Result<ImageCase> read(const CaseJson& json) {
        // GoogleTest's filters interpret '-' and other characters.
        const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
        if (!std::ranges::all_of(case_.name, plain))
            return invalidInput("{}: a case's name has small letters, digits and _ only", path_);
        if (!json.is_object())
            return invalidInput("{}: expected a JSON object", path_);
        for (const char* const needed : {"scene", "size"})
            if (!json.contains(needed))
                return invalidInput("{}: \"{}\" is missing", path_, needed);
        for (const auto& [key, value] : json.items())
            if (!readKey(key, value))
                return invalidInput("{}: \"{}\" is unknown or has a value of another kind: {}", path_, key,
                                    value.dump());
        return std::move(case_);
    }

private:
    bool readKey(const std::string& key, const CaseJson& value) {
        cli::RenderOptions& options = case_.options;
        if (key == "description")
            return value.is_string();
        if (key == "scene")
            return readPlace(value, options.scene);
        if (key == "camera")
            return readPlace(value, options.camera);
        if (key == "environment")
            return readPlace(value, options.environment);
        if (key == "size")
            return readSize(value);
        if (key == "time")
            return readNumber(value, options.time);
        if (key == "frames")
            return value.is_number_unsigned() && (options.frames = value.get<int64_t>(), true);
        if (key == "seed")
            return value.is_number_unsigned() && (value.get_to(options.seed), true);
        if (key == "preset")
            return readText(value, options.settings.preset);
        if (key == "set")
            return readTexts(value, options.settings.assignments);
        if (key == "view")
            return readText(value, options.views.emplace_back());
        if (key == "tolerance")
            return readTolerance(value);
        return false;
    }

    static bool readText(const CaseJson& value, std::string& text) {
        if (value.is_string())
            value.get_to(text);
        return value.is_string();
    }
    static bool readNumber(const CaseJson& value, double& number) {
        if (value.is_number())
            value.get_to(number);
        return value.is_number();
    }
    static bool readTexts(const CaseJson& value, std::vector<std::string>& texts) {
        if (!value.is_array())
            return false;
        for (const CaseJson& text : value)
            if (!readText(text, texts.emplace_back()))
                return false;
        return true;
    }
    bool readPlace(const CaseJson& value, std::string& place) {
        if (!readText(value, place))
            return false;
        if (place.starts_with(kAssets)) {
            place = assets_ + "/" + place.substr(kAssets.size());
            case_.needsAssets = true;
        }
        return true;
    }
    bool readSize(const CaseJson& value) {
        if (!value.is_array() || value.size() != 2 || !value[0].is_number_unsigned() || !value[1].is_number_unsigned())
            return false;
        case_.options.size = fmt::format("{}x{}", value[0].get<uint64_t>(), value[1].get<uint64_t>());
        return true;
    }
    bool readTolerance(const CaseJson& value) {
        if (!value.is_object())
            return false;
        for (const auto& [key, number] : value.items()) {
            double* const target = key == "maxAbsDiff"        ? &case_.tolerance.maxAbsDiff
                                   : key == "failingFraction" ? &case_.tolerance.failingFraction
                                   : key == "meanFlip"        ? &case_.tolerance.meanFlip
                                                              : nullptr;
            if (target == nullptr || !readNumber(number, *target))
                return false;
        }
        return true;
    }

    const std::string& path_;
    const std::string& assets_;
    ImageCase case_;
};

} // namespace

Result<ImageCase> readImageCase(const std::string& path, const std::string& assets) {
    GLINT_TRY(text, readFile(path, kLongestCase));
    const CaseJson json = CaseJson::parse(text, nullptr, false);
    if (json.is_discarded())
        return invalidInput("{}: not JSON", path);
    return CaseReader(path, assets).read(json);
}

std::string commandOf(const ImageCase& imageCase) {
    const cli::RenderOptions& options = imageCase.options;
    std::string command = fmt::format("scripts/glint render '{}' --size {}", options.scene, options.size);
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty())
            command += fmt::format(" {} '{}'", option, value);
    };
    add("--camera", options.camera);
    add("--env", options.environment);
    add("--preset", options.settings.preset);
    for (const std::string& assignment : options.settings.assignments)
        add("--set", assignment);
    for (const std::string& view : options.views)
        add("--view", view);
    if (options.time != 0)
        command += fmt::format(" --time {}", options.time);
    if (options.frames)
        command += fmt::format(" --frames {}", *options.frames);
    if (options.seed != 0)
        command += fmt::format(" --seed {}", options.seed);
    return command + fmt::format(" -o {}.png", imageCase.name);
}

} // namespace glint::test
