#include "lab/cli/compare/certainty_text.hpp"

#include <fmt/format.h>

namespace glint::cli {

std::string statedText(const measure::HitFigures& hits) {
    uint64_t answers = 0;
    for (const measure::AnswerShare& bin : hits.stated)
        answers += bin.answers;
    std::string text;
    for (size_t i = 0; i < hits.stated.size(); ++i) {
        const measure::AnswerShare& bin = hits.stated[i];
        if (bin.answers * 1000 < answers || bin.answers == 0)
            continue;
        text += fmt::format("  stated   {:.1f} to {:.1f}: {:.3f} in the mean, {:.3f} right, {:.1f} % of the answers\n",
                            0.1 * static_cast<double>(i), 0.1 * static_cast<double>(i + 1), bin.meanStated(),
                            bin.share(), 100 * static_cast<double>(bin.answers) / static_cast<double>(answers));
    }
    return text;
}

std::string kindsText(const measure::HitFigures& hits) {
    std::string text;
    for (size_t kind = 0; kind < hits.byKind.size(); ++kind)
        text += fmt::format("  kind {:<3} {:.3f} right of {} answers\n", kind, hits.byKind[kind].share(),
                            hits.byKind[kind].answers);
    return text;
}

} // namespace glint::cli
