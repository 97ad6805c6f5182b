#include "lab/tune/cost_fit.hpp"

#include "lab/measure/bench/effect_times.hpp"
#include "lab/session/settled_frames.hpp"
#include "lab/tune/frame_work.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace glint::tune {
namespace {

/// A pass's row in all its runs in the frame; 0 if it did not run.
double amountOf(const CostRow& row, const FrameWork& work) {
    const auto runs = std::ranges::count(work.passes, row.pass,
                                         [](const std::string& pass) { return std::string(withoutBackEnd(pass)); });
    if (runs == 0)
        return 0;
    return row.unit->amount(work) * (row.unit->isTotal ? 1 : static_cast<double>(runs));
}

using Vector = std::vector<double>;

/// The columns as a Gram matrix: products of each pair.
std::vector<Vector> gramOf(const std::vector<Vector>& columns) {
    std::vector<Vector> gram(columns.size(), Vector(columns.size()));
    for (size_t a = 0; a < columns.size(); ++a)
        for (size_t b = 0; b < columns.size(); ++b)
            for (size_t i = 0; i < columns[a].size(); ++i)
                gram[a][b] += columns[a][i] * columns[b][i];
    return gram;
}

/// Least squares of sum(x * column) = 1, for columns of length 1. No value if they are nearly dependent.
std::optional<Vector> solve(const std::vector<Vector>& columns) {
    constexpr double kLeastPivot = 1e-3; // of 1: sine squared of the angle to the columns before
    std::vector<Vector> gram = gramOf(columns);
    Vector right(columns.size());
    for (size_t a = 0; a < columns.size(); ++a)
        for (const double value : columns[a])
            right[a] += value;
    const size_t n = columns.size();
    for (size_t k = 0; k < n; ++k) { // Cholesky's order needs no exchange of rows
        if (gram[k][k] < kLeastPivot)
            return std::nullopt;
        for (size_t i = k + 1; i < n; ++i) {
            const double factor = gram[i][k] / gram[k][k];
            for (size_t j = k; j < n; ++j)
                gram[i][j] -= factor * gram[k][j];
            right[i] -= factor * right[k];
        }
    }
    Vector x(n);
    for (size_t k = n; k-- > 0;) {
        x[k] = right[k];
        for (size_t j = k + 1; j < n; ++j)
            x[k] -= gram[k][j] * x[j];
        x[k] /= gram[k][k];
    }
    return x;
}

double threeDigits(double value) {
    if (value <= 0)
        return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
    return std::round(value / unit) * unit;
}

/// The rows of one pass, by their places in the table.
class PassFit {
public:
    PassFit(std::span<const CostSample> samples, std::string_view pass) : all_(samples.size()) {
        for (const CostSample& sample : samples)
            if (const auto found = sample.floors.find(pass); found != sample.floors.end() && found->second > 0)
                ran_.push_back({&sample, found->second});
    }

    void fit(std::vector<FittedRow>& rows, const std::vector<size_t>& places) {
        std::vector<size_t> fitted;
        for (const size_t place : places) {
            rows[place].kept = std::ranges::any_of(ran_, [&](const Ran& ran) { return ran.sample->amounts[place] > 0; })
                                   ? ""
                                   : fmt::format("no frame had any {}", rows[place].row.unit->name);
            if (rows[place].kept.empty())
                fitted.push_back(place);
        }
        if (ran_.size() <= fitted.size() || ran_.empty())
            return keep(rows, places, fmt::format("ran in {} of {} frames", ran_.size(), all_));
        const std::vector<double> lengths = makeColumns(fitted);
        const std::optional<Vector> solved = solve(columns_);
        if (!solved)
            return keep(rows, fitted, "its units grow together in these frames");
        if (std::ranges::any_of(*solved, [](double x) { return x < 0; }))
            return keep(rows, fitted, "the fit gives a cost below 0");
        for (size_t i = 0; i < fitted.size(); ++i)
            rows[fitted[i]].floors = threeDigits((*solved)[i] / lengths[i]);
        for (const size_t place : fitted)
            rows[place].error = errorOf(rows, fitted);
    }

private:
    struct Ran {
        const CostSample* sample;
        double floors;
    };

    static void keep(std::vector<FittedRow>& rows, const std::vector<size_t>& places, const std::string& why) {
        for (const size_t place : places)
            rows[place].kept = why;
    }

    /// Amounts relative to the pass's time, each column divided by its length. Returns the lengths.
    std::vector<double> makeColumns(const std::vector<size_t>& places) {
        std::vector<double> lengths;
        columns_.clear();
        for (const size_t place : places) {
            Vector column;
            double squares = 0;
            for (const Ran& ran : ran_) {
                column.push_back(ran.sample->amounts[place] / ran.floors);
                squares += column.back() * column.back();
            }
            lengths.push_back(std::sqrt(squares));
            for (double& value : column)
                value /= lengths.back();
            columns_.push_back(std::move(column));
        }
        return lengths;
    }

    double errorOf(const std::vector<FittedRow>& rows, const std::vector<size_t>& places) const {
        double error = 0;
        for (const Ran& ran : ran_) {
            double sum = 0;
            for (const size_t place : places)
                sum += rows[place].floors * ran.sample->amounts[place];
            error += std::abs(sum / ran.floors - 1);
        }
        return error / static_cast<double>(ran_.size());
    }

    size_t all_;
    std::vector<Ran> ran_;
    std::vector<Vector> columns_;
};

} // namespace

Result<CostSample> measureCosts(const CostTable& table, render::ReflectionSession& session, measure::FloorPass& floor,
                                uint32_t frames) {
    const Settings settings = session.settings().reflections;
    const auto effectPlan = [&floor](bool draw) {
        render::FrameRequest plan;
        plan.draw = draw;
        plan.blend = false;
        plan.afterOpaque = [&floor](gpu::Frame& frame, render::GBuffer& gbuffer) { floor.record(frame, gbuffer); };
        return plan;
    };
    GLINT_CHECK(session.setStatistics(true));
    const uint32_t settled = render::settledFrames(settings);
    render::FrameTimes counted;
    for (uint32_t i = 0; i < settled; ++i) {
        GLINT_TRY(times, session.renderFrame(i, effectPlan(i == 0 || i + 1 == settled)));
        counted = std::move(times);
    }
    GLINT_TRY(rough, roughShare(session));
    const FrameWork work = frameWork(settings, session, counted, true, rough);
    CostSample sample;
    for (const CostRow& row : table.rows)
        sample.amounts.push_back(amountOf(row, work));

    GLINT_CHECK(session.setStatistics(false)); // counting takes time
    measure::EffectTimes times;
    for (uint32_t i = 0; i < settled + frames; ++i) {
        GLINT_TRY(drawn, session.renderFrame(settled + i, effectPlan(i == 0 || i >= settled)));
        if (i < settled)
            continue;
        times.add(drawn);
        times.addDrawn(drawn);
    }
    if (times.floor().median > 0)
        for (const measure::PassSpread& pass : times.passes())
            sample.floors[std::string(withoutBackEnd(pass.name))] += pass.ms.median / times.floor().median;
    return sample;
}

std::vector<FittedRow> fitCosts(const CostTable& table, std::span<const CostSample> samples) {
    std::vector<FittedRow> rows;
    for (const CostRow& row : table.rows)
        rows.push_back({row, row.floors, {}, 0});
    std::set<std::string_view> done;
    for (const CostRow& first : table.rows) {
        if (!done.insert(first.pass).second)
            continue;
        std::vector<size_t> places;
        for (size_t i = 0; i < table.rows.size(); ++i)
            if (table.rows[i].pass == first.pass)
                places.push_back(i);
        PassFit(samples, first.pass).fit(rows, places);
    }
    return rows;
}

std::vector<std::string> passesWithoutRow(const CostTable& table, std::span<const CostSample> samples) {
    std::set<std::string> passes;
    for (const CostSample& sample : samples)
        for (const auto& [pass, floors] : sample.floors)
            if (!table.hasRow(pass))
                passes.insert(pass);
    return {passes.begin(), passes.end()};
}

} // namespace glint::tune
