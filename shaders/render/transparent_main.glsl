// A blended or light-transmitting surface over the picture so far. Premultiplied: what is mirrored in a pane of glass
// does not fade with the pane.
#include "lib/transmission.glsl"
#include "render/lighting_bindings.glsl"

layout(set = 0, binding = 10) uniform sampler2D behind; // the picture without transparent surfaces, with mips

layout(location = 0) out vec4 outRadiance;

/// What comes through: the picture behind, where the refracted light leaves the volume, blurred by roughness.
vec3 transmittedRadiance(Material material, MaterialSample surface, vec3 V) {
    mat4 localToWorld = instances.list[draw.constants.instance].localToWorld;
    float scale = (length(localToWorld[0].xyz) + length(localToWorld[1].xyz) + length(localToWorld[2].xyz)) / 3.0;
    vec3 path = refractedPath(surface.normalWS, V, material.ior, surface.thickness * scale);
    vec4 exitCS = view.constants.worldToClip * vec4(positionWS + path, 1.0);
    vec2 exitUV = exitCS.xy / exitCS.w * vec2(0.5, -0.5) + 0.5;
    float mip =
        log2(float(textureSize(behind, 0).x)) * transmissionRoughness(surface.perceptualRoughness, material.ior);
    vec3 transmittance = volumeTransmittance(length(path), material.attenuationColor, material.attenuationDistance);
    vec2 dfg = loadDfg(clampedNoV(surface.normalWS, V), surface.perceptualRoughness);
    vec3 reflected = specularResponse(surface.dielectricF0, surface.dielectricF90, dfg);
    return textureLod(behind, exitUV, mip).rgb * transmittance * surface.baseColor *
           (surface.transmission * (1.0 - saturate(maxComponent(reflected))));
}

void main() {
    beginLighting();
    Material material = drawnMaterial();
    SurfacePoint point = interpolatedPoint();
    if ((material.flags & kMaterialAlphaMask) != 0u && sampleBaseColor(material, point).a < material.alphaCutoff)
        discard;
    MaterialSample surface = sampleMaterial(material, point);
    vec3 V = viewVector();
    Lighting lighting = lightSurface(surface, point, V);
    if (view.constants.highlights == 0u)
        lighting.directSpecular = vec3(0.0);
    vec3 body = lighting.diffuse + lighting.emission;
    if (surface.transmission > 0.0)
        body += transmittedRadiance(material, surface, V);
    vec3 mirrored = lighting.directSpecular + lighting.environmentSpecular + lighting.coatSpecular;
    // Nothing is there where a texture cuts a shape out: no sheen below 5 % of opacity, smoothly.
    float present = saturate(surface.opacity * 20.0);
    outRadiance = vec4(min(body * surface.opacity + mirrored * present, vec3(65000.0)), surface.opacity);
}
