// The layout, little-endian. Header: "GLINTPRB", uint32 version, uint32 probes, uint64 scene hash, uint64 light hash,
// uint64 bytes of the body, uint64 hash of the body. Body: the scene's name (uint32 length, bytes), then each probe:
// its numbers in the order of `visitNumbers`, uint32 face size, texels.
#include "lab/sources/probe_file.hpp"

#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "gpu/cube_prefilter.hpp"

#include <bit>
#include <cmath>
#include <cstring>

namespace glint::render {
namespace {

static_assert(std::endian::native == std::endian::little, "probe files are written as memory has them");

constexpr std::string_view kMagic = "GLINTPRB";
constexpr size_t kHeaderBytes = 48;
constexpr uint32_t kLongestName = 4096;
constexpr uint32_t kSmallestFace = 16, kLargestFace = 1024;

/// Every number of a probe, in the file's order; enums as uint32.
template <class P, class Visit>
void visitNumbers(P& probe, Visit visit) {
    visit(probe.capturePositionWS);
    visit(probe.strength);
    visit(probe.weight);
    visit(probe.shape);
    visit(probe.influence.centerWS);
    visit(probe.influence.rotation);
    visit(probe.influence.halfExtents);
    visit(probe.blendDistance);
    visit(probe.blendNormalDistance);
    visit(probe.faceFade);
    visit(probe.proxy);
    visit(probe.proxyVolume.centerWS);
    visit(probe.proxyVolume.rotation);
    visit(probe.proxyVolume.halfExtents);
    visit(probe.alphaIsInverseDistance);
}

class Writer {
public:
    template <class T>
    void put(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    void put(std::string_view text) { bytes_.append(text); }
    void operator()(const ProbeShape& shape) { put(static_cast<uint32_t>(shape)); }
    void operator()(bool flag) { put(static_cast<uint32_t>(flag)); }
    void operator()(const ProbeProxy& proxy) { put(static_cast<uint32_t>(proxy)); }
    template <class T>
    void operator()(const T& number) {
        put(number);
    }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Never reads beyond the end; after a failed read every value is 0 and `ok` stays false.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}
    bool ok() const { return ok_; }
    size_t left() const { return bytes_.size(); }

    std::string_view take(size_t size) {
        if (size > bytes_.size()) {
            ok_ = false;
            bytes_ = {};
            return {};
        }
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }
    template <class T>
    T get() {
        T value = {};
        if (const std::string_view raw = take(sizeof(T)); raw.size() == sizeof(T))
            std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }
    void operator()(ProbeShape& shape) { shape = limited<ProbeShape>(1); }
    void operator()(bool& flag) { flag = limited<uint32_t>(1) != 0; }
    void operator()(ProbeProxy& proxy) { proxy = limited<ProbeProxy>(2); }
    void operator()(float& number) {
        number = get<float>();
        ok_ = ok_ && std::isfinite(number);
    }
    template <size_t N>
    void operator()(std::array<float, N>& numbers) {
        for (float& number : numbers)
            (*this)(number);
    }

private:
    template <class E>
    E limited(uint32_t most) {
        const auto value = get<uint32_t>();
        ok_ = ok_ && value <= most;
        return static_cast<E>(ok_ ? value : 0);
    }
    std::string_view bytes_;
    bool ok_ = true;
};

uint64_t hashOf(std::string_view bytes) {
    return Hash().text(bytes).result();
}

Result<BakedProbe> readProbe(Reader& reader, size_t number, std::string_view name) {
    BakedProbe baked;
    visitNumbers(baked.probe, [&](auto& value) { reader(value); });
    baked.faceSize = reader.get<uint32_t>();
    const bool sized =
        baked.faceSize >= kSmallestFace && baked.faceSize <= kLargestFace && std::has_single_bit(baked.faceSize);
    if (!reader.ok() || !sized)
        return invalidInput("{}: probe {} is damaged: bake it anew", name, number);
    const size_t bytes = probeTexels(baked.faceSize) * sizeof(uint64_t); // at most 67 MB
    const std::string_view raw = reader.take(bytes);
    if (!reader.ok())
        return invalidInput("{}: probe {} has {} texels a face, but the file ends before them: bake it anew", name,
                            number, baked.faceSize);
    baked.texels.resize(bytes / sizeof(uint64_t));
    std::memcpy(baked.texels.data(), raw.data(), bytes);
    return baked;
}

} // namespace

size_t probeTexels(uint32_t faceSize) {
    size_t texels = 0;
    for (uint32_t face = faceSize; face >= gpu::kLastFilteredFace; face /= 2)
        texels += size_t{6} * face * face;
    return texels;
}

std::string encodeProbes(const ProbeSet& set) {
    Writer body;
    const std::string name = set.scene.substr(0, kLongestName);
    body.put(static_cast<uint32_t>(name.size()));
    body.put(std::string_view(name));
    for (const BakedProbe& baked : set.probes) {
        visitNumbers(baked.probe, [&](const auto& value) { body(value); });
        body.put(baked.faceSize);
        body.put(std::string_view(reinterpret_cast<const char*>(baked.texels.data()),
                                  baked.texels.size() * sizeof(uint64_t)));
    }
    const std::string content = body.take();
    Writer file;
    file.put(kMagic);
    file.put(kProbeFileVersion);
    file.put(static_cast<uint32_t>(set.probes.size()));
    file.put(set.sceneHash);
    file.put(set.lightHash);
    file.put(uint64_t{content.size()});
    file.put(hashOf(content));
    file.put(std::string_view(content));
    return file.take();
}

Result<ProbeSet> decodeProbes(std::string_view bytes, std::string_view name) {
    if (!bytes.starts_with(kMagic))
        return invalidInput("{}: not a file of probes (glint bake writes one)", name);
    Reader header(bytes.substr(kMagic.size()));
    const auto version = header.get<uint32_t>();
    if (header.ok() && version != kProbeFileVersion)
        return invalidInput("{}: probes of format version {}, this Glint reads version {}: bake it anew", name, version,
                            kProbeFileVersion);
    const auto count = header.get<uint32_t>();
    ProbeSet set;
    set.sceneHash = header.get<uint64_t>();
    set.lightHash = header.get<uint64_t>();
    const auto bodyBytes = header.get<uint64_t>();
    const auto bodyHash = header.get<uint64_t>();
    if (!header.ok())
        return invalidInput("{}: the file ends after {} bytes, within its header of {}: bake it anew", name,
                            bytes.size(), kHeaderBytes);
    const std::string_view content = bytes.substr(kHeaderBytes);
    if (content.size() != bodyBytes)
        return invalidInput("{}: the file has {} bytes of probes, its header says {}: bake it anew", name,
                            content.size(), bodyBytes);
    if (hashOf(content) != bodyHash)
        return invalidInput("{}: its content is damaged (the checksum differs): bake it anew", name);
    if (count > kMaxProbes)
        return invalidInput("{}: {} probes, at most {} can be", name, count, kMaxProbes);
    Reader body(content);
    const auto nameBytes = body.get<uint32_t>();
    if (nameBytes <= kLongestName)
        set.scene = body.take(nameBytes);
    if (!body.ok() || nameBytes > kLongestName)
        return invalidInput("{}: the name of its scene is damaged: bake it anew", name);
    for (uint32_t i = 0; i < count; ++i) {
        GLINT_TRY(baked, readProbe(body, i, name));
        set.probes.push_back(std::move(baked));
    }
    if (body.left() > 0)
        return invalidInput("{}: {} bytes follow its last probe: bake it anew", name, body.left());
    return set;
}

Result<ProbeSet> readProbes(const std::string& path) {
    GLINT_TRY(bytes, readFile(path, kMostProbeFileBytes));
    return decodeProbes(bytes, printable(path));
}

Result<void> checkProbesFit(const ProbeSet& set, uint64_t sceneHash, uint64_t lightHash, const std::string& scene,
                            std::string_view name) {
    if (set.sceneHash != sceneHash)
        return invalidInput("{}: baked from {}, which is another scene than {} or has changed since: bake it anew "
                            "(glint bake)",
                            name, printable(set.scene), printable(scene));
    if (set.lightHash != lightHash)
        return invalidInput("{}: baked in another light (--env, or settings of environment, lights, shadows or sky): "
                            "bake it anew (glint bake)",
                            name);
    return {};
}

} // namespace glint::render
