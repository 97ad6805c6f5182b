// Why a traced ray ended: exactly one reason a ray, shared by C++ and GLSL. src/reflect/trace/outcomes.hpp has the
// words.
#ifndef GLINT_SHARED_OUTCOME_H
#define GLINT_SHARED_OUTCOME_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kOutcomeNone, 0);         // no ray: background, or the sources before `rays` left nothing
GLINT_CONSTANT(uint, kOutcomeHit, 1);          // met a visible surface
GLINT_CONSTANT(uint, kOutcomeSky, 2);          // ended over the background, as far as it goes
GLINT_CONSTANT(uint, kOutcomeOffScreen, 3);    // left the picture
GLINT_CONSTANT(uint, kOutcomeBehindCamera, 4); // reached the near plane
GLINT_CONSTANT(uint, kOutcomeMaxDistance, 5);  // reached screen.maxDistance in front of everything
GLINT_CONSTANT(uint, kOutcomeOutOfSteps, 6);   // screen.maxSteps were not enough; never a hit
GLINT_CONSTANT(uint, kOutcomeHidden, 7);       // ended behind what the picture shows there
GLINT_CONSTANT(uint, kOutcomeTooThick, 8);     // the same, but a slab of twice the thickness would have been met (hiz
                                               // says hidden where it passed in cells and not in pixels)
GLINT_CONSTANT(uint, kOutcomeBackFace, 9);     // met a surface from its unseen side
GLINT_CONSTANT(uint, kOutcomeSide, 10);        // ran into the slab behind a surface: answered with its front's colour
GLINT_CONSTANT(uint, kOutcomeInferred, 11);    // crossed a surface unseen, behind an occluder: answered with the
                                               // nearest that is seen of it
GLINT_CONSTANT(uint, kOutcomeBelowThreshold, 12); // not traced: reflects too little
GLINT_CONSTANT(uint, kOutcomeTooRough, 13);       // not traced: rougher than reflect.maxRoughness
GLINT_CONSTANT(uint, kOutcomeFacingCamera, 14);   // not traced: fade.facingCamera leaves nothing of it
GLINT_CONSTANT(uint, kOutcomeFromNeighbours, 15); // not traced in this frame: neighbours' rays answer
                                                  // (reuse.rate, rays.interpolate)
GLINT_CONSTANT(uint, kOutcomeCount, 16);

GLINT_CONSTANT(uint, kMaxLookups, 4095); // as a ray record stores them: more reads count as this many

GLINT_CONSTANT(uint, kCountedSquare, 64); // pixels a side that a group of composite/statistics counts

// What composite/statistics.comp fills in: outcomes, then a histogram of lookups a ray; and rays/statistics.comp.
struct RayStatistics {
    uint outcomes[16];
    uint lookups[4096];
    uint scenePixels;    ///< that got rays through the host's triangles
    uint sceneRays[2];   ///< those rays, low word first
    uint fromScreen;     ///< of the pixels: their first hit was the screen's
    uint replaced;       ///< of the pixels: the screen had an answer, which was taken back
    uint reusedLight[2]; ///< hits whose light was the picture's, low word first
};

GLINT_SHARED_END

#endif
