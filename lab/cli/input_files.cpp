#include "lab/cli/input_files.hpp"

#include "base/hash.hpp"
#include "base/text.hpp"
#include "lab/job/job_inputs.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/gltf/uri.hpp"
#include "lab/sources/probe_world.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace glint::cli {
namespace {

constexpr size_t kPiece = size_t{1} << 20;        ///< bytes read at a time
constexpr size_t kLongestJson = size_t{1} << 30;  ///< bytes
constexpr size_t kLongestName = 4096;             ///< of a file named in a file
constexpr size_t kGlbHeader = 12, kGlbChunk = 20; ///< bytes: up to the first chunk, and up to its contents

bool isRegularFile(const std::string& name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(name, ignored);
}

Error unreadable(const std::string& file) {
    const int reason = errno;
    return makeError(reason == ENOENT ? ErrorCode::NotFound : ErrorCode::Io, "{}: {}", printable(file),
                     reason == 0 ? "the file cannot be read" : std::strerror(reason));
}

/// Hashes a file of any length, and keeps its JSON: all of a .gltf or .json file, the first chunk of a .glb file.
struct ReadFile {
    Hash hash;
    std::string json;
};

Result<ReadFile> readInput(const std::string& name) {
    errno = 0;
    std::ifstream file(name, std::ios::binary);
    if (!file)
        return unreadable(name);
    ReadFile read;
    const bool glb = name.ends_with(".glb"), text = name.ends_with(".gltf") || name.ends_with(".json");
    std::vector<char> piece(kPiece);
    size_t wanted = text ? kLongestJson : 0, skipped = 0;
    for (bool first = true; file; first = false) {
        file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        const auto count = static_cast<size_t>(file.gcount());
        read.hash.bytes(piece.data(), count);
        if (glb && first && count >= kGlbChunk) {
            uint32_t length = 0;
            std::memcpy(&length, piece.data() + kGlbHeader, sizeof length);
            wanted = length;
            skipped = kGlbChunk;
        }
        if (const size_t from = first ? skipped : 0; read.json.size() < wanted && from < count)
            read.json.append(piece.data() + from, std::min(count - from, wanted - read.json.size()));
    }
    if (file.bad())
        return unreadable(name);
    return read;
}

/// Every text in the JSON that names a file, relative to `folder`: buffers, textures.
void filesNamedIn(const nlohmann::json& json, const std::filesystem::path& folder, std::vector<std::string>& files) {
    if (json.is_structured()) {
        for (const nlohmann::json& inner : json)
            filesNamedIn(inner, folder, files);
    } else if (json.is_string()) {
        const auto& text = json.get_ref<const std::string&>();
        if (text.empty() || text.size() > kLongestName || scene::gltf::isDataUri(text))
            return;
        auto decoded = scene::gltf::decodeRelativeUri(text);
        for (const std::string& name : {text, decoded ? std::move(decoded).value() : text})
            if (std::string file = (folder / name).string(); isRegularFile(file)) {
                files.push_back(std::move(file));
                return;
            }
    }
}

} // namespace

Result<void> InputFiles::add(const std::string& file, Hashes& hashes) {
    const auto found = known_.find(file);
    if (found != known_.end()) {
        hashes.insert(found->second.begin(), found->second.end());
        return {};
    }
    GLINT_TRY(read, readInput(file));
    Hashes own = {{file, fmt::format("{:016x}", read.hash.result())}};
    std::vector<std::string> others;
    const nlohmann::json json = nlohmann::json::parse(read.json, nullptr, false);
    if (!json.is_discarded())
        filesNamedIn(json, std::filesystem::path(file).parent_path(), others);
    for (const std::string& other : others) {
        if (own.contains(other))
            continue;
        GLINT_TRY(bytes, readInput(other));
        own.emplace(other, fmt::format("{:016x}", bytes.hash.result()));
    }
    hashes.insert(own.begin(), own.end());
    known_.emplace(file, std::move(own));
    return {};
}

Result<std::map<std::string, std::string>> InputFiles::of(const std::string& file) {
    Hashes hashes;
    GLINT_CHECK(add(file, hashes));
    return hashes;
}

Result<std::map<std::string, std::string>> InputFiles::of(const render::RenderJob& job) {
    Hashes hashes;
    constexpr std::string_view kBuiltin = "builtin:";
    if (job.scene.starts_with(kBuiltin))
        GLINT_CHECK(scene::checkBuiltinName(std::string_view(job.scene).substr(kBuiltin.size())));
    else
        GLINT_CHECK(add(job.scene, hashes));
    if (!job.environment.empty() && job.environment != "sky" && job.environment != "none")
        GLINT_CHECK(add(job.environment, hashes));
    if (!job.materials.empty() && job.materials != render::kNoMaterials)
        GLINT_CHECK(add(job.materials, hashes));
    if (!job.probes.empty() && job.probes != "auto")
        GLINT_CHECK(add(job.probes, hashes));
    // What is taken where it exists.
    std::vector<std::string> others = {job.camera};
    if (job.materials.empty())
        others.push_back(render::materialFileFor(job.scene));
    if (job.probes == "auto")
        others.push_back(render::probeFileFor(job.scene));
    for (const std::string& file : others)
        if (isRegularFile(file))
            GLINT_CHECK(add(file, hashes));
    return hashes;
}

} // namespace glint::cli
