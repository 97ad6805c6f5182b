#include "lab/gbuffer_files/gbuffer_pixels.hpp"

#include "lab/scene/images/hdr_image.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene {
namespace {

glm::vec3 finiteRadiance(const glm::vec3& color) {
    return {asRadiance(color.x), asRadiance(color.y), asRadiance(color.z)};
}

/// NaN becomes `fallback`.
float fraction(float value, float fallback) {
    return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : fallback;
}
glm::vec3 fraction(const glm::vec3& value, float fallback) {
    return {fraction(value.x, fallback), fraction(value.y, fallback), fraction(value.z, fallback)};
}

/// Fractions that exceed their range by rounding or filtering alone are no mistake.
bool isFraction(float value) {
    constexpr float kTolerance = 0.001f;
    return value >= -kTolerance && value <= 1 + kTolerance;
}
bool isFraction(const glm::vec3& value) {
    return isFraction(value.x) && isFraction(value.y) && isFraction(value.z);
}

bool isRadiance(float value) {
    return value >= 0 && value <= kMaxRadiance;
}
bool isRadiance(const glm::vec3& color) {
    return isRadiance(color.x) && isRadiance(color.y) && isRadiance(color.z);
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

constexpr float kLargestIor = 100;

/// Reflectance at normal incidence (Fresnel's equations) of an interface to air.
float dielectricF0(float ior) {
    const float n = std::isfinite(ior) ? std::clamp(ior, 1.0f, kLargestIor) : 1.5f;
    const float root = (n - 1) / (n + 1);
    return root * root;
}

/// Decodes one pixel after the other and counts what is wrong with them.
class LayerDecoder {
public:
    LayerDecoder(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera)
        : layers_(layers), mapping_(mapping), lens_(camera, layers.width, layers.height) {}

    GBufferPixels decode() {
        GBufferPixels pixels;
        pixels.width = layers_.width;
        pixels.height = layers_.height;
        pixels.notes = layers_.notes;
        const size_t count = layers_.pixels();
        pixels.viewZ.assign(count, 0);
        pixels.normalWS.assign(count, glm::vec3(0));
        pixels.material.assign(count, glm::vec4(0));
        pixels.baseColor.assign(count, glm::vec3(0));
        pixels.litRadiance.assign(count, glm::vec3(0));
        pixels.motionUV.assign(layers_.motion.empty() ? 0 : count, glm::vec2(0));
        pixels.fallbackSpecular.assign(layers_.fallbackSpecular.empty() ? 0 : count, glm::vec3(0));
        pixels.reference.assign(layers_.reference.empty() ? 0 : count, glm::vec3(0));
        for (uint32_t y = 0; y < layers_.height; ++y)
            for (uint32_t x = 0; x < layers_.width; ++x)
                decodePixel(x, y, pixels);
        note(pixels, badDepths_, "depth that is no number");
        note(pixels, badNormals_, "surface without a finite normal");
        note(pixels, badColors_, "colour that is negative or no number, which becomes 0");
        note(pixels, brightColors_, "colour above 65504, which becomes 65504");
        note(pixels, badFallbacks_,
             "fallbackSpecular that is not from 0 to 65504: limited to that, no number becomes 0");
        note(pixels, badReferences_, "reference that is not from 0 to 65504: limited to that, no number becomes 0");
        note(pixels, badRoughness_,
             mapping_.smoothness ? "smoothness that is not from 0 to 1: limited to that, no number becomes 0"
                                 : "roughness that is not from 0 to 1: limited to that, no number becomes 1");
        note(pixels, badF0_, "f0 that is not from 0 to 1: limited to that, no number becomes 0");
        note(pixels, badMetallic_, "metallic that is not from 0 to 1: limited to that, no number becomes 0");
        note(pixels, badBaseColors_, "baseColor that is not from 0 to 1: limited to that, no number becomes 0");
        note(pixels, badIors_, "ior that is not from 1 to 100: limited to that, no number becomes 1.5");
        return pixels;
    }

private:
    static void note(GBufferPixels& pixels, uint64_t count, std::string_view what) {
        if (count > 0)
            pixels.notes.push_back(fmt::format("{} of {} pixels have a {}", count, pixels.viewZ.size(), what));
    }

    void decodePixel(uint32_t x, uint32_t y, GBufferPixels& pixels) {
        const size_t to = size_t{y} * layers_.width + x;
        const uint32_t row = mapping_.meaning.rowsFromBottom ? layers_.height - 1 - y : y;
        const size_t from = size_t{row} * layers_.width + x;
        const glm::vec3& color = layers_.color[from];
        const bool bad = !(color.x >= 0 && color.y >= 0 && color.z >= 0);
        badColors_ += bad;
        brightColors_ += !bad && !isRadiance(color);
        pixels.litRadiance[to] = finiteRadiance(color);
        if (!pixels.fallbackSpecular.empty())
            pixels.fallbackSpecular[to] = countedRadiance(layers_.fallbackSpecular[from], badFallbacks_);
        if (!pixels.reference.empty())
            pixels.reference[to] = countedRadiance(layers_.reference[from], badReferences_);

        if (!pixels.motionUV.empty())
            pixels.motionUV[to] = lens_.motionUV(mapping_, layers_.motion[from]);
        const float viewZ = surfaceZ(x, y, from);
        if (viewZ <= 0)
            return;
        const glm::vec3 normalWS = lens_.normalWS(mapping_.meaning, layers_.normal[from]);
        if (normalWS == glm::vec3(0)) {
            ++badNormals_;
            return;
        }
        ++pixels.surfaces;
        pixels.viewZ[to] = viewZ;
        pixels.normalWS[to] = normalWS;
        pixels.baseColor[to] =
            layers_.baseColor.empty() ? glm::vec3(1) : counted(layers_.baseColor[from], 0.0f, badBaseColors_);
        pixels.material[to] = glm::vec4(f0(from, pixels.baseColor[to]), roughness(from));
    }

    /// 0: background.
    float surfaceZ(uint32_t x, uint32_t y, size_t from) {
        if (!layers_.coverage.empty() && !(layers_.coverage[from] >= 0.5f))
            return 0;
        float viewZ = 0;
        if (!layers_.depth.empty()) {
            const float stored = layers_.depth[from];
            badDepths_ += std::isnan(stored);
            if (!(std::abs(stored) < mapping_.background))
                return 0;
            viewZ = lens_.viewZ(mapping_.meaning, stored, x, y);
        } else {
            const glm::vec3 positionWS = PixelLens::positionWS(mapping_.meaning, layers_.position[from]);
            badDepths_ += !finite(positionWS);
            // A renderer writes (0, 0, 0) where there is nothing; a surface exactly there is rarer than that.
            if (positionWS != glm::vec3(0))
                viewZ = -(lens_.worldToView() * glm::vec4(positionWS, 1)).z;
        }
        constexpr float kFarthest = 1e9f; // metres; products of two such numbers stay finite
        return viewZ > 0 && viewZ < kFarthest ? viewZ : 0;
    }

    static glm::vec3 countedRadiance(const glm::vec3& stored, uint64_t& bad) {
        bad += !isRadiance(stored);
        return finiteRadiance(stored);
    }

    template <class Value>
    static Value counted(const Value& stored, float fallback, uint64_t& bad) {
        bad += !isFraction(stored);
        return fraction(stored, fallback);
    }

    float roughness(size_t from) {
        const float stored = layers_.roughness.empty() ? mapping_.roughness.constant : layers_.roughness[from];
        const float value = counted(stored, mapping_.smoothness ? 0.0f : 1.0f, badRoughness_);
        return mapping_.smoothness ? 1 - value : value;
    }

    /// glTF 2.0, B.2: metals reflect their base colour, dielectrics what their index of refraction says.
    glm::vec3 f0(size_t from, const glm::vec3& baseColor) {
        if (!layers_.f0.empty())
            return counted(layers_.f0[from], 0.0f, badF0_);
        const float ior =
            layers_.ior.empty() ? mapping_.ior.layer.empty() ? mapping_.ior.constant : 1.5f : layers_.ior[from];
        const float metallic =
            layers_.metallic.empty() ? mapping_.metallic.constant : counted(layers_.metallic[from], 0.0f, badMetallic_);
        badIors_ += metallic < 1 && !(ior >= 1 && ior <= kLargestIor); // metals have none
        return glm::mix(glm::vec3(dielectricF0(ior)), baseColor, metallic);
    }

    const GBufferLayers& layers_;
    const GBufferMapping& mapping_;
    PixelLens lens_;
    uint64_t badDepths_ = 0;
    uint64_t badNormals_ = 0;
    uint64_t badColors_ = 0, brightColors_ = 0;
    uint64_t badFallbacks_ = 0, badReferences_ = 0;
    uint64_t badRoughness_ = 0, badF0_ = 0, badMetallic_ = 0, badBaseColors_ = 0, badIors_ = 0;
};

} // namespace

PixelLens::PixelLens(const Camera& camera, uint32_t width, uint32_t height)
    : camera_(camera), worldToView_(glm::inverse(camera.viewToWorld)), size_(width, height) {
    const float halfHeight = camera.orthographic ? camera.orthoHeight / 2 : std::tan(camera.fovY / 2);
    halfExtent_ = {halfHeight * size_.x / size_.y, halfHeight};
}

glm::vec3 PixelLens::positionVS(uint32_t x, uint32_t y, float viewZ) const {
    const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / size_;
    const glm::vec2 plane = glm::vec2(2 * uv.x - 1, 1 - 2 * uv.y) * halfExtent_;
    return {camera_.orthographic ? plane : plane * viewZ, -viewZ};
}

glm::vec3 PixelLens::toCameraVS(const glm::vec3& positionVS) const {
    return camera_.orthographic ? glm::vec3(0, 0, 1) : -glm::normalize(positionVS);
}

glm::vec2 PixelLens::pixelOf(const glm::vec3& positionVS) const {
    const glm::vec2 plane = glm::vec2(positionVS) / (camera_.orthographic ? 1.0f : -positionVS.z) / halfExtent_;
    return glm::vec2(plane.x + 1, 1 - plane.y) * 0.5f * size_;
}

/// `nearness`: reversed device depth, which keeps its precision far away.
float PixelLens::deviceViewZ(float nearness) const {
    const float near = camera_.near, far = camera_.far;
    if (camera_.orthographic)
        return far - nearness * (far - near);
    return std::isfinite(far) ? near * far / (near + nearness * (far - near)) : near / nearness;
}

float PixelLens::viewZ(const GBufferMeaning& meaning, float stored, uint32_t x, uint32_t y) const {
    switch (meaning.depth) {
    case StoredDepth::ViewZ: return stored * meaning.metres;
    case StoredDepth::NegativeViewZ: return -stored * meaning.metres;
    case StoredDepth::Distance:
        return stored * meaning.metres / (camera_.orthographic ? 1.0f : glm::length(positionVS(x, y, 1)));
    case StoredDepth::Device: return stored < 1 ? deviceViewZ(1 - stored) : 0.0f;
    case StoredDepth::ReversedDevice: return stored > 0 ? deviceViewZ(stored) : 0.0f;
    }
    return 0;
}

glm::vec3 PixelLens::normalWS(const GBufferMeaning& meaning, const glm::vec3& stored) const {
    glm::vec3 normal = meaning.normalUnorm ? stored * 2.0f - 1.0f : stored;
    if (meaning.normalInward)
        normal = -normal;
    if (meaning.normalSpace == StoredSpace::View)
        normal = glm::mat3(camera_.viewToWorld) * normal;
    else if (meaning.axes == StoredAxes::ZUp)
        normal = {normal.x, normal.z, -normal.y};
    const float length = glm::length(normal);
    constexpr float kShortest = 0.1f; // shorter ones are means over surfaces of opposite directions
    return std::isfinite(length) && length > kShortest ? normal / length : glm::vec3(0);
}

glm::vec2 PixelLens::motionUV(const GBufferMapping& mapping, const glm::vec2& stored) const {
    const glm::vec2 motion = stored * mapping.motionScale / (mapping.motionInPixels ? size_ : glm::vec2(1));
    constexpr float kFarthest = 10; // what lies screens away is not found again
    return std::isfinite(motion.x + motion.y) ? glm::clamp(motion, -kFarthest, kFarthest) : glm::vec2(0);
}

glm::vec3 PixelLens::positionWS(const GBufferMeaning& meaning, const glm::vec3& stored) {
    const glm::vec3 position = meaning.axes == StoredAxes::ZUp ? glm::vec3(stored.x, stored.z, -stored.y) : stored;
    return position * meaning.metres;
}

Result<GBufferPixels> decodeLayers(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera,
                                   std::string_view name) {
    GBufferPixels pixels = LayerDecoder(layers, mapping, camera).decode();
    if (pixels.surfaces == 0)
        return invalidInput("{}: no pixel shows a surface: {} declared as {} holds no depth between 0 and {}, or no "
                            "pixel has a normal (--mapping says what the layers mean)",
                            name, mapping.depth.empty() ? mapping.position : mapping.depth,
                            mapping.depth.empty() ? "position" : storedDepthNames()[size_t(mapping.meaning.depth)],
                            mapping.background);
    return pixels;
}

} // namespace glint::scene
