// SPDX-License-Identifier: MIT
// Inspection of one pixel's reflection: its ray, every depth sample of the ray, and the result of each source.
// Reflections::recordInspection traces the ray with the frame's own shader code. docs/inspect.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace glint {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;

/// One depth sample of a marcher. Depths are metres along the view axis; the background has infinite depth.
struct RaySample {
    Float2 positionPX = {}; ///< pixels from the top left of the screen
    /// Level of the depth pyramid. The sampled cell contains `positionPX` and is 2^level pixels wide; 0: a pixel.
    uint32_t level = 0;
    float rayDepth = 0;   ///< depth of the ray at `positionPX`; cells: where the ray enters the cell
    float sceneDepth = 0; ///< depth of the surface in the frame; cells: lower bound of it
    /// Depth of the end of the surface's slab (its thickness); cells: upper bound of it. Absent if not fetched.
    std::optional<float> slabEndDepth;
    float distance = 0; ///< metres along the ray
    /// front, behind     the ray is in front of or behind the surface: no hit
    /// empty             the cell contains no surface
    /// lookInto          the ray descends into the cell
    /// passes            tested closely: no hit
    /// hit, side, backFace   the ray ends here with this outcome, or the next, finer samples locate the hit
    /// grazes            the ray is in the slab of the surface that it starts from
    /// nearly            a slab twice as thick would give a hit
    /// places            fetched only to locate a hit exactly
    /// inferred          the ray crosses a surface behind the occluder that the pixel shows
    /// beside            fetched only to find that surface beside the occluder
    std::string_view decision;
};

/// The inspected pixel, its ray, and the results of all sources.
struct RayInspection {
    struct Fade {
        std::string_view name; ///< name of the fade: "roughness", "borderLinear", "distance", ...
        float factor = 1;
    };
    struct Source {
        std::string_view name; ///< "screen", "rays", "planar", "probes", "sky"
        float weight = 0;      ///< its share of the pixel's reflection, [0, 1]
        Float3 radiance = {};  ///< its radiance; linear, not multiplied by the weight
    };
    /// The ray's intersection with a probe's proxy, with march proxy.
    struct Projection {
        std::optional<uint32_t> probe; ///< index of the probe in the host's list; absent: no probe holds the pixel
        std::string_view proxy;        ///< "none", "box", "sphere"
        float distance = 0;            ///< metres along the ray; infinite without a proxy
    };
    struct Point {
        Float2 px = {};
        Float3 positionVS = {}; ///< metres; right-handed, looking down -Z
        Float3 positionWS = {};
        float depth = 0; ///< metres along the view axis
    };

    std::array<uint32_t, 2> pixel = {}; ///< the inspected pixel
    bool background = false;            ///< true if the pixel shows no surface; the next five are then 0
    float depth = 0;                    ///< metres along the view axis
    Float3 positionWS = {};
    Float3 normalWS = {};
    Float3 f0 = {};
    float perceptualRoughness = 0;

    bool traced = false;       ///< true if a ray was traced; if false, all members to `samples` are empty except
    std::string_view whyNoRay; ///< the reason that no ray was traced, as text
    std::string_view outcome;  ///< "hit", "offScreen", ..., as in Statistics
    /// Pixel where the ray starts. With screen.resolutionScale below 1 it may differ from `pixel`.
    std::array<uint32_t, 2> rayPixel = {};
    Point start;
    Point end; ///< the hit, or the end of the march; if infinitely far: `positionWS` at screen.maxDistance
    Float3 directionVS = {}; ///< unit
    Float3 directionWS = {};
    std::optional<Projection> projection; ///< march proxy only
    float maxLength = 0;                  ///< metres: screen.maxDistance, or the distance to the near plane
    float length = 0;                     ///< metres from start to end
    bool hit = false;                     ///< outcome "hit"
    bool answered = false; ///< true if the screen source has a result: a hit, or the side or back of a surface
    std::optional<std::array<uint32_t, 2>> hitPixel; ///< pixel from which the result's radiance was fetched
    float hitDepth = 0;                              ///< depth of the surface in the frame at `hitPixel`
    Float3 radiance = {};    ///< of the screen source's result: linear, not multiplied by the weight
    float weight = 0;        ///< of the screen source's result: the product of the fades
    std::vector<Fade> fades; ///< the active fades
    uint32_t lookups = 0;    ///< fetches from any depth image
    uint32_t iterations = 0;
    std::vector<RaySample> samples; ///< in the order of the march
    bool truncated = false;         ///< true if the march took more than kMaxRaySamples samples
    bool sameAsFrame = true;        ///< true if this trace is bit-identical to the frame's trace of this pixel

    std::vector<Source> sources; ///< sources with a result, in the order of the hierarchy, after denoising
    float totalWeight = 0;
    Float3 reflected = {};               ///< sum of weight * radiance
    std::array<float, 4> composite = {}; ///< the image with reflections, as stored
};

constexpr uint32_t kMaxRaySamples = 4096;

} // namespace glint
