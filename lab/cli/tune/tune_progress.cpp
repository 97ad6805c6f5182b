#include "lab/cli/tune/tune_progress.hpp"

#include "base/text.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace glint::cli {

TuneProgress::TuneProgress(uint32_t generations, std::optional<double> seconds)
    : generations_(generations), seconds_(seconds), terminal_(isatty(fileno(stderr)) != 0),
      created_(std::chrono::steady_clock::now()), logged_(created_) {}

tune::TuneHooks TuneProgress::hooks() {
    tune::TuneHooks hooks;
    hooks.progress = [this](const tune::SearchProgress& progress) {
        const auto now = std::chrono::steady_clock::now();
        std::optional<double> secondsLeft;
        if (progress.generation > 0) {
            if (!firstGeneration_)
                firstGeneration_ = now;
            const double done = progress.generation - 1 + double(progress.tried) / std::max(1u, progress.toTry);
            std::optional<double> limit;
            if (seconds_)
                limit = *seconds_ - std::chrono::duration<double>(now - created_).count();
            secondsLeft =
                left(done / generations_, std::chrono::duration<double>(now - *firstGeneration_).count(), limit);
        }
        show(line(progress, generations_, secondsLeft));
    };
    hooks.working = [this](const std::string& what) { show(printable(what)); };
    return hooks;
}

void TuneProgress::finish() {
    if (shown_ > 0)
        fmt::print(stderr, "\n");
    shown_ = 0;
}

std::string TuneProgress::line(const tune::SearchProgress& progress, uint32_t generations,
                               const std::optional<double>& secondsLeft) {
    std::string text = progress.generation == 0
                           ? fmt::format("trying each setting, {} of {}", progress.tried, progress.toTry)
                           : fmt::format("generation {} of {}, {} of {}", progress.generation, generations,
                                         progress.tried, progress.toTry);
    if (secondsLeft) {
        const auto whole = std::llround(*secondsLeft);
        text += fmt::format(", {}:{:02} left", whole / 60, whole % 60);
    }
    return text;
}

std::optional<double> TuneProgress::left(double part, double passed, const std::optional<double>& limit) {
    std::optional<double> result;
    if (part > 0)
        result = passed * (1 - part) / part;
    if (limit)
        result = std::max(0.0, std::min(result.value_or(*limit), *limit));
    return result;
}

void TuneProgress::log(const std::string& text) {
    constexpr std::chrono::seconds kBetween(60);
    const auto now = std::chrono::steady_clock::now();
    if (now - logged_ < kBetween)
        return;
    fmt::print(stderr, "{}\n", text);
    std::fflush(stderr);
    logged_ = now;
}

void TuneProgress::show(const std::string& text) {
    if (!terminal_) {
        log(text);
        return;
    }
    fmt::print(stderr, "\r{:<{}}", text, shown_);
    std::fflush(stderr);
    shown_ = text.size();
}

} // namespace glint::cli
