// The hierarchy on whole scenes: at each pixel the source that wins is the best one, and where one source takes over
// from another a seam is rarely visible. docs/techniques/composite.md has the figures.
#include "lab/tests/image/source_regret.hpp"
#include "lab/tests/image/source_seams.hpp"

#include <fmt/format.h>

namespace glint::test {
namespace hierarchy_test {

class HierarchyTest : public JobTest {
protected:
    static void record(const std::string& name, double value) { RecordProperty(name, fmt::format("{:.2f}", value)); }

    static void record(const std::string& prefix, const Regret& regret) {
        const double percent = 100 / static_cast<double>(regret.all.pixels);
        record(prefix + "best %", 100 * regret.best);
        record(prefix + "error", regret.all.error);
        record(prefix + "regret", regret.all.regret);
        for (size_t w = 0; w < kMeasured; ++w) {
            const Regret::Winner& won = regret.winners[w];
            const std::string name = prefix + kMeasuredNames[w];
            record(name + " wins %", static_cast<double>(won.pixels) * percent);
            record(name + " error", won.error);
            record(name + " regret", won.regret);
            for (size_t source = 0; source < kMeasured; ++source) {
                const Regret::Instead& instead = won.instead[source];
                if (instead.pixels == 0)
                    continue;
                const std::string other = name + ", instead " + kMeasuredNames[source];
                record(other + " %", static_cast<double>(instead.pixels) * percent);
                record(other + ", better %", static_cast<double>(instead.better) * percent);
                record(other + ", error before", instead.error);
                record(other + ", error", instead.itsOwn);
            }
        }
    }

    static void record(const std::string& name, const Steps& steps) {
        if (steps.steps.empty())
            return;
        RecordProperty(name + " pairs", std::to_string(steps.steps.size()));
        record(name + " mean", steps.mean());
        record(name + " 95 %", steps.percentile95());
        record(name + " seen %", 100 * steps.seen());
    }

    static void record(const std::string& name, const Takeover& takeover) {
        record(name + " across", takeover.across);
        record(name + " beside", takeover.beside);
        record(name + " in a row %", 100 * takeover.inRow());
    }

    static void record(const std::string& prefix, const Seams& seams) {
        record(prefix + "all", seams.all);
        record(prefix + "inside", seams.inside);
        for (size_t one = 0; one < kMeasured; ++one)
            for (size_t other = one + 1; other < kMeasured; ++other)
                record(prefix + kMeasuredNames[one] + " to " + kMeasuredNames[other], seams.between[one][other]);
    }

    /// The order is right: on the pixels that a source wins, any other source with an answer there would be worse
    /// overall. Where fewer than one pixel in a hundred has both, those are uncertain answers of the screen that left
    /// their weight to the next source (fade.uncertain): nearly as often right as wrong.
    static void expectTheBest(const Regret& regret) {
        EXPECT_GT(regret.best, 0.9) << "of the pixels nothing is noticeably better";
        for (size_t w = 0; w < kMeasured; ++w)
            for (size_t source = 0; source < kMeasured; ++source) {
                const Regret::Instead& instead = regret.winners[w].instead[source];
                if (instead.pixels < regret.all.pixels / 100)
                    continue;
                EXPECT_LE(instead.error, instead.itsOwn)
                    << kMeasuredNames[w] << ", and " << kMeasuredNames[source] << " instead";
            }
    }

    static Seams measure(const std::string& prefix, const SourcePictures& pictures) {
        const Regret regret = regretOf(pictures);
        for (const size_t source : {kScreenHits, kProbeLookups})
            EXPECT_GT(regret.winners[source].pixels, 500u) << kMeasuredNames[source];
        record(prefix, regret);
        expectTheBest(regret);
        const Seams seams = SeamFinder(pictures).find();
        record(prefix, seams);
        return seams;
    }

    /// The eye sees steps in a row as a seam. `most`: of their pairs of pixels, a third above the number measured when
    /// this was written (23, without mirrors 110), so that it does not become worse. Not their share of all takeovers:
    /// that rises where unseen ones vanish, as most from probes to the sky did (of 1174 in the hall 44 are left) when
    /// rough surfaces got an answer from each probe's proxy.
    static void expectFewSeams(const Seams& seams, double most) {
        const auto takeovers = static_cast<double>(seams.all.across.steps.size());
        EXPECT_GT(takeovers, 500);
        EXPECT_LE(seams.all.inRow() * takeovers, most);
    }
};

TEST_F(HierarchyTest, TheBestWinsWithFewSeamsInAHall) {
    const SourcePictures pictures = drawSources(device(), hallJob(320, 180), 5);
    expectFewSeams(measure("", pictures), 31);
    expectFewSeams(measure("no mirrors: ", withoutMirrors(pictures)), 147);
}

// Seams are visible here, and documented: docs/techniques/composite.md says where.
TEST_F(HierarchyTest, TheBestWinsInTheOpen) {
    GLINT_NEED_ASSET(path, "scenes/stage1.glb");
    const SourcePictures pictures = drawSources(device(), openJob(path, 320, 180), 16);
    measure("", pictures);
    measure("no mirrors: ", withoutMirrors(pictures));
}

} // namespace hierarchy_test
} // namespace glint::test
