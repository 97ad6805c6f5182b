// The source `rays`: the reflections of the listed pixels, traced through the host's triangles.
// docs/techniques/ray-reflections.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/surface_table.glsl"

#include "rays/back_end.glsl"
#include "rays/rays_inputs.glsl"

#include "rays/path.glsl"

#include "rays/pixel_answer.glsl"
#include "rays/pixel_paths.glsl"
#include "rays/pixel_plan.glsl"
#include "rays/pixel_sums.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

/// Follows path number `i` of a pixel and adds what it finds.
void followSample(PixelRays from, PixelPlan plan, uint i, inout PixelSums sums) {
    Direction first = samplePixel(from, i);
    bool middle =
        first.weight <= 0.0 && i + 1u == plan.samples && sums.weights == 0.0 && !isOn(kRaysAccumulate);
    if (middle) { // all went below: use the middle of the lobe
        first = Direction(reflect(-from.V, from.N), 1.0);
        sums.light.rgb = vec3(0.0);
    }
    if (first.weight <= 0.0 && !plan.lights)
        return;
    sums.weights += first.weight;
    float regularization =
        isOn(kRaysCone) ? 1.0 // one ray finds the light of the whole lobe
                        : regularizationOf(settings.regularization, max(sums.weights, 1.0) * plan.meanOver);
    Path path = startOfSample(from, plan, i, first, middle, regularization);
    followPath(plan.fromScreen ? 1u : 0u, from.px, sampleNumber(i), path);
    if (isOn(kRaysSampleSky))
        sums.skyLight += sanitize(path.lights);
    else
        sums.light.rgb += sanitize(path.lights);
    if (first.weight > 0.0 && !plan.lightsOnly)
        addPath(path, first.weight, sums);
}

void main() {
    uint index = listedRay();
    if (index >= rays.header.rayCount)
        return;
    PixelRays from = loadPixelRays(index);
    PixelPlan plan = planPixel(from);
    PixelSums sums = startSums(from);
    for (uint i = 0u; i < plan.samples; ++i)
        followSample(from, plan, i, sums);
    if (plan.skyApart)
        storeSky(from, plan, sums.skyLight);
    if (plan.lightsOnly)
        storeNoPath(from, plan, sums.record);
    else
        storeAnswer(from, plan, sums);
}
