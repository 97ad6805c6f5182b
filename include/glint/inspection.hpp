// Why one pixel reflects what it does: its ray, every look that the ray took, and what each source gave.
// Reflections::recordInspection traces it with the frame's own shader code. docs/inspect.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace glint {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;

/// One read of a depth image by a marcher. Depths are metres along the view axis, of the background infinite.
struct RaySample {
    Float2 positionPX = {}; ///< on screen, from the top left
    /// Of the depth pyramid: a cell is 2^level pixels a side, that which `positionPX` lies in; 0 is the pixel itself.
    uint32_t level = 0;
    float rayDepth = 0;   ///< of the ray there; of a cell: where the ray enters it
    float sceneDepth = 0; ///< of what the picture shows; of a cell: the nearest that it may show there
    /// To where the surface reaches back, of a cell at most; only where the marcher asked.
    std::optional<float> slabEndDepth;
    float distance = 0; ///< metres along the ray
    /// front, behind     the ray is there, nothing is met
    /// empty             a cell that shows nothing
    /// lookInto          a cell that has to be looked into
    /// passes            looked at closely: nothing is met
    /// hit, side, backFace   the ray ends here with this outcome, or the next finer samples say where exactly
    /// grazes            in the slab of the surface that the ray starts from
    /// nearly            a slab twice as thick would have been met
    /// places            read only to place a hit exactly
    std::string_view decision;
};

struct RayInspection {
    struct Fade {
        std::string_view name; ///< as the setting: "roughness", "borderLinear", "distance", ...
        float factor = 1;
    };
    struct Source {
        std::string_view name; ///< "screen", "rays", "planar", "probes", "sky"
        float weight = 0;      ///< the share that it got, [0, 1]
        Float3 radiance = {};  ///< of which it gave this much; linear, not multiplied by the weight
    };
    /// Where march proxy takes a ray to end.
    struct Projection {
        std::optional<uint32_t> probe; ///< whose proxy it is, counted in the host's list; absent: none reaches here
        std::string_view proxy;        ///< "none", "box", "sphere"
        float distance = 0;            ///< metres along the ray; without a proxy infinite
    };
    struct Point {
        Float2 px = {};
        Float3 positionVS = {}; ///< metres; right-handed, looking down -Z
        Float3 positionWS = {};
        float depth = 0; ///< metres along the view axis
    };

    std::array<uint32_t, 2> pixel = {}; ///< that was asked for
    bool background = false;            ///< it shows no surface; the next five are 0 then
    float depth = 0;                    ///< metres along the view axis
    Float3 positionWS = {};
    Float3 normalWS = {};
    Float3 f0 = {};
    float perceptualRoughness = 0;

    bool traced = false;                   ///< there is a ray; else all down to `samples` is empty, and
    std::string_view whyNoRay;             ///< says why, in words
    std::string_view outcome;              ///< "hit", "offScreen", ..., as in Statistics
    std::array<uint32_t, 2> rayPixel = {}; ///< where the ray starts: another one with screen.resolutionScale below 1
    Point start;
    Point end; ///< of the hit, or where the march ended; infinitely far: `positionWS` at screen.maxDistance
    Float3 directionVS = {}; ///< unit
    Float3 directionWS = {};
    std::optional<Projection> projection; ///< of march proxy alone
    float maxLength = 0;                  ///< metres: screen.maxDistance, or to the near plane
    float length = 0;                     ///< metres from start to end
    bool hit = false;                     ///< outcome "hit"
    bool answered = false;                ///< the screen source has an answer: a hit, or the side or back of a surface
    std::optional<std::array<uint32_t, 2>> hitPixel; ///< from which the answer's radiance was taken
    float hitDepth = 0;                              ///< of what the picture shows there
    Float3 radiance = {};                            ///< of the answer: linear, not multiplied by the weight
    float weight = 0;                                ///< of the answer: the product of the fades
    std::vector<Fade> fades;                         ///< those that act
    uint32_t lookups = 0;                            ///< reads of any depth image
    uint32_t iterations = 0;
    std::vector<RaySample> samples; ///< in the order of the march
    bool truncated = false;         ///< there were more than kMaxRaySamples
    bool sameAsFrame = true;        ///< this trace left the very bits that the frame had left for this pixel

    std::vector<Source> sources; ///< that gave something, in the order of the hierarchy, after any denoising
    float totalWeight = 0;
    Float3 reflected = {};               ///< sum of weight * radiance
    std::array<float, 4> composite = {}; ///< the picture with reflections, as stored
};

constexpr uint32_t kMaxRaySamples = 4096;

} // namespace glint
