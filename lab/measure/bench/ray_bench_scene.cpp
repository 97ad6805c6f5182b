#include "lab/measure/bench/ray_bench_scene.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

constexpr float kTerrainHalf = 20; // metres

/// Two triangles per cell; with `poles`, without those that collapse in the first and last rows.
std::vector<uint32_t> gridIndices(uint32_t columns, uint32_t rows, bool poles) {
    std::vector<uint32_t> indices;
    indices.reserve(size_t{6} * columns * rows);
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t a = row * (columns + 1) + column;
            const uint32_t above = a + columns + 1;
            if (!poles || row > 0)
                indices.insert(indices.end(), {a, a + 1, above + 1});
            if (!poles || row + 1 < rows)
                indices.insert(indices.end(), {a, above + 1, above});
        }
    return indices;
}

/// Columns run along +X and rows along -Z, so that the front faces +Y.
glm::vec3 terrainVertex(uint32_t column, uint32_t row, uint32_t cells) {
    const float x = kTerrainHalf * (2 * static_cast<float>(column) / static_cast<float>(cells) - 1);
    const float z = kTerrainHalf * (1 - 2 * static_cast<float>(row) / static_cast<float>(cells));
    const float hills = 0.7f * std::sin(0.9f * x) * std::cos(1.3f * z);
    return {x, hills + 0.05f * std::sin(17 * x + 11 * z), z};
}

/// In [0, 1), identical on every machine: fractional parts of multiples spread points evenly.
float spread(uint32_t number, uint32_t axis) {
    constexpr double kSteps[] = {0.8191725134, 0.6710436067, 0.5497004779, 0.7548776662};
    double whole = 0;
    return static_cast<float>(std::modf(0.5 + kSteps[axis] * (number + 1), &whole));
}

} // namespace

RayBenchScene::RayBenchScene(uint64_t triangles) {
    const double wanted = static_cast<double>(triangles);
    // A ball of r rows and 2 r columns has 4 r (r - 1) triangles.
    ballRows_ = static_cast<uint32_t>(std::max(2L, std::lround(0.5 + 0.5 * std::sqrt(1 + wanted / (2 * kBallMeshes)))));
    const double inBalls = 4.0 * kBallMeshes * ballRows_ * (ballRows_ - 1);
    const auto cells = static_cast<uint32_t>(std::max(1L, std::lround(std::sqrt(std::max(wanted - inBalls, 0.0) / 2))));
    meshes_.resize(1 + kBallMeshes);
    Mesh& terrain = meshes_.front();
    terrain.positions.reserve(size_t{cells + 1} * (cells + 1));
    for (uint32_t row = 0; row <= cells; ++row)
        for (uint32_t column = 0; column <= cells; ++column)
            terrain.positions.push_back(terrainVertex(column, row, cells));
    terrain.indices = gridIndices(cells, cells, false);
    for (uint32_t ball = 1; ball <= kBallMeshes; ++ball) {
        Mesh& mesh = meshes_[ball];
        mesh.positions.reserve(size_t{2 * ballRows_ + 1} * (ballRows_ + 1));
        for (uint32_t row = 0; row <= ballRows_; ++row)
            for (uint32_t column = 0; column <= 2 * ballRows_; ++column)
                mesh.positions.push_back(ballVertex(ball, column, row, 0));
        mesh.indices = gridIndices(2 * ballRows_, ballRows_, true);
    }
}

glm::vec3 RayBenchScene::ballVertex(uint32_t mesh, uint32_t column, uint32_t row, float phase) const {
    // The first and last columns are the same points bit for bit, and so are all points of a pole: no cracks.
    const float turn = static_cast<float>(column % (2 * ballRows_)) / static_cast<float>(2 * ballRows_);
    const float longitude = glm::two_pi<float>() * turn;
    const float latitude = glm::pi<float>() * (static_cast<float>(row) / static_cast<float>(ballRows_) - 0.5f);
    const bool pole = row == 0 || row == ballRows_;
    const float around = pole ? 0 : std::cos(latitude);
    const glm::vec3 direction(around * std::cos(longitude), pole ? (row == 0 ? -1.0f : 1.0f) : std::sin(latitude),
                              -around * std::sin(longitude));
    const auto kind = static_cast<float>(mesh);
    const float dents = std::sin((3 + kind) * direction.x + phase) * std::cos((4 + kind) * direction.y) +
                        0.5f * std::sin(9 * direction.z + 7 * direction.y + phase);
    return (1 + 0.15f * dents) * direction;
}

uint64_t RayBenchScene::triangles() const {
    uint64_t sum = 0;
    for (const Mesh& mesh : meshes_)
        sum += mesh.indices.size() / 3;
    return sum;
}

uint64_t RayBenchScene::placed() const {
    uint64_t sum = 0;
    for (uint32_t i = 0; i <= kBalls; ++i)
        sum += meshes_[meshOf(i)].indices.size() / 3;
    return sum;
}

std::vector<RayMesh> RayBenchScene::meshes() const {
    std::vector<RayMesh> views;
    for (uint32_t i = 0; i < meshes_.size(); ++i)
        views.push_back({&meshes_[i].positions.front().x, static_cast<uint32_t>(meshes_[i].positions.size()),
                         sizeof(glm::vec3), meshes_[i].indices, i == kDeformedMesh});
    return views;
}

uint32_t RayBenchScene::meshOf(uint32_t instance) {
    return instance == 0 ? 0 : 1 + (instance - 1) % kBallMeshes;
}

glm::mat4 RayBenchScene::localToWorld(uint32_t instance, float phase) {
    if (instance == 0)
        return glm::mat4(1);
    const float angle = glm::two_pi<float>() * spread(instance, 0);
    const float radius = 9 * std::sqrt(spread(instance, 1));
    const float size = 0.7f + 1.1f * spread(instance, 2);
    const glm::vec3 place(radius * std::cos(angle), 0.5f + 0.35f * (9 - radius) + 0.5f * std::sin(phase),
                          radius * std::sin(angle));
    const glm::vec3 axis = glm::normalize(glm::vec3(spread(instance, 3) - 0.5f, 0.3f, spread(instance, 0) - 0.5f));
    return glm::rotate(glm::translate(glm::mat4(1), place), angle + phase, axis) *
           glm::scale(glm::mat4(1), glm::vec3(size));
}

std::vector<RayInstance> RayBenchScene::instances(float phase) const {
    std::vector<RayInstance> instances(1 + kBalls);
    for (uint32_t i = 0; i < instances.size(); ++i) {
        instances[i].mesh = meshOf(i);
        instances[i].doubleSided = false;
        std::copy_n(glm::value_ptr(localToWorld(i, phase)), 16, instances[i].localToWorld.begin());
    }
    return instances;
}

std::vector<glm::vec3> RayBenchScene::deformed(float phase) const {
    std::vector<glm::vec3> positions;
    positions.reserve(meshes_[kDeformedMesh].positions.size());
    for (uint32_t row = 0; row <= ballRows_; ++row)
        for (uint32_t column = 0; column <= 2 * ballRows_; ++column)
            positions.push_back(ballVertex(kDeformedMesh, column, row, phase));
    return positions;
}

std::array<glm::vec3, 3> RayBenchScene::triangleWS(uint32_t instance, uint32_t primitive) const {
    const Mesh& mesh = meshes_[meshOf(instance)];
    const glm::mat4 transform = localToWorld(instance, 0);
    std::array<glm::vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i)
        corners[i] = glm::vec3(transform * glm::vec4(mesh.positions[mesh.indices[size_t{3} * primitive + i]], 1));
    return corners;
}

} // namespace glint::measure
