// The plane of a pixel's surface, from the depths around it, where shading normals do not follow it: normal maps bend
// them, and coarse triangles interpolate them. Include after frame/frame_block.glsl and a definition of loadFacePoint.
#ifndef GLINT_LIB_FACE_NORMAL_GLSL
#define GLINT_LIB_FACE_NORMAL_GLSL

#include "lib/camera.glsl"
#include "lib/math.glsl"
#include "lib/ray_start.glsl"

/// What a pixel shows.
struct FacePoint {
    vec3 positionVS;
    vec3 normalVS; // unit, shading
    bool exists;   // false: the background
};

/// Defined by the includer; `px` lies in the frame.
FacePoint loadFacePoint(ivec2 px);

/// The sine of the angle between a chord and the surface that the normals at its ends describe is 0 on planes and spheres.
/// From here on normals are bent.
const float kBentNormals = 0.035; // 2 degrees

/// Above this cosine to the eye a mirror direction stays above the surface, unless normals are bent by 45 degrees.
const float kSteepView = 0.7071;

/// From here on, 70 degrees, depths and normals are not of one surface.
const float kUnrelated = 0.94;

/// The way to a neighbour, and the sine of kBentNormals; more than 1 without a neighbour.
struct Chord {
    vec3 way;
    float bent;
};

Chord chordTo(ivec2 px, FacePoint here) {
    if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return Chord(vec3(0.0), 2.0);
    FacePoint there = loadFacePoint(px);
    if (!there.exists)
        return Chord(vec3(0.0), 2.0);
    vec3 way = there.positionVS - here.positionVS;
    return Chord(way, 0.5 * abs(dot(way, here.normalVS + there.normalVS)) / max(length(way), 1e-20));
}

/// The chord along an axis, on the side where normals follow it better, as another surface may lie on the other one.
/// Another surface may also lie on both, beside a thing as thin as a pixel: the ways are then long, and no straight line.
Chord chordAlong(ivec2 px, ivec2 step, FacePoint here) {
    const float kStraight = 0.3; // of the ways' length
    const float kLong = 4.0;     // pixels
    const float kLongest = 16.0; // where one way is all that there is
    Chord after = chordTo(px + step, here);
    Chord before = chordTo(px - step, here);
    before.way = -before.way;
    Chord chord = before;
    if (after.bent < before.bent)
        chord = after;
    bool both = max(before.bent, after.bent) <= 1.0;
    bool straight = both && length(after.way - before.way) <= kStraight * length(after.way + before.way);
    float pixel = pixelExtent(frame.constants, frame.constants.uvToView, -here.positionVS.z).y;
    if (!straight && length(chord.way) > (both ? kLong : kLongest) * pixel)
        chord.bent = 2.0;
    return chord;
}

/// False where normals follow depths, or depths say nothing. `faceVS`: unit, towards the eye.
bool findFaceNormal(ivec2 px, FacePoint here, out vec3 faceVS) {
    Chord along = chordAlong(px, ivec2(1, 0), here);
    Chord across = chordAlong(px, ivec2(0, 1), here);
    float bent = length(vec2(along.bent, across.bent));
    faceVS = normalizeOr(cross(along.way, across.way), here.normalVS);
    if (dot(faceVS, viewDirection(frame.constants, here.positionVS)) > 0.0)
        faceVS = -faceVS;
    return bent >= kBentNormals && bent < kUnrelated;
}

/// The shading normal, turned as little as it takes for its mirror direction to stay above the surface: below, there is
/// the surface itself, and no light. Where normals follow depths it is kept as it is.
vec3 normalThatReflectsUp(ivec2 px, FacePoint here) {
    vec3 toSurfaceVS = viewDirection(frame.constants, here.positionVS);
    vec3 faceVS;
    if (dot(here.normalVS, -toSurfaceVS) > kSteepView || !findFaceNormal(px, here, faceVS))
        return here.normalVS;
    vec3 mirroredVS = reflect(toSurfaceVS, here.normalVS);
    if (dot(mirroredVS, faceVS) >= kLeastCosine)
        return here.normalVS;
    return normalizeOr(aboveSurface(mirroredVS, faceVS) - toSurfaceVS, faceVS);
}

#endif
