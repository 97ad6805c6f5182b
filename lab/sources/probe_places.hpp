// Probes placed by the user: a JSON file beside the scene (docs/techniques/probes.md lists the keys).
#pragma once

#include "base/result.hpp"
#include "glint/probes.hpp"

#include <string>
#include <vector>

namespace glint::render {

struct ProbePlace {
    Probe probe;           ///< without its cube
    bool fitsProxy = true; ///< the file names no proxy: a proxy is fitted to the geometry that the probe sees
};

/// Errors: NotFound, Io, InvalidInput, with the file, the probe and the key.
Result<std::vector<ProbePlace>> readProbePlaces(const std::string& path);

/// `name` is used in error messages.
Result<std::vector<ProbePlace>> parseProbePlaces(const std::string& text, const std::string& name);

} // namespace glint::render
