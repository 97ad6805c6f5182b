// Surfaces that leave the frame. A ray that leaves the screen may intersect a surface a few pixels beyond the border,
// which the frame shows at the border: that surface's plane is extended. The answer is the border's pixel (outcome
// `inferred`). It is a guess: the surface may end at the border.
#ifndef GLINT_TRACE_INFER_BORDER_GLSL
#define GLINT_TRACE_INFER_BORDER_GLSL

#include "trace/infer.glsl"

/// How far beyond the border the surface is extended, in pixels.
const float kBeyondBorder = 8.0;
/// Spacing of the samples along the border, in pixels, and their largest number less one.
const float kBorderSpacing = 4.0;
const uint kBorderSamples = 3u;

/// Answers a ray that left the screen in front of a surface that the border shows, if it intersects that surface's plane
/// close beyond the border, with the nearest pixel that shows the surface.
void inferBeyondBorder(Ray r, inout March end) {
    vec2 start = r.screen.startPX;
    vec2 delta = r.screen.deltaPX;
    float leave = r.screen.screenEnd;
    vec2 most = frame.constants.size + kBeyondBorder;
    float far = min(1.0, min(shareInside(start.x, delta.x, -kBeyondBorder, most.x),
                             shareInside(start.y, delta.y, -kBeyondBorder, most.y)));
    vec2 leavePX = start + delta * leave;
    vec2 farPX = clamp(start + delta * far, vec2(0.5), frame.constants.size - 0.5);
    uint samples = 1u + min(uint(floorToInt(distance(leavePX, farPX) / kBorderSpacing)), kBorderSamples);
    for (uint i = 0u; i < samples; ++i) {
        float share = mix(leave, far, float(i) / max(float(samples - 1u), 1.0));
        vec2 px = clamp(start + delta * share, vec2(0.5), frame.constants.size - 0.5);
        Sample border = Sample(share, px, rayViewZ(r.screen, share), loadSceneZ(floorToInt(px)));
        ++end.lookups;
        logBeside(r.screen, share, px, border.rayZ, border.sceneZ);
        if (border.sceneZ >= kBackgroundZ)
            continue;
        ShownPlane plane = planeShown(px, border.sceneZ);
        float height = heightAt(r, plane, leave);
        float heightFar = heightAt(r, plane, far);
        if (height < 0.0 || heightFar >= 0.0 || !facesRay(plane.normalVS, false, r) ||
            isOwnSurface(plane.pointVS, plane.normalVS, r))
            continue;
        Sample crossing = border;
        crossing.share = crossingShare(r.screen, leave, height, far, heightFar);
        crossing.rayZ = rayViewZ(r.screen, crossing.share);
        crossing.px = clamp(start + delta * crossing.share, vec2(0.5), frame.constants.size - 0.5);
        if (lookBeside(r, plane, crossing, crossing.px, end.lookups) != kSurface)
            continue;
        logDecision(crossing.px, kSampleInferred);
        end.outcome = kOutcomeInferred;
        end.hitPX = crossing.px;
        end.share = crossing.share;
        return;
    }
}

#endif
