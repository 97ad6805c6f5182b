// shaders/prepare/pyramid: every cell of every level bounds the surfaces that the frame shows in it, and tightly. The
// pass runs alone, on the tests' own depths; the test visits all pixels of all cells in double precision.
#include "gpu/support/synthetic_gbuffer.hpp"

#include "reflect/prepare/frame_block.hpp"
#include "shared/trace_constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>

namespace glint::test {
namespace pyramid_test {

constexpr float kBackground = shared::kBackgroundZ;
/// As in lib/pyramid.glsl.
constexpr float kEmptyCell = -1.0e37f;
constexpr float kBroken = 1.0e37f;

/// Layout of tests/gpu/shaders/pyramid_cells.comp's output.
struct Cell {
    float front;
    float depth;
    float slab;
    glm::vec2 slope;
    glm::vec2 quarters[4];
    bool empty() const { return front <= kEmptyCell; }
    bool broken() const { return depth >= kBroken; }
};

/// Rounding of nearness, as a fraction of it: the tolerance of the hiz marcher.
constexpr double kRounding = 2e-6;

struct Depths {
    glm::ivec2 size;
    std::vector<float> viewZ; ///< row by row
    bool orthographic = false;
    std::vector<float> backViewZ; ///< of the pixels' objects, or kBackground
    bool backFaces = false;
    float thickness = 0;
    float thicknessRelative = 0;

    bool seen(glm::ivec2 px) const { return viewZ[static_cast<size_t>(px.y * size.x + px.x)] < kBackground; }
    double nearness(double z) const { return orthographic ? -z : 1 / z; }
    double front(glm::ivec2 px) const {
        return nearness(static_cast<double>(viewZ[static_cast<size_t>(px.y * size.x + px.x)]));
    }
    /// Where the surface of a pixel ends behind: hit_test.glsl's slabEnd.
    double slabEnd(glm::ivec2 px) const {
        const double z = static_cast<double>(viewZ[static_cast<size_t>(px.y * size.x + px.x)]);
        double reach = z;
        if (backFaces) {
            const double back = static_cast<double>(backViewZ[static_cast<size_t>(px.y * size.x + px.x)]);
            if (back < static_cast<double>(kBackground))
                reach = back;
        }
        return nearness(reach + static_cast<double>(thickness) + static_cast<double>(thicknessRelative) * z);
    }
};

glm::ivec2 levelSize(glm::ivec2 size, int level) {
    return (size + (1 << level) - 1) / (1 << level);
}

/// levels[i] is level i + 1.
using Levels = std::vector<std::vector<Cell>>;

/// Pixels of a cell's quarter, or of the whole cell; clipped to the image.
template <class Visit>
void forPixels(glm::ivec2 size, glm::ivec2 low, int side, Visit visit) {
    const glm::ivec2 high = glm::min(low + side, size);
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            visit(glm::ivec2(x, y));
}

class PyramidTest : public GpuTest {
protected:
    static constexpr glm::ivec2 kSizes[] = {{1, 1},     {17, 9},  {64, 64}, {65, 33},
                                            {640, 360}, {257, 1}, {1, 300}, {1023, 511}};

    static Levels build(const Depths& in) {
        shared::FrameConstants constants = {};
        constants.size = in.size;
        constants.invSize = 1.0f / constants.size;
        constants.flags = in.orthographic ? shared::kInputOrthographic : 0;
        gpu::Buffer frameConstants =
            must(gpu::uploadBuffer(gpu(), "test/frame", std::vector{reflect::FrameBlockValues{constants, {}}},
                                   VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
        const auto image = [](const char* name, glm::ivec2 size, const std::vector<float>& texels) {
            return uploadTestImage(gpu(), name, VK_FORMAT_R32_SFLOAT, static_cast<uint32_t>(size.x),
                                   static_cast<uint32_t>(size.y), bytesOf(texels));
        };
        gpu::Image viewZ = image("test/viewZ", in.size, in.viewZ);
        gpu::Image backViewZ = in.backFaces ? image("test/backViewZ", in.size, in.backViewZ)
                                            : image("test/backViewZ", {1, 1}, {kBackground});
        // Every surface faces the eye, so the pyramid has no information about what lies between two pixels.
        gpu::Image surface = uploadTestImage(gpu(), "test/surface", VK_FORMAT_R32G32_UINT,
                                             static_cast<uint32_t>(in.size.x), static_cast<uint32_t>(in.size.y),
                                             bytesOf(std::vector<glm::uvec2>(in.viewZ.size(), glm::uvec2(0))));
        // As FrameState::createPyramid creates them.
        const auto longest = static_cast<uint32_t>(std::max(in.size.x, in.size.y));
        const uint32_t levels =
            std::clamp(static_cast<uint32_t>(std::bit_width(longest - 1)), 1u, shared::kMaxPyramidLevels - 1);
        const glm::uvec2 level1 = levelSize(in.size, 1);
        const glm::uvec2 level2 = levelSize(in.size, 2);
        gpu::Image cells = must(gpu::Image::create(
            gpu(), {"test/pyramid", VK_FORMAT_R32G32B32A32_UINT, level1.x + level2.x, level1.y + levels, 1, 1,
                    gpu::ImageShape::Flat, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
        const glm::uvec2 tiles = levelSize(in.size, shared::kPyramidTileLevel);
        gpu::Buffer tileCells =
            must(gpu::uploadBuffer(gpu(), "test/tiles", std::vector<uint32_t>(4 + 8 * size_t{tiles.x} * tiles.y),
                                   VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
        const gpu::Pipeline make =
            must(gpu::Pipeline::compute(gpu(), {"prepare/pyramid", sizeof(shared::PyramidConstants), {}}));
        struct ReadPush {
            glm::ivec2 size;
            int level;
        };
        const gpu::Pipeline read = must(gpu::Pipeline::compute(gpu(), {"pyramid_cells", sizeof(ReadPush), {}}));

        std::vector<gpu::Buffer> out;
        for (uint32_t level = 1; level <= levels; ++level) {
            const glm::uvec2 count = levelSize(in.size, static_cast<int>(level));
            out.push_back(
                must(gpu::uploadBuffer(gpu(), "test/cells", std::vector<Cell>(size_t{count.x} * count.y),
                                       VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT)));
        }
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            for (int again = 0; again < 2; ++again) // the counters are as before
                frame.pass(make)
                    .read("frame", frameConstants)
                    .read("viewZ", viewZ)
                    .read("backViewZ", backViewZ)
                    .read("surface", surface)
                    .write("pyramid", cells)
                    .readWrite("tiles", tileCells)
                    .push(shared::PyramidConstants{in.thickness, in.thicknessRelative,
                                                   in.backFaces ? shared::kTraceBackDepth : 0, levels})
                    .dispatch(tiles.x * make.localSize()[0], tiles.y * make.localSize()[1]);
            for (uint32_t level = 1; level <= levels; ++level) {
                const glm::uvec2 count = levelSize(in.size, static_cast<int>(level));
                frame.pass(read)
                    .read("pyramid", cells)
                    .write("cells", out[level - 1])
                    .push(ReadPush{in.size, static_cast<int>(level)})
                    .dispatch(count.x, count.y);
            }
        });
        Levels result;
        for (gpu::Buffer& buffer : out) {
            const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
            result.emplace_back(bytes.size() / sizeof(Cell));
            std::memcpy(result.back().data(), bytes.data(), bytes.size());
        }
        return result;
    }

    /// `visit(cell, level, low)` for every cell of every level; `low` is its first pixel.
    template <class Visit>
    static void forCells(const Depths& in, const Levels& levels, Visit visit) {
        for (int level = 1; level <= static_cast<int>(levels.size()); ++level) {
            const glm::ivec2 count = levelSize(in.size, level);
            for (int i = 0; i < count.x * count.y && !HasFatalFailure(); ++i)
                visit(levels[static_cast<size_t>(level - 1)][static_cast<size_t>(i)], level,
                      glm::ivec2(i % count.x, i / count.x) * (1 << level));
        }
    }

    /// How far a point of nearness `n` at a pixel lies below the cell's plane, about which its bounds are.
    static double below(const Cell& cell, int level, glm::ivec2 low, glm::ivec2 px, double n) {
        const glm::dvec2 d = glm::dvec2(px - low) + 0.5 - 0.5 * (1 << level);
        return static_cast<double>(cell.front) + glm::dot(glm::dvec2(cell.slope), d) - n;
    }

    static void expectValid(const Depths& in, const Levels& levels) {
        forCells(in, levels, [&](const Cell& cell, int level, glm::ivec2 low) {
            bool any = false;
            bool all = true;
            for (int quarter = 0; quarter < 4; ++quarter) {
                const int half = 1 << (level - 1);
                const glm::dvec2 solid = cell.quarters[quarter];
                forPixels(in.size, low + glm::ivec2(quarter & 1, quarter >> 1) * half, half, [&](glm::ivec2 px) {
                    if (!in.seen(px)) {
                        all = false;
                        return;
                    }
                    any = true;
                    const double front = in.front(px);
                    const double rounding = kRounding * std::abs(front);
                    const double nearest = below(cell, level, low, px, front);
                    const double farthest = below(cell, level, low, px, in.slabEnd(px));
                    const bool valid = !cell.empty() && nearest >= -rounding &&
                                       nearest <= static_cast<double>(cell.depth) + rounding &&
                                       farthest <= static_cast<double>(cell.slab) + rounding &&
                                       solid.x <= nearest + rounding && solid.y >= farthest - rounding;
                    ASSERT_TRUE(valid) << fmt::format("level {}, cell at {},{}, pixel {},{}: solid from {} to {}; "
                                                      "depth {}, slab {}, quarter {} to {}",
                                                      level, low.x, low.y, px.x, px.y, nearest, farthest, cell.depth,
                                                      cell.slab, solid.x, solid.y);
                });
            }
            ASSERT_EQ(cell.empty(), !any) << level << " " << low.x << "," << low.y;
            ASSERT_EQ(cell.broken(), !all) << level << " " << low.x << "," << low.y;
        });
    }

    /// Except for packing's rounding, the bounds are the exact minimum and maximum.
    static void expectTight(const Depths& in, const Levels& levels) {
        constexpr double kPacked = 1.26; // two bits of mantissa, up
        forCells(in, levels, [&](const Cell& cell, int level, glm::ivec2 low) {
            if (cell.empty())
                return;
            const auto where = [&] { return fmt::format("level {}, cell at {},{}", level, low.x, low.y); };
            double nearest = 1e30;
            double depth = 0;
            double slab = 0;
            forPixels(in.size, low, 1 << level, [&](glm::ivec2 px) {
                if (!in.seen(px))
                    return;
                const double here = below(cell, level, low, px, in.front(px));
                nearest = std::min(nearest, here);
                depth = std::max(depth, here);
                slab = std::max(slab, below(cell, level, low, px, in.slabEnd(px)));
            });
            const double rounding = kRounding * std::abs(static_cast<double>(cell.front));
            ASSERT_LE(nearest, rounding) << where();
            ASSERT_TRUE(cell.broken() || cell.depth <= kPacked * (depth + rounding)) << where();
            ASSERT_LE(cell.slab, kPacked * (slab + rounding)) << where();
            for (int quarter = 0; quarter < 4; ++quarter) {
                const int half = 1 << (level - 1);
                const glm::dvec2 solid = cell.quarters[quarter];
                double from = 1e30;
                double to = -1e30;
                forPixels(in.size, low + glm::ivec2(quarter & 1, quarter >> 1) * half, half, [&](glm::ivec2 px) {
                    if (in.seen(px)) {
                        from = std::min(from, below(cell, level, low, px, in.front(px)));
                        to = std::max(to, below(cell, level, low, px, in.slabEnd(px)));
                    }
                });
                const double step = 1.02 / 63 * static_cast<double>(cell.slab) + rounding;
                if (from > to) {
                    ASSERT_GT(solid.x, solid.y) << where() << ": nothing in this quarter";
                } else {
                    ASSERT_GE(solid.x, from - step) << where();
                    ASSERT_LE(solid.y, to + step) << where();
                }
            }
        });
    }

    template <class Z>
    static Depths depths(glm::ivec2 size, Z viewZ) {
        Depths out;
        out.size = size;
        forPixels(size, {0, 0}, std::max(size.x, size.y),
                  [&](glm::ivec2 px) { out.viewZ.push_back(static_cast<float>(viewZ(px))); });
        return out;
    }

    /// Back faces half of the time, some of them unknown.
    static void addSlabs(Depths& in, bool backFaces, std::mt19937& random) {
        std::uniform_real_distribution<float> unit(0, 1);
        in.backFaces = backFaces;
        in.thickness = backFaces ? 0 : 0.2f;
        in.thicknessRelative = 0.01f;
        if (!backFaces)
            return;
        in.backViewZ.clear();
        for (const float z : in.viewZ)
            in.backViewZ.push_back(random() % 4 == 0 ? kBackground : z + 12 * unit(random));
    }
};

TEST_F(PyramidTest, BoundsHoldForAnyDepths) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const glm::ivec2 size : kSizes)
        for (const bool orthographic : {false, true})
            for (const int holes : {0, 1, 2}) { // none, few, most
                SCOPED_TRACE(fmt::format("{}x{}, orthographic {}, holes {}", size.x, size.y, orthographic, holes));
                Depths in = depths(size, [&](glm::ivec2) {
                    const bool hole = holes == 1 ? random() % 50 == 0 : holes == 2 ? random() % 50 != 0 : false;
                    return hole ? static_cast<double>(kBackground) : 0.1 * std::pow(1000.0, unit(random));
                });
                in.orthographic = orthographic;
                addSlabs(in, holes != 0, random);
                expectValid(in, build(in));
                ASSERT_FALSE(HasFatalFailure());
            }
}

/// Planes, balls and edges between them, and a background: depths as in rendered frames.
double roomDepth(glm::ivec2 px, glm::ivec2 size) {
    const glm::dvec3 d = glm::normalize(glm::dvec3((px.x + 0.5) / size.x - 0.5, 0.3 - (px.y + 0.5) / size.y, -1));
    double z = static_cast<double>(kBackground);
    const auto meet = [&](double t) {
        if (t > 0.05 && std::isfinite(t))
            z = std::min(z, -d.z * t);
    };
    meet(-1 / d.y);
    if (d.x * -5 / d.z > -1.2) // a wall that does not fill the width
        meet(-5 / d.z);
    for (const glm::dvec3 center : {glm::dvec3(0.5, -0.6, -3), glm::dvec3(-0.7, 0, -2)}) {
        const double b = glm::dot(d, center);
        const double root = b * b - glm::dot(center, center) + 0.4 * 0.4;
        if (root > 0)
            meet(b - std::sqrt(root));
    }
    return z;
}

TEST_F(PyramidTest, BoundsHoldForPictures) {
    std::mt19937 random(8);
    for (const glm::ivec2 size : kSizes)
        for (const bool orthographic : {false, true}) {
            SCOPED_TRACE(fmt::format("{}x{}, orthographic {}", size.x, size.y, orthographic));
            Depths in = depths(size, [&](glm::ivec2 px) { return roomDepth(px, size); });
            in.orthographic = orthographic;
            addSlabs(in, !orthographic, random);
            expectValid(in, build(in));
            ASSERT_FALSE(HasFatalFailure());
        }
}

TEST_F(PyramidTest, NoBoundIsLooserThanItsRounding) {
    // Depths with edges only: no cell is tilted, so its bounds are the minimum and maximum.
    std::mt19937 random(9);
    constexpr double kDepths[] = {1, 2, 4};
    for (const glm::ivec2 size : kSizes)
        for (const bool orthographic : {false, true}) {
            SCOPED_TRACE(fmt::format("{}x{}, orthographic {}", size.x, size.y, orthographic));
            Depths in = depths(size, [&](glm::ivec2) {
                return random() % 100 == 0 ? static_cast<double>(kBackground) : kDepths[random() % 3];
            });
            in.orthographic = orthographic;
            addSlabs(in, orthographic, random);
            const Levels levels = build(in);
            expectValid(in, levels);
            expectTight(in, levels);
            ASSERT_FALSE(HasFatalFailure());
        }
}

TEST_F(PyramidTest, APlaneIsFlatAtEveryLevel) {
    for (const glm::ivec2 size : kSizes)
        for (const glm::dvec2 tilt : {glm::dvec2(0), glm::dvec2(0.2, 0), glm::dvec2(-0.1, 0.3)}) {
            const glm::dvec2 slope = tilt / glm::dvec2(size);
            if (std::max(std::abs(slope.x), std::abs(slope.y)) > 0.04 * 0.4)
                continue; // so steep a step counts as an edge
            SCOPED_TRACE(fmt::format("{}x{}, tilt {},{}", size.x, size.y, tilt.x, tilt.y));
            const Depths in = depths(size, [&](glm::ivec2 px) { // nearness is linear on screen
                const glm::dvec2 uv = (glm::dvec2(px) + 0.5) / glm::dvec2(size);
                return 1 / (0.5 + glm::dot(tilt, uv));
            });
            const Levels levels = build(in);
            expectValid(in, levels);
            forCells(in, levels, [&](const Cell& cell, int level, glm::ivec2 low) {
                if (glm::any(glm::greaterThan(low + (1 << level), in.size)))
                    return; // cells across the image's end have no slope
                // Slopes are halves: a cell's depth is the slope's rounding across the cell, plus depth's own rounding.
                const double left = glm::dot(glm::abs(slope), glm::dvec2(1 << level)) / 1024;
                ASSERT_LE(cell.depth, left + 1e-6) << "level " << level << ", cell at " << low.x << "," << low.y;
            });
            ASSERT_FALSE(HasFatalFailure());
        }
}

TEST_F(PyramidTest, ABackgroundIsEmptyAtEveryLevel) {
    for (const glm::ivec2 size : kSizes) {
        const Depths in = depths(size, [](glm::ivec2) { return static_cast<double>(kBackground); });
        forCells(in, build(in), [&](const Cell& cell, int level, glm::ivec2 low) {
            ASSERT_TRUE(cell.empty()) << "level " << level << ", cell at " << low.x << "," << low.y;
        });
    }
}

} // namespace pyramid_test
} // namespace glint::test
