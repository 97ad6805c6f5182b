// What the rules (rules.hpp) ask of a G-buffer, stored in a file or in a host's images: its samples, and every meaning
// that the stored values may have.
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <string_view>

namespace glint::check {

/// Fewer samples say nothing.
constexpr size_t kFewestSamples = 50;

/// Ends of findings: what to do, in the terms of whoever declared the meaning.
struct Advice {
    std::string_view nothingAgrees;
    std::string_view turnedCamera;
    std::string_view unitLength;
    std::string_view facing;
    std::string_view range;
    std::string_view otherCamera = {};
};

/// Samples of a G-buffer whose stored depth may be that of a surface. View space is Glint's: right-handed, +Y up, the
/// camera looks down -Z; metres.
class Evidence {
public:
    virtual ~Evidence() = default;

    virtual size_t samples() const = 0;
    virtual Advice advice() const = 0;

    /// The number of readings: combinations of meanings. 0 is the declared one. Readings with the same positions follow
    /// each other.
    virtual size_t readings() const = 0;
    /// Declarations that differ from the declared ones.
    virtual int changes(size_t reading) const = 0;
    virtual bool samePositions(size_t a, size_t b) const = 0;
    /// "normal.space view, not world as declared and ..."
    virtual std::string differences(size_t reading) const = 0;

    /// Position of a sample's pixel, or of the pixel `dx`, `dy` in [-1, 1] beside it; not both other than 0. z is 0 if
    /// the reading has no surface there.
    virtual glm::vec3 positionVS(size_t reading, size_t sample, int dx, int dy) const = 0;
    /// Unit length; (0, 0, 0) if the stored value has no direction.
    virtual glm::vec3 normalWS(size_t reading, size_t sample) const = 0;
    /// Length of the stored normal.
    virtual float normalLength(size_t reading, size_t sample) const = 0;
    virtual glm::mat3 worldToView(size_t reading) const = 0;
    /// Unit direction to the camera.
    virtual glm::vec3 toCameraVS(size_t reading, const glm::vec3& positionVS) const = 0;
    /// Distances of the near and the far plane; infinite if there is none.
    virtual glm::vec2 planes(size_t reading) const = 0;
    /// True if the declared normals are in the world and positions are not, so that a wrong camera turns one alone.
    virtual bool seesTurnOfCamera() const = 0;
};

} // namespace glint::check
