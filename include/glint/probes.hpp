// SPDX-License-Identifier: MIT
// Reflection probes: cube maps that the host drew from places in its world, each with the volume in which it answers
// for reflections. Optional. docs/techniques/probes.md.
#pragma once

#include "glint/api.h"
#include "glint/context.hpp"
#include "glint/gbuffer.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace glint {

namespace reflect {
class ProbesState;
}

enum class ProbeShape : uint8_t { Box, Sphere };

/// What a probe's picture is taken to lie on, which puts reflections where they belong (parallax correction).
enum class ProbeProxy : uint8_t {
    Infinite, ///< infinitely far away: no parallax correction
    Box,
    Sphere,
};

/// A box or a sphere in the world.
struct ProbeVolume {
    std::array<float, 3> centerWS = {0, 0, 0};
    std::array<float, 4> rotation = {0, 0, 0, 1}; ///< unit quaternion x, y, z, w: from the volume's axes to the world's
    std::array<float, 3> halfExtents = {1, 1,
                                        1}; ///< metres, > 0, along the volume's axes; a sphere's [0] is its radius
};

/// Arrays of six go over the influence volume's faces: +X, -X, +Y, -Y, +Z, -Z. A sphere has [0] alone, but for
/// faceFade.
struct Probe {
    /// Radiance around `capturePositionWS`, linear, faces and axes as Vulkan's cube maps have them. With `prefiltered`
    /// as EnvironmentMap::cube, and Glint reads this very image, in SHADER_READ_ONLY_OPTIMAL; else mip 0 counts and
    /// Glint filters it into a cube of its own (Probes::record).
    HostImage cube;
    uint32_t mips = 1; ///< of `cube`
    bool prefiltered = false;
    /// The cube's alpha is 1 / metres from the capture position to what it shows, 0 for the sky: rays are then followed
    /// to what they meet in the picture itself, and the proxy is for what it hides. Filtered like the radiance.
    bool alphaIsInverseDistance = false;
    std::array<float, 3> capturePositionWS = {0, 0, 0}; ///< where its faces were drawn from
    float strength = 1;                                 ///< factor on its radiance, >= 0
    float weight = 1;                                   ///< factor on its weight, [0, 1]

    ProbeShape shape = ProbeShape::Box;
    ProbeVolume influence; ///< surfaces outside get nothing of this probe
    /// Metres inward from each face over which the weight rises from 0 to 1 (smoothly); 0: a hard edge.
    std::array<float, 6> blendDistance = {0, 0, 0, 0, 0, 0};
    /// Metres inward from each face within which surfaces that face away from the capture position get less, so that
    /// the outer sides of a room's walls keep out of the room; 0: none.
    std::array<float, 6> blendNormalDistance = {0, 0, 0, 0, 0, 0};
    /// Weight of reflections that go out through each face, [0, 1].
    std::array<float, 6> faceFade = {1, 1, 1, 1, 1, 1};

    ProbeProxy proxy = ProbeProxy::Box;
    ProbeVolume proxyVolume;
};

constexpr uint32_t kMaxProbes = 4096;

struct ProbesDesc {
    std::span<const Probe> probes;
    uint32_t faceSize =
        0; ///< texels, of the cubes that Glint filters, [16, 1024]; 0: each host cube's own. Power of two
};

/// Each pixel looks at the probes of one cell of a grid over all volumes, smallest volume first.
/// Threading: external synchronisation.
class GLINT_API Probes {
public:
    /// Copies all but the host's images, which stay while they are read: prefiltered ones until the frames are done,
    /// others until the record that filters them is.
    /// Errors: InvalidArgument names the probe and what is wrong with it; OutOfMemory.
    static Result<Probes> create(Context& context, const ProbesDesc& desc);
    ~Probes();
    Probes(Probes&&) noexcept;
    Probes& operator=(Probes&&) noexcept;

    uint32_t count() const;

    /// Volumes, weights, strengths and capture positions anew, as many as there are; the cubes stay (`cube`, `mips` and
    /// `prefiltered` are not looked at). Takes effect with the next record. Errors: InvalidArgument as in create.
    Result<void> setVolumes(std::span<const Probe> probes);
    /// The host has drawn this probe's cube anew: the next record filters it. Nothing for prefiltered ones.
    void refilter(uint32_t probe);

    /// Records what create and the calls above left to do, outside of rendering, before Reflections::record; nothing if
    /// there is nothing. Filtering takes a few hundred lookups a texel; a probe of 128 texels is 0.2 million texels.
    /// Never submits or waits.
    void record(VkCommandBuffer commands);

    /// The filtered cube that is looked up, for a host that keeps it: mip 0 for mirrors, the last mip for roughness 1.
    /// RGBA16F with TRANSFER_SRC, or the host's own. Valid after record.
    HostImage cube(uint32_t probe) const;
    uint32_t cubeMips(uint32_t probe) const;

    reflect::ProbesState& state() { return *state_; } ///< for Glint's own classes

private:
    explicit Probes(std::unique_ptr<reflect::ProbesState> state);
    std::unique_ptr<reflect::ProbesState> state_;
};

} // namespace glint
