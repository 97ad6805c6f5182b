#include "reflect/planar/planar.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reflect/host_image.hpp"
#include "reflect/input_checks.hpp"
#include "reflect/planar/mirrored_view.hpp"
#include "reflect/prepare/conventions.hpp"
#include "reflect/prepare/frame_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace glint::reflect {
namespace {

constexpr uint32_t kLargestPicture = 16384; ///< pixels per side; every Vulkan 1.3 desktop device supports it

Result<void> checkMirror(const PlanarMirror& mirror, size_t number) {
    if (!within(mirror.centerWS, -kLongest, kLongest))
        return invalidArgument("mirror {}: its centre must be finite, within {} m", number, kLongest);
    const glm::vec3 normal = toVec(mirror.normalWS);
    const glm::vec3 tangent = toVec(mirror.tangentWS);
    const auto isUnit = [](const glm::vec3& v) { return std::abs(glm::length(v) - 1) < 1e-3f; };
    if (!isUnit(normal) || !isUnit(tangent) || !(std::abs(glm::dot(normal, tangent)) < 1e-3f))
        return invalidArgument("mirror {}: normal and tangent must be unit vectors across each other", number);
    if (!within(mirror.halfExtents, 1e-6f, kLongest))
        return invalidArgument("mirror {}: its half extents must be above 0, at most {} m", number, kLongest);
    if (!within({&mirror.tolerance, 1}, 0, kLongest))
        return invalidArgument("mirror {}: its tolerance must be 0 to {} m", number, kLongest);
    return {};
}

Result<void> checkMirrors(std::span<const PlanarMirror> mirrors) {
    for (size_t i = 0; i < mirrors.size(); ++i)
        GLINT_CHECK(checkMirror(mirrors[i], i));
    return {};
}

Result<void> checkPicture(const gpu::Context& context, const HostImage& image, const char* name, uint32_t mirror) {
    if (!image.image || !image.view || image.width < 1 || image.height < 1)
        return invalidArgument("mirror {}: its picture's `{}` is missing: hand over an image and its view", mirror,
                               name);
    return checkImage(context, image, formatText("mirror {}: its picture's `{}`", mirror, name),
                      std::string_view(name) == "depth" ? ImageRole::Depth : ImageRole::Color);
}

} // namespace

Result<std::unique_ptr<PlanarState>> PlanarState::create(gpu::Context& context, const PlanarMirrorsDesc& desc) {
    if (desc.mirrors.size() > kMaxPlanarMirrors)
        return invalidArgument("{} planar mirrors: at most {}", desc.mirrors.size(), kMaxPlanarMirrors);
    if (desc.width < 1 || desc.height < 1 || desc.width > kLargestPicture || desc.height > kLargestPicture)
        return invalidArgument("planar mirrors with pictures of {}x{} pixels: each side must be 1 to {}", desc.width,
                               desc.height, kLargestPicture);
    GLINT_CHECK(checkMirrors(desc.mirrors));
    std::unique_ptr<PlanarState> state(new PlanarState(context));
    state->conventions_ = desc.conventions;
    GLINT_TRY(take, gpu::Pipeline::compute(context, {"planar/take", 0, {}}));
    GLINT_TRY(takeSamples, gpu::Pipeline::compute(context, {"planar/take_samples", 0, {}}));
    GLINT_TRY(shrink, gpu::Pipeline::compute(context, {"planar/shrink", 0, {}}));
    GLINT_TRY(constants,
              gpu::Buffer::create(context, {"planar/frame", sizeof(FrameBlockValues),
                                            VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    state->take_ = std::move(take);
    state->takeSamples_ = std::move(takeSamples);
    state->shrink_ = std::move(shrink);
    state->frameConstants_ = std::move(constants);
    for (const PlanarMirror& mirror : desc.mirrors)
        GLINT_CHECK(state->makeSlot(desc, mirror));
    std::vector<gpu::TextureTable::Entry> entries;
    gpu::SamplerDesc sampler;
    sampler.wrapU = sampler.wrapV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    gpu::SamplerDesc texels = sampler;
    texels.magFilter = texels.minFilter = VK_FILTER_NEAREST;
    texels.mipMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    for (const Slot& slot : state->slots_) {
        entries.push_back({&slot.radiance, sampler});
        entries.push_back({&slot.viewZ, texels});
    }
    GLINT_TRY(table, gpu::TextureTable::create(context, entries));
    state->table_ = std::move(table);
    if (state->slots_.empty())
        return state;
    gpu::Frame frame = gpu::Frame::rehearsal(context); // its own images replace the host's
    Slot& slot = state->slots_.front();
    state->take(frame, slot, slot.radiance, slot.viewZ, {});
    GLINT_CHECK(frame.firstError());
    return state;
}

Result<void> PlanarState::makeSlot(const PlanarMirrorsDesc& desc, const PlanarMirror& mirror) {
    const auto mips = static_cast<uint32_t>(std::bit_width(std::max(desc.width, desc.height)));
    constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
    Slot slot;
    slot.mirror = mirror;
    GLINT_TRY(radiance, gpu::Image::create(context_, {"planar/radiance", VK_FORMAT_R16G16B16A16_SFLOAT, desc.width,
                                                      desc.height, mips, 1, gpu::ImageShape::Flat, kUsage}));
    GLINT_TRY(viewZ, gpu::Image::create(context_, {"planar/viewZ", VK_FORMAT_R32_SFLOAT, desc.width, desc.height, 1, 1,
                                                   gpu::ImageShape::Flat, kUsage}));
    slot.radiance = std::move(radiance);
    slot.viewZ = std::move(viewZ);
    // The table refers to the images before they are written: the first writer waits for all possible earlier readers.
    for (gpu::Image* image : {&slot.radiance, &slot.viewZ})
        for (gpu::ResourceState& state : image->states())
            state.readStages = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    slots_.push_back(std::move(slot));
    return {};
}

Result<void> PlanarState::setMirrors(std::span<const PlanarMirror> mirrors) {
    if (mirrors.size() != slots_.size())
        return invalidArgument("{} mirrors, these were made for {}", mirrors.size(), slots_.size());
    GLINT_CHECK(checkMirrors(mirrors));
    for (size_t i = 0; i < mirrors.size(); ++i) {
        slots_[i].mirror = mirrors[i];
        slots_[i].shown = false; // its mirrored view belongs to the old position
    }
    return {};
}

void PlanarState::skip(uint32_t mirror) {
    GLINT_ASSERT(mirror < slots_.size(), "mirror {} of {}", mirror, slots_.size());
    slots_[mirror].shown = false;
}

Result<void> PlanarState::record(VkCommandBuffer commands, uint32_t mirror, const PlanarPicture& picture) {
    if (mirror >= slots_.size())
        return invalidArgument("mirror {}: there are {}", mirror, slots_.size());
    GLINT_CHECK(checkPicture(context_, picture.radiance, "radiance", mirror));
    GLINT_CHECK(checkPicture(context_, picture.depth, "depth", mirror));
    if (const Result<void> view = checkView(picture.view); !view)
        return invalidArgument("mirror {}: its picture's {}", mirror, view.error().message);
    if (picture.radiance.samples != 1)
        return invalidArgument("mirror {}: its picture's radiance has {} samples a pixel, but must have 1", mirror,
                               picture.radiance.samples);
    if (picture.radiance.width != picture.depth.width || picture.radiance.height != picture.depth.height)
        return invalidArgument("mirror {}: its picture's radiance is {}x{}, its depth {}x{}", mirror,
                               picture.radiance.width, picture.radiance.height, picture.depth.width,
                               picture.depth.height);
    gpu::Frame frame(context_, commands);
    gpu::Image radiance = borrow(picture.radiance, "planar/hostRadiance");
    gpu::Image depth = borrow(picture.depth, "planar/hostDepth");
    take(frame, slots_[mirror], radiance, depth,
         makeFrameConstants(picture.view, conventions_, picture.depth.width, picture.depth.height));
    giveBack(frame, radiance, picture.radiance);
    giveBack(frame, depth, picture.depth);
    slots_[mirror].shown = true;
    return {};
}

void PlanarState::take(gpu::Frame& frame, Slot& slot, gpu::Image& radiance, gpu::Image& depth,
                       const shared::FrameConstants& constants) {
    frame.update(frameConstants_, &constants, sizeof(constants)); // the passes below read no settings
    frame.pass(depth.desc().samples > 1 ? takeSamples_ : take_)
        .read("frame", frameConstants_)
        .read("hostRadiance", radiance)
        .read("hostDepth", depth, gpu::SamplerKind::NearestClamp)
        .write("radiance", slot.radiance)
        .write("viewZ", slot.viewZ)
        .dispatch(slot.viewZ.width(), slot.viewZ.height());
    for (uint32_t mip = 1; mip < slot.radiance.desc().mips; ++mip)
        frame.pass(shrink_)
            .readWrite("finer", slot.radiance, mip - 1)
            .write("coarser", slot.radiance, mip)
            .dispatch(std::max(slot.radiance.width() >> mip, 1u), std::max(slot.radiance.height() >> mip, 1u));
    frame.hand(slot.radiance, kHandedOut);
    frame.hand(slot.viewZ, kHandedOut);
}

std::span<const shared::PlanarRecord> PlanarState::records(const shared::FrameConstants& constants,
                                                           std::span<shared::PlanarRecord> room) const {
    size_t count = 0;
    const glm::dmat4 worldToView(constants.worldToView);
    for (uint32_t i = 0; i < slots_.size(); ++i) {
        const Slot& slot = slots_[i];
        if (!slot.shown)
            continue;
        const glm::dvec3 normal = glm::normalize(glm::dvec3(toVec(slot.mirror.normalWS)));
        const glm::dvec3 tangent = glm::normalize(glm::dvec3(toVec(slot.mirror.tangentWS)));
        const glm::dmat3 rotation(worldToView);
        shared::PlanarRecord record = {};
        record.centerVS = glm::vec3(worldToView * glm::dvec4(glm::dvec3(toVec(slot.mirror.centerWS)), 1));
        record.normalVS = glm::vec3(rotation * normal);
        record.tangentVS = glm::vec3(rotation * tangent);
        record.bitangentVS = glm::vec3(rotation * glm::cross(normal, tangent));
        record.tolerance = toleranceOf(slot.mirror);
        record.halfWidth = slot.mirror.halfExtents[0];
        record.halfHeight = slot.mirror.halfExtents[1];
        record.picture = i;
        record.size = {slot.viewZ.width(), slot.viewZ.height()};
        record.lastMip = static_cast<float>(slot.radiance.desc().mips - 1);
        room[count++] = record;
    }
    return room.first(count);
}

} // namespace glint::reflect

// ---------------------------------------------------------------- the public class

namespace glint {

PlanarMirrors::PlanarMirrors(std::unique_ptr<reflect::PlanarState> state) : state_(std::move(state)) {}
PlanarMirrors::~PlanarMirrors() = default;
PlanarMirrors::PlanarMirrors(PlanarMirrors&&) noexcept = default;
PlanarMirrors& PlanarMirrors::operator=(PlanarMirrors&&) noexcept = default;

Result<PlanarMirrors> PlanarMirrors::create(Context& context, const PlanarMirrorsDesc& desc) {
    GLINT_TRY(state, reflect::PlanarState::create(context.gpu(), desc));
    return PlanarMirrors(std::move(state));
}

uint32_t PlanarMirrors::count() const {
    return state_->count();
}

Result<void> PlanarMirrors::setMirrors(std::span<const PlanarMirror> mirrors) {
    return state_->setMirrors(mirrors);
}

Result<void> PlanarMirrors::record(VkCommandBuffer commands, uint32_t mirror, const PlanarPicture& picture) {
    return state_->record(commands, mirror, picture);
}

void PlanarMirrors::skip(uint32_t mirror) {
    state_->skip(mirror);
}

} // namespace glint
