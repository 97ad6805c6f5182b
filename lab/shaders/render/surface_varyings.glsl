// Varyings from a surface's vertex stage to its fragment stage. Define VARYING as `out` or `in` first. Centroid: with
// several samples a pixel, a normal is not extrapolated beyond its surface's edge, where it would turn away from the
// eye and shine. Texture coordinates are extrapolated, because their differences select the mip.
layout(location = 0) centroid VARYING vec3 positionWS;
layout(location = 1) centroid VARYING vec3 normalWS;
layout(location = 2) centroid VARYING vec4 tangentWS;
layout(location = 3) VARYING vec4 uv01;
layout(location = 4) VARYING vec4 color;
layout(location = 5) VARYING vec4 currentCS; // clip-space positions in this frame and the previous one, for motion
layout(location = 6) VARYING vec4 previousCS;
layout(location = 7) VARYING float depthMotion; // viewZ in the previous frame - viewZ in this one, metres
