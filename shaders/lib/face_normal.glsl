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

/// The way to the neighbour along an axis, on the side where normals follow it better, as another surface may lie on the
/// other one. Returns the sine of kBentNormals; more than 1 without a neighbour.
float chordAlong(ivec2 px, ivec2 step, FacePoint here, out vec3 chord) {
    float least = 2.0;
    chord = vec3(0.0);
    for (int side = -1; side <= 1; side += 2) {
        ivec2 at = px + side * step;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(frame.constants.size))))
            continue;
        FacePoint there = loadFacePoint(at);
        if (!there.exists)
            continue;
        vec3 way = there.positionVS - here.positionVS;
        float bent = 0.5 * abs(dot(way, here.normalVS + there.normalVS)) / max(length(way), 1e-20);
        if (bent < least) {
            least = bent;
            chord = float(side) * way;
        }
    }
    return least;
}

/// False where normals follow depths, or depths say nothing. `faceVS`: unit, towards the eye.
bool findFaceNormal(ivec2 px, FacePoint here, out vec3 faceVS) {
    vec3 along;
    vec3 across;
    float bent = max(chordAlong(px, ivec2(1, 0), here, along), chordAlong(px, ivec2(0, 1), here, across));
    faceVS = normalizeOr(cross(along, across), here.normalVS);
    if (dot(faceVS, viewDirection(frame.constants, here.positionVS)) > 0.0)
        faceVS = -faceVS;
    return bent >= kBentNormals && bent <= 1.0;
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
