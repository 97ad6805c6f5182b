#include "lab/measure/bench/bench_series.hpp"

#include "lab/measure/bench/floor_pass.hpp"
#include "lab/measure/truth/share_pass.hpp"
#include "lab/session/settled_frames.hpp"

#include <algorithm>
#include <chrono>

namespace glint::measure {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class Series {
public:
    Series(std::vector<render::ReflectionSession>& sessions, const SeriesPlan& plan, FloorPass& floor, SharePass& share)
        : sessions_(sessions), plan_(plan), floor_(floor), share_(share), figures_(sessions.size()),
          walls_(sessions.size()) {}

    Result<std::vector<SeriesFigures>> run() {
        std::vector<bool> drawnForEffect; // true if the host draws anything for the effect alone
        for (render::ReflectionSession& session : sessions_) {
            GLINT_CHECK(session.resize(plan_.width, plan_.height));
            GLINT_TRY(first, session.renderFrame(0, framePlan(true, true))); // uploads, tables, the G-buffer
            EffectTimes times;
            times.addDrawn(first);
            drawnForEffect.push_back(times.hostMs() > 0);
        }
        GLINT_CHECK(rounds(plan_.warmUp, 1, plan_.budgetSeconds / 4, false));
        GLINT_CHECK(rounds(plan_.frames, kLeastFrames, plan_.budgetSeconds, true));
        for (size_t i = 0; i < sessions_.size(); ++i) {
            if (drawnForEffect[i] && !plan_.redraw) {
                GLINT_TRY(drawn, sessions_[i].renderFrame(++index_, framePlan(true, true)));
                figures_[i].times.addDrawn(drawn);
            }
            figures_[i].wallMs = Spread::of(walls_[i]);
            GLINT_TRY(counts, count(sessions_[i]));
            figures_[i].stats = std::move(counts);
        }
        return std::move(figures_);
    }

private:
    render::FrameRequest framePlan(bool draw, bool reflect) {
        render::FrameRequest plan;
        plan.draw = draw;
        plan.reflect = reflect;
        plan.blend = false;
        plan.afterOpaque = [this, draw](gpu::Frame& frame, render::GBuffer& gbuffer) {
            if (draw && plan_.share)
                share_.record(frame, gbuffer, *plan_.share);
            floor_.record(frame, gbuffer);
        };
        return plan;
    }

    Result<void> rounds(uint32_t count, uint32_t least, double budgetSeconds, bool counted) {
        const Clock::time_point start = Clock::now();
        for (uint32_t round = 0; round < count; ++round) {
            if (round >= least && budgetSeconds > 0 && secondsSince(start) > budgetSeconds)
                break;
            for (size_t i = 0; i < sessions_.size(); ++i) {
                GLINT_TRY(off, sessions_[i].renderFrame(++index_, framePlan(plan_.redraw, false)));
                GLINT_TRY(on, sessions_[i].renderFrame(++index_, framePlan(plan_.redraw, true)));
                if (!counted)
                    continue;
                figures_[i].times.add(on);
                figures_[i].times.addFloor(off);
                if (plan_.redraw)
                    figures_[i].times.addDrawn(on);
                walls_[i].push_back(on.wallMs - off.wallMs);
            }
        }
        return {};
    }

    /// Counts in frames of their own, because counting takes time: how each ray ended is stored and read again.
    Result<render::RenderStats> count(render::ReflectionSession& session) {
        GLINT_CHECK(session.setStatistics(true));
        const uint32_t settled = render::settledFrames(session.settings().reflections);
        const uint32_t frames = std::min(settled, plan_.warmUp + plan_.frames);
        const Clock::time_point start = Clock::now();
        for (uint32_t i = 0; i < frames; ++i) {
            if (i > 0 && plan_.budgetSeconds > 0 && secondsSince(start) > plan_.budgetSeconds)
                break;
            GLINT_CHECK(session.renderFrame(++index_, framePlan(plan_.redraw, true)));
        }
        render::RenderStats counts = session.stats();
        GLINT_CHECK(session.setStatistics(false));
        return counts;
    }

    std::vector<render::ReflectionSession>& sessions_;
    const SeriesPlan& plan_;
    FloorPass& floor_;
    SharePass& share_;
    std::vector<SeriesFigures> figures_;
    std::vector<std::vector<double>> walls_;
    uint32_t index_ = 0;
};

} // namespace

Result<std::vector<SeriesFigures>> runSeries(gpu::Context& context, std::vector<render::ReflectionSession>& sessions,
                                             const SeriesPlan& plan) {
    GLINT_TRY(floor, FloorPass::create(context, plan.width, plan.height));
    GLINT_TRY(share, SharePass::create(context));
    return Series(sessions, plan, floor, share).run();
}

} // namespace glint::measure
