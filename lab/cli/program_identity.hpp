// Which build of the program this is: results of another build may differ.
#pragma once

#include <string>

namespace glint::cli {

/// "glint 0.1.0, build 3f2a...": the version, and the identity that the linker gave this program's code and data.
/// Without the latter, the version alone.
std::string programIdentity();

} // namespace glint::cli
