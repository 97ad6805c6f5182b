#include "check/normal_agreement.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace glint::check {
namespace normal_agreement_test {

/// Points on the sphere, evenly spread (Fibonacci lattice).
std::vector<glm::vec3> sphere(int count) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, angle = 2.399963229728653 * i;
        points.emplace_back(glm::dvec3(std::sqrt(1 - z * z) * glm::dvec2(std::cos(angle), std::sin(angle)), z));
    }
    return points;
}

std::vector<glm::vec3> rotated(const glm::mat3& rotation, std::vector<glm::vec3> points) {
    for (glm::vec3& point : points)
        point = rotation * point;
    return points;
}

const glm::mat3 kTurn(glm::rotate(glm::mat4(1), glm::radians(50.0f), glm::normalize(glm::vec3(1, 2, -0.5f))));

TEST(NormalAgreement, SharesOfPairsWithinTenDegrees) {
    const std::vector<glm::vec3> points = sphere(400);
    EXPECT_DOUBLE_EQ(agreement(kTurn, points, rotated(kTurn, points)).share, 1);
    EXPECT_NEAR(agreement(kTurn, points, rotated(kTurn, points)).score, 1, 1e-3);
    std::vector<glm::vec3> half = rotated(kTurn, points);
    for (size_t i = 0; i < half.size(); i += 2)
        half[i] = i % 4 == 0 ? -half[i] : glm::vec3(0);
    EXPECT_DOUBLE_EQ(agreement(kTurn, points, half).share, 0.5);
    EXPECT_EQ(agreement(kTurn, {}, {}).share, 0);
}

TEST(NormalAgreement, TheRotationIsFoundAmongOutliers) {
    const std::vector<glm::vec3> from = sphere(3000);
    std::vector<glm::vec3> to = rotated(kTurn, from);
    for (size_t i = 0; i < to.size(); ++i)
        if (i % 5 < 3)
            to[i] = from[(i * 7919 + 13) % from.size()];
    const RotationFit fit = fitRotation(from, to);
    EXPECT_GE(fit.agreement.share, 0.4);
    for (int column = 0; column < 3; ++column)
        EXPECT_LT(glm::length(fit.rotation[column] - kTurn[column]), 1e-3f);
}

TEST(NormalAgreement, ParallelDirectionsDetermineNoRotation) {
    const std::vector<glm::vec3> up(100, glm::vec3(0, 1, 0)), right(100, glm::vec3(1, 0, 0));
    EXPECT_EQ(fitRotation(up, right).rotation, glm::mat3(1));
    EXPECT_EQ(fitRotation({}, {}).rotation, glm::mat3(1));
}

} // namespace normal_agreement_test
} // namespace glint::check
