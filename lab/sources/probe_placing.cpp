#include "lab/sources/probe_placing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace glint::render {
namespace {

constexpr float kTrimmed = 0.02f;   ///< fraction of the needs at each end of an axis that is ignored for the domain
constexpr float kLeastGain = 0.02f; ///< fraction of the needs; a probe with a smaller gain is not worth its memory
constexpr size_t kMostCandidates = 3000;
constexpr size_t kQuantiles = 24;

float diagonal(const scene::Bounds& bounds) {
    return glm::length(bounds.max - bounds.min);
}

/// Returns how well a probe at `from` serves a need, [0, 1]. A nearer probe has less parallax error, and a probe with
/// free space around it sees more than the nearest wall.
float service(const FreeSpace& space, const glm::vec3& from, float clearance, const ReflectiveNeed& need, float near,
              float room) {
    const glm::vec3 way = from - need.positionWS;
    const float distance = glm::length(way);
    if (!(glm::dot(way, need.normalWS) > 0.05f * distance))
        return 0; // behind the surface
    if (!space.sees(need.positionWS, from, 1.8f * space.cellSize()))
        return 0;
    return std::min(clearance / room, 1.0f) / (1 + (distance / near) * (distance / near));
}

std::vector<glm::ivec3> candidates(const FreeSpace& space) {
    const auto collect = [&](int stride) {
        std::vector<glm::ivec3> cells;
        for (int z = stride / 2; z < space.size().z; z += stride)
            for (int y = stride / 2; y < space.size().y; y += stride)
                for (int x = stride / 2; x < space.size().x; x += stride)
                    if (space.clearance({x, y, z}) >= 2 * space.cellSize())
                        cells.emplace_back(x, y, z);
        return cells;
    };
    std::vector<glm::ivec3> cells = collect(1);
    for (int stride = 2; cells.size() > kMostCandidates; ++stride)
        cells = collect(stride);
    return cells;
}

} // namespace

scene::Bounds probeDomain(std::span<const ReflectiveNeed> needs, const scene::Bounds& sceneWS) {
    scene::Bounds domain;
    if (needs.empty() || sceneWS.empty())
        return domain;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::pair<float, float>> along; // coordinate, weight
        double total = 0;
        for (const ReflectiveNeed& need : needs) {
            along.emplace_back(need.positionWS[axis], need.weight);
            total += need.weight;
        }
        std::ranges::sort(along);
        double passed = 0;
        domain.min[axis] = along.front().first;
        for (const auto& [at, weight] : along) {
            if (passed <= total * kTrimmed)
                domain.min[axis] = at;
            passed += weight;
            domain.max[axis] = at;
            if (passed >= total * (1 - kTrimmed))
                break;
        }
    }
    const float around = 0.25f * std::max(diagonal(domain), 0.1f * diagonal(sceneWS));
    const float beyond = 0.05f * diagonal(sceneWS);
    domain.min = glm::max(domain.min - around, sceneWS.min - beyond);
    domain.max = glm::min(domain.max + around, sceneWS.max + beyond);
    return domain;
}

std::vector<ReflectiveNeed> gatherNeeds(std::span<const ReflectiveNeed> needs, float cellSize, size_t most) {
    std::map<std::tuple<int, int, int, int>, ReflectiveNeed> cells; // by cell and the normal's main axis
    for (const ReflectiveNeed& need : needs) {
        const glm::ivec3 cell(glm::floor(need.positionWS / cellSize));
        const glm::vec3 n = glm::abs(need.normalWS);
        const int axis = n.x > n.y && n.x > n.z ? 0 : n.y > n.z ? 1 : 2;
        const int facing = axis * 2 + (need.normalWS[axis] < 0 ? 1 : 0);
        ReflectiveNeed& sum = cells[{cell.x, cell.y, cell.z, facing}];
        sum.positionWS =
            sum.weight == 0 ? need.positionWS * need.weight : sum.positionWS + need.positionWS * need.weight;
        sum.normalWS = sum.weight == 0 ? need.normalWS * need.weight : sum.normalWS + need.normalWS * need.weight;
        sum.reflectedWS =
            sum.weight == 0 ? need.reflectedWS * need.weight : sum.reflectedWS + need.reflectedWS * need.weight;
        sum.weight += need.weight;
    }
    std::vector<ReflectiveNeed> gathered;
    for (auto& [key, sum] : cells) {
        if (!(sum.weight > 0) || !(glm::length(sum.normalWS) > 0))
            continue;
        const glm::vec3 normal = glm::normalize(sum.normalWS);
        const bool looks = glm::length(sum.reflectedWS) > 1e-6f;
        gathered.push_back(
            {sum.positionWS / sum.weight, normal, looks ? glm::normalize(sum.reflectedWS) : normal, sum.weight});
    }
    std::ranges::stable_sort(gathered, std::greater<>(), &ReflectiveNeed::weight);
    gathered.resize(std::min(gathered.size(), most));
    return gathered;
}

std::vector<PlacedProbe> placeProbes(const FreeSpace& space, std::span<const ReflectiveNeed> needs, size_t most) {
    const glm::vec3 extent = glm::vec3(space.size()) * space.cellSize();
    const float near = 0.25f * glm::length(extent);
    const float room = 0.08f * glm::length(extent);
    const std::vector<glm::ivec3> cells = candidates(space);
    std::vector<std::vector<float>> served(cells.size());
    for (size_t c = 0; c < cells.size(); ++c)
        for (const ReflectiveNeed& need : needs)
            served[c].push_back(service(space, space.center(cells[c]), space.clearance(cells[c]), need, near, room));

    std::vector<PlacedProbe> probes;
    std::vector<size_t> chosen;
    std::vector<float> best(needs.size(), 0);
    double total = 0;
    for (const ReflectiveNeed& need : needs)
        total += need.weight;
    while (probes.size() < most) {
        size_t winner = cells.size();
        double winnerGain = kLeastGain * total;
        for (size_t c = 0; c < cells.size(); ++c) {
            double gain = 0;
            for (size_t n = 0; n < needs.size(); ++n)
                gain += std::max(served[c][n] - best[n], 0.0f) * needs[n].weight;
            if (gain > winnerGain) {
                winner = c;
                winnerGain = gain;
            }
        }
        if (winner == cells.size())
            break;
        for (size_t n = 0; n < needs.size(); ++n)
            best[n] = std::max(best[n], served[winner][n]);
        chosen.push_back(winner);
        PlacedProbe probe;
        probe.positionWS = space.center(cells[winner]);
        probe.gain = static_cast<float>(winnerGain / total);
        probes.push_back(probe);
    }
    for (size_t n = 0; n < needs.size(); ++n) {
        size_t owner = 0;
        for (size_t p = 1; p < probes.size(); ++p)
            if (served[chosen[p]][n] > served[chosen[owner]][n])
                owner = p;
        if (!probes.empty() && served[chosen[owner]][n] > 0) {
            scene::Bounds& around = probes[owner].needsWS;
            around.min = glm::min(around.min, needs[n].positionWS);
            around.max = glm::max(around.max, needs[n].positionWS);
            probes[owner].needs.push_back(needs[n]);
        }
    }
    // These probes serve no need better than others do.
    std::erase_if(probes, [](const PlacedProbe& probe) { return probe.needsWS.empty(); });
    return probes;
}

void weighByNeeds(std::span<SeenDistance> seen, std::span<const ReflectiveNeed> needs) {
    double total = 0;
    for (const ReflectiveNeed& need : needs)
        total += need.weight;
    if (total <= 0)
        return;
    for (SeenDistance& ray : seen) {
        double looks = 0;
        for (const ReflectiveNeed& need : needs) {
            const float cosine = std::max(glm::dot(ray.directionWS, need.reflectedWS), 0.0f);
            const float c4 = cosine * cosine * cosine * cosine;
            looks += need.weight * c4 * c4;
        }
        ray.weight *= static_cast<float>(0.1 + looks / total);
    }
}

scene::Bounds fitProxyBox(const glm::vec3& positionWS, std::span<const SeenDistance> seen, float farthest) {
    // Sides as distances from the position: +X, -X, +Y, ... Each starts at the median of the distances seen through its
    // face.
    std::array<float, 6> sides = {};
    // Each side may then move to a distance at which rays hit: within 60 degrees of its axis, and again within 25
    // degrees, as only a few of the first rays see a far wall.
    std::array<std::vector<float>, 6> choices;
    for (size_t side = 0; side < 6; ++side)
        for (const float cone : {0.9f, 0.5f}) {
            std::vector<float> met = {farthest};
            for (const SeenDistance& ray : seen) {
                const float along = ray.directionWS[static_cast<int>(side / 2)] * (side % 2 == 0 ? 1.0f : -1.0f);
                if (along > cone)
                    met.push_back(std::clamp(ray.distance * along, farthest * 1e-5f, farthest));
            }
            std::ranges::sort(met);
            sides[side] = met[met.size() / 2];
            for (size_t q = 0; q <= kQuantiles; ++q)
                choices[side].push_back(met[q * (met.size() - 1) / kQuantiles]);
        }
    const auto error = [&] {
        double sum = 0;
        for (const SeenDistance& ray : seen) {
            float distance = 1e30f;
            for (int axis = 0; axis < 3; ++axis)
                if (const float d = ray.directionWS[axis]; std::abs(d) > 1e-6f)
                    distance = std::min(distance, sides[static_cast<size_t>(axis) * 2 + (d < 0 ? 1 : 0)] / std::abs(d));
            const double misplaced = std::abs(1 / distance - 1 / std::max(ray.distance, farthest * 1e-5f));
            // A square root favours a wall that some rays hit over the mean of two walls.
            sum += ray.weight * std::sqrt(misplaced);
        }
        return sum;
    };
    for (int sweep = 0; sweep < 3; ++sweep)
        for (size_t side = 0; side < 6; ++side) {
            float best = sides[side];
            double bestError = error();
            for (const float choice : choices[side]) {
                sides[side] = choice;
                if (const double now = error(); now < bestError) {
                    bestError = now;
                    best = choice;
                }
            }
            sides[side] = best;
        }
    return {positionWS - glm::vec3(sides[1], sides[3], sides[5]), positionWS + glm::vec3(sides[0], sides[2], sides[4])};
}

} // namespace glint::render
