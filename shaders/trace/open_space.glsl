// Open space on a ray's way: while a ray is clearly in front of all that a cell of the depth pyramid shows, no sample there
// can meet anything, and marchers of equal steps need not take it. What they find stays the same to the last bit.
#ifndef GLINT_TRACE_OPEN_SPACE_GLSL
#define GLINT_TRACE_OPEN_SPACE_GLSL

#include "trace/cells.glsl"
#include "trace/hit_test.glsl"

/// Cells of 8 to 64 samples a side, at most 64 pixels. A cell takes as long as some samples.
const int kFinestOpen = 3;
const int kCoarsestOpen = int(kPyramidTileLevel);
/// After a failure so many cells of that size are passed sample by sample; twice as many after each further failure.
const float kMostWaits = 8.0;
/// So many cells are tried together, before the rays of a group take samples.
const int kOpenTogether = 8;
/// In front by this part of the ray's nearness, a sample is not even tested for what comes before its pixel ends.
const float kClearlyInFront = 1.1 * kNearlyBehind;

/// What a march knows of the space before it.
struct OpenSpace {
    Line line;
    float start; // the ray's nearness
    float slope; // and its growth over the whole line
    int level;   // of the cell to be tried next
    float from;  // share from which on it is worth trying
    float waits; // cells to pass after the next failure
    int finest;
    int coarsest;
};

OpenSpace openSpace(ScreenRay ray) {
    float longer = max(frame.constants.size.x, frame.constants.size.y);
    int levels = max(findMSB(uint(longer) - 1u) + 1, 1); // of the pyramid
    OpenSpace space;
    space.line = makeLine(ray);
    space.start = rayNearness(frame.constants, ray, 0.0);
    space.slope = rayNearness(frame.constants, ray, 1.0) - space.start;
    space.coarsest = min(kCoarsestOpen, levels);
    space.finest = min(kFinestOpen + findMSB(settings.step), space.coarsest);
    space.level = space.finest;
    space.from = 0.0;
    space.waits = 1.0;
    return space;
}

/// Share up to which a ray at `share`, which is on screen, is clearly in front; `share` itself where that is not known.
/// `ahead`: as a share, how far beyond a sample its test looks. `lookups` grows by the cells that were read.
float openUntil(ScreenRay ray, inout OpenSpace space, float share, float ahead, inout uint lookups) {
    float inside = 0.01 * space.line.pixelShare; // from a cell's border, for rounding
    float until = share;
    for (int i = 0; i < kOpenTogether && share < ray.screenEnd; ++i) {
        ivec2 cell = floorToInt(ray.startPX + ray.deltaPX * share) >> space.level;
        bool overX;
        float leave = leaveCell(space.line, vec2(cell << space.level), float(1 << space.level), overX);
        CellBounds bounds = loadCell(cell, space.level);
        ++lookups;
        bool open = true;
        if (bounds.front > kEmptyCell) {
            vec2 center = (vec2(cell) + 0.5) * float(1 << space.level);
            float above = space.start - bounds.front - dot(bounds.slope, space.line.startPX - center);
            float climb = space.slope - dot(bounds.slope, space.line.deltaPX);
            float end = min(leave, ray.screenEnd) + ahead;
            float nearest = max(abs(space.start + space.slope * share), abs(space.start + space.slope * end));
            // A sample's depth is that of its pixel's centre.
            float off = 0.5 * (abs(bounds.slope.x) + abs(bounds.slope.y));
            open = min(above + climb * share, above + climb * end) > kClearlyInFront * nearest + off;
            logCell(ray, share, cell, space.level, space.start + space.slope * share - (above + climb * share),
                    bounds.slab, open ? kSampleFront : kSampleLookInto);
        } else {
            logCell(ray, share, cell, space.level, 0.0, 0.0, kSampleEmpty);
        }
        if (open) {
            until = min(leave, ray.screenEnd) - inside;
            share = leave + inside;
            space.level = min(space.level + 1, space.coarsest);
            space.waits = 1.0;
        } else if (space.level > space.finest) {
            --space.level;
        } else {
            space.from = leave + (space.waits - 1.0) * float(1 << space.level) * space.line.pixelShare;
            space.waits = min(2.0 * space.waits, kMostWaits);
            break;
        }
    }
    return until;
}

#endif
