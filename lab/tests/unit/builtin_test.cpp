// The built-in scenes: sound geometry, and the promises that other tests build on (where the floor mirror shows each
// box; that the exact scene is emission and perfect mirrors only).
#include "lab/scene/animation_sampling.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/sign.hpp"
#include "lab/scene/builtin/sweep.hpp"
#include "lab/scene/builtin/turned.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace glint::scene {
namespace builtin_test {

using namespace builtin;

Scene make(std::string_view name) {
    auto scene = builtinScene(name);
    EXPECT_TRUE(scene.ok());
    return std::move(scene).value();
}

/// Made once: the hall's textures take most of a second.
const Scene& cached(std::string_view name) {
    static std::map<std::string, Scene, std::less<>> scenes;
    const auto found = scenes.find(name);
    return found != scenes.end() ? found->second : scenes.emplace(name, make(name)).first->second;
}

glm::mat4 localToWorld(const Node& node) {
    return glm::translate(glm::mat4(1), node.translation) * glm::mat4_cast(node.rotation) *
           glm::scale(glm::mat4(1), node.scale);
}

// ---------------------------------------------------------------- shapes

using Edge = std::pair<std::tuple<float, float, float>, std::tuple<float, float, float>>;

/// -0 and 0 are the same place; otherwise only equal bits are.
std::tuple<float, float, float> key(const glm::vec3& p) {
    return {p.x + 0.f, p.y + 0.f, p.z + 0.f};
}

/// Edges that are not run through once in each direction by two triangles: none in a watertight surface.
size_t openEdges(const Geometry& g) {
    std::map<Edge, int> balance;
    for (size_t i = 0; i < g.indices.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) {
            const auto a = key(g.positions[g.indices[i + k]]), b = key(g.positions[g.indices[i + (k + 1) % 3]]);
            a < b ? ++balance[{a, b}] : --balance[{b, a}];
        }
    }
    return static_cast<size_t>(std::ranges::count_if(balance, [](const auto& entry) { return entry.second != 0; }));
}

/// By the divergence theorem; positive where faces look outward.
double signedVolume(const Geometry& g) {
    double sum = 0;
    for (size_t i = 0; i < g.indices.size(); i += 3) {
        const glm::dvec3 a(g.positions[g.indices[i]]), b(g.positions[g.indices[i + 1]]),
            c(g.positions[g.indices[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return sum;
}

struct Solid {
    std::string name;
    Geometry geometry;
    double volume;    ///< of the ideal shape, cubic metres; 0: only its sign is known
    double tolerance; ///< relative
};

std::vector<Solid> solids() {
    const double pi = 3.14159265358979;
    const std::array<glm::vec3, 3> bend = {glm::vec3(0, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, 1, 0.5f)};
    return {
        {"box", box({1, 2, 3}), 48, 1e-6},
        {"rounded box", roundedBox({1, 2, 3}, 0.01f), 48, 1e-3},
        {"bevelled cube", roundedBox({1, 1, 1}, 1, 6), 4 * pi / 3, 0.03}, // rounded all the way: a sphere
        {"sphere", sphere(2), 4 * pi / 3 * 8, 0.02},
        {"torus", torus(2, 0.5f), 2 * pi * pi * 2 * 0.25, 0.03},
        {"cylinder", cylinder(1, 3), 3 * pi, 0.01},
        {"arch", extrude(archOutline(4, 2.5f, 1.5f, 48), 0.5f), (10 - pi * 2.25 / 2) * 0.5, 0.005},
        {"star", extrude(starOutline(5, 1, 0.4f), 0.2f), 5 * std::sin(pi / 5) * 0.4 * 0.2, 1e-4},
        {"frame", frame({1, 2}, 0.1f, 0.2f), (2.2 * 4.2 - 8) * 0.2, 1e-4},
        {"column", flutedColumn({}), 0, 0},
        {"bent tube", tube(roundedPolyline(bend, 0.2f), 0.03f), 0, 0},
        {"ring of tube", torusKnot(1, 0, 1, 0.1f, 120, 32), 2 * pi * pi * 0.01, 0.02},
        {"knot", torusKnot(2, 3, 0.4f, 0.08f), 0, 0},
        {"sign", neonText("GLINT", 1, 0.04f), 0, 0},
    };
}

TEST(BuiltinShapes, SolidsAreWatertight) {
    for (const Solid& solid : solids())
        EXPECT_EQ(openEdges(solid.geometry), 0u) << solid.name;
}

TEST(BuiltinShapes, SolidsFaceOutwardAndHaveTheirVolume) {
    for (const Solid& solid : solids()) {
        const double volume = signedVolume(solid.geometry);
        EXPECT_GT(volume, 0) << solid.name;
        if (solid.volume > 0) {
            EXPECT_NEAR(volume, solid.volume, solid.tolerance * solid.volume) << solid.name;
        }
    }
}

TEST(BuiltinShapes, TangentFramesFollowTheUvs) {
    const Geometry side = boxSide({1, 1, 1}, Side::PlusZ);
    for (size_t i = 0; i < side.positions.size(); ++i) {
        EXPECT_NEAR(glm::distance(glm::vec3(side.tangents[i]), glm::vec3(1, 0, 0)), 0, 1e-6);
        EXPECT_EQ(side.tangents[i].w, 1); // bitangent +Y, against v: glTF's normal maps have green up
    }
}

// ---------------------------------------------------------------- every scene

void expectSoundGeometry(const Geometry& g, const std::string& name) {
    ASSERT_FALSE(g.indices.empty()) << name;
    ASSERT_EQ(g.indices.size() % 3, 0u) << name;
    ASSERT_EQ(g.normals.size(), g.positions.size()) << name;
    ASSERT_EQ(g.tangents.size(), g.positions.size()) << name;
    ASSERT_EQ(g.uvs[0].size(), g.positions.size()) << name;
    for (const uint32_t index : g.indices)
        ASSERT_LT(index, g.positions.size()) << name;
    for (size_t i = 0; i < g.positions.size(); ++i) {
        const glm::vec3 tangent(g.tangents[i]);
        ASSERT_NEAR(glm::length(g.normals[i]), 1, 1e-4) << name;
        ASSERT_NEAR(glm::length(tangent), 1, 1e-4) << name;
        ASSERT_NEAR(glm::dot(g.normals[i], tangent), 0, 1e-3) << name;
        ASSERT_EQ(std::abs(g.tangents[i].w), 1) << name;
    }
    for (size_t i = 0; i < g.indices.size(); i += 3) {
        const uint32_t* c = &g.indices[i];
        const glm::vec3 face = glm::cross(g.positions[c[1]] - g.positions[c[0]], g.positions[c[2]] - g.positions[c[0]]);
        ASSERT_GE(glm::dot(face, g.normals[c[0]] + g.normals[c[1]] + g.normals[c[2]]), 0)
            << name << " triangle " << i / 3;
    }
}

void expectIndexOrNone(int index, size_t count) {
    EXPECT_GE(index, -1);
    EXPECT_LT(index, static_cast<int>(count));
}

size_t drawnTriangles(const Scene& scene) {
    size_t count = 0;
    for (const Node& node : scene.nodes) {
        if (node.mesh < 0)
            continue;
        for (const Primitive& primitive : scene.meshes[static_cast<size_t>(node.mesh)].primitives)
            count += primitive.geometry.indices.size() / 3;
    }
    return count;
}

TEST(BuiltinScenes, AreSound) {
    for (const BuiltinInfo& info : builtinScenes()) {
        SCOPED_TRACE(info.name);
        const Scene& scene = cached(info.name);
        EXPECT_EQ(scene.name, "builtin:" + std::string(info.name));
        for (const Mesh& mesh : scene.meshes) {
            for (const Primitive& primitive : mesh.primitives) {
                expectSoundGeometry(primitive.geometry, mesh.name);
                EXPECT_GE(primitive.material, 0) << mesh.name;
                expectIndexOrNone(primitive.material, scene.materials.size());
            }
        }
        for (const Node& node : scene.nodes) {
            expectIndexOrNone(node.mesh, scene.meshes.size());
            expectIndexOrNone(node.camera, scene.cameras.size());
            expectIndexOrNone(node.light, scene.lights.size());
        }
        for (const Material& m : scene.materials) {
            for (const TextureSlot* slot : {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture})
                expectIndexOrNone(slot->texture, scene.textures.size());
        }
        for (const Image& image : scene.images)
            EXPECT_EQ(image.rgba.size(), size_t(image.width) * image.height * 4) << image.name;
        EXPECT_EQ(scene.scenes.at(0).nodes.size(), scene.nodes.size());
    }
}

TEST(BuiltinScenes, BeginWithTheirDefaultCamera) {
    for (const BuiltinInfo& info : builtinScenes()) {
        const Scene& scene = cached(info.name);
        const auto first = std::ranges::find_if(scene.nodes, [](const Node& node) { return node.camera >= 0; });
        ASSERT_NE(first, scene.nodes.end()) << info.name;
        EXPECT_EQ(first->name, info.camera);
    }
}

TEST(BuiltinScenes, AreTheSameBitsTwice) {
    for (const BuiltinInfo& info : builtinScenes()) {
        const Scene &a = cached(info.name), b = make(info.name);
        ASSERT_EQ(a.meshes.size(), b.meshes.size());
        for (size_t i = 0; i < a.meshes.size(); ++i) {
            for (size_t k = 0; k < a.meshes[i].primitives.size(); ++k) {
                const Geometry &ga = a.meshes[i].primitives[k].geometry, &gb = b.meshes[i].primitives[k].geometry;
                EXPECT_TRUE(ga.positions == gb.positions && ga.normals == gb.normals && ga.tangents == gb.tangents &&
                            ga.indices == gb.indices)
                    << a.meshes[i].name;
            }
        }
        ASSERT_EQ(a.images.size(), b.images.size());
        for (size_t i = 0; i < a.images.size(); ++i)
            EXPECT_TRUE(a.images[i].rgba == b.images[i].rgba) << a.images[i].name;
    }
}

TEST(BuiltinScenes, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
    const auto scene = builtinScene("hal");
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().code, ErrorCode::InvalidArgument);
    for (const BuiltinInfo& info : builtinScenes())
        EXPECT_THAT(scene.error().message, testing::HasSubstr(std::string(info.name)));
}

TEST(BuiltinCity, IsAsLargeAsItsNameSays) {
    size_t stored = 0;
    for (const int millions : {1, 3, 10}) {
        const std::string name = millions == 1 ? "city" : "city-" + std::to_string(millions);
        const Scene scene = make(name);
        EXPECT_EQ(scene.name, "builtin:" + name);
        EXPECT_GE(drawnTriangles(scene), size_t(millions) * 1000000);
        EXPECT_LE(drawnTriangles(scene), size_t(millions) * 1000000 + 200000); // whole blocks of houses
        EXPECT_GE(scene.materials.size(), 150u);
        EXPECT_GE(scene.images.size(), 30u);
        EXPECT_EQ(scene.lights.size(), 20u);
        size_t inMeshes = 0;
        for (const Mesh& mesh : scene.meshes)
            for (const Primitive& primitive : mesh.primitives)
                inMeshes += primitive.geometry.indices.size() / 3;
        EXPECT_TRUE(stored == 0 || inMeshes == stored) << "instances share their geometry";
        stored = inMeshes;
    }
}

TEST(BuiltinCity, HasNoOtherSizes) {
    for (const char* name : {"city-0", "city-1", "city-11", "city-02", "city-", "city-2x", "hall-2", "city2"}) {
        EXPECT_FALSE(findBuiltin(name)) << name;
        EXPECT_FALSE(checkBuiltinName(name).ok()) << name;
    }
    ASSERT_TRUE(findBuiltin("city-10"));
    EXPECT_EQ(findBuiltin("city-10"), findBuiltin("city"));
    EXPECT_THAT(checkBuiltinName("town").error().message, testing::HasSubstr("city-2 to city-10"));
}

/// Channels of the scene's animation that change anything.
size_t movingChannels(const Scene& scene) {
    size_t count = 0;
    for (const Animation& animation : scene.animations)
        for (const AnimationChannel& channel : animation.channels)
            count += sampleChannel(channel, 0.9) != sampleChannel(channel, 0);
    return count;
}

TEST(BuiltinMotion, EachVariantMovesItsOwnThing) {
    const std::pair<const char*, size_t> channels[] = {
        {"motion-still", 0},  {"motion-objects", 3}, {"motion-hidden", 1},   {"motion-lamp", 1},
        {"motion-grille", 0}, {"motion-panels", 5},  {"motion-emitters", 6}, {"motion", 16},
    };
    for (const auto& [name, count] : channels)
        EXPECT_EQ(movingChannels(cached(name)), count) << name;
}

TEST(BuiltinMotion, TheLampIsSwitchedBetweenFrames) {
    const std::vector<double> times = stepTimes(cached("motion-lamp"));
    ASSERT_GE(times.size(), 4u);
    const double frames[] = {32, 64, 79, 94};
    for (size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(times[i] * 60, frames[i] - 0.5, 1e-3);
}

TEST(BuiltinMotion, TheFloorHasEveryRoughnessAsMetalAndAsDielectric) {
    std::map<float, int> metals, dielectrics;
    for (const Material& m : cached("motion-still").materials)
        if (m.name.starts_with("floor"))
            ++(m.metallicFactor > 0 ? metals : dielectrics)[m.roughnessFactor];
    EXPECT_EQ(metals.size(), 6u);
    EXPECT_EQ(metals, dielectrics);
}

TEST(BuiltinHall, HasTheSizeOfAShowPiece) {
    const size_t triangles = drawnTriangles(cached("hall"));
    EXPECT_GT(triangles, 30'000u);
    EXPECT_LT(triangles, 150'000u);
}

// ---------------------------------------------------------------- exact rays for the two scenes with known pictures

struct Hit {
    double distance;
    glm::dvec3 position, normal;
    int node, material;
};

/// Every triangle of a scene in world space; rays meet front faces only, as the raster pass does.
class Tracer {
public:
    explicit Tracer(const Scene& scene) {
        for (size_t n = 0; n < scene.nodes.size(); ++n) {
            if (scene.nodes[n].mesh < 0)
                continue;
            const glm::mat4 toWorld = localToWorld(scene.nodes[n]);
            for (const Primitive& p : scene.meshes[static_cast<size_t>(scene.nodes[n].mesh)].primitives)
                addPrimitive(p, toWorld, static_cast<int>(n));
        }
    }

    /// Moeller, Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
    std::optional<Hit> trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
        std::optional<Hit> nearest;
        for (const Object& object : objects_) {
            if (!meetsSphere(object, origin, direction))
                continue;
            for (const auto& [a, edge1, edge2] : object.triangles) {
                const glm::dvec3 p = glm::cross(direction, edge2);
                const double determinant = glm::dot(edge1, p);
                if (determinant < 1e-12)
                    continue;
                const glm::dvec3 toOrigin = origin - a, q = glm::cross(toOrigin, edge1);
                const double u = glm::dot(toOrigin, p) / determinant, v = glm::dot(direction, q) / determinant;
                const double t = glm::dot(edge2, q) / determinant;
                if (u < 0 || v < 0 || u + v > 1 || t < 1e-5 || (nearest && nearest->distance <= t))
                    continue;
                nearest = Hit{t, origin + direction * t, glm::normalize(glm::cross(edge1, edge2)), object.node,
                              object.material};
            }
        }
        return nearest;
    }

private:
    struct Object {
        glm::dvec3 center = glm::dvec3(0);
        double radius = 0;
        int node = -1, material = -1;
        std::vector<std::array<glm::dvec3, 3>> triangles; ///< corner, edge to the second, edge to the third
    };

    void addPrimitive(const Primitive& primitive, const glm::mat4& toWorld, int node) {
        Object object;
        object.node = node;
        object.material = primitive.material;
        const Geometry& g = primitive.geometry;
        const auto at = [&](size_t i) { return glm::dvec3(toWorld * glm::vec4(g.positions[g.indices[i]], 1)); };
        for (size_t i = 0; i < g.indices.size(); ++i)
            object.center += at(i) / static_cast<double>(g.indices.size());
        for (size_t i = 0; i < g.indices.size(); i += 3) {
            object.triangles.push_back({at(i), at(i + 1) - at(i), at(i + 2) - at(i)});
            for (size_t k = 0; k < 3; ++k)
                object.radius = std::max(object.radius, glm::distance(object.center, at(i + k)));
        }
        objects_.push_back(std::move(object));
    }

    static bool meetsSphere(const Object& object, const glm::dvec3& origin, const glm::dvec3& direction) {
        const glm::dvec3 toCenter = object.center - origin;
        const double along = glm::dot(toCenter, direction);
        return glm::dot(toCenter, toCenter) - along * along <= object.radius * object.radius * 1.0001;
    }

    std::vector<Object> objects_;
};

/// A picture's geometry: pixel centres to rays, and points to pixels.
struct View {
    glm::dmat4 viewToWorld;
    double tanHalf;
    int width, height;

    View(const Scene& scene, std::string_view camera, int pictureWidth, int pictureHeight)
        : width(pictureWidth), height(pictureHeight) {
        for (const Node& node : scene.nodes) {
            if (node.camera < 0 || node.name != camera)
                continue;
            viewToWorld = glm::dmat4(localToWorld(node));
            tanHalf = std::tan(0.5 * static_cast<double>(scene.cameras[static_cast<size_t>(node.camera)].fovY));
        }
    }

    glm::dvec3 position() const { return glm::dvec3(viewToWorld[3]); }

    glm::dvec3 rayThrough(double x, double y) const {
        const double aspect = static_cast<double>(width) / height;
        const glm::dvec3 directionVS((2 * x / width - 1) * tanHalf * aspect, (1 - 2 * y / height) * tanHalf, -1);
        return glm::normalize(glm::dmat3(viewToWorld) * directionVS);
    }

    glm::dvec2 project(const glm::dvec3& pointWS) const {
        const glm::dvec3 p(glm::inverse(viewToWorld) * glm::dvec4(pointWS, 1));
        const double scale = height / (2 * tanHalf * -p.z);
        return {width / 2.0 + p.x * scale, height / 2.0 - p.y * scale};
    }

    bool contains(const glm::dvec2& px) const { return px.x > 1 && px.y > 1 && px.x < width - 1 && px.y < height - 1; }
};

bool isMirror(const Material& m) {
    return m.metallicFactor == 1 && m.roughnessFactor == 0;
}

class BuiltinMirror : public testing::TestWithParam<glm::ivec2> {};

TEST_P(BuiltinMirror, ShowsEachBoxAtThePredictedPixel) {
    const Scene& scene = cached("mirror");
    const Tracer tracer(scene);
    const View view(scene, "main", GetParam().x, GetParam().y);
    for (const MirrorBox& expected : mirrorBoxes()) {
        const glm::dvec3 face = glm::dvec3(expected.center) + glm::dvec3(0, 0, expected.halfExtent.z);
        const glm::dvec2 px = view.project({face.x, -face.y, face.z});
        ASSERT_TRUE(view.contains(px));
        // The pixel's own ray, through its centre, as a renderer would trace it.
        const glm::dvec3 direction = view.rayThrough(std::floor(px.x) + 0.5, std::floor(px.y) + 0.5);
        const auto floor = tracer.trace(view.position(), direction);
        ASSERT_TRUE(floor);
        EXPECT_TRUE(isMirror(scene.materials[static_cast<size_t>(floor->material)]));
        const auto hit = tracer.trace(floor->position, glm::reflect(direction, floor->normal));
        ASSERT_TRUE(hit);
        EXPECT_EQ(scene.materials[static_cast<size_t>(hit->material)].emissiveFactor, expected.color);
        EXPECT_LT(glm::distance(hit->position, face), 0.1);

        // What the mirror shows is on screen itself, so screen-space tracing can find it.
        const glm::dvec2 direct = view.project(hit->position);
        ASSERT_TRUE(view.contains(direct));
        const glm::dvec3 toFace = glm::normalize(hit->position - view.position());
        const auto seen = tracer.trace(view.position(), toFace);
        ASSERT_TRUE(seen);
        EXPECT_LT(glm::distance(seen->position, hit->position), 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, BuiltinMirror, testing::Values(glm::ivec2(640, 360), glm::ivec2(1279, 717)));

TEST(BuiltinThickness, TheMirrorShowsEachBallBesideAllBalls) {
    const Scene& scene = cached("thickness");
    const View view(scene, "main", 640, 360);
    const auto node = [&](std::string_view name) { return *std::ranges::find(scene.nodes, name, &Node::name); };
    struct Disc {
        glm::dvec2 center;
        double radius;
    };
    const auto seen = [&](const glm::dvec3& center, double radius) {
        const double pixels = view.height / (2 * view.tanHalf);
        return Disc{view.project(center), pixels * radius / glm::distance(center, view.position())};
    };
    const double mirrorZ = static_cast<double>(node("mirror").translation.z);
    std::vector<Disc> balls, images;
    for (const char* name : {"red ball", "yellow ball", "blue ball"}) {
        const glm::dvec3 center(node(name).translation); // it stands on the floor: as high as its radius
        balls.push_back(seen(center, center.y));
        images.push_back(seen({center.x, center.y, 2 * mirrorZ - center.z}, center.y));
    }
    for (const Disc& image : images) {
        EXPECT_TRUE(view.contains(image.center - image.radius) && view.contains(image.center + image.radius));
        for (const Disc& ball : balls)
            EXPECT_GT(glm::distance(image.center, ball.center), image.radius + ball.radius);
    }
}

TEST(BuiltinMirror, BoxesHaveDifferentColours) {
    for (size_t i = 0; i < mirrorBoxes().size(); ++i) {
        for (size_t k = 0; k < i; ++k)
            EXPECT_NE(mirrorBoxes()[i].color, mirrorBoxes()[k].color);
    }
}

TEST(BuiltinExact, IsMadeOfEmissionAndPerfectMirrorsOnly) {
    const Scene& scene = cached("exact");
    EXPECT_TRUE(scene.lights.empty());
    for (const Material& m : scene.materials) {
        if (isMirror(m)) {
            EXPECT_EQ(m.baseColorFactor, glm::vec4(1)) << m.name;
            EXPECT_EQ(m.emissiveFactor, glm::vec3(0)) << m.name;
            continue;
        }
        EXPECT_EQ(m.baseColorFactor, glm::vec4(0, 0, 0, 1)) << m.name;
        EXPECT_EQ(m.metallicFactor, 0) << m.name;
        EXPECT_EQ(m.specularFactor, 0) << m.name;
        EXPECT_LE(std::max({m.emissiveFactor.x, m.emissiveFactor.y, m.emissiveFactor.z}), 1) << m.name; // never clipped
    }
}

/// What the mirrors of one view show, in pixels.
struct MirrorShares {
    int mirrors = 0;
    int onceLit = 0;    ///< emission after one bounce
    int onceHidden = 0; ///< of these, surfaces that are not on the screen themselves
    int twice = 0;      ///< a mirror in a mirror
};

MirrorShares mirrorShares(const Scene& scene, const Tracer& tracer, const View& view) {
    const auto mirror = [&](const Hit& hit) { return isMirror(scene.materials[static_cast<size_t>(hit.material)]); };
    MirrorShares shares;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const glm::dvec3 direction = view.rayThrough(x + 0.5, y + 0.5);
            const auto first = tracer.trace(view.position(), direction);
            if (!first || !mirror(*first))
                continue;
            ++shares.mirrors;
            const auto second = tracer.trace(first->position, glm::reflect(direction, first->normal));
            if (!second)
                continue;
            if (mirror(*second)) {
                ++shares.twice;
                continue;
            }
            ++shares.onceLit;
            const auto seen = tracer.trace(view.position(), glm::normalize(second->position - view.position()));
            shares.onceHidden += !view.contains(view.project(second->position)) || !seen ||
                                 glm::distance(seen->position, second->position) > 1e-3;
        }
    }
    return shares;
}

TEST(BuiltinExact, ShowsMirrorsAndWhatTheyReflectFromEveryCamera) {
    const Scene& scene = cached("exact");
    const Tracer tracer(scene);
    for (const std::string_view camera : {"front", "left", "low", "high"}) {
        const View view(scene, camera, 160, 90);
        const MirrorShares shares = mirrorShares(scene, tracer, view);
        const double pixels = view.width * view.height;
        EXPECT_GT(shares.mirrors / pixels, 0.2) << camera;
        EXPECT_LT(shares.mirrors / pixels, 0.7) << camera;
        EXPECT_GT(shares.onceLit / pixels, 0.08) << camera; // mirrors that show more than black
        EXPECT_GT(shares.twice, 50) << camera;
    }
}

TEST(BuiltinExact, FromTheFrontNearlyAllOneBounceReflectionsAreOnScreen) {
    const Scene& scene = cached("exact");
    const Tracer tracer(scene);
    const MirrorShares shares = mirrorShares(scene, tracer, View(scene, "front", 320, 180));
    EXPECT_LT(shares.onceHidden, 0.01 * shares.onceLit);
    RecordProperty("hidden_per_mille", 1000 * shares.onceHidden / shares.onceLit);
}

} // namespace builtin_test
} // namespace glint::scene
