// Fits the polynomials of shaders/lib/environment_lobe.glsl and prints them, then their error by roughness and NoV. No
// part of the build:
//
//     g++ -O3 -march=native -ffast-math -std=c++20 scripts/lib/environment_lobe.cpp -o /tmp/fit && /tmp/fit
//
// The exact lobe is GGX with height-correlated Smith times the cosine, normalised. The lookups are those of a cube that
// is prefiltered with N = V = R (shaders/prefilter/ggx.comp), whose mips are 0.2 of roughness apart. What is minimized
// is the relative error of what skies over a ground, rooms with soft boxes, and small lights show (Levenberg and
// Marquardt), with the fourth power of large errors on top, so that no case is bought by many.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

constexpr double kPi = std::numbers::pi;
constexpr int kWidth = 180, kHeight = 90; // directions of the sphere
constexpr int kKernels = 4;               // beside the widest
constexpr int kTerms = 10;
constexpr int kParameters = kKernels * 3 * kTerms;

struct Vec {
    double x, y, z;
};
Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator*(double s, Vec a) {
    return {s * a.x, s * a.y, s * a.z};
}
double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec unit(Vec a) {
    return 1 / std::sqrt(dot(a, a)) * a;
}

using Values = std::vector<double>; // one for each direction, or for each environment

struct Sphere {
    std::vector<Vec> directions;
    Values solidAngles;
    Sphere() {
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const double theta = kPi * (y + .5) / kHeight, phi = 2 * kPi * (x + .5) / kWidth;
                directions.push_back(
                    {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
                solidAngles.push_back(std::sin(theta) * kPi / kHeight * 2 * kPi / kWidth);
            }
    }
};
const Sphere sphere;

double ggx(double cosine, double a2) {
    const double spread = cosine * cosine * (a2 - 1) + 1;
    return a2 / (kPi * spread * spread);
}

Values normalised(Values weights) {
    double sum = 0;
    for (double w : weights)
        sum += w;
    for (double& w : weights)
        w /= sum;
    return weights;
}

/// N is +Y, the plane of incidence x, y.
Values exactLobe(double NoV, double roughness) {
    const double a2 = std::pow(roughness, 4);
    const Vec V = {-std::sqrt(1 - NoV * NoV), NoV, 0};
    Values weights(sphere.directions.size(), 0);
    for (size_t i = 0; i < weights.size(); ++i) {
        const double NoL = sphere.directions[i].y;
        if (NoL <= 0)
            continue;
        const double smith = NoL * std::sqrt(NoV * NoV * (1 - a2) + a2) + NoV * std::sqrt(NoL * NoL * (1 - a2) + a2);
        weights[i] = ggx(unit(V + sphere.directions[i]).y, a2) * NoL / smith * sphere.solidAngles[i];
    }
    return normalised(weights);
}

Values kernel(const Vec& axis, double roughness) {
    const double a2 = std::pow(roughness, 4);
    Values weights(sphere.directions.size(), 0);
    for (size_t i = 0; i < weights.size(); ++i)
        if (const double cosine = dot(axis, sphere.directions[i]); cosine > 0)
            weights[i] = ggx(dot(axis, unit(axis + sphere.directions[i])), a2) * cosine * sphere.solidAngles[i];
    return normalised(weights);
}

/// A lookup `angle` from the normal, in the middle of a texel; `between`: where four texels meet, as in the middle of a
/// cube's face. The last mip's faces have 8 texels along a side, those before twice as many each. The filter that makes
/// them blurs its source besides, by somewhat less.
Values lookup(double angle, double roughness, bool between) {
    if (!between)
        return kernel({std::sin(angle), std::cos(angle), 0}, roughness);
    const double half = 1.4 * kPi / 4 / (8 * std::exp2(5 - 5 * roughness));
    Values sum(sphere.directions.size(), 0);
    for (int corner = 0; corner < 4; ++corner) {
        const double turned = angle + (corner & 1 ? half : -half), aside = corner & 2 ? half : -half;
        const Values there = kernel(unit({std::sin(turned), std::cos(turned), aside}), roughness);
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += there[i] / 4;
    }
    return sum;
}

double smooth(double low, double high, double x) {
    x = std::clamp((x - low) / (high - low), 0., 1.);
    return x * x * (3 - 2 * x);
}

std::vector<Values> environments() {
    std::mt19937 random(1);
    const auto u = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
    const auto anywhere = [&] {
        const double y = 2 * u() - 1, phi = 2 * kPi * u(), s = std::sqrt(1 - y * y);
        return Vec{s * std::cos(phi), y, s * std::sin(phi)};
    };
    std::vector<Values> all;
    for (int j = 0; j < 180; ++j) { // skies: the surface faces anywhere, up, down, or sideways
        const Vec sideways = unit({std::cos(j * 1.), 0, std::sin(j * 1.)});
        const Vec up = j < 60 ? anywhere() : j % 4 == 0 ? Vec{0, 1, 0} : j % 4 == 1 ? Vec{0, -1, 0} : sideways;
        const double ground = .1 + .3 * u(), haze = 1.5 * u(), glow = u() < .5 ? 2 * u() : 0;
        const Vec sun = anywhere();
        Values e;
        for (const Vec& d : sphere.directions) {
            const double height = dot(up, d), sky = smooth(-.03, .03, height);
            e.push_back(ground * (1 - sky) * (1 + .3 * d.x) + sky * (.5 + haze * std::pow(1 - std::abs(height), 3)) +
                        glow * std::pow(std::max(0., dot(sun, d)), 12));
        }
        all.push_back(e);
    }
    for (int j = 0; j < 120; ++j) { // rooms with four soft boxes
        Values e(sphere.directions.size(), .3);
        for (int box = 0; box < 4; ++box) {
            const Vec to = anywhere();
            const double edge = std::cos(.15 + .4 * u()), radiance = 1 + 5 * u();
            for (size_t i = 0; i < e.size(); ++i)
                e[i] += radiance * smooth(edge - .03, edge + .02, dot(to, sphere.directions[i]));
        }
        all.push_back(e);
    }
    for (int j = 0; j < 140; ++j) { // one small light
        const Vec to = anywhere(), brighter = anywhere();
        const double edge = std::cos(.07 + .12 * u());
        Values e;
        for (const Vec& d : sphere.directions)
            e.push_back(.5 + .3 * dot(brighter, d) + 30 * smooth(edge - .006, edge + .004, dot(to, d)));
        all.push_back(e);
    }
    return all;
}

const std::vector<Values> shown = environments();

/// What each environment shows through these weights.
Values seen(const Values& weights) {
    Values result;
    for (const Values& e : shown) {
        double sum = 0;
        for (size_t i = 0; i < weights.size(); ++i)
            sum += weights[i] * e[i];
        result.push_back(sum);
    }
    return result;
}

/// Lookups by angle and roughness, tabulated.
class Cube {
public:
    Cube() {
        for (int a = 0; a < kAngles; ++a)
            for (int r = 0; r < kRoughnesses; ++r)
                table_.push_back(seenBothWays((kFirst + kStep * a) * kPi / 180, .1 + .05 * r));
    }
    void add(double angle, double roughness, double weight, Values& sum) const {
        const double mip = roughness * 5;
        const int low = std::min(int(mip), 4);
        if (roughness < .2) { // between a mirror and the first mip: as if it were a mip
            addMip(angle, roughness, weight, sum);
            return;
        }
        addMip(angle, low * .2, weight * (low + 1 - mip), sum);
        addMip(angle, (low + 1) * .2, weight * (mip - low), sum);
    }

private:
    /// Every other environment between texels.
    static Values seenBothWays(double angle, double roughness) {
        Values result = seen(lookup(angle, roughness, false));
        const Values between = seen(lookup(angle, roughness, roughness > .35));
        for (size_t e = 1; e < result.size(); e += 2)
            result[e] = between[e];
        return result;
    }
    static constexpr double kFirst = -60, kStep = 4; // degrees
    static constexpr int kAngles = 54, kRoughnesses = 19;
    void addMip(double angle, double roughness, double weight, Values& sum) const {
        const double a = std::clamp((angle * 180 / kPi - kFirst) / kStep, 0., kAngles - 1.001);
        const double r = std::clamp((roughness - .1) / .05, 0., kRoughnesses - 1.001);
        for (int i = 0; i < 4; ++i) {
            const double share = (i & 1 ? a - int(a) : 1 - a + int(a)) * (i & 2 ? r - int(r) : 1 - r + int(r));
            const Values& there = table_[size_t((int(a) + (i & 1)) * kRoughnesses + int(r) + (i >> 1))];
            for (size_t e = 0; e < sum.size(); ++e)
                sum[e] += weight * share * there[e];
        }
    }
    std::vector<Values> table_;
};

struct Node {
    double NoV, roughness;
    Values exact;
};

double polynomial(const double* p, double x, double y) {
    const double terms[kTerms] = {1, x, y, x * x, x * y, y * y, x * x * y, x * y * y, y * y * y, x * x * x};
    double sum = 0;
    for (int i = 0; i < kTerms; ++i)
        sum += p[i] * terms[i];
    return sum;
}

/// Relative errors of a node's environments, large ones enlarged; `plain`: without that.
void errors(const Cube& cube, const Node& node, const Values& p, bool plain, double* out) {
    Values sum(shown.size(), 0);
    double left = 1;
    for (int k = 0; k < kKernels; ++k) {
        const double* of = &p[size_t(3 * k * kTerms)];
        const double reach = k == 3 ? kPi / 2 : std::acos(node.NoV);
        const double roughness = std::clamp(node.roughness * polynomial(of + kTerms, node.NoV, node.roughness), .1, 1.);
        const double weight = polynomial(of + 2 * kTerms, node.NoV, node.roughness);
        cube.add(reach * polynomial(of, node.NoV, node.roughness), roughness, weight, sum);
        left -= weight;
    }
    cube.add(0, 1, left, sum);
    for (size_t e = 0; e < sum.size(); ++e) {
        const double error = (sum[e] / node.exact[e] - 1) * (node.NoV < .1 && !plain ? .5 : 1);
        out[e] = plain ? error : error * std::sqrt(1 + 60 * error * error);
    }
}

Values allErrors(const Cube& cube, const std::vector<Node>& nodes, const Values& p) {
    Values result(nodes.size() * shown.size());
    for (size_t n = 0; n < nodes.size(); ++n)
        errors(cube, nodes[n], p, false, &result[n * shown.size()]);
    return result;
}

double squares(const Values& v) {
    double sum = 0;
    for (double x : v)
        sum += x * x;
    return sum;
}

/// Solves A x = b by elimination.
Values solve(std::vector<Values> A, Values b) {
    const size_t n = b.size();
    for (size_t i = 0; i < n; ++i) {
        size_t pivot = i;
        for (size_t j = i; j < n; ++j)
            pivot = std::abs(A[j][i]) > std::abs(A[pivot][i]) ? j : pivot;
        std::swap(A[i], A[pivot]);
        std::swap(b[i], b[pivot]);
        for (size_t j = i + 1; j < n; ++j) {
            const double f = A[j][i] / A[i][i];
            for (size_t k = i; k < n; ++k)
                A[j][k] -= f * A[i][k];
            b[j] -= f * b[i];
        }
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; ++k)
            b[i] -= A[i][k] * b[k];
        b[i] /= A[i][i];
    }
    return b;
}

Values firstGuess() {
    Values p(kParameters, 0);
    const std::array<std::array<double, 5>, 4> guess = {{// angle, by roughness; roughness; weight, by roughness
                                                         {.8, -.3, 1, .7, -.4},
                                                         {1, -.2, .7, .3, -.1},
                                                         {1.1, -.2, .5, .1, -.05},
                                                         {1.15, 0, .9, -.02, 0}}};
    for (size_t k = 0; k < kKernels; ++k) {
        double* of = &p[3 * k * kTerms];
        of[0] = guess[k][0];
        of[2] = guess[k][1];
        of[kTerms] = guess[k][2];
        of[2 * kTerms] = guess[k][3];
        of[2 * kTerms + 2] = guess[k][4];
    }
    return p;
}

void fit(const Cube& cube, const std::vector<Node>& nodes, Values& p) {
    Values now = allErrors(cube, nodes, p);
    double damping = 1e-2;
    for (int round = 0; round < 60 && damping < 1e6; ++round) {
        std::vector<std::vector<float>> slopes;
        for (int i = 0; i < kParameters; ++i) {
            constexpr double kStep = 1e-4;
            Values moved = p;
            moved[size_t(i)] += kStep;
            const Values there = allErrors(cube, nodes, moved);
            slopes.emplace_back(now.size());
            for (size_t n = 0; n < now.size(); ++n)
                slopes.back()[n] = float((there[n] - now[n]) / kStep);
        }
        std::vector<Values> normal(kParameters, Values(kParameters));
        Values right(kParameters, 0);
        for (size_t i = 0; i < kParameters; ++i) {
            for (size_t j = 0; j <= i; ++j) {
                double sum = 0;
                for (size_t n = 0; n < now.size(); ++n)
                    sum += slopes[i][n] * slopes[j][n];
                normal[i][j] = normal[j][i] = sum;
            }
            for (size_t n = 0; n < now.size(); ++n)
                right[i] += slopes[i][n] * now[n];
        }
        for (bool better = false; !better && damping < 1e6;) {
            std::vector<Values> damped = normal;
            for (size_t i = 0; i < kParameters; ++i)
                damped[i][i] += damping * normal[i][i] + 1e-6 * double(now.size());
            const Values step = solve(damped, right);
            Values moved = p;
            for (size_t i = 0; i < kParameters; ++i)
                moved[i] -= step[i];
            const Values there = allErrors(cube, nodes, moved);
            better = squares(there) < squares(now);
            damping *= better ? .4 : 4;
            if (better) {
                p = moved;
                now = there;
            }
        }
        std::fprintf(stderr, "round %d: %.4f\n", round, std::sqrt(squares(now) / double(now.size())));
    }
}

int main() {
    const Cube cube;
    std::vector<Node> nodes;
    for (const double roughness : {.2, .3, .4, .5, .6, .7, .8, .9, 1.})
        for (const double NoV : {.08, .15, .25, .4, .55, .7, .85, 1.})
            nodes.push_back({NoV, roughness, seen(exactLobe(NoV, roughness))});
    Values p = firstGuess();
    fit(cube, nodes, p);
    for (size_t i = 0; i < 3 * kKernels; ++i) {
        const double* r = &p[i * kTerms];
        std::printf(
            "    LobePolynomial(vec4(%.4f, %.4f, %.4f, %.4f), vec4(%.4f, %.4f, %.4f, %.4f), vec2(%.4f, %.4f))%s\n",
            r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], r[9], i + 1 < 3 * kKernels ? "," : "");
    }
    for (const Node& node : nodes) {
        Values error(shown.size());
        errors(cube, node, p, true, error.data());
        double skies = 0, most = 0;
        for (size_t e = 0; e < 180; ++e) {
            skies += error[e] * error[e] / 180;
            most = std::max(most, std::abs(error[e]));
        }
        std::printf("roughness %.1f NoV %.2f: %.1f %%, of skies %.1f %%, at most %.0f %%\n", node.roughness, node.NoV,
                    100 * std::sqrt(squares(error) / double(error.size())), 100 * std::sqrt(skies), 100 * most);
    }
}
