// Compares a frame with a plane of which the host knows where it lies: what normals cannot show, distances and places.
#pragma once

#include "glint/input_check.hpp"
#include "reflect/check/host_evidence.hpp"

namespace glint::reflect {

/// `reading`: the one that normals agree with best. Finds nothing if a tenth of the samples lies on the plane and has
/// its normal, as declared.
check::Finding findPlaneElsewhere(const HostEvidence& evidence, size_t reading, const KnownPlane& plane,
                                  const Conventions& declared);

} // namespace glint::reflect
