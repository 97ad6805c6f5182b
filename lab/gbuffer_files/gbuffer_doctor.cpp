#include "lab/gbuffer_files/gbuffer_doctor.hpp"

#include "base/text.hpp"
#include "check/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::scene {
namespace {

constexpr uint64_t kWantedSamples = 20000;

/// Every pixel of a regular grid whose stored depth may be that of a surface.
struct Sample {
    uint32_t x, y; ///< of the file, rows as stored
};

const char* yesNo(bool value) {
    return value ? "true" : "false";
}

/// The layers, under every meaning that a mapping can declare.
class LayerEvidence : public check::Evidence {
public:
    /// `samples`  so many are wanted
    LayerEvidence(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera,
                  uint64_t samples = kWantedSamples)
        : layers_(layers), mapping_(mapping), lens_(camera, layers.width, layers.height), meanings_(meanings()) {
        const uint64_t pixels = std::max<uint64_t>(layers.pixels(), 1);
        const auto stride =
            static_cast<uint32_t>(std::max(1.0, std::floor(std::sqrt(double(pixels) / double(samples)))));
        for (uint32_t y = 1; y + 1 < layers.height; y += stride)
            for (uint32_t x = 1; x + 1 < layers.width; x += stride)
                if (mayShowSurface(x, y))
                    samples_.push_back({x, y});
    }

    size_t samples() const override { return samples_.size(); }
    check::Advice advice() const override {
        return {"check the camera (fovY, position, target) and the names of the layers",
                "check the camera's position and target",
                "the file needs one sample at each pixel's centre, without a filter",
                "the file needs normals that are turned to the camera",
                "correct \"metres\" or the camera",
                "correct the camera file"};
    }
    size_t readings() const override { return meanings_.size(); }
    int changes(size_t reading) const override { return changes(meanings_[reading]); }
    bool samePositions(size_t a, size_t b) const override {
        const GBufferMeaning &one = meanings_[a], &other = meanings_[b];
        return one.depth == other.depth && one.rowsFromBottom == other.rowsFromBottom && one.axes == other.axes;
    }
    std::string differences(size_t reading) const override {
        const GBufferMeaning& meaning = meanings_[reading];
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
    glm::vec3 positionVS(size_t reading, size_t sample, int dx, int dy) const override {
        return positionVS(meanings_[reading], samples_[sample].x + static_cast<uint32_t>(dx),
                          samples_[sample].y + static_cast<uint32_t>(dy));
    }
    glm::vec3 normalWS(size_t reading, size_t sample) const override {
        return lens_.normalWS(meanings_[reading], layers_.normal[index(samples_[sample])]);
    }
    float normalLength(size_t reading, size_t sample) const override {
        const glm::vec3& stored = layers_.normal[index(samples_[sample])];
        return glm::length(meanings_[reading].normalUnorm ? stored * 2.0f - 1.0f : stored);
    }
    glm::mat3 worldToView(size_t) const override { return glm::mat3(lens_.worldToView()); }
    glm::vec3 toCameraVS(size_t, const glm::vec3& positionVS) const override { return lens_.toCameraVS(positionVS); }
    glm::vec2 planes(size_t) const override { return {lens_.camera().near, lens_.camera().far}; }
    bool seesTurnOfCamera() const override {
        return mapping_.meaning.normalSpace == StoredSpace::World && !layers_.depth.empty();
    }

    std::vector<float> roughness() const {
        std::vector<float> values;
        for (const Sample& sample : samples_)
            if (!layers_.roughness.empty())
                values.push_back(layers_.roughness[index(sample)]);
        return values;
    }

    /// Positions must project to their own pixels, and lie as far away as depth says.
    check::Finding findMisplaced(size_t reading) const {
        if (layers_.position.empty())
            return {};
        const GBufferMeaning& meaning = meanings_[reading];
        std::vector<float> offsets, ratios;
        for (const Sample& sample : samples_) {
            const glm::vec3& stored = layers_.position[index(sample)];
            const glm::vec3 positionVS(lens_.worldToView() * glm::vec4(PixelLens::positionWS(meaning, stored), 1));
            const uint32_t y = meaning.rowsFromBottom ? layers_.height - 1 - sample.y : sample.y;
            const glm::vec2 offset = lens_.pixelOf(positionVS) - glm::vec2(sample.x, y) - 0.5f;
            offsets.push_back(positionVS.z < 0 && std::isfinite(offset.x + offset.y) ? glm::length(offset) : 1e9f);
            if (layers_.depth.empty())
                continue;
            const float ratio = -positionVS.z / lens_.viewZ(meaning, layers_.depth[index(sample)], sample.x, y);
            if (std::isfinite(ratio))
                ratios.push_back(ratio);
        }
        constexpr float kOffPX = 1.5f, kRatio = 0.02f;
        if (const float offset = check::median(offsets); offset > kOffPX)
            return offset < 1e9f ? fmt::format("positions project {:.1f} pixels from their own pixels (median): the "
                                               "camera or \"axes\" is not that of the G-buffer",
                                               offset)
                                 : std::string("most positions lie behind the camera: the camera or \"axes\" is not "
                                               "that of the G-buffer");
        if (ratios.empty())
            return {};
        const float ratio = check::median(ratios);
        if (std::abs(ratio - 1) < kRatio)
            return {};
        return fmt::format("positions lie {:.3g} times as far away as depth says: \"depth.is\" or the units differ",
                           ratio);
    }

    std::vector<check::Motion> motions(size_t reading, const Camera& previous) const {
        const PixelLens before(previous, layers_.width, layers_.height);
        const glm::mat4 toBefore = before.worldToView() * lens_.camera().viewToWorld;
        std::vector<check::Motion> found;
        for (const Sample& sample : samples_) {
            const glm::vec3 here = positionVS(meanings_[reading], sample.x, sample.y);
            const glm::vec3 there(toBefore * glm::vec4(here, 1));
            const glm::vec2 stored = layers_.motion[index(sample)];
            if (here.z < 0 && there.z < 0 && std::isfinite(stored.x + stored.y))
                found.push_back({stored, before.pixelOf(there) - lens_.pixelOf(here)});
        }
        return found;
    }

private:
    size_t index(uint32_t x, uint32_t y) const { return size_t{y} * layers_.width + x; }
    size_t index(const Sample& sample) const { return index(sample.x, sample.y); }

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

    /// The declared meaning, then every other combination; those that only positions or only world normals have, where
    /// there are any.
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
        std::erase_if(all, [&](const GBufferMeaning& meaning) { return changes(meaning) == 0; });
        all.insert(all.begin(), mapping_.meaning);
        return all;
    }

    int changes(const GBufferMeaning& meaning) const {
        const GBufferMeaning& d = mapping_.meaning;
        return (meaning.depth != d.depth) + (meaning.rowsFromBottom != d.rowsFromBottom) + (meaning.axes != d.axes) +
               (meaning.normalSpace != d.normalSpace) + (meaning.normalUnorm != d.normalUnorm) +
               (meaning.normalInward != d.normalInward);
    }

    const GBufferLayers& layers_;
    const GBufferMapping& mapping_;
    PixelLens lens_;
    std::vector<GBufferMeaning> meanings_;
    std::vector<Sample> samples_;
};

/// Looks for the camera under which normals agree best with depth: of another field of view, or orthographic and not
/// perspective. Its place and direction are the declared ones.
class CameraSearch {
public:
    CameraSearch(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera, float middleZ)
        : layers_(layers), mapping_(mapping), camera_(camera), middleZ_(middleZ) {}

    check::OtherCamera best() const {
        constexpr int kRefinements = 2;
        Trial best;
        for (const bool orthographic : {false, true})
            best = bestOf({orthographic, 1, -1}, kFirstStep, 6, best);
        float step = kFirstStep;
        for (int refinement = 0; refinement < kRefinements; ++refinement) {
            step = std::sqrt(std::sqrt(step));
            best = bestOf(best, step, 3, best);
        }
        const Camera found = cameraOf(best);
        return {nameOf(found), check::agreementAsDeclared(LayerEvidence(layers_, mapping_, found))};
    }

private:
    static constexpr float kFirstStep = 1.2f; ///< the searched sizes are 1/3 to 3 times the declared one

    struct Trial {
        bool orthographic = false;
        float scale = 1; ///< of what the image shows at middleZ_, to the declared camera's
        double score = -1;
    };

    Trial bestOf(const Trial& around, float step, int steps, Trial best) const {
        constexpr uint64_t kFewSamples = kWantedSamples / 4; // the best one is compared again with all
        for (int i = -steps; i <= steps; ++i) {
            Trial trial = {around.orthographic, around.scale * std::pow(step, static_cast<float>(i)), 0};
            const LayerEvidence evidence(layers_, mapping_, cameraOf(trial), kFewSamples);
            trial.score = check::agreementAsDeclared(evidence).score;
            if (trial.score > best.score)
                best = trial;
        }
        return best;
    }

    Camera cameraOf(const Trial& trial) const {
        const float halfHeight =
            (camera_.orthographic ? camera_.orthoHeight / 2 : middleZ_ * std::tan(camera_.fovY / 2)) * trial.scale;
        Camera camera = camera_;
        camera.orthographic = trial.orthographic;
        camera.orthoHeight = 2 * halfHeight;
        camera.fovY = 2 * std::atan(halfHeight / middleZ_);
        return camera;
    }

    std::string nameOf(const Camera& found) const {
        const auto size = [](const Camera& camera) {
            return camera.orthographic ? fmt::format("orthoHeight {:.3g}", camera.orthoHeight)
                                       : fmt::format("fovY {:.3g}", glm::degrees(camera.fovY));
        };
        const char* const kind = found.orthographic == camera_.orthographic ? "a camera"
                                 : found.orthographic                       ? "an orthographic camera"
                                                                            : "a perspective camera";
        return fmt::format("{} of about {}, not {} as declared", kind, size(found), size(camera_));
    }

    const GBufferLayers& layers_;
    const GBufferMapping& mapping_;
    const Camera& camera_;
    float middleZ_; ///< half of the surfaces are nearer
};

/// Returns 0 if no sample shows a surface.
float middleDepth(const LayerEvidence& evidence) {
    std::vector<float> depths;
    for (size_t sample = 0; sample < evidence.samples(); ++sample)
        if (const float z = -evidence.positionVS(0, sample, 0, 0).z; z > 0)
            depths.push_back(z);
    return depths.empty() ? 0 : check::median(depths);
}

std::string nameOf(const check::MotionUnit& unit) {
    return fmt::format("motion.unit {} and motion.scale [{}, {}]", unit.pixels ? "pixels" : "uv", unit.scale.x,
                       unit.scale.y);
}

} // namespace

GBufferHealth examine(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera,
                      const Camera* previous) {
    const LayerEvidence evidence(layers, mapping, camera);
    GBufferHealth health;
    health.tested = evidence.samples();
    if (health.tested < check::kFewestSamples)
        return health;
    const auto add = [&](const check::Finding& finding) {
        if (finding)
            health.findings.push_back(*finding);
    };
    const float middleZ = middleDepth(evidence);
    const auto bestCamera = [&] {
        return middleZ > 0 ? CameraSearch(layers, mapping, camera, middleZ).best() : check::OtherCamera();
    };
    const check::Comparison compared = check::compareNormals(evidence, bestCamera);
    health.normalsAgree = compared.agree;
    add(compared.finding);
    add(check::findOddLengths(evidence, compared.best));
    add(check::findAverted(evidence, compared.best));
    add(check::findOutOfRange(evidence, compared.best));
    add(evidence.findMisplaced(compared.best));
    add(check::findRoughnessOutside(evidence.roughness()));
    if (previous && !layers.motion.empty())
        add(check::compareMotion(evidence.motions(compared.best, *previous), glm::vec2(layers.width, layers.height),
                                 {mapping.motionScale, mapping.motionInPixels}, nameOf)
                .finding);
    return health;
}

} // namespace glint::scene
