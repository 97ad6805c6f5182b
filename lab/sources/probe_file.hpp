// Baked probes as a file: volumes and GGX-filtered cubes, with hashes of what they were baked from, so that a file that
// does not fit a scene is rejected.
#pragma once

#include "base/result.hpp"
#include "glint/probes.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::render {

struct BakedProbe {
    Probe probe;            ///< without its cube
    uint32_t faceSize = 16; ///< texels, a power of two, [16, 1024]
    /// RGBA half floats, alpha = 1 / metres: mip after mip down to 8 texels, six faces each, rows from the top.
    std::vector<uint64_t> texels;
};

struct ProbeSet {
    std::string scene;      ///< the scene as the user named it, for messages
    uint64_t sceneHash = 0; ///< lab/sources/scene_hash.hpp
    uint64_t lightHash = 0;
    std::vector<BakedProbe> probes;
};

constexpr uint32_t kProbeFileVersion = 2;
constexpr size_t kMostProbeFileBytes = size_t{1} << 31;

/// Returns the number of texels in all mips and faces.
size_t probeTexels(uint32_t faceSize);

std::string encodeProbes(const ProbeSet& set);

/// `name` is used in error messages. Errors: InvalidInput with the reason: not a probe file, truncated, damaged, or
/// written by a newer Glint.
Result<ProbeSet> decodeProbes(std::string_view bytes, std::string_view name);

/// Errors: as decodeProbes; NotFound, Io.
Result<ProbeSet> readProbes(const std::string& path);

/// Errors: InvalidInput if the set was not baked from this scene in this light.
Result<void> checkProbesFit(const ProbeSet& set, uint64_t sceneHash, uint64_t lightHash, const std::string& scene,
                            std::string_view name);

} // namespace glint::render
