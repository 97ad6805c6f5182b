#include "reflect/probes/probes.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reflect/host_image.hpp"
#include "reflect/host_numbers.hpp"
#include "reflect/input_checks.hpp"
#include "reflect/probes/probe_grid.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace glint::reflect {
namespace {

constexpr uint32_t kSmallestFace = 16; ///< two mips
constexpr uint32_t kLargestFace = 1024;

Result<void> checkVolume(const ProbeVolume& volume, size_t extents, const char* name, size_t number) {
    const auto& q = volume.rotation;
    const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(std::abs(length - 1) < 1e-3f))
        return invalidArgument("probe {}: the rotation of its {} must be a unit quaternion; its length is {}", number,
                               name, length);
    if (!within(volume.centerWS, -kLongest, kLongest))
        return invalidArgument("probe {}: the centre of its {} must be finite, within {} m", number, name, kLongest);
    if (!within(std::span(volume.halfExtents).first(extents), 1e-6f, kLongest))
        return invalidArgument("probe {}: the half extents of its {} must be above 0, at most {} m", number, name,
                               kLongest);
    return {};
}

Result<void> checkVolumes(const Probe& probe, size_t number) {
    if (probe.shape > ProbeShape::Sphere || probe.proxy > ProbeProxy::Sphere)
        return invalidArgument("probe {}: no such shape", number);
    GLINT_CHECK(checkVolume(probe.influence, probe.shape == ProbeShape::Sphere ? 1 : 3, "influence", number));
    if (probe.proxy != ProbeProxy::Infinite)
        GLINT_CHECK(checkVolume(probe.proxyVolume, probe.proxy == ProbeProxy::Sphere ? 1 : 3, "proxy", number));
    if (!within(probe.capturePositionWS, -kLongest, kLongest))
        return invalidArgument("probe {}: its capture position must be finite, within {} m", number, kLongest);
    if (!within(probe.blendDistance, 0, kLongest) || !within(probe.blendNormalDistance, 0, kLongest))
        return invalidArgument("probe {}: its blend distances must be 0 to {} m", number, kLongest);
    if (!within(probe.faceFade, 0, 1) || !within({&probe.weight, 1}, 0, 1))
        return invalidArgument("probe {}: its weight and face fades must be 0 to 1", number);
    if (!within({&probe.strength, 1}, 0, 65504))
        return invalidArgument("probe {}: its strength must be 0 to 65504", number);
    return {};
}

Result<void> checkProbeCube(const gpu::Context& context, const Probe& probe, size_t number) {
    GLINT_CHECK(checkCube(context, probe.cube, probe.mips, formatText("probe {}: its cube", number)));
    if (probe.prefiltered && probe.cube.layout != VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL)
        return invalidArgument("probe {}: a prefiltered cube must be in SHADER_READ_ONLY_OPTIMAL, not VkImageLayout {}",
                               number, static_cast<int>(probe.cube.layout));
    return {};
}

/// Rows of the world-to-volume transform.
void packTransform(const ProbeVolume& volume, shared::float4 (&rows)[3]) {
    const auto& q = volume.rotation;
    const glm::dmat3 axes = glm::mat3_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]))); // columns: WS
    for (int row = 0; row < 3; ++row)
        rows[row] = glm::vec4(axes[row], -glm::dot(axes[row], glm::dvec3(toVec(volume.centerWS))));
}

/// Minimum width of a hard edge, which avoids a division by 0.
float blendOf(float distance, float extent) {
    return std::max(distance, extent * 1e-5f);
}

shared::ProbeRecord packRecord(const Probe& probe, uint32_t cube, uint32_t mips) {
    shared::ProbeRecord out = {};
    const bool sphere = probe.shape == ProbeShape::Sphere;
    packTransform(probe.influence, out.worldToInfluence);
    out.influenceExtents = sphere ? glm::vec3(probe.influence.halfExtents[0]) : toVec(probe.influence.halfExtents);
    out.influenceShape = sphere ? shared::kProbeSphere : shared::kProbeBox;
    out.proxyShape = shared::kProbeNoProxy;
    if (probe.proxy != ProbeProxy::Infinite) {
        packTransform(probe.proxyVolume, out.worldToProxy);
        out.proxyExtents = toVec(probe.proxyVolume.halfExtents);
        out.proxyShape = probe.proxy == ProbeProxy::Box ? shared::kProbeBox : shared::kProbeSphere;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<size_t>(axis) * 2;
        out.blendPos[axis] = blendOf(probe.blendDistance[i], out.influenceExtents[axis]);
        out.blendNeg[axis] = blendOf(probe.blendDistance[i + 1], out.influenceExtents[axis]);
        out.blendNormalPos[axis] = probe.blendNormalDistance[i];
        out.blendNormalNeg[axis] = probe.blendNormalDistance[i + 1];
        out.faceFadePos[axis] = probe.faceFade[i];
        out.faceFadeNeg[axis] = probe.faceFade[i + 1];
    }
    out.weight = probe.weight;
    out.strength = probe.strength;
    out.lastMip = static_cast<float>(mips - 1);
    out.cube = cube;
    out.capturePositionWS = toVec(probe.capturePositionWS);
    out.distances = probe.alphaIsInverseDistance ? 1 : 0;
    return out;
}

ProbeBounds boundsOf(const Probe& probe) {
    const glm::vec3 center = toVec(probe.influence.centerWS);
    const glm::vec3 half = toVec(probe.influence.halfExtents);
    if (probe.shape == ProbeShape::Sphere)
        return {center - half.x, center + half.x, 4 / 3.0 * glm::pi<double>() * std::pow(double(half.x), 3)};
    const auto& q = probe.influence.rotation;
    const glm::mat3 axes = glm::mat3_cast(glm::normalize(glm::quat(q[3], q[0], q[1], q[2])));
    const glm::vec3 reach = glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z;
    return {center - reach, center + reach, 8.0 * half.x * half.y * half.z};
}

} // namespace

Result<std::unique_ptr<ProbesState>> ProbesState::create(gpu::Context& context, const ProbesDesc& desc) {
    if (desc.probes.size() > kMaxProbes)
        return invalidArgument("{} probes: at most {}", desc.probes.size(), kMaxProbes);
    if (desc.faceSize != 0 &&
        (desc.faceSize < kSmallestFace || desc.faceSize > kLargestFace || !std::has_single_bit(desc.faceSize)))
        return invalidArgument("probes with faces of {} texels: a power of two from {} to {}", desc.faceSize,
                               kSmallestFace, kLargestFace);
    std::unique_ptr<ProbesState> state(new ProbesState(context));
    GLINT_TRY(progress, gpu::Progress::create(context, "probes/progress"));
    state->progress_ = std::move(progress);
    for (const Probe& probe : desc.probes) {
        GLINT_CHECK(checkProbeCube(context, probe, state->cubes_.size()));
        GLINT_CHECK(checkVolumes(probe, state->cubes_.size()));
        GLINT_CHECK(state->addCube(probe, desc.faceSize));
    }
    if (!state->sources_.empty()) {
        GLINT_TRY(prefilter, gpu::CubePrefilter::create(context));
        state->prefilter_ = std::move(prefilter);
    }
    std::vector<VkDescriptorImageInfo> infos;
    for (const Cube& cube : state->cubes_)
        infos.push_back({context.sampler(gpu::SamplerKind::LinearClamp),
                         cube.filtered ? cube.filtered.view() : cube.host.view,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    GLINT_TRY(table, gpu::TextureTable::create(context, infos));
    state->table_ = std::move(table);
    const size_t count = desc.probes.size();
    GLINT_CHECK(state->records_.create(context, "probes/records", count * sizeof(shared::ProbeRecord)));
    const size_t most = count == 0 ? 1 : kMaxProbeCells + 1; // the finest grid that any volumes may need
    GLINT_CHECK(
        state->cells_.create(context, "probes/cells", sizeof(shared::ProbeGridHeader) + most * sizeof(uint32_t)));
    GLINT_CHECK(state->lists_.create(context, "probes/lists", (count == 0 ? 1 : kMaxProbeListed) * sizeof(uint32_t)));
    GLINT_CHECK(state->setVolumes(desc.probes));
    return state;
}

Result<void> ProbesState::addCube(const Probe& probe, uint32_t faceSize) {
    Cube cube;
    cube.host = probe.cube;
    cube.hostMips = probe.mips;
    cube.mips = probe.mips;
    if (!probe.prefiltered) {
        const uint32_t face =
            faceSize != 0 ? faceSize : std::clamp(std::bit_floor(probe.cube.width), kSmallestFace, kLargestFace);
        cube.mips = gpu::cubeMips(face, gpu::kLastFilteredFace);
        cube.filtering.ask();
        const auto make = [&](const char* name, uint32_t mips) {
            return gpu::Image::create(context_,
                                      {name, VK_FORMAT_R16G16B16A16_SFLOAT, face, face, mips, 6, gpu::ImageShape::Cube,
                                       VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
        };
        GLINT_TRY(filtered, make("probes/filtered", cube.mips));
        cube.filtered = std::move(filtered);
        if (std::ranges::find(sources_, face, &gpu::Image::width) == sources_.end()) {
            GLINT_TRY(source, make("probes/source", gpu::cubeMips(face, 1)));
            sources_.push_back(std::move(source));
        }
    }
    cubes_.push_back(std::move(cube));
    return {};
}

Result<void> ProbesState::setVolumes(std::span<const Probe> probes) {
    if (probes.size() != cubes_.size())
        return invalidArgument("{} probes, these were made for {}", probes.size(), cubes_.size());
    std::vector<shared::ProbeRecord> records;
    std::vector<ProbeBounds> bounds;
    for (const Probe& probe : probes) {
        const auto number = static_cast<uint32_t>(records.size());
        GLINT_CHECK(checkVolumes(probe, number));
        records.push_back(packRecord(probe, number, cubes_[number].mips));
        bounds.push_back(boundsOf(probe));
    }
    const ProbeGrid grid = ProbeGrid::build(bounds);
    if (records.empty())
        return {};
    const shared::ProbeGridHeader header = {grid.originWS, static_cast<uint32_t>(records.size()), grid.cellsPerMetre,
                                            grid.size};
    std::vector<uint32_t> cells(sizeof(header) / sizeof(uint32_t));
    std::memcpy(cells.data(), &header, sizeof(header));
    cells.insert(cells.end(), grid.first.begin(), grid.first.end());
    records_.set(records);
    cells_.set(cells);
    lists_.set(grid.listed);
    return {};
}

void ProbesState::refilter(uint32_t probe) {
    GLINT_ASSERT(probe < cubes_.size(), "probe {} of {}", probe, cubes_.size());
    if (cubes_[probe].filtered)
        cubes_[probe].filtering.ask();
}

void ProbesState::filter(gpu::Frame& frame, uint32_t probe) {
    Cube& cube = cubes_[probe];
    gpu::Image host = borrow(cube.host, "probe", cube.hostMips, 6);
    gpu::Image& source = *std::ranges::find(sources_, cube.filtered.width(), &gpu::Image::width);
    prefilter_.copy(frame, host, source, cube.filtered);
    prefilter_.filter(frame, source, cube.filtered);
    frame.hand(cube.filtered, kHandedOut);
    giveBack(frame, host, cube.host);
    cube.filtering.recorded(progress_);
}

void ProbesState::record(VkCommandBuffer commands) {
    const std::array lists = {&records_, &cells_, &lists_};
    const bool listsPending = std::ranges::any_of(lists, [&](TableBuffer* list) { return list->pending(progress_); });
    if (!listsPending && std::ranges::none_of(cubes_, [&](Cube& cube) { return cube.filtering.isNeeded(progress_); }))
        return;
    progress_.begin();
    gpu::Frame frame(context_, commands);
    for (uint32_t i = 0; i < count(); ++i)
        if (cubes_[i].filtering.isNeeded(progress_))
            filter(frame, i);
    for (TableBuffer* list : lists)
        list->record(frame, progress_);
    progress_.end(frame);
}

HostImage ProbesState::cube(uint32_t probe) const {
    GLINT_ASSERT(probe < cubes_.size(), "probe {} of {}", probe, cubes_.size());
    const Cube& cube = cubes_[probe];
    return cube.filtered ? handOut(cube.filtered) : cube.host;
}

gpu::Pass& ProbesState::bindLists(gpu::Pass& pass) {
    return pass.read("probes", records_.buffer())
        .read("probeCells", cells_.buffer())
        .read("probeLists", lists_.buffer());
}

} // namespace glint::reflect

// ---------------------------------------------------------------- the public class

namespace glint {

Probes::Probes(std::unique_ptr<reflect::ProbesState> state) : state_(std::move(state)) {}
Probes::~Probes() = default;
Probes::Probes(Probes&&) noexcept = default;
Probes& Probes::operator=(Probes&&) noexcept = default;

Result<Probes> Probes::create(Context& context, const ProbesDesc& desc) {
    GLINT_TRY(state, reflect::ProbesState::create(context.gpu(), desc));
    return Probes(std::move(state));
}

uint32_t Probes::count() const {
    return state_->count();
}

Result<void> Probes::setVolumes(std::span<const Probe> probes) {
    return state_->setVolumes(probes);
}

void Probes::refilter(uint32_t probe) {
    state_->refilter(probe);
}

void Probes::record(VkCommandBuffer commands) {
    state_->record(commands);
}

HostImage Probes::cube(uint32_t probe) const {
    return state_->cube(probe);
}

uint32_t Probes::cubeMips(uint32_t probe) const {
    return state_->cubeMips(probe);
}

} // namespace glint
