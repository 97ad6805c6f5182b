#include "reflect/check/host_evidence.hpp"

#include "base/format.hpp"
#include "base/text.hpp"
#include "reflect/prepare/conventions.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glint::reflect {
namespace {

/// Declarations that may be wrong at once: more would explain any image.
constexpr int kMostChanges = 4;

constexpr std::array<std::string_view, 4> kEncodings = {"Signed", "Unorm", "Octahedral", "OctahedralUnorm"};

bool isOctahedral(NormalEncoding encoding) {
    return encoding == NormalEncoding::Octahedral || encoding == NormalEncoding::OctahedralUnorm;
}

bool isUnorm(NormalEncoding encoding) {
    return encoding == NormalEncoding::Unorm || encoding == NormalEncoding::OctahedralUnorm;
}

/// As lib/octahedral.glsl: Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".
glm::vec3 decodeOctahedral(const glm::vec2& p) {
    glm::vec3 direction(p, 1 - std::abs(p.x) - std::abs(p.y));
    if (direction.z < 0) {
        const float x = (1 - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f);
        direction.y = (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f);
        direction.x = x;
    }
    return glm::normalize(direction);
}

/// As viewZFromDepth of lib/camera.glsl; 0 for the background.
float viewZOf(const shared::FrameConstants& frame, float depth) {
    float z = depth * frame.depthScale;
    if ((frame.flags & shared::kInputLinearDepth) == 0) {
        const bool reversed = (frame.flags & shared::kInputReversedDepth) != 0;
        if (reversed ? depth <= frame.farDepth : depth >= frame.farDepth)
            return 0;
        const float ndc = depth * frame.depthScale + frame.depthOffset;
        z = (ndc * frame.depthToViewZ.x + frame.depthToViewZ.y) / (ndc * frame.depthToViewZ.z + frame.depthToViewZ.w);
    }
    constexpr float kFarthest = 1e9f;
    return z > 0 && z < kFarthest ? z : 0;
}

glm::vec3 positionOf(const shared::FrameConstants& frame, const glm::vec2& pixel, float viewZ) {
    const glm::vec2 uv = (pixel + 0.5f) * frame.invSize;
    const float scale = (frame.flags & shared::kInputOrthographic) != 0 ? 1 : viewZ;
    const glm::vec3 position((uv * glm::vec2(frame.uvToView) + glm::vec2(frame.uvToView.z, frame.uvToView.w)) * scale,
                             -viewZ);
    return std::isfinite(position.x + position.y) ? position : glm::vec3(0);
}

glm::vec2 pixelOf(const shared::FrameConstants& frame, const glm::vec3& positionVS) {
    const glm::vec4 pixel = frame.viewToPixel * glm::vec4(positionVS, 1);
    return glm::vec2(pixel) / pixel.w;
}

/// The clip matrix of the other order of depth: what was 0 becomes 1.
glm::mat4 otherOrder(glm::mat4 viewToClip, bool minusOneToOne) {
    for (int column = 0; column < 4; ++column)
        viewToClip[column].z = (minusOneToOne ? 0 : viewToClip[column].w) - viewToClip[column].z;
    return viewToClip;
}

Matrix4 toMatrix4(const glm::mat4& matrix) {
    Matrix4 out;
    std::copy_n(glm::value_ptr(matrix), out.size(), out.begin());
    return out;
}

bool isPerspective(const glm::mat4& viewToClip) {
    return viewToClip[2].w != 0;
}

/// Jitter and lens shift of `to` become those of `from`: motion is without jitter.
void copyOffset(const glm::mat4& from, glm::mat4& to) {
    const int column = isPerspective(to) ? 2 : 3;
    to[column].x = from[column].x;
    to[column].y = from[column].y;
}

} // namespace

SampleGrid SampleGrid::over(const glm::uvec2& extent) {
    SampleGrid grid = {{0, 0}, 1};
    if (extent.x < 3 || extent.y < 3)
        return grid;
    const glm::uvec2 inner = extent - 2u;
    for (;; ++grid.stride) {
        grid.count = (inner + grid.stride - 1u) / grid.stride;
        if (uint64_t{grid.count.x} * grid.count.y <= shared::kMostInputSamples)
            return grid;
    }
}

HostEvidence::HostEvidence(const FrameCamera& camera, const Conventions& conventions, const SampleGrid& grid,
                           std::span<const shared::InputSample> samples)
    : camera_(camera), declared_(conventions), grid_(grid), samples_(samples) {
    // 0 and 1 are the backgrounds of every kind of depth. What is a surface depends on the reading.
    for (uint32_t i = 0; i < grid.samples(); ++i)
        if (const float depth = samples[i].depth[0]; std::isfinite(depth) && depth != 0 && depth != 1)
            places_.push_back(i);
    makeReadings();
}

check::Advice HostEvidence::advice() const {
    return {
        "check View::worldToView, View::viewToClip, and that depth and normals are of the frame that View describes",
        "check View::worldToView, and that the normals have its world",
        "Glint needs the normal of one surface in each pixel, not resolved and not filtered",
        "Glint needs normals that are turned to the camera",
        "correct Conventions::linearDepthScale or View::viewToClip"};
}

void HostEvidence::makeReadings() {
    const glm::mat4 toClip = glm::make_mat4(camera_.view.viewToClip.data());
    const glm::mat3 rotation(glm::make_mat4(camera_.view.worldToView.data()));
    const glm::mat3 turned = glm::transpose(rotation) - rotation;
    const bool symmetric = glm::dot(turned[0], turned[0]) + glm::dot(turned[1], turned[1]) < 1e-4f;
    std::vector<Reading> all = {Reading{declared_}};
    const auto vary = [&](auto... changes) {
        std::vector<Reading> varied;
        for (const Reading& reading : all) {
            varied.push_back(reading);
            const auto add = [&](auto change) {
                Reading other = reading;
                other.changes += change(other);
                varied.push_back(other);
            };
            (add(changes), ...);
        }
        all = std::move(varied);
    };
    if (isPerspective(glm::transpose(toClip)))
        vary([](Reading& r) { return r.matrices.transposedClip = true, 1; });
    if (!symmetric)
        vary([](Reading& r) { return r.matrices.inverseView = true, 1; });
    vary([](Reading& r) { return r.conventions.clipYDown = !r.conventions.clipYDown, 1; });
    vary([](Reading& r) {
        r.conventions.handedness = r.conventions.handedness == Handedness::Left ? Handedness::Right : Handedness::Left;
        return 1;
    });
    const auto otherRange = [](Reading& r) {
        return r.conventions.depthMinusOneToOne = !r.conventions.depthMinusOneToOne, 1;
    };
    const auto reordered = [](Reading& r) { return r.matrices.otherOrder = true, 1; };
    const auto both = [&](Reading& r) { return otherRange(r) + reordered(r); };
    const auto linearOrDevice = [](DepthKind kind, float scale) {
        return [=](Reading& r) { return r.conventions.depth = kind, r.conventions.linearDepthScale = scale, 1; };
    };
    const float sign = declared_.linearDepthScale < 0 ? -1.0f : 1.0f;
    if (declared_.depth == DepthKind::Device) {
        vary(otherRange, reordered, both, linearOrDevice(DepthKind::LinearViewZ, 1),
             linearOrDevice(DepthKind::LinearViewZ, -1));
    } else {
        const auto device = linearOrDevice(DepthKind::Device, declared_.linearDepthScale);
        vary(
            linearOrDevice(DepthKind::LinearViewZ, -sign), device,
            [=](Reading& r) { return device(r) + otherRange(r); }, [=](Reading& r) { return device(r) + reordered(r); },
            [=](Reading& r) { return device(r) + both(r); });
    }
    for (Reading& reading : all) {
        if (reading.changes > kMostChanges)
            continue;
        reading.geometry = readings_.size();
        reading.frame = frameOf(reading, camera_);
        addNormals(reading);
    }
}

/// The meanings of normals; the declared one first.
void HostEvidence::addNormals(Reading geometry) {
    for (const bool inward : {false, true})
        for (const NormalSpace space : {NormalSpace::World, NormalSpace::View})
            for (size_t encoding = 0; encoding < kEncodings.size(); ++encoding) {
                Reading reading = geometry;
                reading.inward = inward;
                reading.conventions.normalSpace = space;
                reading.conventions.normalEncoding = static_cast<NormalEncoding>(encoding);
                reading.changes += inward + (space != declared_.normalSpace) +
                                   (reading.conventions.normalEncoding != declared_.normalEncoding);
                if (reading.changes > kMostChanges)
                    continue;
                readings_.push_back(reading);
                if (reading.changes == geometry.changes) // the first of its geometry
                    std::swap(readings_.back(), readings_[geometry.geometry]);
            }
}

shared::FrameConstants HostEvidence::frameOf(const Reading& reading, const FrameCamera& camera) const {
    View view = camera.view;
    glm::mat4 toClip = glm::make_mat4(view.viewToClip.data());
    if (reading.matrices.transposedClip)
        toClip = glm::transpose(toClip);
    if (reading.matrices.otherOrder)
        toClip = otherOrder(toClip, reading.conventions.depthMinusOneToOne);
    view.viewToClip = toMatrix4(toClip);
    if (reading.matrices.inverseView)
        view.worldToView = toMatrix4(glm::inverse(glm::make_mat4(view.worldToView.data())));
    return makeFrameConstants(view, reading.conventions, camera.extent.x, camera.extent.y);
}

std::string HostEvidence::differences(size_t reading) const {
    const Reading& found = readings_[reading];
    const Conventions& now = found.conventions;
    std::vector<std::string> parts;
    const auto add = [&](bool differs, std::string_view text) {
        if (differs)
            parts.emplace_back(text);
    };
    const bool linear = now.depth == DepthKind::LinearViewZ;
    const auto sign = [](float scale) { return scale < 0 ? "negative" : "positive"; };
    if (now.depth != declared_.depth)
        parts.push_back(linear ? formatText("DepthKind::LinearViewZ and a {} linearDepthScale, not Device as declared",
                                            sign(now.linearDepthScale))
                               : "DepthKind::Device, not LinearViewZ as declared");
    else if (linear && (now.linearDepthScale < 0) != (declared_.linearDepthScale < 0))
        parts.push_back(formatText("a {} linearDepthScale, not a {} one as declared", sign(now.linearDepthScale),
                                   sign(declared_.linearDepthScale)));
    if (now.depthMinusOneToOne != declared_.depthMinusOneToOne)
        parts.push_back(formatText("depthMinusOneToOne {}, not {} as declared", now.depthMinusOneToOne,
                                   declared_.depthMinusOneToOne));
    if (found.matrices.otherOrder) {
        const bool reversed = (found.frame.flags & shared::kInputReversedDepth) != 0;
        parts.emplace_back(reversed ? "depth that is reversed although View::viewToClip is not"
                                    : "depth that is not reversed although View::viewToClip is");
    }
    if (now.clipYDown != declared_.clipYDown)
        parts.push_back(formatText("clipYDown {}, not {} as declared", now.clipYDown, declared_.clipYDown));
    const bool left = now.handedness == Handedness::Left;
    add(now.handedness != declared_.handedness,
        left ? "Handedness::Left, not Right as declared" : "Handedness::Right, not Left as declared");
    add(found.matrices.inverseView, "the inverse of View::worldToView, not the matrix as given");
    add(found.matrices.transposedClip, "the transpose of View::viewToClip, not the matrix as given");
    const bool view = now.normalSpace == NormalSpace::View;
    add(now.normalSpace != declared_.normalSpace,
        view ? "NormalSpace::View, not World as declared" : "NormalSpace::World, not View as declared");
    if (now.normalEncoding != declared_.normalEncoding)
        parts.push_back(formatText("NormalEncoding::{}, not {} as declared", kEncodings[size_t(now.normalEncoding)],
                                   kEncodings[size_t(declared_.normalEncoding)]));
    add(found.inward, "normals that point into the surfaces, which Glint needs negated");
    return listText(parts, " and ");
}

glm::vec3 HostEvidence::positionVS(size_t reading, size_t sample, int dx, int dy) const {
    const shared::FrameConstants& frame = readings_[reading].frame;
    const size_t which = dx < 0 ? 1 : dx > 0 ? 2 : dy < 0 ? 3 : dy > 0 ? 4 : 0;
    const float viewZ = viewZOf(frame, stored(sample).depth[which]);
    if (!(viewZ > 0))
        return glm::vec3(0);
    return positionOf(frame, glm::vec2(glm::ivec2(grid_.pixel(places_[sample])) + glm::ivec2(dx, dy)), viewZ);
}

glm::vec3 HostEvidence::decoded(const Reading& reading, size_t sample) const {
    glm::vec3 normal(stored(sample).normal);
    const NormalEncoding encoding = reading.conventions.normalEncoding;
    if (isUnorm(encoding))
        normal = normal * 2.0f - 1.0f;
    return isOctahedral(encoding) ? decodeOctahedral(glm::vec2(normal)) : normal;
}

glm::vec3 HostEvidence::normalWS(size_t reading, size_t sample) const {
    const Reading& as = readings_[reading];
    glm::vec3 normal = decoded(as, sample);
    if (as.conventions.normalSpace == NormalSpace::View) {
        if (as.conventions.handedness == Handedness::Left)
            normal.z = -normal.z;
        normal = glm::mat3(as.frame.viewToWorld) * normal;
    }
    const float length = glm::length(normal) * (as.inward ? -1.0f : 1.0f);
    constexpr float kShortest = 0.1f; // shorter ones are means over surfaces of opposite directions
    return std::isfinite(length) && std::abs(length) > kShortest ? normal / length : glm::vec3(0);
}

float HostEvidence::normalLength(size_t reading, size_t sample) const {
    return glm::length(decoded(readings_[reading], sample));
}

glm::mat3 HostEvidence::worldToView(size_t reading) const {
    return glm::mat3(readings_[reading].frame.worldToView);
}

glm::vec3 HostEvidence::toCameraVS(size_t reading, const glm::vec3& positionVS) const {
    const bool orthographic = (readings_[reading].frame.flags & shared::kInputOrthographic) != 0;
    return orthographic ? glm::vec3(0, 0, 1) : -glm::normalize(positionVS);
}

glm::vec2 HostEvidence::planes(size_t reading) const {
    const shared::FrameConstants& frame = readings_[reading].frame;
    const bool minusOneToOne = readings_[reading].conventions.depthMinusOneToOne;
    const bool reversed = (frame.flags & shared::kInputReversedDepth) != 0;
    const float ndc = reversed ? (minusOneToOne ? -1.0f : 0.0f) : 1.0f;
    const float far =
        (ndc * frame.depthToViewZ.x + frame.depthToViewZ.y) / (ndc * frame.depthToViewZ.z + frame.depthToViewZ.w);
    constexpr float kFarthest = 1e7f; // a far plane beyond this is infinity with rounding
    return {frame.nearZ, far > frame.nearZ && far < kFarthest ? far : std::numeric_limits<float>::infinity()};
}

glm::vec3 HostEvidence::positionWS(size_t reading, size_t sample) const {
    return glm::vec3(readings_[reading].frame.viewToWorld * glm::vec4(positionVS(reading, sample, 0, 0), 1));
}

glm::vec3 HostEvidence::eyeWS(size_t reading) const {
    return glm::vec3(readings_[reading].frame.viewToWorld[3]);
}

std::vector<float> HostEvidence::roughness(const MaterialChannel& stated) const {
    std::vector<float> values;
    for (size_t i = 0; i < samples(); ++i)
        values.push_back(stored(i).roughness[static_cast<int>(stated.channel)] * stated.scale + stated.bias);
    return values;
}

std::vector<check::Motion> HostEvidence::motions(size_t reading, const FrameCamera& previous) const {
    FrameCamera before = previous;
    glm::mat4 toClip = glm::make_mat4(before.view.viewToClip.data());
    copyOffset(glm::make_mat4(camera_.view.viewToClip.data()), toClip);
    before.view.viewToClip = toMatrix4(toClip);
    const shared::FrameConstants& now = readings_[reading].frame;
    const shared::FrameConstants then = frameOf(readings_[reading], before);
    const glm::mat4 toThen = then.worldToView * now.viewToWorld;
    std::vector<check::Motion> found;
    for (size_t i = 0; i < samples(); ++i) {
        const glm::vec3 here = positionVS(reading, i, 0, 0);
        const glm::vec3 there(toThen * glm::vec4(here, 1));
        const glm::vec2 stated(stored(i).motion[0], stored(i).motion[1]);
        if (here.z >= 0 || there.z >= 0 || !std::isfinite(stated.x + stated.y))
            continue;
        found.push_back({stated, (pixelOf(then, there) * then.invSize - pixelOf(now, here) * now.invSize) * now.size});
    }
    return found;
}

std::vector<check::DepthMotion> HostEvidence::depthMotions(size_t reading, const FrameCamera& previous) const {
    const shared::FrameConstants then = frameOf(readings_[reading], previous);
    const glm::mat4 toThen = then.worldToView * readings_[reading].frame.viewToWorld;
    std::vector<check::DepthMotion> found;
    for (size_t i = 0; i < samples(); ++i) {
        const glm::vec3 here = positionVS(reading, i, 0, 0);
        const float stated = stored(i).motion[2];
        if (here.z >= 0 || !std::isfinite(stated))
            continue;
        const float nearer = here.z - (toThen * glm::vec4(here, 1)).z;
        found.push_back({stated / -here.z, nearer / -here.z});
    }
    return found;
}

std::string nameOfMotion(const check::MotionUnit& unit, const glm::uvec2& extent) {
    if (!unit.pixels)
        return formatText("motionScale {{{}, {}}}", unit.scale.x, unit.scale.y);
    return formatText("motionScale {{{} / {}, {} / {}}}", unit.scale.x, extent.x, unit.scale.y, extent.y);
}

} // namespace glint::reflect
