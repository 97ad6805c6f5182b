// The `hiz` marcher: walks cell by cell through the depth pyramid. The ray leaves a cell at once if it passes in front
// of or behind the cell's surfaces. A cell that shows a single flat surface gives the pixel of the hit itself. In any
// other cell the ray descends a level. Walking and testing pixels are loops of their own, so that the rays of a group
// test together: a ray that has come to a pixel waits for the others, but not for long. docs/techniques/hiz.md
#include "trace/cells.glsl"
#include "trace/hit_test.glsl"

/// The level at which a ray starts: most rays leave a surface that is flat over this many pixels.
const int kFirstLevel = 4;
/// So many cells are walked before those rays of the group that have come to a pixel test it. measured: NVIDIA H200,
/// builtin:hall at 1920x1080, mirror directions: 1.46 ms; 1.51 with 3, 1.78 if they wait for all. No difference on
/// llvmpipe, whose groups have eight rays.
const int kCellsTogether = 10;
/// Rounding of the cell's and of the ray's nearness, as a fraction of it.
const float kRounding = 2e-6;
/// A flat cell gives the hit itself if it places the hit this exactly, in pixels along the ray.
const float kFlatEnough = 0.75;

/// The pixel behind the border across which the ray leaves a cell.
ivec2 enterNext(Line line, ivec2 cell, int level, float share, bool overX) {
    ivec2 low = cell << level;
    ivec2 high = ((cell + 1) << level) - 1;
    ivec2 px = clamp(floorToInt(line.startPX + line.deltaPX * share), low, high);
    if (overX)
        px.x = line.deltaPX.x > 0.0 ? high.x + 1 : low.x - 1;
    else
        px.y = line.deltaPX.y > 0.0 ? high.y + 1 : low.y - 1;
    return px;
}

/// A ray's way through a cell or a part of it, from `share` to `end` of its line, and its height over the cell's plane
/// as a function of the share: nearness, `above` + `climb` * share.
struct Way {
    float share;
    float end;
    float above;
    float climb;
};

/// Where the march continues inside a cell that it descends into.
struct Quarter {
    bool found; // false: the ray passes all quarters
    float share;
    int which; // as for quarterSolid
};

/// Does the ray hit something in quarter `which`, on its way there?
Quarter enterQuarter(Line line, CellBounds cell, int which, Way way, float rounding) {
    vec2 solid = quarterSolid(cell, which);
    float first = way.above + way.climb * way.share;
    float last = way.above + way.climb * way.end;
    bool inFront = min(first, last) >= -solid.x - rounding;
    // Starts a pixel earlier, as tests of single pixels do.
    bool behind = max(way.above + way.climb * max(way.share - line.pixelShare, 0.0), last) < -solid.y;
    bool isSolid = solid.x <= solid.y;
    if (behind && isSolid)
        passBehind(way.share);
    // The ray hits nothing before it reaches the solid part.
    float to = way.share;
    if (first > -solid.x)
        to = clamp((-solid.x - way.above) / way.climb, way.share, way.end);
    else if (first < -solid.y)
        to = clamp((-solid.y - way.above) / way.climb - line.pixelShare, way.share, way.end);
    return Quarter(isSolid && !inFront && !behind, to, which);
}

/// The first quarter of the cell at `at` that the ray may hit on its way from pixel `px`.
Quarter firstQuarter(Line line, CellBounds cell, ivec2 at, int level, ivec2 px, Way way, float rounding) {
    // A line crosses at most three quarters: it goes over the cell's middle in x and in y, unless it starts behind it.
    ivec2 quarter = (px >> (level - 1)) & 1;
    vec2 middle = vec2((2 * at + 1) << (level - 1));
    vec2 crossing = max((middle - line.startPX) * line.invDelta, way.share);
    crossing = mix(vec2(1e30), crossing, notEqual(vec2(quarter), line.forward));
    crossing = mix(crossing, vec2(1e30), greaterThan(abs(line.invDelta), vec2(1e29)));
    float first = min(crossing.x, crossing.y);
    float second = max(crossing.x, crossing.y);
    int which = quarter.x + 2 * quarter.y;
    int last = which ^ 3;
    int next = which ^ (crossing.x < crossing.y ? 1 : 2);
    float from = way.share;
    float to = first;
    while (true) {
        Quarter found = enterQuarter(line, cell, which, Way(from, min(to, way.end), way.above, way.climb), rounding);
        if (found.found || to >= way.end || which == last)
            return found;
        from = to;
        to = which == next ? way.end : second;
        which = which == next ? last : next;
    }
}

const uint kWalkEnded = 0u; // the march has
const uint kWalkGoesOn = 1u; // no pixel yet
const uint kAtPixel = 2u;    // a pixel decides whether the ray ends there
const uint kAtFlatCell = 3u; // the same: a cell of several pixels shows one flat surface, which the ray meets at this one

/// What a walk came to.
struct Candidate {
    uint found; // one of the four above
    ivec2 px;
    float at; // share
};

/// What a march knows on its way.
struct CellWalk {
    ivec2 px;
    int level;
    float share;      // the ray is here
    ivec2 cell;       // the cell of `level` that it is in,
    float leave;      // where it leaves that cell,
    float last;       // and how far it goes there at most
    bool leavesOverX; // and across which border
    bool mayBeFlat;   // false: the flat cell's pixel was tested already
};

void enterCell(Line line, float endShare, inout CellWalk walk) {
    walk.cell = walk.px >> walk.level;
    walk.leave =
        leaveCell(line, vec2(walk.cell << walk.level), float(1 << walk.level), walk.leavesOverX);
    walk.last = min(max(walk.leave, walk.share), endShare);
}

/// Goes to the next cell: up at most two levels, where it lies in another cell of the level above.
void leaveForNext(Line line, float endShare, inout CellWalk walk) {
    walk.share = walk.last;
    if (walk.leave >= endShare)
        return;
    walk.px = enterNext(line, walk.cell, walk.level, walk.leave, walk.leavesOverX);
    ivec2 left = walk.cell << walk.level;
    int from = max(walk.level, int(settings.minLevel));
    uint apart = uint((walk.px.x ^ left.x) | (walk.px.y ^ left.y)) >> uint(from + 1);
    walk.level = min(from + int(min(apart, 2u)), max(int(settings.maxLevel), from));
}

/// Has the march ended: off screen, without steps left, or at `endShare`?
bool hasEnded(CellWalk walk, float endShare, inout March result) {
    if (walk.share >= endShare)
        return true;
    if (any(lessThan(walk.px, ivec2(0))) || any(greaterThanEqual(walk.px, ivec2(frame.constants.size))))
        result.outcome = kOutcomeOffScreen;
    else if (result.iterations >= settings.maxSteps)
        result.outcome = kOutcomeOutOfSteps;
    return result.outcome != kOutcomeNone;
}

/// The first candidate among the pixels on the ray's way; none if the march has ended, or after kCellsTogether cells.
Candidate walkToPixel(ScreenRay ray, Line line, float start, float slope, float endShare, inout CellWalk walk,
                      inout March result) {
    ivec2 size = ivec2(frame.constants.size);
    int finest = max(int(settings.minLevel), 1); // below it one pixel decides
    for (int cells = 0; walk.level >= finest; ++cells) {
        if (hasEnded(walk, endShare, result))
            return Candidate(kWalkEnded, walk.px, walk.share);
        if (cells == kCellsTogether)
            return Candidate(kWalkGoesOn, walk.px, walk.share);
        ++result.iterations;
        enterCell(line, endShare, walk);
        CellBounds bounds =
            unpackBounds(texelFetch(pyramid, pyramidOffset(size, walk.level) + walk.cell, 0), frame.constants.invSize.x);
        ++result.lookups;
        if (bounds.front > kEmptyCell) {
            // How much nearer the ray is than the cell's plane: linear along the ray.
            vec2 center = (vec2(walk.cell) + 0.5) * float(1 << walk.level);
            float above = start - bounds.front - dot(bounds.slope, line.startPX - center);
            float climb = slope - dot(bounds.slope, line.deltaPX);
            Way way = Way(walk.share, walk.last, above, climb);
            float first = above + climb * way.share;
            float last = above + climb * way.end;
            float rounding = kRounding * abs(start + slope * way.share);
            bool inFront = min(first, last) >= -rounding;
            // Starts a pixel earlier, as tests of single pixels do.
            bool behind = max(above + climb * max(way.share - line.pixelShare, 0.0), last) < -bounds.slab;
            if (behind && !inFront)
                passBehind(way.share);
            logCell(ray, way.share, walk.cell, walk.level, start + slope * way.share - first, bounds.slab,
                    inFront  ? kSampleFront
                    : behind ? kSampleBehind
                             : kSampleLookInto);
            if (!inFront && !behind) {
                float fall = -climb * line.pixelShare; // a pixel
                float crossing = clamp((-0.5 * bounds.depth - above) / climb, way.share, way.end);
                vec2 at = line.startPX + line.deltaPX * crossing;
                bool isFlat = first >= -rounding && last < -bounds.depth && bounds.depth <= kFlatEnough * fall;
                if (isFlat && walk.mayBeFlat && onScreen(at) && // cells exceed the border
                    result.iterations > settings.selfCollisionSkip)
                    return Candidate(kAtFlatCell, floorToInt(at), crossing);
                walk.mayBeFlat = true;
                Quarter quarter = firstQuarter(line, bounds, walk.cell, walk.level, walk.px, way, rounding);
                if (quarter.found) {
                    --walk.level;
                    walk.share = quarter.share;
                    ivec2 low = (2 * walk.cell + ivec2(quarter.which & 1, quarter.which >> 1)) << walk.level;
                    ivec2 high = min(low + (1 << walk.level), size) - 1;
                    walk.px = clamp(floorToInt(line.startPX + line.deltaPX * quarter.share), low, high);
                    continue;
                }
                logCellDecision(kSamplePasses);
            }
        } else {
            logCell(ray, walk.share, walk.cell, walk.level, 0.0, 0.0, kSampleEmpty);
        }
        leaveForNext(line, endShare, walk);
    }
    if (hasEnded(walk, endShare, result))
        return Candidate(kWalkEnded, walk.px, walk.share);
    enterCell(line, endShare, walk);
    if (settings.minLevel > 0u) // the one pixel of a quarter, within the step of that quarter's cell
        return Candidate(kAtPixel, walk.px, walk.last);
    ++result.iterations;
    vec2 center = vec2(walk.px) + 0.5;
    float nearest = dot(center - line.startPX, line.deltaPX) / dot(line.deltaPX, line.deltaPX);
    return Candidate(kAtPixel, walk.px, clamp(nearest, walk.share, walk.last));
}

March march(Ray r) {
    ScreenRay ray = r.screen;
    March result = March(0.0, ray.startPX, 0u, 0u, kOutcomeNone);
    Line line = makeLine(ray);
    // The ray's nearness at a fraction of the line.
    float start = rayNearness(frame.constants, ray, 0.0);
    float slope = rayNearness(frame.constants, ray, 1.0) - start;
    float endShare = isOn(kTraceClipToFrustum) ? ray.screenEnd : 1.0;

    bool nearlyThickEnough = false;
    CellWalk walk;
    // The first pixel is the ray's own.
    walk.share = leaveCell(line, vec2(r.px), 1.0, walk.leavesOverX);
    walk.px = enterNext(line, r.px, 0, walk.share, walk.leavesOverX);
    walk.level = clamp(kFirstLevel, int(settings.minLevel), int(settings.maxLevel));
    walk.mayBeFlat = true;

    while (true) {
        Candidate candidate = walkToPixel(ray, line, start, slope, endShare, walk, result);
        if (candidate.found == kWalkGoesOn)
            continue;
        if (candidate.found == kWalkEnded)
            break;
        bool inFlatCell = candidate.found == kAtFlatCell;
        Sample s = takeSample(ray, candidate.px, candidate.at, result.lookups);
        float from = candidate.at - line.pixelShare;
        bool tests = result.iterations > settings.selfCollisionSkip;
        bool inFront = false;
        if (inFlatCell) {
            // Two surfaces with an edge between them may lie on one plane: the pixel itself decides.
            from += 0.5 * line.pixelShare;
            s.share += 0.5 * line.pixelShare;
            s.rayZ = rayViewZ(ray, s.share);
        } else {
            if (settings.minLevel > 0u)
                from = walk.share - 0.5 * line.pixelShare;
            else
                from = max(from, walk.share - kBeforePixel * line.pixelShare);
            inFront = s.rayZ < s.sceneZ;
            nearlyThickEnough = nearlyThickEnough && !inFront;
            tests = tests && (!inFront || mayMeetBeforeLeaving(r, walk.last, s));
        }
        if (tests) {
            uint met = meetSurface(r, max(from, 0.0), inFront, s, result.lookups);
            if ((met == kMeets || !inFlatCell) && endsMarch(met, s, result))
                return result;
            nearlyThickEnough = nearlyThickEnough || (met == kNearlyMeets && !inFlatCell);
        }
        if (inFlatCell)
            walk.mayBeFlat = false; // look into its quarters
        else
            leaveForNext(line, endShare, walk);
    }

    result.share = min(walk.share, endShare);
    if (result.outcome != kOutcomeNone)
        return result;
    result.share = endShare;
    if (endShare >= 1.0) { // the ray ends on screen
        vec2 endPX = clamp(ray.startPX + ray.deltaPX, vec2(0.0), frame.constants.size - 0.5);
        float sceneZ = texelFetch(metViewZ, floorToInt(endPX), 0).r;
        ++result.lookups;
        logSample(ray, 1.0, endPX, rayViewZ(ray, 1.0), sceneZ);
        result.outcome = endedOnScreen(ray, sceneZ, rayViewZ(ray, 1.0) >= sceneZ, nearlyThickEnough);
    } else {
        result.outcome = kOutcomeOffScreen;
    }
    return result;
}
