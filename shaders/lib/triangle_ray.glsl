// Intersects a ray with a triangle without cracks: rays through a shared edge or vertex hit at least one of its
// triangles. Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1).
#ifndef GLINT_LIB_TRIANGLE_RAY_GLSL
#define GLINT_LIB_TRIANGLE_RAY_GLSL

/// A ray with permuted axes: z is the largest component of its direction.
struct ShearedRay {
    vec3 origin;
    uint longest; // axis, 0 to 2
    vec3 shear;   // moves points onto the ray's z axis: x/z and y/z of the direction, and 1/z
};

struct TriangleHit {
    float distance;    // in lengths of the direction; NaN or any value where `met` is false
    vec2 barycentrics; // weights of the second and third vertex
    bool frontFace;    // counter-clockwise as seen from the origin
    bool met;
};

/// A cyclic permutation keeps handedness; `frontFace` replaces the paper's extra swap for negative z.
vec3 longestLast(vec3 v, uint longest) {
    return longest == 2u ? v : longest == 0u ? v.yzx : v.zxy;
}

ShearedRay shearRay(vec3 origin, vec3 direction) {
    vec3 size = abs(direction);
    ShearedRay ray;
    ray.origin = origin;
    ray.longest = size.x > size.y ? (size.x > size.z ? 0u : 2u) : (size.y > size.z ? 1u : 2u);
    vec3 d = longestLast(direction, ray.longest);
    ray.shear = vec3(d.xy, 1.0) / d.z;
    return ray;
}

/// `normal`: any length, as exact as available. The paper's distance, a mean of the vertices' distances by their
/// weights, loses digits on long thin triangles. The plane through the vertex of largest weight keeps them, and makes
/// the distance on axis-aligned planes exact. Where the ray runs along the plane the vertices' own range bounds the
/// distance.
///
/// `precise`: an edge that two triangles share must give exactly opposite signs in both, so fused multiply-adds are not
/// allowed. An edge value of 0 counts as inside for both triangles. The paper recomputes such a value in double
/// precision to tell which of the two is hit, which does not matter here. Degenerate triangles and NaN are not hit.
TriangleHit intersectTriangle(ShearedRay ray, vec3 v0, vec3 v1, vec3 v2, vec3 normal) {
    precise vec3 a = longestLast(v0 - ray.origin, ray.longest);
    precise vec3 b = longestLast(v1 - ray.origin, ray.longest);
    precise vec3 c = longestLast(v2 - ray.origin, ray.longest);
    precise vec2 p = a.xy - ray.shear.xy * a.z;
    precise vec2 q = b.xy - ray.shear.xy * b.z;
    precise vec2 r = c.xy - ray.shear.xy * c.z;
    precise float u = r.x * q.y - r.y * q.x;
    precise float v = p.x * r.y - p.y * r.x;
    precise float w = q.x * p.y - q.y * p.x;
    float determinant = u + v + w;

    TriangleHit hit;
    hit.met = ((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)) && determinant != 0.0;
    float inverse = 1.0 / determinant;
    hit.barycentrics = vec2(v, w) * inverse;
    hit.frontFace = (determinant > 0.0) == (ray.shear.z > 0.0);

    vec3 n = longestLast(normal, ray.longest);
    vec3 nearby = abs(u) > max(abs(v), abs(w)) ? a : abs(v) > abs(w) ? b : c;
    float z = dot(n, nearby) / dot(n, vec3(ray.shear.xy, 1.0));
    z = z < min(min(a.z, b.z), c.z) ? min(min(a.z, b.z), c.z) : z;
    z = z > max(max(a.z, b.z), c.z) ? max(max(a.z, b.z), c.z) : z;
    hit.distance = z * ray.shear.z;
    return hit;
}

#endif
