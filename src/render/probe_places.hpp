// Probes that a person placed: a JSON file beside the scene (docs/techniques/probes.md has the keys).
#pragma once

#include "base/result.hpp"
#include "glint/probes.hpp"

#include <string>
#include <vector>

namespace glint::render {

struct ProbePlace {
    Probe probe;           ///< all but its cube
    bool fitsProxy = true; ///< the file names no proxy: one is fitted to what the probe sees
};

/// Errors name the file, the probe and the key: NotFound, Io, InvalidInput.
Result<std::vector<ProbePlace>> readProbePlaces(const std::string& path);

/// `name` stands in errors.
Result<std::vector<ProbePlace>> parseProbePlaces(const std::string& text, const std::string& name);

} // namespace glint::render
