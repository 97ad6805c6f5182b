#include "scene/gbuffer_doctor.hpp"

#include "base/text.hpp"
#include "scene/normal_agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::scene {
namespace {

constexpr uint64_t kWantedSamples = 20000;
constexpr uint64_t kFewestSamples = 50; ///< fewer say nothing

/// Every pixel of a regular grid whose stored depth may be that of a surface.
struct Sample {
    uint32_t x, y; ///< of the file, rows as stored
};

/// One meaning of the layers, and how well the normals then agree with the depth.
struct Hypothesis {
    GBufferMeaning meaning;
    int changes = 0; ///< declarations that differ
    double score = 0;
    double agree = 0; ///< share of samples
};

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

/// `values` must not be empty; changes their order.
float median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

const char* yesNo(bool value) {
    return value ? "true" : "false";
}

class Doctor {
public:
    Doctor(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera)
        : layers_(layers), mapping_(mapping), lens_(camera, layers.width, layers.height) {
        const uint64_t pixels = std::max<uint64_t>(layers.pixels(), 1);
        const auto stride =
            static_cast<uint32_t>(std::max(1.0, std::floor(std::sqrt(double(pixels) / double(kWantedSamples)))));
        for (uint32_t y = 1; y + 1 < layers.height; y += stride)
            for (uint32_t x = 1; x + 1 < layers.width; x += stride)
                if (mayShowSurface(x, y))
                    samples_.push_back({x, y});
    }

    GBufferHealth examine(const Camera* previous) {
        GBufferHealth health;
        health.tested = samples_.size();
        if (samples_.size() < kFewestSamples)
            return health;
        const Hypothesis declared = bestOf({mapping_.meaning});
        health.normalsAgree = declared.agree;
        const Hypothesis best = bestOf(meanings());
        compare(declared, best, health.findings);
        checkNormals(best.meaning, health.findings);
        checkFacing(best.meaning, health.findings);
        checkRange(best.meaning, health.findings);
        checkPositions(best.meaning, health.findings);
        checkRoughness(health.findings);
        if (previous)
            checkMotion(best.meaning, *previous, health.findings);
        return health;
    }

private:
    size_t index(uint32_t x, uint32_t y) const { return size_t{y} * layers_.width + x; }

    bool mayShowSurface(uint32_t x, uint32_t y) const {
        const size_t i = index(x, y);
        if (!layers_.coverage.empty() && !(layers_.coverage[i] >= 0.5f))
            return false;
        if (layers_.depth.empty())
            return std::isfinite(glm::dot(layers_.position[i], layers_.position[i])) &&
                   layers_.position[i] != glm::vec3(0);
        return std::abs(layers_.depth[i]) < mapping_.background && layers_.depth[i] != 0;
    }

    /// View-space position of a stored pixel. Returns z = 0 if the meaning has no surface there.
    glm::vec3 positionVS(const GBufferMeaning& meaning, uint32_t x, uint32_t storedY) const {
        const uint32_t y = meaning.rowsFromBottom ? layers_.height - 1 - storedY : storedY;
        const size_t i = index(x, storedY);
        float viewZ = 0;
        if (!mayShowSurface(x, storedY))
            return glm::vec3(0);
        if (layers_.depth.empty())
            viewZ = -(lens_.worldToView() * glm::vec4(PixelLens::positionWS(meaning, layers_.position[i]), 1)).z;
        else
            viewZ = lens_.viewZ(meaning, layers_.depth[i], x, y);
        return viewZ > 0 && std::isfinite(viewZ) ? lens_.positionVS(x, y, viewZ) : glm::vec3(0);
    }

    /// The smaller of the two steps to neighbouring pixels, which stays on the surface at its edges. 0: none.
    static glm::vec3 step(const glm::vec3& before, const glm::vec3& here, const glm::vec3& after) {
        const bool hasBefore = before.z < 0, hasAfter = after.z < 0;
        if (hasBefore && (!hasAfter || std::abs(here.z - before.z) < std::abs(after.z - here.z)))
            return here - before;
        return hasAfter ? after - here : glm::vec3(0);
    }

    /// Normal of the depth image, view space, toward the camera. Returns 0 where there is none.
    glm::vec3 depthNormalVS(const GBufferMeaning& meaning, const Sample& sample) const {
        const auto at = [&](int dx, int dy) {
            return positionVS(meaning, sample.x + static_cast<uint32_t>(dx), sample.y + static_cast<uint32_t>(dy));
        };
        const glm::vec3 here = at(0, 0);
        if (here.z >= 0)
            return glm::vec3(0);
        const glm::vec3 right = step(at(-1, 0), here, at(1, 0));
        const glm::vec3 down = step(at(0, -1), here, at(0, 1));
        const glm::vec3 normal = glm::cross(right, down);
        const float length = glm::length(normal);
        if (!(length > 0) || !std::isfinite(length))
            return glm::vec3(0);
        return glm::dot(normal, here) > 0 ? -normal / length : normal / length;
    }

    /// Every combination of meanings; those that only positions or only world normals have, where there are any.
    std::vector<GBufferMeaning> meanings() const {
        std::vector<GBufferMeaning> all = {mapping_.meaning};
        const auto vary = [&](auto GBufferMeaning::*member, auto values) {
            std::vector<GBufferMeaning> varied;
            for (const GBufferMeaning& meaning : all)
                for (const auto value : values) {
                    varied.push_back(meaning);
                    varied.back().*member = value;
                }
            all = std::move(varied);
        };
        if (!layers_.depth.empty())
            vary(&GBufferMeaning::depth,
                 std::to_array({StoredDepth::ViewZ, StoredDepth::NegativeViewZ, StoredDepth::Distance,
                                StoredDepth::Device, StoredDepth::ReversedDevice}));
        vary(&GBufferMeaning::rowsFromBottom, std::to_array({false, true}));
        vary(&GBufferMeaning::axes, std::to_array({StoredAxes::YUp, StoredAxes::ZUp}));
        vary(&GBufferMeaning::normalSpace, std::to_array({StoredSpace::World, StoredSpace::View}));
        vary(&GBufferMeaning::normalUnorm, std::to_array({false, true}));
        vary(&GBufferMeaning::normalInward, std::to_array({false, true}));
        return all;
    }

    int changes(const GBufferMeaning& meaning) const {
        const GBufferMeaning& d = mapping_.meaning;
        return (meaning.depth != d.depth) + (meaning.rowsFromBottom != d.rowsFromBottom) + (meaning.axes != d.axes) +
               (meaning.normalSpace != d.normalSpace) + (meaning.normalUnorm != d.normalUnorm) +
               (meaning.normalInward != d.normalInward);
    }

    /// Meanings that share depth, rows and axes share the normals of their depth.
    Hypothesis bestOf(const std::vector<GBufferMeaning>& all) const {
        Hypothesis best;
        best.score = -1;
        std::vector<glm::vec3> normalsVS;
        const GBufferMeaning* computed = nullptr;
        for (const GBufferMeaning& meaning : all) {
            if (!computed || computed->depth != meaning.depth || computed->rowsFromBottom != meaning.rowsFromBottom ||
                computed->axes != meaning.axes) {
                normalsVS.clear();
                for (const Sample& sample : samples_)
                    normalsVS.push_back(depthNormalVS(meaning, sample));
                computed = &meaning;
            }
            const Hypothesis one = judge(meaning, normalsVS);
            if (one.score > best.score)
                best = one;
        }
        return best;
    }

    std::vector<glm::vec3> givenNormalsWS(const GBufferMeaning& meaning) const {
        std::vector<glm::vec3> normals;
        for (const Sample& sample : samples_)
            normals.push_back(lens_.normalWS(meaning, layers_.normal[index(sample.x, sample.y)]));
        return normals;
    }

    /// Prefers what is declared among equals.
    Hypothesis judge(const GBufferMeaning& meaning, const std::vector<glm::vec3>& depthNormalsVS) const {
        constexpr double kCostOfChange = 0.01;
        const Agreement found = agreement(glm::mat3(lens_.worldToView()), givenNormalsWS(meaning), depthNormalsVS);
        const int different = changes(meaning);
        return {meaning, different, found.score - kCostOfChange * different, found.share};
    }

    void compare(const Hypothesis& declared, const Hypothesis& best, std::vector<std::string>& findings) const {
        constexpr double kClearly = 0.05, kGood = 0.3;
        const Turn turn = bestTurn();
        if (turn.fit.share >= kGood && turn.degrees > kAgreeDegrees && turn.fit.score > best.score + kClearly) {
            findings.push_back(fmt::format("depth and normals agree with a camera that is turned by {:.0f} degrees ({} "
                                           "of pixels, {} as declared): check the camera's position and target",
                                           turn.degrees, percent(turn.fit.share), percent(declared.agree)));
        } else if (best.changes > 0 && best.agree >= kGood && best.score > declared.score + kClearly) {
            findings.push_back(fmt::format("depth and normals agree with {} ({} of pixels, {} as declared)",
                                           differences(best.meaning), percent(best.agree), percent(declared.agree)));
        } else if (declared.agree < kGood) {
            findings.push_back(fmt::format("the normals of only {} of pixels agree with depth and camera, and no other "
                                           "meaning agrees better: check the camera (fovY, position, target) and the "
                                           "names of the layers",
                                           percent(declared.agree)));
        }
    }

    /// The camera rotation with which world normals agree best, as an angle to the camera's.
    struct Turn {
        float degrees = 0;
        Agreement fit;
    };
    Turn bestTurn() const {
        const GBufferMeaning& meaning = mapping_.meaning;
        if (meaning.normalSpace == StoredSpace::View || layers_.depth.empty()) // no camera turns these
            return {};
        std::vector<glm::vec3> normalsVS;
        for (const Sample& sample : samples_)
            normalsVS.push_back(depthNormalVS(meaning, sample));
        const RotationFit fit = fitRotation(givenNormalsWS(meaning), normalsVS);
        const glm::mat3 turn = fit.rotation * glm::transpose(glm::mat3(lens_.worldToView()));
        const float cosine = (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2;
        return {glm::degrees(std::acos(glm::clamp(cosine, -1.0f, 1.0f))), fit.agreement};
    }

    std::string differences(const GBufferMeaning& meaning) const {
        const GBufferMeaning& d = mapping_.meaning;
        std::vector<std::string> parts;
        const auto add = [&](bool differs, std::string_view key, std::string_view found, std::string_view declared) {
            if (differs)
                parts.push_back(fmt::format("{} {}, not {} as declared", key, found, declared));
        };
        const auto depth = storedDepthNames();
        const auto axes = storedAxesNames();
        const auto space = storedSpaceNames();
        add(meaning.depth != d.depth, "depth.is", depth[size_t(meaning.depth)], depth[size_t(d.depth)]);
        add(meaning.axes != d.axes, "axes", axes[size_t(meaning.axes)], axes[size_t(d.axes)]);
        add(meaning.normalSpace != d.normalSpace, "normal.space", space[size_t(meaning.normalSpace)],
            space[size_t(d.normalSpace)]);
        add(meaning.normalUnorm != d.normalUnorm, "normal.unorm", yesNo(meaning.normalUnorm), yesNo(d.normalUnorm));
        add(meaning.normalInward != d.normalInward, "normal.inward", yesNo(meaning.normalInward),
            yesNo(d.normalInward));
        add(meaning.rowsFromBottom != d.rowsFromBottom, "rowsFromBottom", yesNo(meaning.rowsFromBottom),
            yesNo(d.rowsFromBottom));
        return listText(parts, " and ");
    }

    /// Means over samples, and filtered edges, have shorter normals; more than some of them mean another encoding.
    void checkNormals(const GBufferMeaning& meaning, std::vector<std::string>& findings) const {
        constexpr float kTolerance = 0.05f;
        constexpr double kMany = 0.25;
        uint64_t odd = 0;
        for (const Sample& sample : samples_) {
            const glm::vec3& stored = layers_.normal[index(sample.x, sample.y)];
            const float length = glm::length(meaning.normalUnorm ? stored * 2.0f - 1.0f : stored);
            odd += !(std::abs(length - 1) < kTolerance);
        }
        const double share = double(odd) / double(samples_.size());
        if (share > kMany)
            findings.push_back(fmt::format("the normals of {} of pixels do not have unit length: the file needs one "
                                           "sample at each pixel's centre, without a filter",
                                           percent(share)));
    }

    /// A visible surface faces the camera.
    void checkFacing(const GBufferMeaning& meaning, std::vector<std::string>& findings) const {
        constexpr float kAway = -0.2f; // cosine: interpolated and mapped normals lean away a little at silhouettes
        constexpr double kMany = 0.05;
        const glm::mat3 toView(lens_.worldToView());
        uint64_t away = 0;
        for (const Sample& sample : samples_) {
            const glm::vec3 here = positionVS(meaning, sample.x, sample.y);
            if (here.z >= 0)
                continue;
            const glm::vec3 normalWS = lens_.normalWS(meaning, layers_.normal[index(sample.x, sample.y)]);
            away += glm::dot(toView * normalWS, lens_.toCameraVS(here)) < kAway;
        }
        const double share = double(away) / double(samples_.size());
        if (share > kMany)
            findings.push_back(fmt::format("the normals of {} of pixels point away from the camera: the file needs "
                                           "normals that are turned to the camera",
                                           percent(share)));
    }

    /// A camera file's planes enclose the surfaces, unless depth is in another unit.
    void checkRange(const GBufferMeaning& meaning, std::vector<std::string>& findings) const {
        std::vector<float> depths;
        for (const Sample& sample : samples_)
            if (const glm::vec3 here = positionVS(meaning, sample.x, sample.y); here.z < 0)
                depths.push_back(-here.z);
        if (depths.empty())
            return;
        const float middle = median(depths);
        if (middle < lens_.camera().near || middle > lens_.camera().far)
            findings.push_back(fmt::format("half of the surfaces lie {} than {:.3g} m, outside the near and far planes "
                                           "of the camera ({:.3g} and {:.3g} m): correct \"metres\" or the camera",
                                           middle < lens_.camera().near ? "nearer" : "farther", middle,
                                           lens_.camera().near, lens_.camera().far));
    }

    /// Positions must project to their own pixels, and lie as far away as depth says.
    void checkPositions(const GBufferMeaning& meaning, std::vector<std::string>& findings) const {
        if (layers_.position.empty())
            return;
        std::vector<float> offsets, ratios;
        for (const Sample& sample : samples_) {
            const glm::vec3& stored = layers_.position[index(sample.x, sample.y)];
            const glm::vec3 positionVS(lens_.worldToView() * glm::vec4(PixelLens::positionWS(meaning, stored), 1));
            const uint32_t y = meaning.rowsFromBottom ? layers_.height - 1 - sample.y : sample.y;
            const glm::vec2 offset = lens_.pixelOf(positionVS) - glm::vec2(sample.x, y) - 0.5f;
            offsets.push_back(positionVS.z < 0 && std::isfinite(offset.x + offset.y) ? glm::length(offset) : 1e9f);
            if (layers_.depth.empty())
                continue;
            const float ratio =
                -positionVS.z / lens_.viewZ(meaning, layers_.depth[index(sample.x, sample.y)], sample.x, y);
            if (std::isfinite(ratio))
                ratios.push_back(ratio);
        }
        constexpr float kOffPX = 1.5f, kRatio = 0.02f;
        if (const float offset = median(offsets); offset > kOffPX) {
            findings.push_back(
                offset < 1e9f ? fmt::format("positions project {:.1f} pixels from their own pixels (median): the "
                                            "camera or \"axes\" is not that of the G-buffer",
                                            offset)
                              : std::string("most positions lie behind the camera: the camera or \"axes\" is not that "
                                            "of the G-buffer"));
        } else if (!ratios.empty()) {
            if (const float ratio = median(ratios); !(std::abs(ratio - 1) < kRatio))
                findings.push_back(fmt::format("positions lie {:.3g} times as far away as depth says: \"depth.is\" or "
                                               "the units differ",
                                               ratio));
        }
    }

    /// Stored motion, and that of a surface which stands still under the two cameras, in pixels.
    struct Motion {
        glm::vec2 stored, still;
    };
    std::vector<Motion> motions(const GBufferMeaning& meaning, const Camera& previous) const {
        const PixelLens before(previous, layers_.width, layers_.height);
        const glm::mat4 toBefore = before.worldToView() * lens_.camera().viewToWorld;
        std::vector<Motion> found;
        for (const Sample& sample : samples_) {
            const glm::vec3 here = positionVS(meaning, sample.x, sample.y);
            const glm::vec3 there(toBefore * glm::vec4(here, 1));
            const glm::vec2 stored = layers_.motion[index(sample.x, sample.y)];
            if (here.z >= 0 || there.z >= 0 || !std::isfinite(stored.x + stored.y))
                continue;
            found.push_back({stored, before.pixelOf(there) - lens_.pixelOf(here)});
        }
        return found;
    }

    /// The share of surfaces that stand still if stored motion has this meaning.
    double shareStill(const std::vector<Motion>& motions, const glm::vec2& scale, bool pixels) const {
        constexpr float kOffPX = 0.5f, kOff = 0.05f;
        const glm::vec2 size = pixels ? glm::vec2(1) : glm::vec2(layers_.width, layers_.height);
        const auto still = std::ranges::count_if(motions, [&](const Motion& motion) {
            return glm::length(motion.stored * scale * size - motion.still) < kOffPX + kOff * glm::length(motion.still);
        });
        return double(still) / double(motions.size());
    }

    /// Most surfaces stand still, so their motion is that of the camera. Nothing is said where it hardly moves.
    void checkMotion(const GBufferMeaning& meaning, const Camera& previous, std::vector<std::string>& findings) const {
        constexpr float kMovesPX = 2;
        constexpr double kGood = 0.3, kClearly = 0.1;
        if (layers_.motion.empty())
            return;
        const std::vector<Motion> all = motions(meaning, previous);
        const auto moved =
            std::ranges::count_if(all, [](const Motion& motion) { return glm::length(motion.still) > kMovesPX; });
        if (all.size() < kFewestSamples || moved < std::ssize(all) / 2)
            return;
        const double declared = shareStill(all, mapping_.motionScale, mapping_.motionInPixels);
        double best = 0;
        glm::vec2 bestScale(0);
        bool bestPixels = false;
        for (const bool pixels : {false, true})
            for (const glm::vec2 scale :
                 {glm::vec2(1, 1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(-1, -1), glm::vec2(0.5f, 0.5f),
                  glm::vec2(0.5f, -0.5f), glm::vec2(-0.5f, 0.5f), glm::vec2(-0.5f, -0.5f)}) // halves: clip space
                if (const double share = shareStill(all, scale, pixels); share > best) {
                    best = share;
                    bestScale = scale;
                    bestPixels = pixels;
                }
        if (declared >= kGood && best < declared + kClearly)
            return;
        findings.push_back(
            best >= kGood
                ? fmt::format("motion agrees with the cameras as motion.unit {} and motion.scale [{}, {}], not {} and "
                              "[{}, {}] as declared ({} of pixels, {} as declared)",
                              bestPixels ? "pixels" : "uv", bestScale.x, bestScale.y,
                              mapping_.motionInPixels ? "pixels" : "uv", mapping_.motionScale.x, mapping_.motionScale.y,
                              percent(best), percent(declared))
                : fmt::format("the motion of only {} of pixels agrees with the cameras: everything moves, or motion is "
                              "not that to the previous frame",
                              percent(declared)));
    }

    void checkRoughness(std::vector<std::string>& findings) const {
        if (layers_.roughness.empty())
            return;
        uint64_t outside = 0;
        for (const Sample& sample : samples_) {
            const float value = layers_.roughness[index(sample.x, sample.y)];
            outside += !(value >= -0.001f && value <= 1.001f);
        }
        constexpr double kSome = 0.01;
        const double share = double(outside) / double(samples_.size());
        if (share > kSome)
            findings.push_back(fmt::format("the roughness of {} of pixels is not from 0 to 1", percent(share)));
    }

    const GBufferLayers& layers_;
    const GBufferMapping& mapping_;
    PixelLens lens_;
    std::vector<Sample> samples_;
};

} // namespace

GBufferHealth examine(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera,
                      const Camera* previous) {
    return Doctor(layers, mapping, camera).examine(previous);
}

} // namespace glint::scene
