#include "lab/renderer/body_shape.hpp"

#include "lab/scene/builtin/shapes.hpp"

#include <gtest/gtest.h>

namespace glint::test {
namespace body_shape_test {

using render::bodyShape;

scene::Material glass(float thickness) {
    scene::Material material;
    material.transmissionFactor = 1;
    material.thicknessFactor = thickness;
    return material;
}

TEST(BodyShape, BallsAreSpheresAndBoxesPlates) {
    const scene::Geometry ball = scene::builtin::sphere(0.5f, 32, 16);
    EXPECT_EQ(bodyShape(glass(1), ball), BodyShape::Sphere);
    EXPECT_EQ(bodyShape(glass(0.4f), ball), BodyShape::Sphere); // authors guess
    EXPECT_EQ(bodyShape(glass(0.02f), ball), BodyShape::Plane); // a bubble of glass
    EXPECT_EQ(bodyShape(glass(1), scene::builtin::box({0.5f, 0.5f, 0.5f})), BodyShape::Plane);
}

TEST(BodyShape, WithoutThicknessOrLightNothingIsBent) {
    const scene::Geometry ball = scene::builtin::sphere(0.5f, 32, 16);
    EXPECT_EQ(bodyShape(glass(0), ball), BodyShape::Straight);
    scene::Material opaque = glass(1);
    opaque.transmissionFactor = 0;
    EXPECT_EQ(bodyShape(opaque, ball), BodyShape::Straight);
}

TEST(BodyShape, ItsAuthorKnowsBetter) {
    const scene::Geometry ball = scene::builtin::sphere(0.5f, 32, 16);
    scene::Material material = glass(1);
    material.refraction = scene::RefractionShape::Plane;
    EXPECT_EQ(bodyShape(material, ball), BodyShape::Plane);
    material.refraction = scene::RefractionShape::None;
    EXPECT_EQ(bodyShape(material, ball), BodyShape::Straight);
    material = glass(0);
    material.refraction = scene::RefractionShape::Thin;
    EXPECT_EQ(bodyShape(material, ball), BodyShape::Thin);
}

TEST(BodyShape, BrokenGeometryIsAPlate) {
    scene::Geometry broken = scene::builtin::sphere(0.5f, 8, 4);
    broken.normals.clear();
    EXPECT_EQ(bodyShape(glass(1), broken), BodyShape::Plane);
    scene::Geometry empty;
    EXPECT_EQ(bodyShape(glass(1), empty), BodyShape::Plane);
    scene::Geometry point = scene::builtin::sphere(0, 8, 4);
    EXPECT_EQ(bodyShape(glass(1), point), BodyShape::Plane);
}

} // namespace body_shape_test
} // namespace glint::test
