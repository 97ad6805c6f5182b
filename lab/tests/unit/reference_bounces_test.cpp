// A reference follows as many bounces as what is held against it.
#include "lab/cli/compare/reference_bounces.hpp"

#include <gtest/gtest.h>

namespace glint::cli {
namespace reference_bounces_test {

measure::ComparedConfig config(std::string name, bool rays, int bounces) {
    measure::ComparedConfig made;
    made.name = std::move(name);
    made.job.settings.reflections.rays.enabled = rays;
    made.job.settings.reflections.rays.bounces = bounces;
    return made;
}

int bounces(const measure::ComparedConfig& config) {
    return config.job.settings.reflections.rays.bounces;
}

TEST(ReferenceBounces, AreTheMostOfTheConfigsThatSendRays) {
    measure::ComparedConfig reference = config("reference", true, 2);
    const measure::ComparedConfig configs[] = {config("a", true, 3), config("b", true, 1), config("c", false, 8)};
    followAsManyBounces(reference, configs);
    EXPECT_EQ(bounces(reference), 3);
    EXPECT_EQ(reference.name, "reference, 3 bounces");
}

TEST(ReferenceBounces, AreLeftAloneWhereTheyAreEnough) {
    measure::ComparedConfig reference = config("reference", true, 4);
    const measure::ComparedConfig configs[] = {config("a", true, 3)};
    followAsManyBounces(reference, configs);
    EXPECT_EQ(bounces(reference), 4);
    EXPECT_EQ(reference.name, "reference");
}

TEST(ReferenceBounces, MeanNothingToAReferenceWithoutRays) {
    measure::ComparedConfig reference = config("balanced", false, 1);
    const measure::ComparedConfig configs[] = {config("a", true, 3)};
    followAsManyBounces(reference, configs);
    EXPECT_EQ(bounces(reference), 1);
    EXPECT_EQ(reference.name, "balanced");
}

} // namespace reference_bounces_test
} // namespace glint::cli
