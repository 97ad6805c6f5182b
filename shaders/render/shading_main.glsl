// The light of an opaque or masked surface: the second half of gbuffer.mode geometry.
#include "render/lighting_bindings.glsl"
#include "render/surface_visible.glsl"

layout(location = 0) out vec4 outLitRadiance;
layout(location = 1) out vec4 outFallbackSpecular;
layout(location = 2) out vec4 outAlbedo;

void main() {
    beginLighting();
    SurfacePoint point = interpolatedPoint();
    MaterialSample surface = visibleSurface(point);
    Lighting lighting = lightSurface(surface, point, viewVector());
    if (view.constants.highlights == 0u)
        lighting.directSpecular = vec3(0.0);
    // Half floats end at 65504: an infinity would spread through every blur that comes after.
    outLitRadiance = vec4(min(totalRadiance(lighting), vec3(65000.0)), 1.0);
    outFallbackSpecular = vec4(min(lighting.environmentSpecular, vec3(65000.0)), 1.0);
    outAlbedo = vec4(surface.baseColor, 1.0);
}
