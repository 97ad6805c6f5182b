// The sources of reflections and the order in which they are asked.
#ifndef GLINT_SHARED_HIERARCHY_H
#define GLINT_SHARED_HIERARCHY_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kSourceScreen, 0);
GLINT_CONSTANT(uint, kSourceRays, 1);
GLINT_CONSTANT(uint, kSourcePlanar, 2);
GLINT_CONSTANT(uint, kSourceProbes, 3);
GLINT_CONSTANT(uint, kSourceSky, 4);
GLINT_CONSTANT(uint, kSourceCount, 5);
GLINT_CONSTANT(uint, kMaxSources, 6); // capacity of the table: three weights of ten bits a word

struct HierarchyConstants {
    uint sources;      // bit s: source s takes part
    uint order;        // four bits a source, the first one's lowest
    uint keepsWeights; // 1: hierarchy/combine writes what weight each source got
};

GLINT_SHARED_END

#endif
