// A transparent surface as the reflections take it (include/glint/transparent_layer.hpp): lit, but for what comes
// through it and what it mirrors of the picture.
#include "lib/octahedral.glsl"
#include "render/transparent_surface.glsl"
#include "shared/refraction.h"

layout(location = 0) out vec4 outRadiance;
layout(location = 1) out vec4 outFallbackSpecular;
layout(location = 2) out vec2 outNormal;
layout(location = 3) out vec4 outMaterial;
layout(location = 4) out vec4 outTransmittance;
layout(location = 5) out vec4 outAbsorption;
layout(location = 6) out vec4 outBody;
layout(location = 7) out vec4 outObjectCenter;

void main() {
    TransparentSurface s = transparentSurface();
    Instance instance = instances.list[draw.constants.instance];
    vec3 radiance = (s.lighting.diffuse + s.lighting.emission) * s.surface.opacity + s.mirrored * s.present;

    outRadiance = vec4(min(radiance, vec3(65000.0)), s.surface.opacity);
    outFallbackSpecular = vec4(min(s.lighting.environmentSpecular * s.present, vec3(65000.0)), 1.0);
    outNormal = encodeOctahedral(s.surface.normalWS);
    outMaterial = vec4(reflectionF0(s.surface, s.V), s.surface.perceptualRoughness);
    outTransmittance = vec4(s.surface.baseColor * (s.surface.transmission * s.surface.opacity), s.present);
    outAbsorption = vec4(s.material.attenuationColor, min(s.material.attenuationDistance, 65000.0));
    outBody = vec4(s.material.ior, min(s.thickness, 65000.0), float(instance.bodyShape), 1.0);
    outObjectCenter = vec4(instance.centerWS, 1.0);
}
