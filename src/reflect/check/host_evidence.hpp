// A host's samples, under every declaration that it could have made, as evidence for the rules (check/rules.hpp).
// Decodes with the same constants as the passes (prepare/conventions.hpp).
#pragma once

#include "check/rules.hpp"
#include "glint/gbuffer.hpp"
#include "glint/view.hpp"
#include "shared/frame_constants.h"
#include "shared/input_check.h"

#include <vector>

namespace glint::reflect {

/// A regular grid of at most kMostInputSamples pixels, none of them on the image's border.
struct SampleGrid {
    glm::uvec2 count;
    uint32_t stride;

    static SampleGrid over(const glm::uvec2& extent);
    uint32_t samples() const { return count.x * count.y; }
    glm::uvec2 pixel(uint32_t sample) const { return 1u + stride * glm::uvec2(sample % count.x, sample / count.x); }
};

/// The camera of a frame and the pixels that the frame uses.
struct FrameCamera {
    View view;
    glm::uvec2 extent;
};

class HostEvidence : public check::Evidence {
public:
    /// `samples`: of the whole grid; must outlive this object.
    HostEvidence(const FrameCamera& camera, const Conventions& conventions, const SampleGrid& grid,
                 std::span<const shared::InputSample> samples);

    size_t samples() const override { return places_.size(); }
    check::Advice advice() const override;
    size_t readings() const override { return readings_.size(); }
    int changes(size_t reading) const override { return readings_[reading].changes; }
    bool samePositions(size_t a, size_t b) const override { return readings_[a].geometry == readings_[b].geometry; }
    std::string differences(size_t reading) const override;
    glm::vec3 positionVS(size_t reading, size_t sample, int dx, int dy) const override;
    glm::vec3 normalWS(size_t reading, size_t sample) const override;
    float normalLength(size_t reading, size_t sample) const override;
    glm::mat3 worldToView(size_t reading) const override;
    glm::vec3 toCameraVS(size_t reading, const glm::vec3& positionVS) const override;
    glm::vec2 planes(size_t reading) const override;
    bool seesTurnOfCamera() const override { return declared_.normalSpace == NormalSpace::World; }

    glm::vec3 positionWS(size_t reading, size_t sample) const;
    glm::vec3 eyeWS(size_t reading) const;
    /// Roughness as stored, scaled and biased.
    std::vector<float> roughness(const MaterialChannel& stated) const;
    std::vector<check::Motion> motions(size_t reading, const FrameCamera& previous) const;
    std::vector<check::DepthMotion> depthMotions(size_t reading, const FrameCamera& previous) const;

private:
    /// What differs from the declarations beside `conventions`.
    struct Matrices {
        bool inverseView = false;    ///< worldToView is the inverse of a view to world matrix
        bool transposedClip = false; ///< viewToClip
        bool otherOrder = false;     ///< viewToClip is reversed and depth is not, or the other way round
    };
    struct Reading {
        Conventions conventions;
        Matrices matrices;
        bool inward = false; ///< normals point into the surfaces
        int changes = 0;
        size_t geometry = 0; ///< equal: the same positions
        shared::FrameConstants frame = {};
    };

    void makeReadings();
    void addNormals(Reading geometry);
    shared::FrameConstants frameOf(const Reading& reading, const FrameCamera& camera) const;
    glm::vec3 decoded(const Reading& reading, size_t sample) const;
    const shared::InputSample& stored(size_t sample) const { return samples_[places_[sample]]; }

    FrameCamera camera_;
    Conventions declared_;
    SampleGrid grid_;
    std::span<const shared::InputSample> samples_;
    std::vector<uint32_t> places_; ///< in the grid: those that may show a surface
    std::vector<Reading> readings_;
};

/// "motionScale {-1, -1}"
std::string nameOfMotion(const check::MotionUnit& unit, const glm::uvec2& extent);

} // namespace glint::reflect
