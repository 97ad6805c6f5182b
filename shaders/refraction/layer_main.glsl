// A layer of transparent surfaces over the frame so far: its transmitted light, refracted, absorbed and blurred, and
// its reflections. Each ray walks through the same sources separately: screen, probes, sky.
// docs/techniques/refraction.md.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/user_response.glsl"
#include "refraction/layer_inputs.glsl"
#include "refraction/layer_light.glsl"
#include "refraction/layer_seen.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

vec3 layered(LayerSurface s, ivec2 px) {
    vec4 radiance = texelFetch(layerRadiance, px, 0);
    vec4 tint = texelFetch(layerTransmittance, px, 0);
    bool encoded = (frame.constants.flags & kInputGamma) != 0u;
    float coverage = saturate(sanitize(radiance.a));
    vec3 result = pictureAt(px) * (1.0 - coverage) + linearColor(radiance.rgb, encoded);
    vec3 response = surfaceResponse(s);
    float reflectance = saturate(maxComponent(response));
    CompositeConstants composited = frame.settings.composite;
    bool lerps = composited.model != 0u; // transmitted light is a part of what the reflection is lerped over
    vec3 through = sanitize(tint.rgb) * (lerps ? 1.0 : 1.0 - reflectance);
    bool reflects = layerHas(kLayerReflects) && maxComponent(s.here.f0) > 0.0 && tint.a > 0.0;
    Light light = followRays(s, px, reflectance, maxComponent(through) > 0.0, reflects);
    result += through * light.transmitted;
    if (reflects && lerps) {
        vec4 reflection = vec4(light.reflected, light.reflectedWeight);
        float NoV = clamp(dot(s.here.normalVS, s.toEyeVS), 0.0, 1.0);
        float f90 = edgeReflectance(maxComponent(s.here.f0));
        vec3 lerped = lerpedReflection(composited, result, reflection, s.here.f0, f90, NoV);
        result = mix(result, lerped, saturate(tint.a));
    } else if (reflects) {
        Response given = userResponse(composited, response);
        if (layerHas(kLayerFallback))
            result -= light.reflectedWeight * given.taken * linearColor(texelFetch(layerFallback, px, 0).rgb, encoded);
        result += light.reflected * given.value * saturate(tint.a);
    }
    if (layerHas(kLayerViews)) {
        imageStore(refracted, px, vec4(light.transmitted, 1.0));
        imageStore(refractionWeights, px, vec4(light.weights, 1.0));
    }
    return sanitize(result);
}

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return;
    float z = seenLayerZ(px);
    if (z >= kBackgroundZ)
        return; // the layer is not seen here
    vec3 result = layered(loadLayer(px, z), px);
    if (layerHas(kLayerCoverage))
        result = mix(pictureAt(px), result, saturate(sanitize(texelFetch(layerCoverage, px, 0).r)));
    if ((frame.constants.flags & kOutputGamma) != 0u)
        result = encodeSrgb(result);
    imageStore(composite, px, vec4(result, texelFetch(behind, px, 0).a));
}
