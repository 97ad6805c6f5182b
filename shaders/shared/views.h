// The debug views of the library, one row each (Reflections::recordView). From these rows come the values
// (composite/view.comp), the library's list of names, how the programs show a view, and docs/views.md.
//
//   X(name, kind, channels, meaning, value)
//   kind      how values become colours: Radiance, Fraction, Direction, Distance or Count (ViewKind)
//   channels  the meaningful channels, named as in an EXR file
//   value     an expression over the names of viewValue in composite/view.comp: float, vec2, vec3 or vec4
#ifndef GLINT_SHARED_VIEWS_H
#define GLINT_SHARED_VIEWS_H

// clang-format off
#define GLINT_VIEWS(X) \
    X(reflection, Radiance, "RGB", "reflected radiance, all sources together", texelFetch(reflected, px, 0).rgb) \
    X(weight, Fraction, "Y", "weight of the screen-space answer", texelFetch(radianceWeight, px, 0).a) \
    X(weights, Fraction, "RGBA", "weight of each source: screen, sky, rays, probes", \
      vec4(sourceWeight(shares, kSourceScreen), sourceWeight(shares, kSourceSky), sourceWeight(shares, kSourceRays), \
           sourceWeight(shares, kSourceProbes))) \
    X(source, Fraction, "RGB", \
      "which source answered most: green screen, orange rays, yellow planar, violet probes, blue sky", \
      sourceColor(shares)) \
    X(outcome, Fraction, "RGB", "how each ray ended, as colours", outcomeColor(ray, frame.settings.trace.maxSteps)) \
    X(normal, Direction, "XYZ", "world-space normal", \
      background ? vec3(0.0) : mat3(frame.constants.viewToWorld) * here.normalVS) \
    X(depth, Distance, "Z", "metres along the view axis", background ? 0.0 : z) \
    X(roughness, Fraction, "Y", "perceptual roughness", background ? 0.0 : here.perceptualRoughness) \
    X(reflectivity, Fraction, "RGB", "F0", \
      background ? vec3(0.0) : resolvedMaterial(frame.constants, texelFetch(material, px, 0)).rgb) \
    X(hitUV, Fraction, "UV", "where on the screen the ray hit", hit ? ray.hitUV : vec2(0.0)) \
    X(hitDistance, Distance, "Z", "metres along the ray to its hit", hit ? ray.hitDistance : 0.0) \
    X(lookups, Count, "Y", "depth reads of the ray", float(ray.lookups)) \
    X(rayDirWS, Direction, "XYZ", "world-space direction of the mirror ray", \
      background ? vec3(0.0) : rayDirectionWS(px, here, z)) \
    X(color, Radiance, "RGB", "radiance that the screen source found", foundRadiance(px)) \
    X(hitDepth, Distance, "Z", "metres along the view axis to the surface that the ray hit", hit ? hitDepth(ray) : 0.0) \
    X(hitSuccess, Fraction, "RGB", "light green: hit, light blue: failed, yellow: a side or back, black: no ray", \
      successColor(ray.outcome)) \
    X(probes, Radiance, "RGB", "radiance that the probes answered with", \
      answerOf(kSourceProbes, probesAnswer, shares, px)) \
    X(weightRays, Fraction, "Y", "share of the rays", sourceWeight(shares, kSourceRays)) \
    X(weightProbes, Fraction, "Y", "share of the probes", sourceWeight(shares, kSourceProbes)) \
    X(weightSky, Fraction, "Y", "share of the environment", sourceWeight(shares, kSourceSky)) \
    X(planar, Radiance, "RGB", "radiance that the planar mirrors answered with", \
      answerOf(kSourcePlanar, planarAnswer, shares, px)) \
    X(weightPlanar, Fraction, "Y", "share of the planar mirrors", sourceWeight(shares, kSourcePlanar)) \
    X(refraction, Radiance, "RGB", "radiance that comes through the nearest transparent layer", \
      texelOfLayer(refracted, px)) \
    X(refractionWeights, Fraction, "RGB", "where it is from: screen, probes, sky", \
      texelOfLayer(refractionWeights, px)) \
    X(historyFrames, Count, "Y", "frames that the denoised answer is a mean of", \
      denoised != 0u ? texelFetch(historyMeta, px, 0).x : 0.0) \
    X(antilag, Fraction, "Y", "share of the last mean's frames given up because light changed", \
      denoised != 0u ? historyGivenUp(px) : 0.0) \
    X(raySent, Fraction, "Y", "white: a ray was sent from here and denoised, grey: its neighbours' rays are taken", \
      denoised != 0u ? raySent(px) : 0.0) \
    X(ray, Fraction, "RGBA", "for programs: hitUV, number of the outcome, lookups", \
      vec4(ray.hitUV, float(ray.outcome), float(ray.lookups)))
// clang-format on

#endif
