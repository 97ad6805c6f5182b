#include "lab/cli/sweep/sweep_folder.hpp"

#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "lab/scene/images/image_file.hpp"

#include <array>
#include <cstring>
#include <filesystem>

namespace glint::cli {
namespace {

constexpr const char* kListFormat = "glint sweep 1";
constexpr const char* kResultFormat = "glint sweep result 1";
constexpr const char* kFailureFormat = "glint sweep failure 1";
constexpr size_t kLongestList = size_t{1} << 30;   ///< bytes
constexpr size_t kLongestResult = size_t{1} << 24; ///< bytes
constexpr size_t kLongestMessage = 2000;           ///< characters
constexpr std::string_view kJsonEnd = ".json";

std::string listFile(const std::string& folder) {
    return folder + "/sweep.json";
}
std::string resultFile(const std::string& folder, const std::string& job) {
    return fmt::format("{}/jobs/{}.json", folder, job);
}
std::string failureFile(const std::string& folder, const std::string& job) {
    return fmt::format("{}/failed/{}.json", folder, job);
}
std::string referenceFile(const std::string& folder, const std::string& name) {
    return fmt::format("{}/references/{}.reference", folder, name);
}

std::string lines(const SweepJson& json) {
    return json.dump(1, ' ', false, SweepJson::error_handler_t::replace) + "\n";
}

bool isText(const SweepJson& json, const char* key) {
    return json.contains(key) && json[key].is_string();
}

/// A description as SweepJob::description has it.
bool isDescription(const SweepJson& json) {
    for (const char* key : {"name", "kind", "scene", "size", "config"})
        if (!json.is_object() || !isText(json, key))
            return false;
    return json.contains("seed") && json["seed"].is_number_unsigned();
}

bool isSide(const SweepJson& json) {
    return json.is_number_unsigned() && json.get<uint64_t>() >= 1 && json.get<uint64_t>() <= scene::kMaxImageSide;
}

bool areNumbers(const SweepJson& json) {
    if (!json.is_object())
        return false;
    for (const auto& [name, value] : json.items())
        if (!value.is_number())
            return false;
    return true;
}

// A reference picture: the header, then for each pixel three bytes as displayed, then for each pixel five floats
// (radiance, roughness, reflectivity), then a hash of all of it. Numbers have the byte order of the machine.
constexpr std::array<char, 8> kReferenceMagic = {'G', 'L', 'I', 'N', 'T', 'R', 'F', '1'};
constexpr size_t kReferenceHeader = kReferenceMagic.size() + 2 * sizeof(uint32_t);
constexpr size_t kFloats = 5;

size_t referenceBytes(uint32_t width, uint32_t height) {
    return kReferenceHeader + size_t{width} * height * (3 + kFloats * sizeof(float)) + sizeof(uint64_t);
}

void append(std::string& bytes, const void* data, size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

} // namespace

Result<void> SweepFolder::create() const {
    for (const char* inner : {"/jobs", "/failed", "/references"}) {
        std::error_code error;
        std::filesystem::create_directories(path_ + inner, error);
        if (error)
            return makeError(ErrorCode::Io, "--out {}: {}", printable(path_), error.message());
    }
    return {};
}

Result<void> SweepFolder::writeList(const std::string& program, const std::string& plan,
                                    std::span<const SweepJob> jobs) const {
    // A line a job: ten thousand jobs are a few megabytes, which every process of the sweep reads.
    std::string text =
        fmt::format("{{\"format\": {},\n\"program\": {},\n\"plan\": {},\n\"jobs\": [", // as JSON
                    SweepJson(kListFormat).dump(), SweepJson(program).dump(), SweepJson(printable(plan)).dump());
    for (const SweepJob& job : jobs)
        text += fmt::format("{}\n{}", &job == &jobs.front() ? "" : ",",
                            job.description.dump(-1, ' ', false, SweepJson::error_handler_t::replace));
    text += "\n]}\n";
    const auto before = readFile(listFile(path_), kLongestList);
    if (before && *before == text)
        return {};
    return writeFile(listFile(path_), text);
}

Result<SweepList> SweepFolder::readList() const {
    auto text = readFile(listFile(path_), kLongestList);
    if (!text)
        return makeError(text.error().code, "{}; give the folder of --out, where a sweep was run",
                         text.error().message);
    const SweepJson json = SweepJson::parse(*text, nullptr, false);
    const Error damaged = invalidInput("{}: this is no list of a sweep's jobs; run the sweep again, which writes it",
                                       printable(listFile(path_)));
    if (json.is_discarded() || !json.is_object() || !isText(json, "format") || json["format"] != kListFormat ||
        !isText(json, "program") || !isText(json, "plan") || !json.contains("jobs") || !json["jobs"].is_array())
        return damaged;
    SweepList list = {json["program"].get<std::string>(), json["plan"].get<std::string>(), {}};
    for (const SweepJson& job : json["jobs"]) {
        if (!isDescription(job))
            return damaged;
        list.jobs.push_back(job);
    }
    return list;
}

Result<void> SweepFolder::writeResult(const SweepResult& result) const {
    const SweepJson json = {
        {"format", kResultFormat},   {"job", result.description},
        {"program", result.program}, {"device", {{"name", result.device}, {"driver", result.driver}}},
        {"width", result.width},     {"height", result.height},
        {"figures", result.figures}, {"notes", result.notes},
        {"run", result.run}};
    return writeFile(resultFile(path_, result.description["name"].get<std::string>()), lines(json));
}

std::optional<SweepResult> SweepFolder::readResult(const SweepJson& description) const {
    const auto text = readFile(resultFile(path_, description["name"].get<std::string>()), kLongestResult);
    if (!text)
        return std::nullopt;
    const SweepJson json = SweepJson::parse(*text, nullptr, false);
    if (json.is_discarded() || !json.is_object() || !isText(json, "format") || json["format"] != kResultFormat ||
        !json.contains("job") || json["job"] != description || !isText(json, "program"))
        return std::nullopt;
    for (const char* key : {"device", "width", "height", "figures", "notes", "run"})
        if (!json.contains(key))
            return std::nullopt;
    if (!isText(json["device"], "name") || !isText(json["device"], "driver") || !isSide(json["width"]) ||
        !isSide(json["height"]) || !areNumbers(json["figures"]) || !json["notes"].is_array() ||
        !json["run"].is_object())
        return std::nullopt;
    SweepResult result;
    result.description = description;
    result.program = json["program"].get<std::string>();
    result.device = json["device"]["name"].get<std::string>();
    result.driver = json["device"]["driver"].get<std::string>();
    result.width = json["width"].get<uint32_t>();
    result.height = json["height"].get<uint32_t>();
    result.figures = json["figures"];
    for (const SweepJson& note : json["notes"])
        if (note.is_string())
            result.notes.push_back(note.get<std::string>());
    result.run = json["run"];
    return result;
}

Result<void> SweepFolder::writeFailure(const std::string& job, const std::string& message) const {
    return writeFile(
        failureFile(path_, job),
        lines({{"format", kFailureFormat}, {"job", job}, {"message", printable(message, kLongestMessage)}}));
}

void SweepFolder::removeFailure(const std::string& job) const {
    std::error_code ignored; // another process may have removed it
    std::filesystem::remove(failureFile(path_, job), ignored);
}

std::set<std::string> SweepFolder::failures() const {
    std::set<std::string> jobs;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(path_ + "/failed", error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.ends_with(kJsonEnd))
            jobs.insert(name.substr(0, name.size() - kJsonEnd.size()));
    }
    return jobs;
}

std::string SweepFolder::readFailure(const std::string& job) const {
    const auto text = readFile(failureFile(path_, job), kLongestResult);
    const SweepJson json = text ? SweepJson::parse(*text, nullptr, false) : SweepJson();
    return json.is_object() && isText(json, "message") ? json["message"].get<std::string>() : std::string();
}

Result<void> SweepFolder::writeReference(const std::string& name, const measure::ReferenceImages& images,
                                         uint32_t width, uint32_t height) const {
    std::string bytes;
    bytes.reserve(referenceBytes(width, height));
    append(bytes, kReferenceMagic.data(), kReferenceMagic.size());
    append(bytes, &width, sizeof width);
    append(bytes, &height, sizeof height);
    append(bytes, images.displayed.data(), images.displayed.size());
    for (size_t i = 0; i < images.radiance.size(); i += 4) {
        append(bytes, &images.radiance[i], 3 * sizeof(float));
        append(bytes, &images.roughness[i], sizeof(float));
        append(bytes, &images.reflectivity[i], sizeof(float));
    }
    const uint64_t hash = Hash().text(bytes).result();
    append(bytes, &hash, sizeof hash);
    return writeFile(referenceFile(path_, name), bytes);
}

std::optional<measure::ReferenceImages> SweepFolder::readReference(const std::string& name, uint32_t width,
                                                                   uint32_t height) const {
    const auto read = readFile(referenceFile(path_, name), referenceBytes(width, height));
    if (!read || read->size() != referenceBytes(width, height))
        return std::nullopt;
    const std::string_view bytes = *read;
    std::array<uint32_t, 2> size = {};
    uint64_t hash = 0;
    std::memcpy(size.data(), &bytes[kReferenceMagic.size()], sizeof size);
    std::memcpy(&hash, &bytes[bytes.size() - sizeof hash], sizeof hash);
    if (std::memcmp(bytes.data(), kReferenceMagic.data(), kReferenceMagic.size()) != 0 || size[0] != width ||
        size[1] != height || hash != Hash().text(bytes.substr(0, bytes.size() - sizeof hash)).result())
        return std::nullopt;
    const size_t pixels = size_t{width} * height;
    measure::ReferenceImages images;
    images.displayed.resize(3 * pixels);
    images.radiance.resize(4 * pixels);
    images.roughness.resize(4 * pixels);
    images.reflectivity.resize(4 * pixels);
    const char* at = &bytes[kReferenceHeader];
    std::memcpy(images.displayed.data(), at, images.displayed.size());
    at += images.displayed.size();
    for (size_t i = 0; i < 4 * pixels; i += 4, at += kFloats * sizeof(float)) {
        std::memcpy(&images.radiance[i], at, 3 * sizeof(float));
        std::memcpy(&images.roughness[i], at + 3 * sizeof(float), sizeof(float));
        std::memcpy(&images.reflectivity[i], at + 4 * sizeof(float), sizeof(float));
    }
    return images;
}

bool SweepFolder::hasReference(const std::string& name) const {
    std::error_code ignored;
    return std::filesystem::exists(referenceFile(path_, name), ignored);
}

} // namespace glint::cli
