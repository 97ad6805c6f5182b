#include "lab/sources/mirror_world.hpp"

#include "lab/renderer/lending.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace {

constexpr size_t kNone = SIZE_MAX;

/// Settings of reflections in mirrored views: mirrors, up to their depth, and the sources of the frame. Rays are
/// disabled, as their hits see the whole scene, and so is the previous frame, which had another camera.
Settings inMirrors(Settings settings) {
    settings.rays.enabled = false;
    settings.screen.colorSource = ColorSource::Current;
    settings.debug.outcome = false;
    settings.denoise.enabled = false; // a level's mirrors take turns: a history would be another mirror's
    settings.input.colorIsGamma = false;
    settings.output.colorIsGamma = false;
    return settings;
}

/// The camera of mirroredView.
scene::Camera mirroredCamera(const scene::Camera& camera, const glint::View& mirrored) {
    scene::Camera result = camera;
    result.viewToWorld = glm::mat4(glm::inverse(glm::dmat4(glm::make_mat4(mirrored.worldToView.data()))));
    return result;
}

/// False if all corners of the mirror's rectangle are beyond one side of the image.
bool isInPicture(const PlanarMirror& mirror, const View& view) {
    const auto vec = [](const std::array<float, 3>& v) { return glm::vec3(v[0], v[1], v[2]); };
    const glm::vec3 along = vec(mirror.tangentWS) * mirror.halfExtents[0];
    const glm::vec3 across = glm::cross(vec(mirror.normalWS), vec(mirror.tangentWS)) * mirror.halfExtents[1];
    unsigned outside = 31;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
        const glm::vec4 at =
            view.worldToClip * glm::vec4(vec(mirror.centerWS) + corner.x * along + corner.y * across, 1);
        outside &= (at.x < -at.w ? 1u : 0u) | (at.x > at.w ? 2u : 0u) | (at.y < -at.w ? 4u : 0u) |
                   (at.y > at.w ? 8u : 0u) | (at.w <= 0 ? 16u : 0u);
    }
    return outside == 0;
}

} // namespace

/// The frame whose mirrors are drawn.
struct MirrorWorld::Seen {
    gpu::Frame& frame;
    VkCommandBuffer commands;
    bool withSky;
    uint32_t frameIndex;
    uint32_t seed;
};

Result<MirrorWorld> MirrorWorld::create(gpu::Context& context, Context& library, Renderer& renderer,
                                        const std::vector<PlanarMirror>& mirrors, Probes* probes,
                                        const ProgramSettings& settings, uint32_t width, uint32_t height) {
    MirrorWorld world(renderer);
    world.context_ = &context;
    world.settings_ = settings;
    world.list_ = mirrors;
    const MirrorsSettings& wanted = settings.render.mirrors;
    const auto scaled = [&](uint32_t size) {
        return std::max(static_cast<uint32_t>(std::lround(static_cast<float>(size) * wanted.resolution)), 1u);
    };
    const Settings reflected = inMirrors(settings.reflections);
    // A single mirror never sees itself.
    const size_t depth = mirrors.size() > 1 ? static_cast<size_t>(wanted.depth) : 1;
    for (size_t i = 0; i < depth; ++i) {
        PlanarMirrorsDesc desc;
        desc.mirrors = world.list_;
        desc.width = scaled(width);
        desc.height = scaled(height);
        GLINT_TRY(planar, PlanarMirrors::create(library, desc));
        GLINT_TRY(target, renderer.makeTarget(desc.width, desc.height));
        Level level = {std::move(planar), std::move(target), nullptr};
        if (wanted.reflections) {
            ReflectionsDesc reflectionsDesc = {desc.width, desc.height, reflected};
            reflectionsDesc.framesInFlight = 1; // the session waits for every frame
            GLINT_TRY(reflections, Reflections::create(library, reflectionsDesc));
            level.reflections = std::make_unique<Reflections>(std::move(reflections));
            if (probes)
                GLINT_CHECK(level.reflections->setProbes(*probes));
        }
        world.levels_.push_back(std::move(level));
    }
    for (size_t i = 0; i + 1 < depth; ++i)
        if (world.levels_[i].reflections)
            GLINT_CHECK(world.levels_[i].reflections->setPlanar(world.levels_[i + 1].mirrors));
    GLINT_TRY(timers, gpu::Timers::create(context));
    world.timers_ = std::move(timers);
    return world;
}

Result<bool> MirrorWorld::setMirrors(const std::vector<PlanarMirror>& mirrors) {
    if (mirrors.size() != list_.size())
        return false;
    list_ = mirrors;
    for (Level& level : levels_)
        GLINT_CHECK(level.mirrors.setMirrors(mirrors));
    return true;
}

Result<void> MirrorWorld::record(VkCommandBuffer commands, const ViewParameters& parameters, bool withSky,
                                 uint32_t frameIndex, uint32_t seed) {
    gpu::Frame frame(*context_, commands, timers_.get());
    ViewParameters mirrored = parameters;
    mirrored.prevCamera.reset();
    return drawPictures({frame, commands, withSky, frameIndex, seed}, 0, mirrored, kNone);
}

/// `except`: the mirror whose mirrored view is being drawn.
Result<void> MirrorWorld::drawPictures(const Seen& seen, size_t level, const ViewParameters& parameters,
                                       size_t except) {
    const gpu::Image& picture = levels_[level].target.gbuffer.litRadiance;
    const View view = makeView(parameters.camera, picture.width(), picture.height(), parameters.jitterPX);
    for (size_t i = 0; i < list_.size(); ++i) {
        levels_[level].mirrors.skip(static_cast<uint32_t>(i));
        if (i != except && facesView(list_[i], libraryView(view, 0, 0)) && isInPicture(list_[i], view))
            GLINT_CHECK(drawPicture(seen, level, i, parameters, view));
    }
    return {};
}

/// `view`: the view of `parameters`, in which the mirror is visible.
Result<void> MirrorWorld::drawPicture(const Seen& seen, size_t level, size_t mirror, const ViewParameters& parameters,
                                      const View& view) {
    Level& here = levels_[level];
    RenderTarget& target = here.target;
    const glint::View mirroredLibraryView = mirroredView(libraryView(view, seen.frameIndex, seen.seed), list_[mirror]);
    ViewParameters mirrored = parameters;
    mirrored.camera = mirroredCamera(parameters.camera, mirroredLibraryView);
    mirrored.jitterPX.x = -parameters.jitterPX.x;
    mirrored.clipPlaneWS = glm::make_vec4(clipPlane(list_[mirror]).data());
    mirrored.sunDisc = false; // the sun's light on the mirror is the highlight of the sun's directional light
    if (level + 1 < levels_.size())
        GLINT_CHECK(drawPictures(seen, level + 1, mirrored, mirror));

    gpu::Frame& frame = seen.frame;
    GBuffer& g = renderer_->drawOpaque(frame, mirrored, target);
    gpu::Image reflected;
    gpu::Image* picture = &g.litRadiance;
    if (here.reflections) {
        const EnvironmentMap environment =
            seen.withSky ? lendEnvironmentMap(frame, renderer_->environment(), settings_.render.environment)
                         : EnvironmentMap();
        GLINT_CHECK(here.reflections->setInputs(lendGBuffer(frame, g), environment));
        reflected = borrow(here.reflections->record(seen.commands, mirroredLibraryView), "mirror/reflected");
        picture = &reflected;
    }
    renderer_->drawTransparent(frame, *picture, target);
    return here.mirrors.record(seen.commands, static_cast<uint32_t>(mirror),
                               {lend(frame, *picture), lend(frame, g.deviceDepth), mirroredLibraryView});
}

double MirrorWorld::milliseconds() {
    double sum = 0;
    for (const gpu::PassTime& time : timers_->latest())
        sum += time.milliseconds;
    return sum;
}

} // namespace glint::render
