// Seams: edges where one source takes over from another on one surface, and where the reference has no edge.
#pragma once

#include "lab/tests/image/source_pictures.hpp"

#include <algorithm>
#include <numeric>

namespace glint::test {

/// Steps between neighbouring pixels, bytes, as far as the reference has none.
struct Steps {
    std::vector<double> steps;

    double mean() const { return std::accumulate(steps.begin(), steps.end(), 0.0) / count(); }
    double seen() const { ///< fraction of visible steps
        return static_cast<double>(std::ranges::count_if(steps, [](double step) { return step > kNoticeable; })) /
               count();
    }
    double percentile95() const {
        std::vector<double> sorted = steps;
        std::ranges::sort(sorted);
        return sorted.empty() ? 0 : sorted[(sorted.size() - 1) * 95 / 100];
    }

private:
    double count() const { return static_cast<double>(std::max<size_t>(steps.size(), 1)); }
};

/// Pairs of pixels where the winner changes, and the pairs that continue them in line on either side, where it does not
/// change. The latter show as much of the scene and have its errors, but no seam.
struct Takeover {
    Steps across, beside;
    size_t rows = 0; ///< pairs across whose step is seen, and two more within two pixels of it

    double inRow() const {
        return static_cast<double>(rows) / static_cast<double>(std::max<size_t>(across.steps.size(), 1));
    }
};

struct Seams {
    Takeover all;
    std::array<std::array<Takeover, kMeasured>, kMeasured> between; ///< by winners, the smaller number first
    Steps inside;                                                   ///< all pairs where the winner does not change
};

/// Two pixels, the second to the right of the first or below it.
struct PixelPair {
    size_t x = 0, y = 0;
    bool down = false;
};

class SeamFinder {
public:
    explicit SeamFinder(const SourcePictures& pictures)
        : pictures_(pictures), width_(pictures.camera.width()), height_(pictures.camera.height()) {}

    Seams find() const {
        Seams out;
        for (size_t y = 0; y < height_; ++y)
            for (size_t x = 0; x < width_; ++x)
                for (const bool down : {false, true})
                    if (const PixelPair pair{x, y, down}; isOneSurface(pair))
                        count(pair, out);
        return out;
    }

private:
    void count(const PixelPair& pair, Seams& out) const {
        const auto [one, other] = winners(pair);
        if (one == other) {
            out.inside.steps.push_back(step(pair));
            return;
        }
        for (Takeover* takeover : {&out.all, &out.between[one][other]}) {
            takeover->across.steps.push_back(step(pair));
            takeover->rows += isInRow(pair);
            for (const PixelPair& beside : {next(pair, -1), next(pair, 1)})
                if (isOneSurface(beside) && wins(pixel(beside)) == wins(pixel(next(beside, 1))))
                    takeover->beside.steps.push_back(step(beside));
        }
    }

    /// The smaller number first.
    std::pair<size_t, size_t> winners(const PixelPair& pair) const {
        return std::minmax({wins(pixel(pair)), wins(pixel(next(pair, 1)))});
    }
    /// A single wrong pixel is no seam; a line of steps is.
    bool isInRow(const PixelPair& pair) const {
        if (step(pair) <= kNoticeable)
            return false;
        size_t seen = 0;
        for (size_t v = pair.y - 2; v != pair.y + 3; ++v)
            for (size_t u = pair.x - 2; u != pair.x + 3; ++u)
                for (const bool down : {false, true})
                    if (const PixelPair near{u, v, down}; isOneSurface(near) && winners(near) == winners(pair))
                        seen += step(near) > kNoticeable;
        return seen >= 3;
    }
    size_t pixel(const PixelPair& pair) const { return pair.y * width_ + pair.x; }
    size_t wins(size_t i) const { return winner(pictures_.whole.shares[i]); }
    /// The pair that continues this one in line.
    static PixelPair next(const PixelPair& pair, int by) {
        const size_t along = static_cast<size_t>(by); // one before the first is beyond the last
        return pair.down ? PixelPair{pair.x, pair.y + along, true} : PixelPair{pair.x + along, pair.y, false};
    }
    bool isInside(const PixelPair& pair) const {
        return pair.x < width_ && pair.y < height_ && next(pair, 1).x < width_ && next(pair, 1).y < height_;
    }

    glm::dvec3 normal(size_t i) const {
        return {pictures_.normal[i * 4], pictures_.normal[i * 4 + 1], pictures_.normal[i * 4 + 2]};
    }
    glm::dvec3 position(size_t i) const {
        const glm::dvec2 center = glm::dvec2(i % width_, i / width_) + 0.5;
        return pictures_.camera.position(pictures_.camera.ray(center), pictures_.depth[i * 4]);
    }

    /// Smooth, and of one material.
    bool isOneSurface(const PixelPair& pair) const {
        if (!isInside(pair))
            return false;
        const size_t p = pixel(pair), q = pixel(next(pair, 1));
        if (!pictures_.reflective[p] || !pictures_.reflective[q])
            return false;
        const glm::dvec3 way = position(q) - position(p);
        // 6 degrees: the smooth spheres turn by less from pixel to pixel except at their rims, edges by far more. A
        // pixel of the same surface lies in its plane, within half of what that angle allows.
        const double kTurn = glm::radians(6.0);
        const bool smooth = glm::dot(normal(p), normal(q)) > std::cos(kTurn) &&
                            std::abs(glm::dot(normal(p), way)) < kTurn * glm::length(way);
        // Less than between any two of the hall's materials, more than its textures change from pixel to pixel.
        const bool same = std::abs(pictures_.roughness[p * 4] - pictures_.roughness[q * 4]) < 0.05f &&
                          std::abs(pictures_.reflectivity[p * 4] - pictures_.reflectivity[q * 4]) < 0.02f;
        return smooth && same;
    }

    static double channelStep(const std::vector<Rgb>& picture, size_t p, size_t q, size_t channel) {
        return std::abs(picture[p][channel] - picture[q][channel]);
    }

    /// Mean of the channels' steps, each minus the reference's largest step within a pixel: a reflection displaced by a
    /// pixel has edges that are no seams.
    double step(const PixelPair& pair) const {
        double sum = 0;
        for (size_t channel = 0; channel < 3; ++channel) {
            double real = 0;
            for (size_t v = pair.y - 1; v != pair.y + 2; ++v)
                for (size_t u = pair.x - 1; u != pair.x + 2; ++u)
                    if (const PixelPair near{u, v, pair.down}; isInside(near))
                        real = std::max(real,
                                        channelStep(pictures_.reference, pixel(near), pixel(next(near, 1)), channel));
            const double shown = channelStep(pictures_.whole.rgb, pixel(pair), pixel(next(pair, 1)), channel);
            sum += std::max(0.0, shown - real);
        }
        return sum / 3;
    }

    const SourcePictures& pictures_;
    size_t width_, height_;
};

} // namespace glint::test
