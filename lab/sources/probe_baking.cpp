#include "lab/sources/probe_baking.hpp"

#include "gpu/transfer.hpp"
#include "lab/renderer/lending.hpp"
#include "lab/sources/probe_placing.hpp"
#include "lab/sources/scene_hash.hpp"
#include "shared/environment.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace glint::render {
namespace {

constexpr uint32_t kNeedWidth = 192; ///< pixels; width of the images in which reflective surfaces are found
constexpr size_t kMostCameras = 8;
constexpr size_t kMostNeeds = 400;
constexpr uint32_t kSpaceCells = 64;
constexpr uint32_t kSeenFace = 32; ///< directions per face side, for fitting the proxy
constexpr uint32_t kSamples = 2;   ///< per texel side; otherwise thin bright objects would be missed in some texels

/// Vulkan 1.3, "Cube Map Face Selection": the axis of a face, and the direction of its rows.
struct FaceAxes {
    glm::vec3 forward;
    glm::vec3 up;
};
constexpr FaceAxes kFaces[6] = {{{1, 0, 0}, {0, 1, 0}},  {{-1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, -1}},
                                {{0, -1, 0}, {0, 0, 1}}, {{0, 0, 1}, {0, 1, 0}},  {{0, 0, -1}, {0, 1, 0}}};

scene::Camera faceCamera(const glm::vec3& positionWS, uint32_t face, float near) {
    const auto& [forward, up] = kFaces[face];
    scene::Camera camera;
    camera.viewToWorld = glm::mat4(glm::vec4(glm::cross(forward, up), 0), glm::vec4(up, 0), glm::vec4(-forward, 0),
                                   glm::vec4(positionWS, 1));
    camera.fovY = glm::half_pi<float>();
    camera.near = near;
    return camera;
}

/// Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2), listing 2.
glm::vec3 decodeOctahedral(const glm::vec2& p) {
    glm::vec3 n(p.x, p.y, 1 - std::abs(p.x) - std::abs(p.y));
    if (n.z < 0) {
        const glm::vec2 folded = 1.0f - glm::abs(glm::vec2(n.y, n.x));
        n.x = std::copysign(folded.x, n.x);
        n.y = std::copysign(folded.y, n.y);
    }
    return glm::normalize(n);
}

class Bake {
public:
    Bake(gpu::Context& context, Context& library, Renderer& renderer, const JobInputs& inputs,
         const RenderSettings& settings, const BakeOptions& options)
        : context_(context), library_(library), renderer_(renderer), inputs_(inputs), settings_(settings),
          options_(options) {}

    Result<std::vector<BakedProbe>> run() {
        GLINT_CHECK(options_.places.empty() ? findPlaces() : takePlaces());
        if (placed_.empty())
            return std::vector<BakedProbe>();
        GLINT_CHECK(checkSize());
        GLINT_CHECK(makeCubes());
        GLINT_CHECK(drawAll(nullptr));
        for (size_t i = 0; i < placed_.size(); ++i)
            options_.places.empty() ? makeVolumes(i) : takeVolumes(i);
        return finish();
    }

private:
    void tell(const char* what, size_t done, size_t of) const {
        if (options_.progress)
            options_.progress(what, done, of);
    }

    /// Checks the limits of the file before the work is done.
    Result<void> checkSize() const {
        constexpr size_t kNumbers = 1024; // maximum bytes of a probe without its cube, and of the file header
        const size_t bytes = (placed_.size() + 1) * (probeTexels(options_.faceSize) * sizeof(uint64_t) + kNumbers);
        if (bytes > kMostProbeFileBytes)
            return invalidArgument(
                "{} probes of {} texels a face make {} MB, a file holds {}: bake fewer or smaller ones", placed_.size(),
                options_.faceSize, bytes >> 20, kMostProbeFileBytes >> 20);
        return {};
    }

    // ------------------------------------------------------------ places

    Result<void> takePlaces() {
        const scene::Bounds& all = renderer_.boundsWS();
        cellSize_ = all.empty() ? 1 : std::max(glm::length(all.max - all.min), 1e-6f) / kSpaceCells;
        for (const ProbePlace& place : options_.places) {
            const auto& at = place.probe.capturePositionWS;
            PlacedProbe placed;
            placed.positionWS = {at[0], at[1], at[2]};
            placed_.push_back(placed);
        }
        return {};
    }

    Result<void> findPlaces() {
        GLINT_CHECK(findNeeds());
        const scene::Bounds domain = probeDomain(needs_, renderer_.boundsWS());
        if (domain.empty())
            return {};
        const FreeSpace space = FreeSpace::build(inputs_.pose, domain, kSpaceCells);
        cellSize_ = space.cellSize();
        const std::vector<ReflectiveNeed> gathered = gatherNeeds(needs_, 2 * cellSize_, kMostNeeds);
        tell("placing probes", 0, 1);
        placed_ = placeProbes(space, gathered, options_.most);
        return {};
    }

    Result<void> findNeeds() {
        std::vector<scene::Camera> cameras = {inputs_.camera};
        cameras.insert(cameras.end(), inputs_.pose.cameras.begin(), inputs_.pose.cameras.end());
        cameras.resize(std::min(cameras.size(), kMostCameras));
        const uint32_t height = std::max(kNeedWidth * inputs_.height / std::max(inputs_.width, 1u), 1u);
        GLINT_CHECK(renderer_.resize(kNeedWidth, std::min(height, 4 * kNeedWidth)));
        for (size_t i = 0; i < cameras.size(); ++i) {
            tell("looking for reflective surfaces", i, cameras.size());
            GLINT_CHECK(addNeeds(cameras[i]));
        }
        return {};
    }

    Result<void> addNeeds(const scene::Camera& camera) {
        ViewParameters parameters;
        parameters.camera = camera;
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands);
            renderer_.drawOpaque(frame, parameters);
        }));
        GBuffer& g = renderer_.gbuffer();
        GLINT_TRY(depth, gpu::downloadImageAsFloats(context_, g.deviceDepth));
        GLINT_TRY(normal, gpu::downloadImageAsFloats(context_, g.normal));
        GLINT_TRY(material, gpu::downloadImageAsFloats(context_, g.material));
        const View view = renderer_.view(parameters);
        for (uint32_t y = 0; y < view.height; ++y)
            for (uint32_t x = 0; x < view.width; ++x) {
                const size_t i = (size_t{y} * view.width + x) * 4;
                if (depth[i] <= 0)
                    continue;
                const glm::vec4 clip((static_cast<float>(x) + 0.5f) / static_cast<float>(view.width) * 2 - 1,
                                     1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(view.height) * 2, depth[i],
                                     1);
                const glm::vec4 at = view.clipToWorld * clip;
                ReflectiveNeed need;
                need.positionWS = glm::vec3(at) / at.w;
                need.normalWS = decodeOctahedral({normal[i], normal[i + 1]});
                const glm::vec3 toEye =
                    view.orthographic ? -view.forwardWS() : glm::normalize(view.positionWS() - need.positionWS);
                const float f0 = std::max({material[i], material[i + 1], material[i + 2]});
                if (f0 <= 0)
                    continue;
                const float NoV = std::clamp(glm::dot(need.normalWS, toEye), 0.0f, 1.0f);
                const float fresnel = f0 + (1 - f0) * std::pow(1 - NoV, 5.0f); // Schlick 1994
                // Parallax errors are not visible on rough surfaces.
                need.weight = fresnel * (1 - 0.8f * material[i + 3]);
                need.reflectedWS = glm::reflect(-toEye, need.normalWS);
                needs_.push_back(need);
            }
        return {};
    }

    // ------------------------------------------------------------ faces

    uint32_t pictureSize() const { return options_.faceSize * kSamples; }

    Result<void> makeCubes() {
        GLINT_TRY(toCube,
                  gpu::Pipeline::compute(context_, {"environment/face_to_cube", sizeof(shared::FaceConstants), {}}));
        toCube_ = std::move(toCube);
        const uint32_t face = options_.faceSize;
        for (size_t i = 0; i < placed_.size(); ++i) {
            GLINT_TRY(cube, gpu::Image::create(context_,
                                               {"bake/cube", kRadianceFormat, face, face, 1, 6, gpu::ImageShape::Cube,
                                                VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT}));
            cubes_.push_back(std::move(cube));
        }
        seen_.resize(placed_.size());
        return renderer_.resize(pictureSize(), pictureSize());
    }

    /// Draws every face of every probe; with reflections once there are probes to sample.
    Result<void> drawAll(Reflections* reflections) {
        for (size_t i = 0; i < placed_.size(); ++i)
            for (uint32_t face = 0; face < 6; ++face) {
                tell("drawing probes", i * 6 + face, placed_.size() * 6);
                GLINT_CHECK(drawFace(i, face, reflections));
                if (!reflections)
                    GLINT_CHECK(measureFace(i, face));
            }
        return {};
    }

    Result<void> drawFace(size_t probe, uint32_t face, Reflections* reflections) {
        ViewParameters parameters;
        parameters.camera = faceCamera(placed_[probe].positionWS, face, cellSize_ * 0.02f);
        parameters.highlights = false;
        Result<void> status;
        GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
            gpu::Frame frame(context_, commands);
            GBuffer& g = renderer_.drawOpaque(frame, parameters);
            gpu::Image* picture = &g.litRadiance;
            gpu::Image reflected;
            if (reflections) {
                const EnvironmentMap environment =
                    inputs_.environment == EnvironmentKind::None
                        ? EnvironmentMap()
                        : lendEnvironmentMap(frame, renderer_.environment(), settings_.environment);
                status = reflections->setInputs(lendGBuffer(frame, g), environment);
                if (!status)
                    return;
                reflected = borrow(reflections->record(commands, libraryView(renderer_.view(parameters), face, 0)),
                                   "bake/reflected");
                picture = &reflected;
            }
            renderer_.drawTransparent(frame, *picture);
            const shared::FaceConstants constants = {face, parameters.camera.near};
            frame.pass(toCube_)
                .read("picture", *picture, gpu::SamplerKind::NearestClamp)
                .read("depth", g.deviceDepth, gpu::SamplerKind::NearestClamp)
                .write("cube", cubes_[probe], 0, true)
                .push(constants)
                .dispatch(options_.faceSize, options_.faceSize);
            frame.hand(*picture, kSampled);
            frame.hand(cubes_[probe], kSampled);
        }));
        return status;
    }

    /// Distances in some directions of the face drawn last.
    Result<void> measureFace(size_t probe, uint32_t face) {
        GLINT_TRY(depth, gpu::downloadImageAsFloats(context_, renderer_.gbuffer().deviceDepth));
        const scene::Camera camera = faceCamera(placed_[probe].positionWS, face, cellSize_ * 0.02f);
        const uint32_t size = pictureSize();
        const uint32_t samples = std::min(kSeenFace, size);
        const uint32_t step = size / samples;
        for (uint32_t y = 0; y < samples; ++y)
            for (uint32_t x = 0; x < samples; ++x) {
                const glm::uvec2 px(x * step + step / 2, y * step + step / 2);
                const glm::vec2 uv = (glm::vec2(px) + 0.5f) / static_cast<float>(size);
                const glm::vec3 throughVS(uv.x * 2 - 1, 1 - uv.y * 2, -1);
                const float length = glm::length(throughVS);
                const float device = depth[(size_t{px.y} * size + px.x) * 4];
                SeenDistance ray;
                ray.directionWS = glm::normalize(glm::mat3(camera.viewToWorld) * throughVS);
                ray.distance = device > 0 ? camera.near / device * length // lab/renderer/view.hpp: depth = near / viewZ
                                          : std::numeric_limits<float>::infinity();
                ray.weight = 4 / (static_cast<float>(samples * samples) * length * length * length);
                seen_[probe].push_back(ray);
            }
        return {};
    }

    // ------------------------------------------------------------ volumes

    static ProbeVolume boxOf(const scene::Bounds& bounds) {
        ProbeVolume box;
        const glm::vec3 center = (bounds.min + bounds.max) * 0.5f;
        const glm::vec3 half = glm::max((bounds.max - bounds.min) * 0.5f, glm::vec3(1e-4f));
        box.centerWS = {center.x, center.y, center.z};
        box.halfExtents = {half.x, half.y, half.z};
        return box;
    }

    float farthest() const {
        const scene::Bounds& all = renderer_.boundsWS();
        return all.empty() ? 1 : 10 * std::max(glm::length(all.max - all.min), 1e-6f);
    }

    void takeVolumes(size_t i) {
        Probe probe = options_.places[i].probe;
        if (options_.places[i].fitsProxy)
            probe.proxyVolume = boxOf(fitProxyBox(placed_[i].positionWS, seen_[i], farthest()));
        probe.alphaIsInverseDistance = true;
        baked_.push_back({probe, options_.faceSize, {}});
    }

    /// The best placed probe covers the whole scene, as a fallback; the others cover the needs that they serve best.
    void makeVolumes(size_t i) {
        const PlacedProbe& placed = placed_[i];
        const scene::Bounds& all = renderer_.boundsWS();
        scene::Bounds influence = placed.needsWS;
        const float blend = std::max(2 * cellSize_, 0.1f * glm::length(influence.max - influence.min));
        if (i == 0) {
            influence.min = glm::min(influence.min, all.min);
            influence.max = glm::max(influence.max, all.max);
        }
        influence.min -= blend + cellSize_;
        influence.max += blend + cellSize_;
        weighByNeeds(seen_[i], placed.needs);
        Probe probe;
        probe.capturePositionWS = {placed.positionWS.x, placed.positionWS.y, placed.positionWS.z};
        probe.influence = boxOf(influence);
        probe.blendDistance.fill(blend);
        probe.proxyVolume = boxOf(fitProxyBox(placed.positionWS, seen_[i], farthest()));
        probe.alphaIsInverseDistance = true;
        baked_.push_back({probe, options_.faceSize, {}});
    }

    // ------------------------------------------------------------ filtering

    Result<std::vector<BakedProbe>> finish() {
        std::vector<Probe> list;
        for (size_t i = 0; i < baked_.size(); ++i) {
            list.push_back(baked_[i].probe);
            list.back().cube = {cubes_[i].handle(), cubes_[i].view(), kRadianceFormat, options_.faceSize,
                                options_.faceSize};
        }
        GLINT_TRY(probes, Probes::create(library_, {list, options_.faceSize}));
        GLINT_CHECK(filter(probes));
        if (options_.bounces > 1)
            GLINT_CHECK(bounce(probes));
        for (size_t i = 0; i < baked_.size(); ++i)
            GLINT_CHECK(readBack(probes, i));
        return std::move(baked_);
    }

    Result<void> filter(Probes& probes) {
        tell("filtering probes", 0, 1);
        return context_.submitAndWait([&](VkCommandBuffer commands) { probes.record(commands); });
    }

    /// Draws the faces again, with the previous probes reflected in mirrors.
    Result<void> bounce(Probes& probes) {
        ReflectionsDesc desc;
        desc.width = desc.height = pictureSize();
        desc.settings.screen.enabled = false;
        desc.settings.denoise.enabled = false; // each face is one frame
        desc.framesInFlight = 1;               // the baking waits for every face
        GLINT_TRY(reflections, Reflections::create(library_, desc));
        GLINT_CHECK(reflections.setProbes(probes));
        for (uint32_t done = 1; done < options_.bounces; ++done) {
            GLINT_CHECK(drawAll(&reflections));
            for (uint32_t i = 0; i < probes.count(); ++i)
                probes.refilter(i);
            GLINT_CHECK(filter(probes));
        }
        return {};
    }

    Result<void> readBack(Probes& probes, size_t i) {
        const auto number = static_cast<uint32_t>(i);
        gpu::Image cube = borrow(probes.cube(number), "bake/filtered", probes.cubeMips(number), 6);
        for (uint32_t mip = 0; mip < probes.cubeMips(number); ++mip)
            for (uint32_t face = 0; face < 6; ++face) {
                GLINT_TRY(bytes, gpu::downloadImage(context_, cube, mip, face));
                const size_t before = baked_[i].texels.size();
                baked_[i].texels.resize(before + bytes.size() / sizeof(uint64_t));
                std::memcpy(&baked_[i].texels[before], bytes.data(), bytes.size());
            }
        return {};
    }

    gpu::Context& context_;
    Context& library_;
    Renderer& renderer_;
    const JobInputs& inputs_;
    const RenderSettings& settings_;
    const BakeOptions& options_;
    float cellSize_ = 1;
    gpu::Pipeline toCube_;
    std::vector<ReflectiveNeed> needs_;
    std::vector<PlacedProbe> placed_;
    std::vector<gpu::Image> cubes_;
    std::vector<std::vector<SeenDistance>> seen_;
    std::vector<BakedProbe> baked_;
};

} // namespace

Result<ProbeSet> bakeProbes(gpu::Context& context, Context& library, Renderer& renderer, const JobInputs& inputs,
                            const RenderSettings& settings, const std::string& sceneName, const BakeOptions& options) {
    ProbeSet set;
    set.scene = sceneName;
    set.sceneHash = sceneHash(*inputs.scene, inputs.pose);
    set.lightHash = lightHash(inputs, settings);
    Bake bake(context, library, renderer, inputs, settings, options);
    GLINT_TRY(probes, bake.run());
    set.probes = std::move(probes);
    return set;
}

} // namespace glint::render
