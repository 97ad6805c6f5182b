// A transparent surface as the reflections take it (include/glint/transparent_layer.hpp): lit, but for what comes
// through it and what it mirrors of the picture.
#include "lib/octahedral.glsl"
#include "render/lighting_bindings.glsl"
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
    beginLighting();
    Material material = drawnMaterial();
    Instance instance = instances.list[draw.constants.instance];
    SurfacePoint point = interpolatedPoint();
    if ((material.flags & kMaterialAlphaMask) != 0u && sampleBaseColor(material, point).a < material.alphaCutoff)
        discard;
    MaterialSample surface = sampleMaterial(material, point);
    vec3 V = viewVector();
    Lighting lighting = lightSurface(surface, point, V);
    if (view.constants.highlights == 0u)
        lighting.directSpecular = vec3(0.0);
    // Nothing is there where a texture cuts a shape out: no sheen below 5 % of opacity, smoothly.
    float present = saturate(surface.opacity * 20.0);
    vec3 mirrored = lighting.directSpecular + lighting.environmentSpecular + lighting.coatSpecular;
    vec3 radiance = (lighting.diffuse + lighting.emission) * surface.opacity + mirrored * present;
    mat4 localToWorld = instance.localToWorld;
    float scale = (length(localToWorld[0].xyz) + length(localToWorld[1].xyz) + length(localToWorld[2].xyz)) / 3.0;

    outRadiance = vec4(min(radiance, vec3(65000.0)), surface.opacity);
    outFallbackSpecular = vec4(min(lighting.environmentSpecular * present, vec3(65000.0)), 1.0);
    outNormal = encodeOctahedral(surface.normalWS);
    outMaterial = vec4(reflectionF0(surface, V), surface.perceptualRoughness);
    outTransmittance = vec4(surface.baseColor * (surface.transmission * surface.opacity), present);
    outAbsorption = vec4(material.attenuationColor, min(material.attenuationDistance, 65000.0));
    outBody = vec4(material.ior, min(surface.thickness * scale, 65000.0), float(instance.bodyShape), 1.0);
    outObjectCenter = vec4(instance.centerWS, 1.0);
}
