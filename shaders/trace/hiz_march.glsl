// The `hiz` marcher: walks cell by cell through the depth pyramid. The ray leaves a cell at once if it passes in front
// of or behind the cell's surfaces. A cell that shows a single flat surface gives the hit itself. In any other cell the
// ray descends a level. docs/techniques/hiz.md
#include "lib/nearness.glsl"
#include "lib/pyramid.glsl"
#include "trace/hit_test.glsl"

layout(set = 0, binding = 12) uniform usampler2D pyramid;

/// The level at which a ray starts: most rays leave a surface that is flat over this many pixels.
const int kFirstLevel = 4;
/// Rounding of the cell's and of the ray's nearness, as a fraction of it.
const float kRounding = 2e-6;
/// A flat cell gives the hit itself if it places the hit this exactly, in pixels along the ray.
const float kFlatEnough = 0.75;

Cell lookUp(ivec2 cell, int level) {
    ivec2 size = ivec2(frame.constants.size);
    return unpackCell(texelFetch(pyramid, pyramidOffset(size, level) + cell, 0), frame.constants.invSize.x);
}

/// The line on screen, in the form that crossings of cell borders need.
struct Line {
    vec2 startPX;
    vec2 deltaPX;
    vec2 invDelta;    // large for an axis along which the line does not move
    vec2 forward;     // 1 where the line moves toward larger coordinates, else 0
    float pixelShare; // a pixel along the line's longer axis, as a fraction of the line
};

Line makeLine(ScreenRay ray) {
    vec2 moves = vec2(notEqual(ray.deltaPX, vec2(0.0)));
    vec2 invDelta = mix(vec2(1e30), 1.0 / mix(vec2(1.0), ray.deltaPX, moves), moves);
    return Line(ray.startPX, ray.deltaPX, invDelta, vec2(greaterThan(ray.deltaPX, vec2(0.0))), 1.0 / screenPixels(ray));
}

/// Fraction of the line at which it leaves the cell that spans [low, low + size) pixels, and the axis it crosses.
float leaveCell(Line line, vec2 low, float size, out bool overX) {
    vec2 at = (low + line.forward * size - line.startPX) * line.invDelta;
    at = mix(at, vec2(1e30), greaterThan(abs(line.invDelta), vec2(1e29)));
    overX = at.x < at.y;
    return min(at.x, at.y);
}

/// The pixel behind the border across which the ray leaves a cell.
ivec2 enterNext(Line line, ivec2 cell, int level, float share, bool overX) {
    vec2 at = line.startPX + line.deltaPX * share;
    ivec2 low = cell << level;
    ivec2 high = ((cell + 1) << level) - 1;
    ivec2 px = clamp(ivec2(floor(at)), low, high);
    if (overX)
        px.x = line.deltaPX.x > 0.0 ? high.x + 1 : low.x - 1;
    else
        px.y = line.deltaPX.y > 0.0 ? high.y + 1 : low.y - 1;
    return px;
}

/// Where the march continues inside a cell that it descends into.
struct Quarter {
    bool found; // false: the ray passes all quarters
    float share;
    ivec2 px;
};

/// The first quarter of `cell` that the ray may hit, from `share` to `last` of its line. `above` and `climb` give the
/// ray's height over the cell's plane.
Quarter firstQuarter(Line line, Cell cell, int level, ivec2 px, float share, float last, float above, float climb,
                     float rounding) {
    ivec2 parent = px >> level;
    for (int i = 0; i < 3; ++i) { // a line crosses at most three quarters
        ivec2 child = px >> (level - 1);
        bool overX;
        float leave = leaveCell(line, vec2(child << (level - 1)), float(1 << (level - 1)), overX);
        float end = min(max(leave, share), last);
        vec2 solid = cell.quarters[(child.x & 1) + 2 * (child.y & 1)];
        float first = above + climb * share;
        float final = above + climb * end;
        bool inFront = min(first, final) >= -solid.x - rounding;
        bool behind = max(above + climb * max(share - line.pixelShare, 0.0), final) < -solid.y;
        if (!inFront && !behind && solid.x <= solid.y) {
            // The ray hits nothing before it reaches the solid part.
            float to = share;
            if (first > -solid.x)
                to = clamp((-solid.x - above) / climb, share, end);
            else if (first < -solid.y)
                to = clamp((-solid.y - above) / climb - line.pixelShare, share, end);
            ivec2 low = child << (level - 1);
            ivec2 high = min((child + 1) << (level - 1), ivec2(frame.constants.size)) - 1;
            return Quarter(true, to, clamp(ivec2(floor(line.startPX + line.deltaPX * to)), low, high));
        }
        if (behind && solid.x <= solid.y)
            passBehind(share);
        if (leave >= last)
            break;
        ivec2 next = enterNext(line, child, level - 1, leave, overX);
        if ((next >> level) != parent)
            break;
        px = next;
        share = end;
    }
    return Quarter(false, last, px);
}

March march(Ray r) {
    ScreenRay ray = r.screen;
    March result = March(0.0, ray.startPX, 0u, 0u, kOutcomeNone);
    Line line = makeLine(ray);
    float pixelShare = line.pixelShare;
    // The ray's nearness at a fraction of the line.
    float start = rayNearness(frame.constants, ray, 0.0);
    float slope = rayNearness(frame.constants, ray, 1.0) - start;
    float endShare = isOn(kTraceClipToFrustum) ? ray.screenEnd : 1.0;
    int minLevel = int(settings.minLevel);
    int maxLevel = int(settings.maxLevel);
    ivec2 screenSize = ivec2(frame.constants.size);

    bool nearlyThickEnough = false;
    bool overX;
    // The first pixel is the ray's own.
    float share = leaveCell(line, vec2(r.px), 1.0, overX);
    ivec2 px = enterNext(line, r.px, 0, share, overX);
    int level = clamp(kFirstLevel, minLevel, maxLevel);

    while (share < endShare) {
        if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, screenSize))) {
            result.share = share;
            result.outcome = kOutcomeOffScreen;
            return result;
        }
        if (result.iterations == settings.maxSteps) {
            result.share = share;
            result.outcome = kOutcomeOutOfSteps;
            return result;
        }
        ++result.iterations;
        ivec2 cell = px >> level;
        float leave = leaveCell(line, vec2(cell << level), float(1 << level), overX);
        float last = min(max(leave, share), endShare);

        if (level > 0) {
            Cell bounds = lookUp(cell, level);
            ++result.lookups;
            if (bounds.front > kEmptyCell) {
                // How much nearer the ray is than the cell's plane: linear along the ray.
                vec2 center = (vec2(cell) + 0.5) * float(1 << level);
                float above = start - bounds.front - dot(bounds.slope, ray.startPX - center);
                float climb = slope - dot(bounds.slope, ray.deltaPX);
                float aboveFirst = above + climb * share;
                float aboveLast = above + climb * last;
                float rounding = kRounding * abs(start + slope * share);
                bool inFront = min(aboveFirst, aboveLast) >= -rounding;
                // Starts a pixel earlier, as tests of single pixels do.
                bool behind = max(above + climb * max(share - pixelShare, 0.0), aboveLast) < -bounds.slab;
                if (behind && !inFront)
                    passBehind(share);
                logCell(ray, share, cell, level, start + slope * share - aboveFirst, bounds.slab,
                        inFront  ? kSampleFront
                        : behind ? kSampleBehind
                                 : kSampleLookInto);
                if (!inFront && !behind) {
                    float fall = -climb * pixelShare; // a pixel
                    bool flatCell =
                        aboveFirst >= -rounding && aboveLast < -bounds.depth && bounds.depth <= kFlatEnough * fall;
                    float crosses = clamp((-0.5 * bounds.depth - above) / climb, share, last);
                    flatCell = flatCell && onScreen(ray.startPX + ray.deltaPX * crosses); // cells exceed the border
                    if (flatCell && result.iterations > settings.selfCollisionSkip) {
                        // Two surfaces with an edge between them may lie on one plane: the pixel itself decides.
                        Sample s = takeSample(ray, crosses, result.lookups);
                        s.share = crosses + 0.5 * pixelShare;
                        s.rayZ = rayViewZ(ray, s.share);
                        uint met = meetSurface(r, max(crosses - 0.5 * pixelShare, 0.0), s, result.lookups);
                        if (met == kMeets && endsMarch(met, s, result))
                            return result;
                    }
                    if (level > minLevel) {
                        Quarter quarter = firstQuarter(line, bounds, level, px, share, last, above, climb, rounding);
                        if (quarter.found) {
                            share = quarter.share;
                            px = quarter.px;
                            --level;
                            continue;
                        }
                        logCellDecision(kSamplePasses);
                    } else {
                        // The finest level to descend to: one pixel gives the answer for each of its quarters.
                        Quarter quarter = firstQuarter(line, bounds, level, px, share, last, above, climb, rounding);
                        if (quarter.found) {
                            bool quarterOverX;
                            ivec2 child = quarter.px >> (level - 1);
                            float side = float(1 << (level - 1));
                            float out_ = leaveCell(line, vec2(child) * side, side, quarterOverX);
                            Sample s = takeSample(ray, quarter.px, min(max(out_, quarter.share), last), result.lookups);
                            if (s.rayZ >= s.sceneZ && result.iterations > settings.selfCollisionSkip) {
                                float from = max(quarter.share - 0.5 * pixelShare, 0.0);
                                uint met = meetSurface(r, from, s, result.lookups);
                                if (endsMarch(met, s, result))
                                    return result;
                                nearlyThickEnough = nearlyThickEnough || met == kNearlyMeets;
                            }
                            ivec2 next = enterNext(line, child, level - 1, out_, quarterOverX);
                            if (out_ < last && (next >> level) == cell) { // go to the cell's next quarter
                                share = max(out_, share);
                                px = next;
                                continue;
                            }
                        } else {
                            logCellDecision(kSamplePasses);
                        }
                    }
                }
            } else {
                logCell(ray, share, cell, level, 0.0, 0.0, kSampleEmpty);
            }
        } else {
            vec2 center = vec2(px) + 0.5;
            float at = clamp(dot(center - ray.startPX, ray.deltaPX) / dot(ray.deltaPX, ray.deltaPX), share, last);
            Sample s = takeSample(ray, px, at, result.lookups);
            if (s.rayZ < s.sceneZ) {
                nearlyThickEnough = false;
            } else if (result.iterations > settings.selfCollisionSkip) {
                uint met = meetSurface(r, max(at - pixelShare, 0.0), s, result.lookups);
                if (endsMarch(met, s, result))
                    return result;
                nearlyThickEnough = nearlyThickEnough || met == kNearlyMeets;
            }
        }

        // Go to the next cell. Go up at most two levels, where the next cell lies in another cell of the level above.
        share = last;
        if (leave >= endShare)
            break;
        px = enterNext(line, cell, level, leave, overX);
        ivec2 left = cell << level;
        for (int i = 0; i < 2 && level < maxLevel && (px >> (level + 1)) != (left >> (level + 1)); ++i)
            ++level;
    }

    result.share = endShare;
    if (endShare >= 1.0) { // the ray ends on screen
        vec2 endPX = clamp(ray.startPX + ray.deltaPX, vec2(0.0), frame.constants.size - 0.5);
        float sceneZ = texelFetch(viewZ, ivec2(endPX), 0).r;
        ++result.lookups;
        logSample(ray, 1.0, endPX, rayViewZ(ray, 1.0), sceneZ);
        result.outcome = endedOnScreen(ray, sceneZ, rayViewZ(ray, 1.0) >= sceneZ, nearlyThickEnough);
    } else {
        result.outcome = kOutcomeOffScreen;
    }
    return result;
}
