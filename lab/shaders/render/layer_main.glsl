// A transparent surface as a layer for the reflections (include/glint/transparent_layer.hpp): lit, without transmitted
// light and without reflections of the frame.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

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
    outBody = vec4(s.material.ior, min(s.thickness, 65000.0), float(instance.bodyShape), s.material.dispersion);
    outObjectCenter = vec4(instance.centerWS, 1.0);
}
