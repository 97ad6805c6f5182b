// Lights that paths sample directly: the cells of the environment, and the emissive triangles. Each kind is the leaves
// of a tree of sums, four to a group. The group of the root comes first; depth d has 4^d groups.
#ifndef GLINT_SHARED_LIGHT_TREE_H
#define GLINT_SHARED_LIGHT_TREE_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

// The environment: a cube of square cells; the leaves of a face are in Morton order.
GLINT_CONSTANT(uint, kEnvironmentSideBits, 8u);
GLINT_CONSTANT(uint, kEnvironmentSide, 1u << kEnvironmentSideBits); ///< cells along a face's edge
GLINT_CONSTANT(uint, kEnvironmentLeaves, 6u * kEnvironmentSide * kEnvironmentSide);
GLINT_CONSTANT(uint, kEnvironmentDepth, 9u); ///< of the groups of leaves
GLINT_CONSTANT(uint, kEnvironmentGroups, ((1u << (2u * kEnvironmentDepth)) - 1u) / 3u + kEnvironmentLeaves / 4u);

// Emissive triangles: those of an instance are consecutive leaves. Instances that do not fit are not sampled.
GLINT_CONSTANT(uint, kEmitterDepth, 8u); ///< of the groups of leaves, at most
GLINT_CONSTANT(uint, kEmitterLeaves, 1u << (2u * (kEmitterDepth + 1u)));
GLINT_CONSTANT(uint, kEmitterGroups, (kEmitterLeaves - 1u) / 3u);

// One buffer holds both trees, the environment's first.
GLINT_CONSTANT(uint, kLightTreeGroups, kEnvironmentGroups + kEmitterGroups);
GLINT_CONSTANT(uint, kLightTreeThreads, 256u); ///< of the one workgroup that adds up a tree

/// The tree that rays/light_tree_sums adds up.
struct LightTreeConstants {
    uint firstGroup;
    uint depth; ///< of the groups of leaves
    uint leaves;
    uint isEnvironment;
};

/// Begins the list of emitters, which continues in words: for each instance its first leaf or kNoEmitter, then for each
/// emissive instance its first leaf and its number.
struct EmittersHeader {
    uint leaves;
    uint depth; ///< of the groups of leaves
    uint emitters;
    uint instances;
};

GLINT_CONSTANT(uint, kNoEmitter, 0xffffffffu);

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(glint::shared::kEnvironmentLeaves <= 4u << 2u * glint::shared::kEnvironmentDepth);
#endif
#endif
