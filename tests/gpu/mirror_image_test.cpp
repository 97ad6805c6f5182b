// shaders/denoise/mirror_image.glsl against the place where a ball truly mirrors a point, found in double precision;
// and the history of a rough ball past which the camera moves.
#include "gpu/support/library_test.hpp"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstring>
#include <random>

namespace glint::test {
namespace mirror_image_test {

/// Layout of tests/gpu/shaders/mirror_image.comp.
struct MirrorItem {
    glm::vec3 position;
    glm::vec3 N;
    glm::vec3 V;
    glm::vec2 curvature;
    float distance;
    glm::vec3 step = {};
    glm::vec3 eyeBefore;
    glm::vec3 image = {};
    uint32_t seen = 0;
};

/// A ball that mirrors `end` to an eye at the origin. Convex: its normals point outwards.
struct Ball {
    glm::dvec3 center;
    double radius;
    bool convex;

    glm::dvec3 normalAt(const glm::dvec3& on) const { return (convex ? 1.0 : -1.0) * glm::normalize(on - center); }
    /// Where the ball mirrors `end` to `eye`, near `start`: there the way of the light is stationary (Fermat).
    glm::dvec3 mirrors(const glm::dvec3& end, const glm::dvec3& eye, const glm::dvec3& start) const {
        glm::dvec3 on = start;
        const auto along = [&](const glm::dvec3& place) {
            const glm::dvec3 n = glm::normalize(place - center);
            const glm::dvec3 pull = glm::normalize(eye - place) + glm::normalize(end - place);
            return pull - n * glm::dot(pull, n);
        };
        for (int i = 0; i < 30; ++i) {
            const glm::dvec3 n = glm::normalize(on - center);
            const glm::dvec3 a =
                glm::normalize(std::abs(n.x) < 0.7 ? glm::cross(n, {1, 0, 0}) : glm::cross(n, {0, 1, 0}));
            const glm::dvec3 b = glm::cross(n, a);
            const auto moved = [&](double x, double y) {
                return center + radius * glm::normalize(on + a * x + b * y - center);
            };
            const double h = 1e-6 * radius;
            const auto local = [&](const glm::dvec3& v) { return glm::dvec2(glm::dot(v, a), glm::dot(v, b)); };
            const glm::dvec2 pull = local(along(on));
            const glm::dvec2 dx = (local(along(moved(h, 0))) - local(along(moved(-h, 0)))) / (2 * h);
            const glm::dvec2 dy = (local(along(moved(0, h))) - local(along(moved(0, -h)))) / (2 * h);
            const double area = dx.x * dy.y - dy.x * dx.y;
            on = moved(-(dy.y * pull.x - dy.x * pull.y) / area, -(dx.x * pull.y - dx.y * pull.x) / area);
        }
        return on;
    }
};

class MirrorImageTest : public LibraryTest {
protected:
    static std::vector<MirrorItem> evaluated(std::vector<MirrorItem> list) {
        gpu::Buffer buffer = must(gpu::uploadBuffer(
            gpu(), "test/mirrorImage", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"mirror_image", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline).readWrite("items", buffer).dispatch(static_cast<uint32_t>(list.size()));
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
        std::memcpy(list.data(), bytes.data(), list.size() * sizeof(MirrorItem));
        return list;
    }
};

/// Pixels a radian: 1080 rows of 60 degrees.
const double kFocal = 540 / std::tan(glm::radians(30.0));

double pixelsBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return kFocal * glm::length(glm::normalize(a) - glm::normalize(b));
}

TEST_F(MirrorImageTest, CurvedMirrorsShowItWhereBallsDo) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> axis;
    const auto direction = [&] { return glm::normalize(glm::dvec3(axis(random), axis(random), axis(random))); };
    struct Truth {
        Ball ball;
        glm::dvec3 on;  // of the ball, where it mirrors what is looked at
        glm::dvec3 was; // in the previous frame
    };
    std::vector<MirrorItem> list;
    std::vector<Truth> truths;
    while (list.size() < 2000) {
        const bool convex = list.size() % 2 == 0;
        const glm::dvec3 N = direction(), V = direction();
        if (glm::dot(N, V) < 0.2)
            continue;
        const double away = 1 + 5 * unit(random);
        const double distance = 0.2 + 4 * unit(random);
        // Concave ones so that what is mirrored lies nearer than the focus: the image is behind them.
        const double radius = convex ? 0.2 + 2 * unit(random) : distance * (2.5 + 4 * unit(random)) / glm::dot(N, V);
        const glm::dvec3 on = -V * away;
        const Ball ball = {on - N * (convex ? radius : -radius), radius, convex};
        const glm::dvec3 end = on + (2 * glm::dot(N, V) * N - V) * distance;
        const glm::dvec3 step =
            list.size() % 3 == 0 ? direction() * std::min(2 * away / kFocal, 0.005 * distance) : glm::dvec3(0);
        const glm::dvec3 eye = direction() * (4 * away / kFocal); // the ball moves by up to four pixels
        const auto curvature = static_cast<float>((convex ? 1 : -1) / radius);
        list.push_back({on, N, V, glm::vec2(curvature), static_cast<float>(distance), step, eye});
        truths.push_back({ball, on, ball.mirrors(end + step, eye, on)});
    }
    double flat = 0, curved = 0, worst = 0;
    size_t caustics = 0;
    const std::vector<MirrorItem> got = evaluated(list);
    for (size_t i = 0; i < got.size(); ++i) {
        const glm::dvec3 eye = got[i].eyeBefore;
        const glm::dvec3 truth = truths[i].was - eye;
        if (got[i].seen == 0) {
            ++caustics;
            continue;
        }
        const double error = pixelsBetween(glm::dvec3(got[i].image) - eye, truth);
        EXPECT_LT(error, 0.3) << i << (truths[i].ball.convex ? " convex, radius " : " concave, radius ")
                              << truths[i].ball.radius << ", distance " << got[i].distance;
        worst = std::max(worst, error);
        curved += error;
        const glm::dvec3 mirrored = glm::dvec3(got[i].step) -
                                    2 * glm::dot(glm::dvec3(got[i].step), glm::dvec3(got[i].N)) * glm::dvec3(got[i].N);
        flat += pixelsBetween(truths[i].on - glm::dvec3(got[i].V) * double(got[i].distance) + mirrored - eye, truth);
    }
    const double seen = static_cast<double>(got.size() - caustics);
    std::cout << "off by " << curved / seen << " px, at most " << worst << "; flat mirrors: " << flat / seen << " px; "
              << caustics << " caustics\n";
    EXPECT_GT(flat / seen, 20 * curved / seen);
    EXPECT_LT(caustics, 100u);
}

TEST_F(MirrorImageTest, ACausticHasNoImage) {
    // A hollow ball's surface, seen at right angles, that mirrors a point in its focus, at half of the radius; and one
    // whose image lies at the eye.
    const glm::vec3 N(0, 0, 1);
    const glm::vec3 position(0, 0, -3);
    const auto hollow = [&](float radius, float distance) {
        return MirrorItem{position, N, N, glm::vec2(-1 / radius), distance, {}, {0.01f, 0, 0}};
    };
    const std::vector<MirrorItem> got = evaluated({
        hollow(2, 1),                  // focus
        hollow(2, 1.02f),              // beside it
        hollow(2, 1.5f),               // image at the eye: 1/1.5 - 1 = -1/3
        hollow(2, 0.5f), hollow(2, 4), // between mirror and eye
    });
    EXPECT_EQ(got[0].seen, 0u);
    EXPECT_EQ(got[1].seen, 0u);
    EXPECT_EQ(got[2].seen, 0u);
    ASSERT_EQ(got[3].seen, 1u);
    EXPECT_NEAR(got[3].image.z, -4, 1e-4); // 1/0.5 - 1 = 1/1
    ASSERT_EQ(got[4].seen, 1u);
    EXPECT_NEAR(got[4].image.z, -3 + 4 / 3.0, 1e-4);
}

} // namespace mirror_image_test
} // namespace glint::test
