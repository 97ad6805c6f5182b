// The `hiz` marcher: walks cell by cell through the depth pyramid. The ray leaves a cell at once if it passes in front
// of or behind the cell's surfaces. A cell that shows a single flat surface gives the pixel of the hit itself. In any
// other cell the ray descends a level. Walking and testing pixels are loops of their own, so that the rays of a group
// test together: a ray that has come to a pixel waits for the others, but not for long. docs/techniques/hiz.md
#include "trace/cells.glsl"
#include "trace/hit_test.glsl"

/// The level at which a ray starts: most rays leave a surface that is flat over this many pixels.
const int kFirstLevel = 4;
/// So many cells are walked before those rays of the group that have come to a pixel test it. measured: NVIDIA H200,
/// builtin:hall at 1920x1080, mirror directions, an earlier form of the walk: 1.46 ms; 1.51 with 3, 1.78 if they wait for
/// all. No difference on llvmpipe, whose groups have eight rays.
const uint kCellsTogether = 10u;
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

/// What a march knows on its way. A driver that runs rays in groups copies all of it for each cell, so it holds no more
/// than the next cell needs.
struct CellWalk {
    ivec2 px;
    int level;
    float share;     // the ray is here
    uint cells;      // looked at so far
    uint flatTested; // the number of the cell whose flat surface a pixel has decided about: its quarters are looked at
};

/// A ray's way through a cell or a part of it, from `share` to `end` of its line, and its height over the cell's plane
/// as a function of the share: nearness, `above` + `climb` * share.
struct Way {
    float share;
    float end;
    float above;
    float climb;
    float invClimb; // 1 / climb
};

/// Where the march continues inside a cell that it descends into.
struct Quarter {
    bool found; // false: the ray passes all quarters
    float share;
    int which; // as for quarterSolid
};

const uint kPassesQuarter = 0u; // in front of what is solid there, or there is nothing
const uint kPassesBehindQuarter = 1u;
const uint kMayHitQuarter = 2u;

/// What the ray does on its way through a quarter whose solid part is `solid`.
uint crossQuarter(Line line, vec2 solid, Way way, float rounding) {
    float first = way.above + way.climb * way.share;
    float last = way.above + way.climb * way.end;
    bool inFront = min(first, last) >= -solid.x - rounding;
    // Starts a pixel earlier, as tests of single pixels do.
    bool behind = max(way.above + way.climb * max(way.share - line.pixelShare, 0.0), last) < -solid.y;
    uint crossed = behind ? kPassesBehindQuarter : inFront ? kPassesQuarter : kMayHitQuarter;
    return solid.x <= solid.y ? crossed : kPassesQuarter;
}

/// Where the ray reaches the solid part of a quarter: it hits nothing before.
float reachSolid(Line line, vec2 solid, Way way) {
    float first = way.above + way.climb * way.share;
    bool fromFront = first > -solid.x;
    bool fromBehind = !fromFront && first < -solid.y;
    float reached = ((fromFront ? -solid.x : -solid.y) - way.above) * way.invClimb - (fromFront ? 0.0 : line.pixelShare);
    return fromFront || fromBehind ? clamp(reached, way.share, way.end) : way.share;
}

/// The first quarter of the cell at `at` that the ray may hit on its way from the walk's pixel. `passed`: share at which
/// it passes behind a quarter before that one; 2: it does not. Without branches: rays of a group cross different numbers
/// of quarters.
Quarter firstQuarter(Line line, CellBounds cell, ivec2 at, CellWalk walk, Way way, float rounding, out float passed) {
    // A line crosses at most three quarters: it goes over the cell's middle in x and in y, unless it starts behind it.
    ivec2 quarter = (walk.px >> (walk.level - 1)) & 1;
    vec2 middle = vec2((2 * at + 1) << (walk.level - 1));
    vec2 crossing = max((middle - line.startPX) * line.invDelta, way.share);
    crossing = mix(vec2(1e30), crossing, notEqual(vec2(quarter), line.forward));
    crossing = mix(crossing, vec2(1e30), greaterThan(abs(line.invDelta), vec2(1e29)));
    float first = min(crossing.x, crossing.y);
    float second = max(crossing.x, crossing.y);
    int which0 = quarter.x + 2 * quarter.y;
    int which1 = which0 ^ (crossing.x < crossing.y ? 1 : 2);
    int which2 = which0 ^ 3;
    Way way0 = Way(way.share, min(first, way.end), way.above, way.climb, way.invClimb);
    Way way1 = Way(first, min(second, way.end), way.above, way.climb, way.invClimb);
    Way way2 = Way(second, way.end, way.above, way.climb, way.invClimb);
    vec2 solid0 = quarterSolid(cell, which0);
    vec2 solid1 = quarterSolid(cell, which1);
    vec2 solid2 = quarterSolid(cell, which2);
    uint crossed0 = crossQuarter(line, solid0, way0, rounding);
    uint crossed1 = first < way.end ? crossQuarter(line, solid1, way1, rounding) : kPassesQuarter;
    uint crossed2 = second < way.end ? crossQuarter(line, solid2, way2, rounding) : kPassesQuarter;
    bool hits0 = crossed0 == kMayHitQuarter;
    bool hits1 = crossed1 == kMayHitQuarter;
    bool found = hits0 || hits1 || crossed2 == kMayHitQuarter;
    // The first that it passes behind, of those before the one found.
    passed = !hits0 && !hits1 && crossed2 == kPassesBehindQuarter ? second : 2.0;
    passed = !hits0 && crossed1 == kPassesBehindQuarter ? first : passed;
    passed = crossed0 == kPassesBehindQuarter ? way.share : passed;
    Way into = way2;
    into.share = hits0 ? way0.share : hits1 ? way1.share : way2.share;
    into.end = hits0 ? way0.end : hits1 ? way1.end : way2.end;
    vec2 solid = hits0 ? solid0 : hits1 ? solid1 : solid2;
    return Quarter(found, reachSolid(line, solid, into), hits0 ? which0 : hits1 ? which1 : which2);
}

/// A ray's way through the cell that it is in.
struct CellCrossing {
    ivec2 cell;
    float leave; // the ray leaves the cell here,
    float last;  // goes there no farther than this,
    bool overX;  // and leaves over a border in x
};

CellCrossing crossCell(Line line, float endShare, CellWalk walk) {
    CellCrossing crossing;
    crossing.cell = walk.px >> walk.level;
    crossing.leave = leaveCell(line, vec2(crossing.cell << walk.level), float(1 << walk.level), crossing.overX);
    crossing.last = min(max(crossing.leave, walk.share), endShare);
    return crossing;
}

/// Goes to the next cell: up at most two levels, where it lies in another cell of the level above.
void leaveForNext(Line line, CellCrossing crossing, inout CellWalk walk) {
    walk.share = crossing.last;
    walk.px = enterNext(line, crossing.cell, walk.level, crossing.leave, crossing.overX);
    ivec2 left = crossing.cell << walk.level;
    int from = max(walk.level, int(settings.minLevel));
    uint apart = uint((walk.px.x ^ left.x) | (walk.px.y ^ left.y)) >> uint(from + 1);
    walk.level = min(from + int(min(apart, 2u)), max(int(settings.maxLevel), from));
}

bool isOffScreen(ivec2 px, ivec2 size) {
    return any(greaterThanEqual(uvec2(px), uvec2(size)));
}

const uint kWalked = 0u;     // no pixel yet
const uint kAtPixel = 1u;    // a pixel decides whether the ray ends there
const uint kAtFlatCell = 2u; // the same: a cell of several pixels shows one flat surface, which the ray meets at this one

/// The ray's line, and its nearness along it.
struct CellRay {
    ScreenRay screen;
    Line line;
    float start; // nearness at share 0
    float slope; // nearness gained from share 0 to 1
    float end;   // share at which the march ends
};

/// The ray's way through a cell of this plane.
Way wayThrough(CellRay ray, CellBounds bounds, CellWalk walk, CellCrossing crossing) {
    // How much nearer the ray is than the cell's plane: linear along the ray.
    vec2 center = (vec2(crossing.cell) + 0.5) * float(1 << walk.level);
    float above = ray.start - bounds.front - dot(bounds.slope, ray.line.startPX - center);
    float climb = ray.slope - dot(bounds.slope, ray.line.deltaPX);
    return Way(walk.share, crossing.last, above, climb, 1.0 / climb);
}

/// Goes down to a quarter of the cell.
void descend(Line line, CellCrossing crossing, Quarter quarter, inout CellWalk walk) {
    --walk.level;
    walk.share = quarter.share;
    ivec2 low = (2 * crossing.cell + ivec2(quarter.which & 1, quarter.which >> 1)) << walk.level;
    ivec2 high = min(low + (1 << walk.level), ivec2(frame.constants.size)) - 1;
    walk.px = clamp(floorToInt(line.startPX + line.deltaPX * quarter.share), low, high);
}

/// Walks up to the first pixel that decides something, or to cell number `stop`. With kWalked and kAtPixel the ray may be
/// at its end or off screen. `pixels`: steps of the march that were no cells. `flatShare`: where the ray meets the flat
/// surface of kAtFlatCell.
uint walkToPixel(CellRay ray, uint stop, uint pixels, inout CellWalk walk, inout March march, out float flatShare) {
    ivec2 size = ivec2(frame.constants.size);
    Line line = ray.line;
    int finest = max(int(settings.minLevel), 1); // below it one pixel decides
    flatShare = 0.0;
    while (walk.level >= finest && walk.cells < stop && walk.share < ray.end && !isOffScreen(walk.px, size)) {
        CellCrossing crossing = crossCell(line, ray.end, walk);
        CellBounds bounds = loadCell(crossing.cell, walk.level);
        bool mayBeFlat = walk.cells != walk.flatTested;
        ++walk.cells;
        bool descends = false;
        if (bounds.front > kEmptyCell) {
            Way way = wayThrough(ray, bounds, walk, crossing);
            float first = way.above + way.climb * way.share;
            float last = way.above + way.climb * way.end;
            float rounding = kRounding * abs(ray.start + ray.slope * way.share);
            bool inFront = min(first, last) >= -rounding;
            // Starts a pixel earlier, as tests of single pixels do.
            bool behind = max(way.above + way.climb * max(way.share - line.pixelShare, 0.0), last) < -bounds.slab;
            if (behind && !inFront)
                passBehind(march, way.share);
            logCell(ray.screen, way.share, crossing.cell, walk.level, ray.start + ray.slope * way.share - first,
                    bounds.slab,
                    inFront  ? kSampleFront
                    : behind ? kSampleBehind
                             : kSampleLookInto);
            if (!inFront && !behind) {
                float fall = -way.climb * line.pixelShare; // a pixel
                flatShare = clamp((-0.5 * bounds.depth - way.above) * way.invClimb, way.share, way.end);
                bool isFlat = first >= -rounding && last < -bounds.depth && bounds.depth <= kFlatEnough * fall;
                if (isFlat && mayBeFlat && walk.cells + pixels > settings.selfCollisionSkip &&
                    onScreen(line.startPX + line.deltaPX * flatShare)) // cells exceed the border
                    return kAtFlatCell;
                float passed;
                Quarter quarter = firstQuarter(line, bounds, crossing.cell, walk, way, rounding, passed);
                if (passed <= 1.0)
                    passBehind(march, passed);
                descends = quarter.found;
                if (descends)
                    descend(line, crossing, quarter, walk);
                else
                    logCellDecision(kSamplePasses);
            }
        } else {
            logCell(ray.screen, walk.share, crossing.cell, walk.level, 0.0, 0.0, kSampleEmpty);
        }
        if (!descends)
            leaveForNext(line, crossing, walk);
    }
    return walk.level < finest ? kAtPixel : kWalked;
}

/// The pixel that a walk has come to.
struct PixelStep {
    ivec2 px;
    float walked; // share that the walk has come to,
    float at;     // that of the pixel's sample,
    float leave;  // and where the ray leaves the pixel's cell
    bool inFlatCell;
};

/// `at`: for a flat cell, where the ray meets its surface. `pixels` counts the pixels that are steps of their own.
PixelStep stepToPixel(Line line, CellWalk walk, CellCrossing crossing, bool inFlatCell, float at, inout uint pixels) {
    PixelStep step = PixelStep(walk.px, walk.share, at, crossing.last, inFlatCell);
    if (inFlatCell) {
        step.px = min(floorToInt(line.startPX + line.deltaPX * at), ivec2(frame.constants.size) - 1);
    } else if (settings.minLevel > 0u) { // the one pixel of a quarter, within the step of that quarter's cell
        step.at = crossing.last;
    } else {
        ++pixels;
        float nearest = dot(vec2(step.px) + 0.5 - line.startPX, line.deltaPX) / dot(line.deltaPX, line.deltaPX);
        step.at = clamp(nearest, walk.share, crossing.last);
    }
    return step;
}

/// Tests a pixel that the walk has come to. True if the ray ends there. `counts`: it is no step that
/// screen.selfCollisionSkip leaves out.
bool endsAtPixel(Ray r, Line line, PixelStep step, bool counts, inout bool nearlyThickEnough, inout March march) {
    Sample s = takeSample(r.screen, step.px, step.at, march.lookups);
    float from = step.at - line.pixelShare;
    bool tests = counts;
    bool inFront = false;
    if (step.inFlatCell) {
        // Two surfaces with an edge between them may lie on one plane: the pixel itself decides.
        from += 0.5 * line.pixelShare;
        s.share = min(s.share + 0.5 * line.pixelShare, 1.0); // beyond its end the line comes to infinity
        s.rayZ = rayViewZ(r.screen, s.share);
    } else {
        if (settings.minLevel > 0u)
            from = step.walked - 0.5 * line.pixelShare;
        else
            from = max(from, step.walked - kBeforePixel * line.pixelShare);
        inFront = s.rayZ < s.sceneZ;
        nearlyThickEnough = nearlyThickEnough && !inFront;
        tests = tests && (!inFront || mayMeetBeforeLeaving(r, step.leave, s));
    }
    bool ends = false;
    if (tests) {
        uint met = meetSurface(r, max(from, 0.0), inFront, s, march);
        ends = (met == kMeets || met == kMeetsSunk || !step.inFlatCell) && endsMarch(met, s, march);
        nearlyThickEnough = nearlyThickEnough || (met == kNearlyMeets && !step.inFlatCell);
    }
    return ends;
}

/// How a march ended that met no surface, and where.
void endWalk(CellRay ray, CellWalk walk, bool nearlyThickEnough, inout March march) {
    march.share = min(walk.share, ray.end);
    if (march.share < ray.end) {
        bool left = isOffScreen(walk.px, ivec2(frame.constants.size));
        march.outcome = left ? kOutcomeOffScreen : kOutcomeOutOfSteps;
    } else if (ray.end >= 1.0) { // the ray ends on screen
        vec2 endPX = clamp(ray.line.startPX + ray.line.deltaPX, vec2(0.0), frame.constants.size - 0.5);
        float sceneZ = loadSceneZ(floorToInt(endPX));
        ++march.lookups;
        float rayZ = rayViewZ(ray.screen, 1.0);
        logSample(ray.screen, 1.0, endPX, rayZ, sceneZ);
        march.outcome = endedOnScreen(ray.screen, sceneZ, rayZ >= sceneZ, nearlyThickEnough);
    } else {
        march.outcome = kOutcomeOffScreen;
    }
}

CellRay cellRay(ScreenRay screen) {
    CellRay ray;
    ray.screen = screen;
    ray.line = makeLine(screen);
    ray.start = rayNearness(frame.constants, screen, 0.0);
    ray.slope = rayNearness(frame.constants, screen, 1.0) - ray.start;
    ray.end = isOn(kTraceClipToFrustum) ? screen.screenEnd : 1.0;
    return ray;
}

/// The first pixel is the ray's own.
CellWalk startWalk(Line line, ivec2 px) {
    CellWalk walk;
    bool overX;
    walk.share = leaveCell(line, vec2(px), 1.0, overX);
    walk.px = enterNext(line, px, 0, walk.share, overX);
    walk.level = clamp(kFirstLevel, int(settings.minLevel), int(settings.maxLevel));
    walk.cells = 0u;
    walk.flatTested = ~0u;
    return walk;
}

March march(Ray r) {
    March result = startMarch(r.screen);
    CellRay ray = cellRay(r.screen);
    Line line = ray.line;
    ivec2 size = ivec2(frame.constants.size);
    bool nearlyThickEnough = false;
    uint pixels = 0u; // steps that were no cells
    CellWalk walk = startWalk(line, r.px);
    while (true) {
        uint left = settings.maxSteps - walk.cells - pixels;
        uint stop = walk.cells + min(left, kCellsTogether);
        float flatShare;
        uint found = walkToPixel(ray, stop, pixels, walk, result, flatShare);
        bool inFlatCell = found == kAtFlatCell;
        if (!inFlatCell) {
            bool hasSteps = walk.cells + pixels < settings.maxSteps;
            if (walk.share >= ray.end || isOffScreen(walk.px, size) || !hasSteps)
                break;
            // A walk that ends early without a pixel is over, also where a broken G-buffer makes `share` NaN.
            if (found == kWalked && walk.cells < stop)
                break;
            if (found == kWalked)
                continue;
        }
        CellCrossing crossing = crossCell(line, ray.end, walk);
        PixelStep step = stepToPixel(line, walk, crossing, inFlatCell, flatShare, pixels);
        bool counts = walk.cells + pixels > settings.selfCollisionSkip;
        if (endsAtPixel(r, line, step, counts, nearlyThickEnough, result))
            break;
        if (inFlatCell)
            walk.flatTested = walk.cells;
        else
            leaveForNext(line, crossing, walk);
    }
    result.iterations = walk.cells + pixels;
    result.lookups += walk.cells;
    if (result.outcome == kOutcomeNone)
        endWalk(ray, walk, nearlyThickEnough, result);
    return result;
}
