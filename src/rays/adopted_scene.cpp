#include "rays/adopted_scene.hpp"

#include "base/result.hpp"
#include "rays/instance.hpp"
#include "rays/mesh.hpp"

namespace glint::rays {
namespace {

Result<void> check(const HostAccelerationStructure& host) {
    if (!host.topLevel)
        return invalidArgument("the host's top-level acceleration structure is null");
    if (host.instanceCount > kMostInstances)
        return invalidArgument("the host's acceleration structure has {} instances, at most {} can be had",
                               host.instanceCount, kMostInstances);
    if (!host.triangleCounts.empty() && host.triangleCounts.size() != host.instanceCount)
        return invalidArgument("the host's acceleration structure has {} instances, but triangle counts of {}",
                               host.instanceCount, host.triangleCounts.size());
    for (size_t axis = 0; axis < 3; ++axis) {
        const float low = host.transparentLowWS[axis];
        const float high = host.transparentHighWS[axis];
        if (!(low >= -kFarthest && low <= high && high <= kFarthest)) // true for NaN
            return invalidArgument("the box of what transmits light reaches from {} to {} on axis {}", low, high, axis);
    }
    return {};
}

} // namespace

Result<AdoptedScene> AdoptedScene::create(const HostAccelerationStructure& host) {
    AdoptedScene scene;
    scene.numbering_ = host.numbering;
    GLINT_CHECK(scene.replace(host));
    return scene;
}

Result<void> AdoptedScene::replace(const HostAccelerationStructure& host) {
    GLINT_CHECK(check(host));
    if (host.numbering != numbering_)
        return invalidArgument("the scene was adopted with another numbering of its instances; adopt another scene");
    topLevel_ = host.topLevel;
    instanceCount_ = host.instanceCount;
    triangleCounts_.assign(host.triangleCounts.begin(), host.triangleCounts.end());
    transparentBounds_ = {};
    transparentBounds_.add({host.transparentLowWS[0], host.transparentLowWS[1], host.transparentLowWS[2]});
    transparentBounds_.add({host.transparentHighWS[0], host.transparentHighWS[1], host.transparentHighWS[2]});
    return {};
}

} // namespace glint::rays
