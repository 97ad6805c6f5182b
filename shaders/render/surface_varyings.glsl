// What the vertex stage of a surface hands to its fragment stage. Define VARYING as `out` or `in` first.
layout(location = 0) VARYING vec3 positionWS;
layout(location = 1) VARYING vec3 normalWS;
layout(location = 2) VARYING vec4 tangentWS;
layout(location = 3) VARYING vec4 uv01;
layout(location = 4) VARYING vec4 color;
layout(location = 5) VARYING vec4 currentCS; // this frame's and the last frame's place on the screen, for motion
layout(location = 6) VARYING vec4 previousCS;
